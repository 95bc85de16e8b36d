#include "fault/tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace hn {
namespace {

constexpr std::array<std::string_view, 2> kThree = {"<<=", ">>="};
constexpr std::array<std::string_view, 19> kTwo = {
    "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "^^"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// How many characters of text the blanks and comments at its start have.
std::size_t length_of_space(std::string_view text) {
  std::size_t i = 0;
  for (;;) {
    const std::string_view rest = text.substr(i);
    if (rest.starts_with("//")) {
      i += std::min(rest.find('\n'), rest.size());
    } else if (rest.starts_with("/*")) {
      const auto end = rest.find("*/", 2);
      i += end == std::string_view::npos ? rest.size() : end + 2;
    } else if (!rest.empty() && is_blank(rest.front())) {
      ++i;
    } else {
      return i;
    }
  }
}

std::size_t length_of_directive(std::string_view text) {
  std::size_t end = text.find('\n');
  while (end != std::string_view::npos && end > 0 && text[end - 1] == '\\') end = text.find('\n', end + 1);
  return std::min(end, text.size());
}

std::size_t length_of_number(std::string_view text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  std::size_t i = 0;
  while (i < text.size()) {
    const bool after_exponent = i > 0 && !hexadecimal && (text[i - 1] == 'e' || text[i - 1] == 'E');
    if (!is_word(text[i]) && text[i] != '.' && !(after_exponent && (text[i] == '+' || text[i] == '-'))) break;
    ++i;
  }
  return i;
}

std::size_t length_of_symbol(std::string_view text) {
  if (std::find(kThree.begin(), kThree.end(), text.substr(0, 3)) != kThree.end()) return 3;
  return std::find(kTwo.begin(), kTwo.end(), text.substr(0, 2)) != kTwo.end() ? 2 : 1;
}

Token next_token(std::string_view text) {
  const char first = text.front();
  if (first == '#') return {Token::Kind::directive, {}, std::string(text.substr(0, length_of_directive(text)))};
  if (is_digit(first) || (first == '.' && text.size() > 1 && is_digit(text[1]))) {
    return {Token::Kind::number, {}, std::string(text.substr(0, length_of_number(text)))};
  }
  if (is_word(first)) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_word);
    return {Token::Kind::word, {}, std::string(text.begin(), end)};
  }
  return {Token::Kind::symbol, {}, std::string(text.substr(0, length_of_symbol(text)))};
}

}  // namespace

std::vector<Token> tokenize(std::string_view text) {
  std::vector<Token> tokens;
  for (;;) {
    const std::size_t space = length_of_space(text);
    Token token = text.size() == space ? Token{} : next_token(text.substr(space));
    token.space = text.substr(0, space);
    text.remove_prefix(space + token.text.size());
    tokens.push_back(token);
    if (token.kind == Token::Kind::end) return tokens;
  }
}

}  // namespace hn
