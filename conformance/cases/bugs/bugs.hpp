// Each case is a bug of a real driver or translator: a few lines of code, inputs, and the right words.
//
// The lines are GLSL that is translated as the library is, and run in each language that can express them. A bug is
// data, so that a browser can run the same. C++ that is not GLSL computes its right words when the table is made, from
// the specification.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "cases/case.hpp"
#include "library/shaders.hpp"

namespace hn {

struct BugPoint {
  std::vector<std::uint32_t> inputs;    // a word for each of the function's inputs
  std::vector<std::uint32_t> expected;  // a word for each of its outputs
};

// The rule of the specification on a bug.
struct Rule {
  std::string_view text;
  // Whether the specification pins the words down. Where it does not they are the natural ones, and a driver that
  // differs is none the worse for it: a warning.
  bool defined;
  // How far a float may be off, because the specification allows it; 0 if it must be the very number.
  double allowed;
};

struct Bug {
  // id ("bugs.abs_of_int"), columns and body as of the library's functions; its file is config.glsl, for its names of
  // types. The body may use float_of and bits_of.
  Function function;
  std::string_view reference;  // where it was reported
  Rule rule;
  // Space-separated names of the profiles in which it runs.
  std::string_view profiles;
  // The bug's own functions, if it is about functions.
  std::string_view declarations = "";
  std::vector<BugPoint> points = {};
  bool given = false;  // by a user (given.hpp): nobody reported it, and its rule names the origin of the words
  // Space-separated names of the profiles that have another rule, and that rule.
  std::string_view exceptions = "";
  Rule exception = {};
  // The body and the functions in WGSL, if they are no translation.
  std::string_view wgsl = "";
  std::string_view wgsl_declarations = "";

  const Rule& rule_in(const Profile& profile) const;
  std::string code_in(const Profile& profile) const;
  // The check of its cases' ids.
  std::string_view check(const Profile& profile) const {
    return given ? "same" : rule_in(profile).defined ? "defined" : "undefined";
  }
  // Sentences for messages, without the last point.
  std::string note(const Profile& profile) const;
  // Integers, and floats that must be the very number, are exact.
  std::string_view arithmetic() const { return rule.allowed > 0.0 ? "fast" : "exact"; }
};

std::span<const Bug> all_bugs();

// The evaluation for evaluation_shader that makes the bug's shader.
Evaluation evaluation_of(const Bug& bug, const Profile& profile);
Outcome check_bug(Session& session, const Bug& bug, const Profile& profile);
// The driver's words for its points: kOutputWords for each.
tl::expected<std::vector<std::uint32_t>, Outcome> outputs_of(Session& session, const Bug& bug, const Profile& profile);
// Compares them with the right ones.
Outcome judge_bug(const Bug& bug, const Profile& profile, std::span<const std::uint32_t> outputs);

}  // namespace hn
