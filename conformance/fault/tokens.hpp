// GLSL as a row of tokens that, put together again, are the very same text.
#pragma once

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

}  // namespace hn
