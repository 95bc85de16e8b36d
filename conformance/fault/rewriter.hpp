// Rewrites the code of a shader, so that operators and calls go through functions of a fault. Nothing moves to
// another line.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "fault/expression.hpp"

namespace hn {

// The new text of a part of an expression; the space before the part stays.
struct Rewriting {
  std::string space;
  std::string code;

  std::string whole() const { return space + code; }
};

// Where in the shader an expression stands.
struct Place {
  bool in_loop = false;
  std::set<std::string, std::less<>> swizzled;  // the variables whose swizzles this function wrote so far
  bool highp_by_default = false;                // whether this function set the precision of its scope
};

struct Rules {
  using Names = std::map<std::string, std::string, std::less<>>;
  Names operators = {};    // binary ones: "%" becomes a call of this function, "%=" an assignment of one
  Names functions = {};    // calls of other functions
  std::string minus = {};  // called by the unary minus of anything but a number
  // The code for an expression, or nothing if the other rules are to decide; it is called before them. The code begins
  // with that of the expression's first part, without the space before it.
  using Render = std::function<Rewriting(const Expression&)>;  // rewrites a part
  using Pattern = std::optional<std::string>(const Expression&, const Render&, Place&);
  Pattern* pattern = nullptr;
  bool only_constants = false;  // only operators between numbers
  // Statements before a loop, at the start of its body, and behind it.
  std::string before_loop = {};
  std::string in_loop = {};
  std::string after_loop = {};
  std::string condition = {};       // is added to the condition of each loop: "&& ..."
  std::string initializer = {};     // is added to the value that a for loop starts with: "+ 1"
  std::string behind_default = {};  // a statement behind the default of a switch
  // Whether the bodies of macros with parameters are code as well; not what the suite itself looks at values with.
  bool in_macros = true;
};

// The text by the rules. Rewritten are the bodies of functions and of macros that are expressions; the initializers of
// constants, which may call nothing, stay.
Result<std::string> rewrite(std::string_view text, const Rules& rules);

}  // namespace hn
