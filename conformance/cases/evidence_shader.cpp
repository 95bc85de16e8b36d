#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include "base/text.hpp"
#include "cases/evidence.hpp"
#include "cases/facets.hpp"
#include "expected/compare.hpp"
#include "fault/expression.hpp"

namespace hn {
namespace {

std::string shown(WordType type, std::uint32_t word) {
  if (type == WordType::u32) return fmt::format("{}", word);
  if (type == WordType::i32) return fmt::format("{}", static_cast<std::int32_t>(word));
  return fmt::format("{:.9g}", std::bit_cast<float>(word));
}

std::string describe_outputs(const Function& function, std::span<const std::uint32_t> words) {
  if (words.empty()) return "no value";
  std::string text;
  for (std::size_t i = 0; i < function.outputs.size(); ++i) {
    const std::string value = shown(function.outputs[i].type, words[i]);
    text += fmt::format("{}{}={} ({:08x})", text.empty() ? "" : " ", function.outputs[i].name, value, words[i]);
  }
  return text;
}

std::string describe_allowed(const Function& function, std::span<const double> allowed) {
  const auto used = allowed.first(function.outputs.size());
  const bool constant = std::all_of(used.begin(), used.end(), [&](double number) { return number == used.front(); });
  if (constant) return fmt::format(", within {:.3g}", allowed.front());
  std::string text;
  for (std::size_t i = 0; i < function.outputs.size(); ++i) {
    text += fmt::format("{} {} within {:.3g}", i == 0 ? "," : " and", function.outputs[i].name, allowed[i]);
  }
  return text;
}

// Names and versions come from drivers; a line break in one would end the comment.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~' || c == '\\'; }, ' ');
  return text;
}

std::string comments(const SourceSet& sources, const Evaluation& evaluation, const ShaderFacts& facts) {
  const Function& function = evaluation.function;
  const bool is_fragment = facts.id.find(".fragment.") != std::string::npos;
  const std::string rule = rule_of(facts.id);
  const bool is_given = facts.id.starts_with("check.");
  return fmt::format(
      R"(// {}
// {} on {}{}{}.
//
// rule      {}
// at        {}
// got       {}
// expected  {}{}
//
// To see it: draw with this shader over anything, with any vertex shader, and set no uniform. Green is right, red is
// wrong. (uniform zero keeps the compiler from evaluating the function itself.) A vertex shader, for three vertices:
//   void main() {{ gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }}
//
// It is made of the functions of {}.
)",
      facts.id, is_given ? "differs" : "fails", one_line(facts.renderer),
      sources.transform() ? ", made to have a fault" : "", is_fragment ? "" : ", and so does this fragment shader",
      fmt::join(split(rule, ';'), ";\n//          "), describe_inputs(function, facts.inputs),
      describe_outputs(function, facts.got), describe_outputs(function, facts.expected),
      facts.every_bit ? "" : describe_allowed(function, facts.allowed),
      one_line(is_given ? sources.find(function.file)->path
                        : fmt::format("{}; MIT License", library_text(sources.edited()))));
}

std::string hidden(std::span<const std::uint32_t> words) {
  return fmt::format("uvec4(0x{:08X}u ^ zero, 0x{:08X}u ^ zero, 0x{:08X}u ^ zero, 0x{:08X}u ^ zero)", words[0],
                     words[1], words[2], words[3]);
}

// main and its two variables, without macros: a brief shader has none.
constexpr std::ptrdiff_t kDeclarationsOfMain = 3;
std::string main_of(const Evaluation& evaluation, const ShaderFacts& facts) {
  const Function& function = evaluation.function;
  constexpr std::array<char, kOutputWords> kParts = {'x', 'y', 'z', 'w'};
  const auto argument = [&](std::size_t i) { return hidden(facts.inputs.subspan(4 * i)); };
  constexpr std::string_view kNextLine = ",\n                                ";
  std::string right;
  for (std::size_t i = 0; i < function.outputs.size(); ++i) {
    if (i > 0) right += " &&\n               ";
    const auto expected = std::bit_cast<float>(facts.expected[i]);
    const bool is_float = function.outputs[i].type == WordType::f32;
    if (is_float && std::isnan(expected)) {
      right += fmt::format("(got.{} & 0x7FFFFFFFu) > 0x7F800000u", kParts[i]);
    } else if (facts.every_bit || function.is_name(i) || (is_float && std::isinf(expected))) {
      right += fmt::format("got.{0} == expected.{0}", kParts[i]);
    } else {
      right += fmt::format("abs(uintBitsToFloat(got.{0}) - uintBitsToFloat(expected.{0})) <= {1:.9e}", kParts[i],
                           facts.allowed[i]);
    }
  }
  return fmt::format(R"(uniform {0}uint zero;
out {0}vec4 colour;
void main() {{
  {0}uvec4 got = evaluate({1});
  {0}uvec4 expected = {2};
  bool right = {3};
  colour = right ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}}
)",
                     evaluation.profile.es ? "highp " : "", arguments_of(function, argument, kNextLine),
                     hidden(facts.expected), right);
}

// A part at the top of a shader: a function, a constant, a directive.
struct Declaration {
  std::vector<Token> tokens;
  std::size_t first_line;
  std::size_t last_line;
};

std::vector<Declaration> declarations_of(std::string_view glsl) {
  std::vector<Declaration> declarations;
  std::vector<Token> tokens;
  std::size_t line = 1;
  std::size_t first_line = 1;
  int depth = 0;
  for (Token& token : tokenize(glsl)) {
    line += static_cast<std::size_t>(std::count(token.space.begin(), token.space.end(), '\n'));
    if (token.kind == Token::Kind::end) break;
    if (tokens.empty()) first_line = line;
    depth += token.is("{") || token.is("(") ? 1 : token.is("}") || token.is(")") ? -1 : 0;
    const bool is_struct = !tokens.empty() && tokens.front().is("struct");
    const bool ends = token.kind == Token::Kind::directive || token.is(";") || (token.is("}") && !is_struct);
    tokens.push_back(std::move(token));
    if (!ends || depth != 0) continue;
    declarations.push_back({std::move(tokens), first_line, line});
    tokens.clear();
  }
  return declarations;
}

// The name of a constant or a structure, which is needed where its name stands. Else nothing.
std::string_view name_of(const Declaration& declaration) {
  const auto& tokens = declaration.tokens;
  if (tokens.front().is("struct")) return tokens[1].text;
  if (!tokens.front().is("const")) return {};
  const auto end = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("=") || t.is("["); });
  return end == tokens.end() ? std::string_view{} : (end - 1)->text;
}

bool is_function(const Declaration& declaration) { return declaration.tokens.back().is("}"); }

// As the preprocessor wrote it, without the lines that it left empty.
std::string text_of(const Declaration& declaration) {
  std::string text;
  for (const Token& token : declaration.tokens) {
    const auto line = token.space.rfind('\n');
    if (!text.empty() && !token.space.empty()) text += line == std::string::npos ? " " : token.space.substr(line);
    text += token.text;
  }
  return text + "\n";
}

// The parts of a shader that its main needs, in their order, and main as it was.
Result<std::string> needed_of(const std::string& glsl, const std::string& main, const Profile& profile,
                              const ReferenceCompiler& compiler) {
  HN_TRY(const auto expanded, compiler.preprocessed({glsl, {"the shader"}}, profile, Stage::fragment));
  // glslang has no bit casts in old versions, which drivers have as an extension: it reads the text as a newer one.
  const Profile& newer = profile.has_bit_casts() ? profile : profile_named("gl330");
  const ShaderText in_newer{std::string(newer.directive) + expanded.text.substr(expanded.text.find('\n')),
                            {"the shader"}};
  HN_TRY(const auto called, compiler.lines_of_called(in_newer, newer, Stage::fragment));
  std::set<std::string, std::less<>> words;  // of what is needed so far, from the end: things are declared before used
  std::string text = main;
  auto declarations = declarations_of(expanded.text);
  std::reverse(declarations.begin(), declarations.end());
  declarations.erase(declarations.begin(), declarations.begin() + kDeclarationsOfMain);
  for (const Declaration& declaration : declarations) {
    const auto name = name_of(declaration);
    const auto line = called.lower_bound(declaration.first_line);
    const bool is_called = line != called.end() && *line <= declaration.last_line;
    if (is_function(declaration) ? !is_called : !name.empty() && !words.contains(name)) continue;
    for (const Token& token : declaration.tokens) {
      if (token.kind == Token::Kind::word) words.insert(token.text);
    }
    text.insert(0, text_of(declaration));
  }
  return text;
}

}  // namespace

std::string expecting_got(std::string shader, const ShaderFacts& facts) {
  const std::string expected = hidden(facts.expected);
  const auto at = shader.rfind(expected);
  return at == shader.npos ? shader : shader.replace(at, expected.size(), hidden(facts.got));
}

std::string without_comments(std::string_view glsl) {
  std::string text;
  while (!glsl.empty()) {
    std::string_view line = glsl.substr(0, glsl.find('\n'));
    glsl.remove_prefix(std::min(line.size() + 1, glsl.size()));
    line = line.substr(0, line.find("//"));  // GLSL has no strings
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    if (!line.empty() && !line.starts_with("#line")) text += fmt::format("{}\n", line);
  }
  return text;
}

Result<std::string> stand_alone_shader(const SourceSet& sources, const Evaluation& evaluation, const ShaderFacts& facts,
                                       const ReferenceCompiler* compiler) {
  const std::string main = main_of(evaluation, facts);
  HN_TRY(const auto shader, expand(sources, evaluation.profile, shader_that_evaluates(evaluation, main)));
  std::string text = without_comments(shader.text);
  if (compiler != nullptr) {
    HN_TRY(text, needed_of(text, main, evaluation.profile, *compiler));
  }
  // WebGL wants #version in the first line.
  const auto second_line = text.find('\n') + 1;
  return text.substr(0, second_line) + comments(sources, evaluation, facts) + text.substr(second_line);
}

}  // namespace hn
