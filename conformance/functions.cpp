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

const std::vector<Function>& functions() {
  static const std::vector<Function> kFunctions = {
#define FUNCTION(id, file, columns, accuracy, ...) make_function(id, file, columns, Accuracy::accuracy, #__VA_ARGS__),
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

// What the shader is, for the preprocessor.
std::string case_names(const Evaluation& evaluation) {
  const auto name_of_shape = [](Shape shape) -> std::string_view {
    switch (shape) {
      case Shape::inlined:
        return "#define CASE_INLINED\n";
      case Shape::in_loop:
        return "#define CASE_IN_LOOP\n";
      case Shape::constant:
        return "#define CASE_CONSTANT\n";
      case Shape::called:
        break;
    }
    return "";
  };
  const auto name_of_stage = [](Stage stage) -> std::string_view {
    if (stage == Stage::vertex) return "#define CASE_VERTEX\n";
    return stage == Stage::compute ? "#define CASE_COMPUTE\n" : "#define CASE_FRAGMENT\n";
  };
  const auto name_of_seed = [](SeedFrom seed) -> std::string_view {
    if (seed == SeedFrom::constant) return "#define CASE_CONSTANT_SEED\n";
    return seed == SeedFrom::uniform ? "#define CASE_UNIFORM_SEED\n" : "";
  };
  return fmt::format("{}{}{}", name_of_stage(evaluation.stage), name_of_shape(evaluation.variant.shape),
                     name_of_seed(evaluation.variant.seed_from));
}

// SEEDED, behind the include, since it may need hn_uint.
std::string seeding_of(const ShaderVariant& variant) {
  if (!variant.seeded) return std::string(kUnseeded);
  switch (variant.seed_from) {
    case SeedFrom::constant:
      return fmt::format("#define SEEDED(s) , 0x{:08X}u\n", kVariantSeed);
    case SeedFrom::uniform:
      return "uniform hn_uint variant_seed;\n#define SEEDED(s) , variant_seed\n";
    case SeedFrom::point:
      break;
  }
  return std::string(kSeeded);
}

// Declares at, the point's place in the textures, and result, unless it is an output.
std::string beginning_of(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      // A draw per row: in a longer one softpipe counts gl_VertexID from 0 again after 4,096 vertices.
      return "  hn_ivec2 at = ivec2(gl_VertexID, row);\n  gl_Position = vec4(0.0);\n";
    case Stage::compute:
      return fmt::format(
          "  hn_int index = int(gl_GlobalInvocationID.x);\n  hn_ivec2 at = ivec2(index % {0}, index / "
          "{0});\n"
          "  hn_uvec4 result;\n",
          kGridSide);
    case Stage::fragment:
      break;
  }
  return "  hn_ivec2 at = ivec2(gl_FragCoord.xy);\n";
}

// The body of evaluate, as a part of main.
std::string inlined(std::string_view body) {
  constexpr std::string_view kReturn = "return ";  // each body has one, at its end
  const auto at = body.find(kReturn);
  return fmt::format("{}result = {}", body.substr(0, at), body.substr(at + kReturn.size()));
}

// evaluate of constants, where the point at hand is one of them.
std::string evaluated_constants(std::span<const std::uint32_t> words) {
  std::string text = "  result = uvec4(0u);\n";
  for (std::size_t i = 0; i < words.size(); i += kInputWords) {
    const auto part = [&](std::size_t first) {
      const auto* const w = &words[i + first];
      return fmt::format("uvec4(0x{:08X}u, 0x{:08X}u, 0x{:08X}u, 0x{:08X}u)", w[0], w[1], w[2], w[3]);
    };
    text += fmt::format("  if (at.x == {}) result = evaluate({}, {});\n", i / kInputWords, part(0), part(4));
  }
  return text;
}

// The part of main that sets result.
std::string result_of(const Evaluation& evaluation) {
  switch (evaluation.variant.shape) {
    case Shape::inlined:
      return fmt::format(
          "  hn_uvec4 a = texelFetch(input_a, at, 0);\n  hn_uvec4 b = texelFetch(input_b, at, 0);\n  {}\n",
          inlined(evaluation.function.body));
    case Shape::in_loop:
      // The words of the last trips move through the result, so that none can be left out.
      return R"(  hn_uvec4 last = uvec4(0u);
  for (hn_int i = 0; i < trips; ++i) {
    hn_ivec2 other = ivec2(at.x ^ i, at.y);
    hn_uvec4 v = evaluate(texelFetch(input_a, other, 0), texelFetch(input_b, other, 0));
    last = uvec4(last.y, last.z, last.w, v.x ^ v.y ^ v.z ^ v.w);
  }
  result = last;
)";
    case Shape::constant:
      return evaluated_constants(evaluation.variant.constants);
    case Shape::called:
      break;
  }
  return "  result = evaluate(texelFetch(input_a, at, 0), texelFetch(input_b, at, 0));\n";
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

Function make_function(std::string_view id, std::string_view file, std::string_view columns, Accuracy accuracy,
                       std::string_view body) {
  const auto equals = columns.find(" = ");
  return {id,       file, columns, parse_columns(columns.substr(0, equals)), parse_columns(columns.substr(equals + 3)),
          accuracy, body};
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

Arithmetic Configuration::arithmetic() const {
  if (name.ends_with("+precise")) return Arithmetic::precise;
  return name.ends_with("+fixed") ? Arithmetic::fixed : Arithmetic::fast;
}

std::string_view Configuration::name_without_arithmetic() const {
  return fast() ? name : name.substr(0, name.rfind('+'));
}

std::string_view arithmetic_name(const Function& function, const Configuration& configuration) {
  constexpr std::array<std::string_view, 3> kNames = {"fast", "precise", "fixed"};
  return function.exact() ? "exact" : kNames[static_cast<std::size_t>(configuration.arithmetic())];
}

bool has_exact_values(const Function& function, const Configuration& configuration) {
  return function.exact() || configuration.arithmetic() == Arithmetic::fixed;
}

bool has_same_bits(const Function& function, const Configuration& configuration) {
  return function.exact() || !configuration.fast();
}

bool depends_on_configuration(const Function& function) {
  constexpr std::array<std::string_view, 4> kIndependent = {"hash.unorm", "hash.snorm", "hash.gradient2",
                                                            "hash.gradient3"};
  return std::find(kIndependent.begin(), kIndependent.end(), function.id) == kIndependent.end();
}

const Profile& main_profile(const Configuration& configuration, bool es) {
  if (configuration.arithmetic() == Arithmetic::precise) return profile_named(es ? "es320" : "gl400");
  return profile_named(es ? "es300" : "gl330");
}

std::string knobs_of(const Configuration& configuration) {
  return fmt::format("{}{}", configuration.knobs, configuration.name == "custom" ? kCustomHash : "");
}

bool covers(const Configuration& configuration, const Function& function) {
  if (function.exact() && !configuration.fast()) return false;
  if (function.id.starts_with("gradient.")) return function.id.starts_with("gradient.sine") == configuration.sine();
  if (configuration.hash_only()) return depends_on_configuration(function) || configuration.is_default();
  if (function.id.find("perlin") != std::string_view::npos) return true;
  // The octave sums are the same code above any noise, but their bounds depend on it; and each arithmetic has its own.
  const auto name = configuration.name_without_arithmetic();
  return function.file == "fbm.glsl" && (name == "lattice+sine" || (name == "lattice" && !configuration.fast()));
}

std::string evaluation_shader(const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  std::string text = running_preamble(profile) + case_names(evaluation);
  if (stage == Stage::compute) text += fmt::format("layout(local_size_x = {}) in;\n", kComputeGroup);
  text += fmt::format("{}{}#include \"{}\"\n{}", knobs_of(configuration), variant.knobs, function.file,
                      seeding_of(variant));
  if (variant.shape == Shape::in_loop) text += "uniform hn_int trips;\n";
  text += fmt::format("uniform {0}usampler2D input_a;\nuniform {0}usampler2D input_b;\n", profile.es ? "highp " : "");
  if (stage == Stage::compute) {
    text += "layout(std430, binding = 0) buffer Results { hn_uvec4 results[]; };\n";
  } else {
    text += fmt::format("{}out hn_uvec4 result;\n", stage == Stage::vertex ? "uniform hn_int row;\nflat " : "");
  }
  if (variant.shape != Shape::inlined) {
    text += fmt::format("hn_uvec4 evaluate(hn_uvec4 a, hn_uvec4 b) {{ {} }}\n", function.body);
  }
  return text + fmt::format("void main() {{\n{}{}{}}}\n", beginning_of(stage), result_of(evaluation),
                            stage == Stage::compute ? "  results[gl_GlobalInvocationID.x] = result;\n" : "");
}

std::string vertex_shader() {
  // One triangle that covers the viewport: (-1, -1), (3, -1), (-1, 3).
  return R"(void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
}

std::string idle_fragment_shader() { return "void main() {}\n"; }

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
      text += fmt::format("hn_uvec4 evaluate{}(hn_uvec4 a, hn_uvec4 b) {{ {} }}\n", count, function.body);
      calls += fmt::format("  r ^= evaluate{}(r, r + 1u);\n", count++);
    }
  }
  const std::string start = fmt::format("  hn_uvec4 r = uvec4(uint(HN_VERSION_MAJOR), 2u, 3u, 4u);\n{}", calls);
  const std::string_view layout = profile.spirv ? "layout(location = 0) " : "";
  if (stage == Stage::compute) {
    const std::string_view binding =
        profile.spirv ? "layout(std430, set = 0, binding = 0)" : "layout(std430, binding = 0)";
    return text +
           fmt::format("{} buffer Out {{ hn_uvec4 result; }};\nvoid main() {{\n{}  result = r;\n}}\n", binding, start);
  }
  if (stage == Stage::vertex) {
    return text + fmt::format(
                      "{}flat out hn_uvec4 result;\nvoid main() {{\n{}  result = r;\n"
                      "  gl_Position = vec4(0.0);\n}}\n",
                      layout, start);
  }
  return text + fmt::format("{}out hn_uvec4 result;\nvoid main() {{\n{}  result = r;\n}}\n", layout, start);
}

std::string shader_that_evaluates(const Evaluation& evaluation, std::string_view rest) {
  return fmt::format("{}{}{}{}#include \"{}\"\n{}hn_uvec4 evaluate(hn_uvec4 a, hn_uvec4 b) {{ {} }}\n{}",
                     running_preamble(evaluation.profile), case_names(evaluation), knobs_of(evaluation.configuration),
                     evaluation.variant.knobs, evaluation.function.file,
                     evaluation.variant.seeded ? kSeeded : kUnseeded, evaluation.function.body, rest);
}

}  // namespace hn
