// GLSL as a row of tokens, and its expressions as trees.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hn {

struct Token {
  enum class Kind { word, number, symbol, directive, end };
  Kind kind = Kind::end;
  std::string space;  // between the token before and this one: blanks, line ends, comments
  std::string text;   // of a directive: the whole line, and those that a backslash adds

  bool is(std::string_view what) const { return text == what && kind != Kind::directive; }
};

// The last token is an end, with the rest behind the others as its space.
std::vector<Token> tokenize(std::string_view text);

struct Expression {
  enum class Kind {
    leaf,      // a name or a number
    paren,     // ( 0 )
    prefix,    // - 0
    postfix,   // 0 ++
    binary,    // 0 + 1
    assign,    // 0 += 1
    ternary,   // 0 ? 1 : 2
    call,      // 0 ( 1 ), without a 1 if there are no arguments
    index,     // 0 [ 1 ]
    member,    // 0 . xy
    comma,     // 0 , 1
    adjacent,  // 0 1: the second is a macro that brings its own comma
  };
  Kind kind = Kind::leaf;
  Token token = {};  // the leaf, the operator, the opening bracket, the dot
  Token close = {};  // the closing bracket, the colon, the name of the member
  std::vector<Expression> parts = {};

  bool is(Kind what, std::string_view text) const { return kind == what && token.text == text; }
};

// The expression without the parentheses around it.
const Expression& bare(const Expression& expression);
// Whether it is made of numbers alone.
bool is_constant(const Expression& expression);
// "floor" of floor(x) with one argument; empty if it is not such a call.
std::string_view called_with_one(const Expression& expression);

// Reads expressions from a row of tokens.
class ExpressionParser {
 public:
  explicit ExpressionParser(const std::vector<Token>& tokens) : tokens_(tokens) {}

  const Token& peek(std::size_t ahead = 0) const;
  Token take();
  // The error in a wrong expression; empty if there is none. After an error only ends are read.
  const std::string& error() const { return error_; }
  Token expect(std::string_view what);

  Expression expression();  // with commas
  Expression assignment();  // without

 private:
  Expression ternary();
  Expression binary(int level);
  Expression prefix();
  Expression postfix();
  Expression arguments();
  void fail(std::string_view expected);

  const std::vector<Token>& tokens_;
  std::size_t next_ = 0;
  std::string error_;
};

}  // namespace hn
