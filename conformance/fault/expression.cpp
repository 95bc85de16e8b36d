#include "fault/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

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

namespace {

using Kind = Expression::Kind;

// From the weakest to the strongest; all of them associate to the left.
constexpr std::array<std::array<std::string_view, 4>, 11> kLevels = {{{"||"},
                                                                      {"^^"},
                                                                      {"&&"},
                                                                      {"|"},
                                                                      {"^"},
                                                                      {"&"},
                                                                      {"==", "!="},
                                                                      {"<", ">", "<=", ">="},
                                                                      {"<<", ">>"},
                                                                      {"+", "-"},
                                                                      {"*", "/", "%"}}};
constexpr std::array<std::string_view, 11> kAssignments = {
    "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
constexpr std::array<std::string_view, 6> kPrefixes = {"+", "-", "!", "~", "++", "--"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& all, const Token& token) {
  return token.kind == Token::Kind::symbol && std::find(all.begin(), all.end(), token.text) != all.end();
}

Expression join(Kind kind, Token token, Expression first, Expression second) {
  Expression joined{kind, std::move(token)};
  joined.parts.push_back(std::move(first));
  joined.parts.push_back(std::move(second));
  return joined;
}

}  // namespace

const Expression& bare(const Expression& expression) {
  return expression.kind == Kind::paren ? bare(expression.parts[0]) : expression;
}

bool is_constant(const Expression& expression) {
  switch (expression.kind) {
    case Kind::leaf:
      return expression.token.kind == Token::Kind::number;
    case Kind::paren:
    case Kind::prefix:
    case Kind::binary:
      return std::all_of(expression.parts.begin(), expression.parts.end(), is_constant);
    default:
      return false;
  }
}

std::string_view called_with_one(const Expression& expression) {
  if (expression.kind != Kind::call || expression.parts.size() != 2) return {};
  const Kind arguments = expression.parts[1].kind;
  if (arguments == Kind::comma || arguments == Kind::adjacent) return {};
  return expression.parts[0].token.text;
}

const Token& ExpressionParser::peek(std::size_t ahead) const {
  return tokens_[std::min(error_.empty() ? next_ + ahead : tokens_.size(), tokens_.size() - 1)];
}

Token ExpressionParser::take() {
  Token token = peek();
  next_ = std::min(next_ + 1, tokens_.size() - 1);
  return token;
}

void ExpressionParser::fail(std::string_view expected) {
  if (error_.empty()) error_ = fmt::format("'{}' where {} should be", peek().text, expected);
}

Token ExpressionParser::expect(std::string_view what) {
  if (!peek().is(what)) fail(fmt::format("'{}'", what));
  return take();
}

Expression ExpressionParser::expression() {
  Expression left = assignment();
  while (peek().is(",")) {
    Token comma = take();
    left = join(Kind::comma, std::move(comma), std::move(left), assignment());
  }
  return left;
}

Expression ExpressionParser::assignment() {
  Expression left = ternary();
  if (!is_one_of(kAssignments, peek())) return left;
  Token token = take();
  return join(Kind::assign, std::move(token), std::move(left), assignment());
}

Expression ExpressionParser::ternary() {
  Expression condition = binary(0);
  if (!peek().is("?")) return condition;
  Token question = take();
  Expression whole = join(Kind::ternary, std::move(question), std::move(condition), expression());
  whole.close = expect(":");
  whole.parts.push_back(assignment());
  return whole;
}

Expression ExpressionParser::binary(int level) {
  if (level == static_cast<int>(kLevels.size())) return prefix();
  Expression left = binary(level + 1);
  while (!peek().text.empty() && is_one_of(kLevels[static_cast<std::size_t>(level)], peek())) {
    Token token = take();
    left = join(Kind::binary, std::move(token), std::move(left), binary(level + 1));
  }
  return left;
}

Expression ExpressionParser::prefix() {
  if (!is_one_of(kPrefixes, peek())) return postfix();
  Expression whole{Kind::prefix, take()};
  whole.parts.push_back(prefix());
  return whole;
}

// Arguments are an expression with commas, and macros may stand behind each.
Expression ExpressionParser::arguments() {
  const auto one = [this] {
    Expression argument = assignment();
    while (peek().kind == Token::Kind::word) {
      argument = join(Kind::adjacent, {}, std::move(argument), assignment());
    }
    return argument;
  };
  Expression left = one();
  while (peek().is(",")) {
    Token comma = take();
    left = join(Kind::comma, std::move(comma), std::move(left), one());
  }
  return left;
}

Expression ExpressionParser::postfix() {
  Expression left;
  if (peek().is("(")) {
    left = {Kind::paren, take()};
    left.parts.push_back(expression());
    left.close = expect(")");
  } else {
    if (peek().kind != Token::Kind::word && peek().kind != Token::Kind::number) fail("a value");
    left = {Kind::leaf, take()};
  }
  for (;;) {
    const Token& next = peek();
    Expression whole;
    if (next.is("(") || next.is("[")) {
      const bool call = next.is("(");
      const std::string_view end = call ? ")" : "]";
      whole = {call ? Kind::call : Kind::index, take()};
      whole.parts.push_back(std::move(left));
      if (!peek().is(end)) whole.parts.push_back(arguments());
      whole.close = expect(end);
    } else if (next.is(".")) {
      whole = {Kind::member, take()};
      whole.parts.push_back(std::move(left));
      whole.close = take();
    } else if (next.is("++") || next.is("--")) {
      whole = {Kind::postfix, take()};
      whole.parts.push_back(std::move(left));
    } else {
      return left;
    }
    left = std::move(whole);
  }
}

}  // namespace hn
