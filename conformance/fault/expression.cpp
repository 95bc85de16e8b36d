#include "fault/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hn {
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
