#include "cases/evidence_shader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "expected/compare.hpp"

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
  return fmt::format(
      R"(// {}
// fails on {}.
//
// at        {}
// got       {}
// expected  {}{}
//
// To see it: draw with this shader over anything, with any vertex shader, and set no uniform. Green is right, red is
// wrong. (uniform zero keeps the compiler from evaluating the function itself.) A vertex shader, for three vertices:
//   void main() {{ gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }}
//
// The functions are those of {}, without the comments; MIT License.
)",
      facts.id, one_line(facts.renderer), describe_inputs(function, facts.inputs),
      describe_outputs(function, facts.got), describe_outputs(function, facts.expected),
      facts.every_bit ? "" : describe_allowed(function, facts.allowed), one_line(library_text(sources.edited())));
}

std::string hidden(std::span<const std::uint32_t> words) {
  return fmt::format("uvec4(0x{:08X}u ^ zero, 0x{:08X}u ^ zero, 0x{:08X}u ^ zero, 0x{:08X}u ^ zero)", words[0],
                     words[1], words[2], words[3]);
}

std::string main_of(const Function& function, const ShaderFacts& facts) {
  constexpr std::array<char, kOutputWords> kParts = {'x', 'y', 'z', 'w'};
  const auto argument = [&](std::size_t i) { return hidden(facts.inputs.subspan(4 * i)); };
  constexpr std::string_view kNextLine = ",\n                                ";
  std::string right;
  for (std::size_t i = 0; i < function.outputs.size(); ++i) {
    if (i > 0) right += " && ";
    if (facts.every_bit || function.is_name(i)) {
      right += fmt::format("got.{0} == expected.{0}", kParts[i]);
    } else {
      right += fmt::format("abs(float_of(got.{0}) - float_of(expected.{0})) <= {1:.9e}", kParts[i], facts.allowed[i]);
    }
  }
  return fmt::format(R"(uniform hn_uint zero;
out hn_vec4 colour;
void main() {{
  hn_uvec4 got = evaluate({});
  hn_uvec4 expected = {};
  colour = {} ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}}
)",
                     arguments_of(function, argument, kNextLine), hidden(facts.expected), right);
}

}  // namespace

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

Result<std::string> stand_alone_shader(const SourceSet& sources, const Evaluation& evaluation,
                                       const ShaderFacts& facts) {
  HN_TRY(const auto shader,
         expand(sources, evaluation.profile, shader_that_evaluates(evaluation, main_of(evaluation.function, facts))));
  const std::string text = without_comments(shader.text);
  // WebGL wants #version in the first line.
  const auto second_line = text.find('\n') + 1;
  return text.substr(0, second_line) + comments(sources, evaluation, facts) + text.substr(second_line);
}

}  // namespace hn
