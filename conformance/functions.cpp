#include "functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

namespace hn {
namespace {

WordType type_of(std::string_view name) {
  if (name == "u32") return WordType::u32;
  if (name == "i32") return WordType::i32;
  return name == "f32" ? WordType::f32 : WordType::f64;
}

// "x:f32 y:f32" -> columns
std::vector<Column> parse_columns(std::string_view text) {
  std::vector<Column> columns;
  while (!text.empty()) {
    const auto end = std::min(text.find(' '), text.size());
    const auto item = text.substr(0, end);
    const auto colon = item.find(':');
    if (!item.empty()) columns.push_back({item.substr(0, colon), type_of(item.substr(colon + 1))});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return columns;
}

Function make(std::string_view id, std::string_view file, std::string_view columns, Accuracy accuracy,
              std::string_view body) {
  const auto equals = columns.find(" = ");
  return {id,       file, columns, parse_columns(columns.substr(0, equals)), parse_columns(columns.substr(equals + 3)),
          accuracy, body};
}

const std::vector<Function>& functions() {
  static const std::vector<Function> kFunctions = {
#define FUNCTION(id, file, columns, accuracy, ...) make(id, file, columns, Accuracy::accuracy, #__VA_ARGS__),
#include "functions.inc"
  };
  return kFunctions;
}

constexpr std::array kConfigurations = {
#define CONFIGURATION(index, name, knobs) Configuration{name, knobs, index},
#include "configurations.inc"
#undef CONFIGURATION
};

// For HN_HASH_CUSTOM; the same in twin.cpp.
constexpr std::string_view kCustomHash = "#define HN_HASH_FN(k) (((k) ^ ((k) >> 16)) * 0x045D9F3Bu)\n";

// Whether the shader that tries a file calls a function: those that the file declares, and for the file that only
// includes the others, one of each.
bool called_from(std::string_view file, const Function& function) {
  constexpr std::array<std::string_view, 4> kOneOfEach = {"hash.word", "noise2d.perlin", "noise3d.perlin", "fbm.fbm2"};
  if (file != "hashnoise.glsl") return function.file == file;
  return std::find(kOneOfEach.begin(), kOneOfEach.end(), function.id) != kOneOfEach.end();
}

// What a shader needs before it can use the library. In ES the default precision is the lowest there is, since the
// library must not depend on it.
std::string preamble(const Profile& profile, std::string_view bit_casts) {
  std::string text;
  if (profile.es) text += "precision mediump float;\nprecision mediump int;\n";
  return text + std::string(bit_casts);
}

constexpr std::string_view kBitCasts =
    "#define float_of(u) uintBitsToFloat(u)\n#define bits_of(f) floatBitsToUint(f)\n";

constexpr std::string_view kSeeded = "#define SEEDED(s) , s\n";
constexpr std::string_view kUnseeded = "#define SEEDED(s)\n";

std::string running_preamble(const Profile& profile) {
  const std::string extension = profile.has_bit_casts() ? "" : "#extension GL_ARB_shader_bit_encoding : require\n";
  return extension + preamble(profile, kBitCasts);
}

// glslang knows no GL_ARB_shader_bit_encoding. Where a shader is only compiled, a conversion has the same types.
std::string compiling_preamble(const Profile& profile) {
  return preamble(profile,
                  profile.has_bit_casts() ? kBitCasts : "#define float_of(u) float(u)\n#define bits_of(f) uint(f)\n");
}

}  // namespace

int Function::input(std::string_view name) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const Column& c) { return c.name == name; });
  return found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin());
}

std::span<const Function> all_functions() { return functions(); }

const Function& find_function(std::string_view id) {
  const auto& all = functions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Function& f) { return f.id == id; });
  assert(found != all.end());
  return *found;
}

std::span<const Configuration> all_configurations() { return kConfigurations; }

const Configuration& default_configuration() {
  return *std::find_if(kConfigurations.begin(), kConfigurations.end(),
                       [](const Configuration& c) { return c.is_default(); });
}

std::uint32_t Configuration::period() const {
  constexpr std::string_view kTag = "+period";
  const auto tag = name.find(kTag);
  std::uint32_t cells = 0;
  if (tag != std::string_view::npos) {
    std::from_chars(name.data() + tag + kTag.size(), name.data() + name.size(), cells);
  }
  return cells;
}

bool depends_on_configuration(const Function& function) {
  constexpr std::array<std::string_view, 4> kIndependent = {"hash.unorm", "hash.snorm", "hash.gradient2",
                                                            "hash.gradient3"};
  return std::find(kIndependent.begin(), kIndependent.end(), function.id) == kIndependent.end();
}

std::string knobs_of(const Configuration& configuration) {
  return fmt::format("{}{}", configuration.knobs, configuration.name == "custom" ? kCustomHash : "");
}

bool covers(const Configuration& configuration, const Function& function) {
  if (function.id.starts_with("gradient.")) return function.id.starts_with("gradient.sine") == configuration.sine();
  if (configuration.hash_only()) return depends_on_configuration(function) || configuration.is_default();
  // The octave sums are the same code above any noise, but their bounds depend on it.
  return function.id.find("perlin") != std::string_view::npos ||
         (function.file == "fbm.glsl" && configuration.name == "lattice+sine");
}

std::string evaluation_shader(const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant] = evaluation;
  return fmt::format(R"({}{}{}#include "{}"
{}uniform HN_HIGHP usampler2D input_a;
uniform HN_HIGHP usampler2D input_b;
out HN_HIGHP uvec4 result;
HN_HIGHP uvec4 evaluate(HN_HIGHP uvec4 a, HN_HIGHP uvec4 b) {{ {} }}
void main() {{
  HN_HIGHP ivec2 at = ivec2(gl_FragCoord.xy);
  result = evaluate(texelFetch(input_a, at, 0), texelFetch(input_b, at, 0));
}}
)",
                     running_preamble(profile), knobs_of(configuration), variant.knobs, function.file,
                     variant.seeded ? kSeeded : kUnseeded, function.body);
}

std::string vertex_shader() {
  // One triangle that covers the viewport: (-1, -1), (3, -1), (-1, 3).
  return R"(void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
}

std::string calling_shader(std::string_view file, const Configuration& configuration, const Profile& profile,
                           Stage stage) {
  std::string text = compiling_preamble(profile);
  if (stage == Stage::compute) text += "layout(local_size_x = 1) in;\n";
  text += fmt::format("{}#include \"{}\"\n#include \"{}\"\n", knobs_of(configuration), file, file);
  std::string calls;
  int count = 0;
  for (const std::string_view seeding : {kSeeded, kUnseeded}) {
    text += fmt::format("#undef SEEDED\n{}", seeding);
    for (const Function& function : functions()) {
      const bool has_variant = function.seed_word() >= 0 && profile.spirv;
      if (!called_from(file, function) || (seeding == kUnseeded && !has_variant)) continue;
      text +=
          fmt::format("HN_HIGHP uvec4 evaluate{}(HN_HIGHP uvec4 a, HN_HIGHP uvec4 b) {{ {} }}\n", count, function.body);
      calls += fmt::format("  r ^= evaluate{}(r, r + 1u);\n", count++);
    }
  }
  const std::string start = fmt::format("  HN_HIGHP uvec4 r = uvec4(uint(HN_VERSION_MAJOR), 2u, 3u, 4u);\n{}", calls);
  const std::string_view layout = profile.spirv ? "layout(location = 0) " : "";
  if (stage == Stage::compute) {
    const std::string_view binding =
        profile.spirv ? "layout(std430, set = 0, binding = 0)" : "layout(std430, binding = 0)";
    return text + fmt::format("{} buffer Out {{ HN_HIGHP uvec4 result; }};\nvoid main() {{\n{}  result = r;\n}}\n",
                              binding, start);
  }
  if (stage == Stage::vertex) {
    return text + fmt::format(
                      "{}flat out HN_HIGHP uvec4 result;\nvoid main() {{\n{}  result = r;\n"
                      "  gl_Position = vec4(0.0);\n}}\n",
                      layout, start);
  }
  return text + fmt::format("{}out HN_HIGHP uvec4 result;\nvoid main() {{\n{}  result = r;\n}}\n", layout, start);
}

std::string shader_that_evaluates(const Evaluation& evaluation, std::string_view rest) {
  return fmt::format(
      "{}{}{}#include \"{}\"\n{}HN_HIGHP uvec4 evaluate(HN_HIGHP uvec4 a, HN_HIGHP uvec4 b) {{ {} }}\n{}",
      running_preamble(evaluation.profile), knobs_of(evaluation.configuration), evaluation.variant.knobs,
      evaluation.function.file, evaluation.variant.seeded ? kSeeded : kUnseeded, evaluation.function.body, rest);
}

}  // namespace hn
