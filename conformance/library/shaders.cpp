#include "library/shaders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/strings.hpp"
#include "library/files.hpp"

namespace hn {
namespace {

// What a file of the library includes, by itself or by what it includes.
std::set<std::string_view> included_by(std::string_view file) {
  constexpr std::string_view kInclude = "\n#include \"";
  std::set<std::string_view> files;
  const std::string_view text = text_of(kLibraryFiles, file);
  for (auto at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at + 1)) {
    const auto start = at + kInclude.size();
    const auto name = text.substr(start, text.find('"', start) - start);
    files.insert(name);
    files.merge(included_by(name));
  }
  return files;
}

// What the shader that tries a file calls: the functions of that file, or of a file that only includes others the first
// function of each of these.
std::vector<const Function*> called_from(std::string_view file) {
  std::vector<const Function*> own;
  std::vector<const Function*> others;
  std::set<std::string_view> included = included_by(file);
  for (const Function& function : all_functions()) {
    if (function.file == file) own.push_back(&function);
    if (included.erase(function.file) != 0) others.push_back(&function);
  }
  return own.empty() ? others : own;
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
  const auto name_of_seed = [](SeedFrom seed) -> std::string_view {
    if (seed == SeedFrom::constant) return "#define CASE_CONSTANT_SEED\n";
    return seed == SeedFrom::uniform ? "#define CASE_UNIFORM_SEED\n" : "";
  };
  return fmt::format("#define CASE_{}\n{}{}", in_upper_case(name_of(evaluation.stage)),
                     name_of_shape(evaluation.variant.shape), name_of_seed(evaluation.variant.seed_from));
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

// What the stages of a shader that evaluates differ in.
struct StageText {
  std::string layout;       // before everything
  std::string declaration;  // of where results go
  std::string beginning;    // of main: declares at, the point's place in the textures, and result if it is no output
  std::string end;          // of main
};

StageText text_of(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      // A draw per row: in a longer one softpipe counts gl_VertexID from 0 again after 4,096 vertices.
      return {.layout = {},
              .declaration = "uniform hn_int row;\nflat out hn_uvec4 result;\n",
              .beginning = "  hn_ivec2 at = ivec2(gl_VertexID, row);\n  gl_Position = vec4(0.0);\n",
              .end = {}};
    case Stage::compute:
      return {.layout = fmt::format("layout(local_size_x = {}) in;\n", kComputeGroup),
              .declaration = "layout(std430, binding = 0) buffer Results { hn_uvec4 results[]; };\n",
              .beginning = fmt::format("  hn_int index = int(gl_GlobalInvocationID.x);\n"
                                       "  hn_ivec2 at = ivec2(index % {0}, index / {0});\n  hn_uvec4 result;\n",
                                       kGridSide),
              .end = "  results[gl_GlobalInvocationID.x] = result;\n"};
    case Stage::fragment:
      break;
  }
  return {.layout = {},
          .declaration = "out hn_uvec4 result;\n",
          .beginning = "  hn_ivec2 at = ivec2(gl_FragCoord.xy);\n",
          .end = {}};
}

// The same of a shader that is only compiled: where its one result goes. Vulkan wants a place for it.
StageText compiled_text_of(Stage stage, bool vulkan) {
  const std::string_view location = vulkan ? "layout(location = 0) " : "";
  switch (stage) {
    case Stage::vertex:
      return {.layout = {},
              .declaration = fmt::format("{}flat out hn_uvec4 result;\n", location),
              .beginning = {},
              .end = "  gl_Position = vec4(0.0);\n"};
    case Stage::compute:
      return {.layout = "layout(local_size_x = 1) in;\n",
              .declaration = fmt::format("layout(std430, {}binding = 0) buffer Out {{ hn_uvec4 result; }};\n",
                                         vulkan ? "set = 0, " : ""),
              .beginning = {},
              .end = {}};
    case Stage::fragment:
      break;
  }
  return {.layout = {}, .declaration = fmt::format("{}out hn_uvec4 result;\n", location), .beginning = {}, .end = {}};
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

std::string evaluation_shader(const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const StageText of_stage = text_of(stage);
  std::string text = running_preamble(profile) + case_names(evaluation) + of_stage.layout;
  text += fmt::format("{}{}#include \"{}\"\n{}", knobs_of(configuration), variant.knobs, function.file,
                      seeding_of(variant));
  if (variant.shape == Shape::in_loop) text += "uniform hn_int trips;\n";
  text += fmt::format("uniform {0}usampler2D input_a;\nuniform {0}usampler2D input_b;\n", profile.es ? "highp " : "");
  text += of_stage.declaration;
  if (variant.shape != Shape::inlined) {
    text += fmt::format("hn_uvec4 evaluate(hn_uvec4 a, hn_uvec4 b) {{ {} }}\n", function.body);
  }
  return text + fmt::format("void main() {{\n{}{}{}}}\n", of_stage.beginning, result_of(evaluation), of_stage.end);
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
  const StageText of_stage = compiled_text_of(stage, profile.spirv);
  std::string text = compiling_preamble(profile) + of_stage.layout;
  text += fmt::format("{}#include \"{}\"\n#include \"{}\"\n", knobs_of(configuration), file, file);
  const std::vector<const Function*> called = called_from(file);
  std::string calls;
  int count = 0;
  for (const std::string_view seeding : {kSeeded, kUnseeded}) {
    text += fmt::format("#undef SEEDED\n{}", seeding);
    for (const Function* const function : called) {
      const bool has_variant = function->seed_word() >= 0 && profile.spirv;
      if (seeding == kUnseeded && !has_variant) continue;
      text += fmt::format("hn_uvec4 evaluate{}(hn_uvec4 a, hn_uvec4 b) {{ {} }}\n", count, function->body);
      calls += fmt::format("  r ^= evaluate{}(r, r + 1u);\n", count++);
    }
  }
  return text + fmt::format(
                    "{}void main() {{\n  hn_uvec4 r = uvec4(uint(HN_VERSION_MAJOR), 2u, 3u, 4u);\n{}  result = r;\n{}}}\n",
                    of_stage.declaration, calls, of_stage.end);
}

std::string shader_that_evaluates(const Evaluation& evaluation, std::string_view rest) {
  return fmt::format("{}{}{}{}#include \"{}\"\n{}hn_uvec4 evaluate(hn_uvec4 a, hn_uvec4 b) {{ {} }}\n{}",
                     running_preamble(evaluation.profile), case_names(evaluation), knobs_of(evaluation.configuration),
                     evaluation.variant.knobs, evaluation.function.file,
                     evaluation.variant.seeded ? kSeeded : kUnseeded, evaluation.function.body, rest);
}

}  // namespace hn
