#include "fault/rewriter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hn {
namespace {

using Kind = Expression::Kind;

// The parts put together as they were.
Rewriting unchanged(const Expression& node, const std::vector<Rewriting>& parts) {
  const auto& [kind, token, close, sources] = node;
  switch (kind) {
    case Kind::leaf:
      return {token.space, token.text};
    case Kind::paren:
      return {token.space, fmt::format("({}{})", parts[0].whole(), close.space)};
    case Kind::prefix:
      return {token.space, token.text + parts[0].whole()};
    case Kind::postfix:
      return {parts[0].space, parts[0].code + token.space + token.text};
    case Kind::ternary:
      return {parts[0].space,
              fmt::format("{}{}?{}{}:{}", parts[0].code, token.space, parts[1].whole(), close.space, parts[2].whole())};
    case Kind::call:
    case Kind::index:
      return {parts[0].space, fmt::format("{}{}{}{}{}{}", parts[0].code, token.space, token.text,
                                          parts.size() > 1 ? parts[1].whole() : "", close.space, close.text)};
    case Kind::member:
      return {parts[0].space, fmt::format("{}{}.{}{}", parts[0].code, token.space, close.space, close.text)};
    case Kind::binary:
    case Kind::assign:
    case Kind::comma:
    case Kind::adjacent:
      break;
  }
  return {parts[0].space, fmt::format("{}{}{}{}", parts[0].code, token.space, token.text, parts[1].whole())};
}

// A call with the parts as arguments. A comma takes the place of the operator.
std::string call_of(const std::string& function, const Expression& node, const std::vector<Rewriting>& parts) {
  return fmt::format("{}({}{},{})", function, parts[0].code, node.token.space, parts[1].whole());
}

// The function for an operator, compound or not: "%" for "%=".
const std::string* function_for(const Rules& rules, const Expression& node) {
  std::string_view symbol = node.token.text;
  if (node.kind == Kind::assign) symbol.remove_suffix(1);
  const auto found = rules.operators.find(symbol);
  return found == rules.operators.end() ? nullptr : &found->second;
}

std::optional<std::string> replacement(const Rules& rules, const Expression& node,
                                       const std::vector<Rewriting>& parts) {
  if (node.kind == Kind::call) {
    const auto found = rules.functions.find(node.parts[0].token.text);
    if (node.parts[0].kind != Kind::leaf || found == rules.functions.end() || parts.size() < 2) return std::nullopt;
    return fmt::format("{}{}({}{})", found->second, node.token.space, parts[1].whole(), node.close.space);
  }
  if (node.is(Kind::prefix, "-") && !rules.minus.empty() && !is_constant(node)) {
    return fmt::format("{}({})", rules.minus, parts[0].whole());
  }
  if (node.kind != Kind::binary && node.kind != Kind::assign) return std::nullopt;
  const std::string* const function = function_for(rules, node);
  if (!function || (rules.only_constants && !is_constant(node))) return std::nullopt;
  const std::string call = call_of(*function, node, parts);
  return node.kind == Kind::binary ? call : fmt::format("{} = {}", parts[0].code, call);
}

std::string space_before(const Expression& node) {
  const bool starts_itself = node.kind == Kind::leaf || node.kind == Kind::paren || node.kind == Kind::prefix;
  return starts_itself ? node.token.space : space_before(node.parts[0]);
}

Rewriting rewrite_expression(const Rules& rules, const Expression& node, Place& place) {
  if (rules.pattern) {
    const auto render = [&](const Expression& part) { return rewrite_expression(rules, part, place); };
    if (auto code = rules.pattern(node, render, place)) return {space_before(node), std::move(*code)};
  }
  std::vector<Rewriting> parts;
  for (const Expression& part : node.parts) parts.push_back(rewrite_expression(rules, part, place));
  Rewriting result = unchanged(node, parts);
  if (auto code = replacement(rules, node, parts)) result.code = std::move(*code);
  return result;
}

// The body of a macro with parameters, if it is an expression: "#define A(x) ((x) * 2u)".
std::string rewrite_macro(const Rules& rules, const std::string& line) {
  constexpr std::string_view kDefine = "#define ";
  const auto open = line.find('(');
  const auto close = line.find(')');
  const bool has_parameters =
      line.starts_with(kDefine) && close != std::string::npos && line.find_first_of(" \t", kDefine.size()) > open;
  if (!has_parameters || !rules.in_macros) return line;
  const auto tokens = tokenize(std::string_view(line).substr(close + 1));
  ExpressionParser parser(tokens);
  const Expression body = parser.expression();
  if (!parser.error().empty() || parser.peek().kind != Token::Kind::end) return line;
  Place place;
  return line.substr(0, close + 1) + rewrite_expression(rules, body, place).whole() + parser.peek().space;
}

class ShaderRewriter {
 public:
  ShaderRewriter(const Rules& rules, const std::vector<Token>& tokens) : rules_(rules), parser_(tokens) {}

  Result<std::string> run() {
    while (!at_end()) top_level();
    if (!parser_.error().empty()) return fail(parser_.error());
    return out_ + parser_.peek().space;
  }

 private:
  bool at_end() const { return parser_.peek().kind == Token::Kind::end; }

  void put(const Token& token) { out_ += token.space + token.text; }
  void copy() { put(parser_.take()); }
  void copy(std::string_view expected) { put(parser_.expect(expected)); }
  void put(const Expression& expression) { out_ += rewrite_expression(rules_, expression, place_).whole(); }

  bool directive() {
    if (parser_.peek().kind != Token::Kind::directive) return false;
    const Token token = parser_.take();
    out_ += token.space + rewrite_macro(rules_, token.text);
    return true;
  }

  // A declaration, or a function.
  void top_level() {
    if (directive()) return;
    bool after_parameters = false;
    while (!at_end() && !parser_.peek().is(";") && !parser_.peek().is("{")) {
      if (directive()) continue;
      after_parameters = parser_.peek().is(")");
      copy();
    }
    if (at_end()) return;  // behind lines that are macros
    if (parser_.peek().is(";")) return copy();
    if (after_parameters) {
      place_ = {};
      return statement();
    }
    copy_braces();
  }

  // A structure or an interface block.
  void copy_braces() {
    int depth = 0;
    while (!at_end()) {
      depth += parser_.peek().is("{") ? 1 : parser_.peek().is("}") ? -1 : 0;
      copy();
      if (depth == 0) return;
    }
  }

  void block() {
    copy("{");
    while (!at_end() && !parser_.peek().is("}")) statement();
    copy("}");
  }

  void statement() {
    const Token& next = parser_.peek();
    if (directive()) return;
    if (next.is("{")) return block();
    if (next.is("for") || next.is("while") || next.is("do")) return loop();
    if (next.is("if") || next.is("switch")) return branch();
    if (next.is("case") || next.is("default")) {
      const bool is_default = next.is("default");
      while (!at_end() && !parser_.peek().is(":")) copy();
      copy(":");
      if (is_default) out_ += rules_.behind_default;
      return;
    }
    simple_statement();
  }

  void branch() {
    copy();
    copy("(");
    put(parser_.expression());
    copy(")");
    statement();
    if (!parser_.peek().is("else")) return;
    copy();
    statement();
  }

  // A declaration, an expression or a jump, with its semicolon; start is added to the value of a declaration.
  void simple_statement(const std::string& start = "") {
    constexpr std::array<std::string_view, 4> kJumps = {"return", "break", "continue", "discard"};
    if (std::find(kJumps.begin(), kJumps.end(), parser_.peek().text) != kJumps.end()) {
      copy();
    } else if (parser_.peek().kind == Token::Kind::word && parser_.peek(1).kind == Token::Kind::word) {
      return declaration(start);
    }
    if (!parser_.peek().is(";")) put(parser_.expression());
    copy(";");
  }

  // "highp uint a = 1u, b[2];"
  void declaration(const std::string& start) {
    bool constant = false;
    // The second is glsl/hashnoise/config.glsl's macro of the first.
    if (parser_.peek().is("precision") || parser_.peek().is("HN_I_HIGHP_HERE")) place_.highp_by_default = true;
    while (parser_.peek(1).kind == Token::Kind::word) {
      constant = constant || parser_.peek().is("const");
      copy();
    }
    while (!at_end() && !parser_.peek().is(";")) {
      if (!parser_.peek().is("=") || constant) {
        copy();
        continue;
      }
      copy();
      put(parser_.assignment());
      out_ += start;
    }
    copy(";");
  }

  void loop() {
    const bool was_in_loop = std::exchange(place_.in_loop, true);
    const bool has_more = !rules_.before_loop.empty() || !rules_.after_loop.empty();
    const Token keyword = parser_.take();
    out_ += keyword.space + (has_more ? "{ " + rules_.before_loop + " " : "") + keyword.text;
    if (keyword.is("do")) {
      body();
      copy("while");
    }
    copy("(");
    if (keyword.is("for")) simple_statement(rules_.initializer);
    condition();
    if (keyword.is("for")) {
      copy(";");
      if (!parser_.peek().is(")")) put(parser_.expression());
    }
    copy(")");
    if (keyword.is("do")) {
      copy(";");
    } else {
      body();
    }
    place_.in_loop = was_in_loop;
    if (has_more) out_ += " " + rules_.after_loop + " }";
  }

  void condition() {
    if (parser_.peek().is(";")) return;
    const Rewriting written = rewrite_expression(rules_, parser_.expression(), place_);
    const std::string& added = rules_.condition;
    out_ += written.space + (added.empty() ? written.code : fmt::format("({}) {}", written.code, added));
  }

  void body() {
    if (!rules_.in_loop.empty()) out_ += " { " + rules_.in_loop;
    statement();
    if (!rules_.in_loop.empty()) out_ += " }";
  }

  const Rules& rules_;
  ExpressionParser parser_;
  Place place_;
  std::string out_;
};

}  // namespace

Result<std::string> rewrite(std::string_view text, const Rules& rules) {
  const auto tokens = tokenize(text);
  return ShaderRewriter(rules, tokens).run();
}

}  // namespace hn
