#include "library/shaders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "base/entry_named.hpp"
#include "base/text.hpp"
#include "library/files.hpp"
#include "library/source.hpp"

namespace hn {
namespace {

// Adds the files that a file of the library includes, by itself or through others. Each file is looked at once: every
// start of the program calls this for all of them, and they include each other in many ways.
void add_included_by(std::string_view file, std::set<std::string_view>& files) {
  constexpr std::string_view kInclude = "\n#include \"";
  const std::string_view text = text_of(kLibraryFiles, file);
  for (auto at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at + 1)) {
    const std::string_view above = text.substr(0, at);
    if (above.substr(above.rfind('\n') + 1).starts_with("#if ")) continue;  // only some knobs include it
    const auto start = at + kInclude.size();
    const std::string name = included_from(file, text.substr(start, text.find('"', start) - start));
    const std::string_view known = entry_named(kLibraryFiles, &EmbeddedFile::name, name, "file of the library").name;
    if (files.insert(known).second) add_included_by(known, files);
  }
}

// The functions that the shader for a file calls: those of that file, but not twice a function that has two rows (bench
// calls it once). If the file has no function of its own or is the whole library, it also calls the first function of
// each included file or family.
std::vector<const Function*> called_from(std::string_view file, Callees callees) {
  std::vector<const Function*> own;
  std::vector<const Function*> others;
  std::set<std::string_view> included;
  add_included_by(file, included);
  std::set<Family> families;
  std::set<std::string_view> files;
  for (const Function& function : all_functions()) {
    if (function.file == file && !function.call.empty()) own.push_back(&function);
    if (!included.contains(function.file)) continue;
    const bool of_new_family = families.insert(function.family).second;
    const bool of_new_file = files.insert(function.file).second;
    if (callees == Callees::of_each_file ? of_new_file : of_new_family) others.push_back(&function);
  }
  // Mesa 22.3's softpipe crashes with all 30 sums in space over noise of sines in one shader. No user's shader has
  // them, and cases of their own run each.
  constexpr std::size_t kMany = 20;
  std::set<std::string_view> bounds;
  const auto is_further = [&](const Function* function) { return !bounds.insert(function->bound).second; };
  if (callees == Callees::few && own.size() > kMany) std::erase_if(own, is_further);
  if (own.empty() || file == "hashnoise.glsl") own.insert(own.end(), others.begin(), others.end());
  return own;
}

// The lines before the library's include. In ES the default precision is the lowest there is, since the library must
// not depend on it.
std::string preamble(const Profile& profile, std::string_view bit_casts) {
  std::string text;
  if (profile.es) text += "precision mediump float;\nprecision mediump int;\n";
  return text + std::string(bit_casts);
}

constexpr std::string_view kBitCasts =
    "#define float_of(u) uintBitsToFloat(u)\n#define bits_of(f) floatBitsToUint(f)\n";

constexpr std::string_view kSeeded = "#define SEEDED(s) , s\n#define SEED(s) s\n";
constexpr std::string_view kUnseeded = "#define SEEDED(s)\n#define SEED(s) s\n";

// The suite's names of types and bit casts, behind the library's own names for them.
constexpr std::string_view kVectorNames = "#include \"detail/vectors_begin.h\"\n";
constexpr std::string_view kNamesInHlsl =
    "#define float_of(u) asfloat(u)\n#define bits_of(f) asuint(f)\n#define floatBitsToUint asuint\n#define fract "
    "frac\n";
constexpr std::string_view kNamesInMetal =
    "using namespace metal;\nusing namespace hashnoise;\n"
    "#define float_of(u) as_type<float>(u)\n#define bits_of(f) as_type<uint>(f)\n#define floatBitsToUint bits_of\n";

std::string running_preamble(const Profile& profile) {
  if (!profile.in_glsl()) return "";
  const std::string extension = profile.has_bit_casts() ? "" : "#extension GL_ARB_shader_bit_encoding : require\n";
  return extension + preamble(profile, kBitCasts);
}

// The names of the shader's case, for the preprocessor.
std::string case_names(const Evaluation& evaluation) {
  constexpr std::array kShapes = {"", "#define CASE_INLINED\n", "#define CASE_IN_LOOP\n", "#define CASE_CONSTANT\n"};
  constexpr std::array kSeeds = {"", "#define CASE_CONSTANT_SEED\n", "#define CASE_UNIFORM_SEED\n"};
  const ShaderVariant& variant = evaluation.variant;
  return fmt::format("#define CASE_{}\n{}{}{}", in_upper_case(name_of(evaluation.stage)),
                     kShapes.at(static_cast<std::size_t>(variant.shape)),
                     kSeeds.at(static_cast<std::size_t>(variant.seed_from)),
                     variant.periods.empty() ? "" : "#define CASE_CONSTANT_PERIOD\n");
}

// Whether points and results are in buffers, and uniforms as well.
bool in_buffers(const Profile& profile) { return profile.platform() != Platform::opengl; }

// SEEDED, behind the include, since it may need hn_uint.
std::string seeding_of(const ShaderVariant& variant, const Profile& profile) {
  if (!variant.seeded) return std::string(kUnseeded);
  switch (variant.seed_from) {
    case SeedFrom::constant:
      return fmt::format("#define SEEDED(s) , 0x{0:08X}u\n#define SEED(s) 0x{0:08X}u\n", kVariantSeed);
    case SeedFrom::uniform:
      return fmt::format("{}#define SEEDED(s) , variant_seed\n#define SEED(s) variant_seed\n",
                         in_buffers(profile) ? "" : "uniform hn_uint variant_seed;\n");
    case SeedFrom::point:
      break;
  }
  return std::string(kSeeded);
}

// The differences between the stages of an evaluating shader.
struct StageText {
  std::string layout = {};       // before everything
  std::string declaration = {};  // of where results go, and where points come from if that is no texture
  std::string beginning = {};    // of main: declares at, the point's place, and result if it is no output
  std::string end = {};          // of main
  std::string head = "void main()";
};

// All words are in buffers: in, out, and uniforms.
StageText text_over_buffers(const Profile& profile) {
  constexpr std::string_view kBeginning = "  hn_int at = int({});\n  hn_uvec4 result;\n";
  constexpr std::string_view kEnd = "  results[{}] = result;\n";
  if (profile.in_glsl()) {
    return {.layout = fmt::format("layout(local_size_x = {}) in;\n", kComputeGroup),
            .declaration =
                "layout(std430, set = 0, binding = 0) buffer Results { hn_uvec4 results[]; };\n"
                "layout(std430, set = 0, binding = 1) readonly buffer Points { hn_uvec4 points[]; };\n"
                "layout(std430, set = 0, binding = 2) readonly buffer Uniforms { hn_int trips; hn_uint "
                "variant_seed; };\n",
            .beginning = fmt::format(kBeginning, "gl_GlobalInvocationID.x"),
            .end = fmt::format(kEnd, "gl_GlobalInvocationID.x")};
  }
  if (profile.language == Language::metal) {
    return {.beginning = fmt::format(kBeginning, "index"),
            .end = fmt::format(kEnd, "index"),
            .head =
                "kernel void evaluate_point(device hn_uvec4* results [[buffer(0)]], const device hn_uvec4* points "
                "[[buffer(1)]], uint index [[thread_position_in_grid]])"};
  }
  // Read-only buffers are writable, too: the read-only ones of shader model 5 become textures in Vulkan.
  return {.declaration =
              "RWStructuredBuffer<hn_uvec4> results : register(u0);\n"
              "RWStructuredBuffer<hn_uvec4> points : register(u1);\n"
              "RWStructuredBuffer<hn_uint> uniforms : register(u2);\n"
              "#define trips int(uniforms[0])\n#define variant_seed uniforms[1]\n",
          .beginning = fmt::format(kBeginning, "thread.x"),
          .end = fmt::format(kEnd, "thread.x"),
          .head = fmt::format("[numthreads({}, 1, 1)]\nvoid main(uint3 thread : SV_DispatchThreadID)", kComputeGroup)};
}

StageText text_of(Stage stage, const Profile& profile) {
  if (in_buffers(profile)) return text_over_buffers(profile);
  switch (stage) {
    case Stage::vertex:
      // A draw per row: in a longer one softpipe counts gl_VertexID from 0 again after 4,096 vertices.
      return {.declaration = "uniform hn_int row;\nflat out hn_uvec4 result;\n",
              .beginning = "  hn_ivec2 at = ivec2(gl_VertexID, row);\n  gl_Position = vec4(0.0);\n"};
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
  return {.declaration = "out hn_uvec4 result;\n", .beginning = "  hn_ivec2 at = ivec2(gl_FragCoord.xy);\n"};
}

// The text of a shader that is only compiled: where its one result goes. Vulkan wants a place for it.
StageText compiled_text_of(Stage stage, bool vulkan) {
  const std::string_view location = vulkan ? "layout(location = 0) " : "";
  switch (stage) {
    case Stage::vertex:
      return {.declaration = fmt::format("{}flat out hn_uvec4 result;\n", location),
              .end = "  gl_Position = vec4(0.0);\n"};
    case Stage::compute:
      return {.layout = "layout(local_size_x = 1) in;\n",
              .declaration = fmt::format("layout(std430, {}binding = 0) buffer Out {{ hn_uvec4 result; }};\n",
                                         vulkan ? "set = 0, " : "")};
    case Stage::fragment:
      break;
  }
  return {.declaration = fmt::format("{}out hn_uvec4 result;\n", location)};
}

// The body of evaluate, as a part of main.
std::string inlined(std::string_view body) {
  constexpr std::string_view kReturn = "return ";  // each body has one, at its end
  const auto at = body.find(kReturn);
  return fmt::format("{}result = {}", body.substr(0, at), body.substr(at + kReturn.size()));
}

// The names of evaluate's parameters.
char name_of_parameter(std::size_t i) { return static_cast<char>('a' + i); }

// Constants in place of the words of the periods.
std::string constant_periods(const Function& function, std::span<const std::int32_t> periods) {
  std::string text;
  for (std::size_t axis = 0; axis < std::min(periods.size(), static_cast<std::size_t>(function.axes)); ++axis) {
    const std::size_t word = static_cast<std::size_t>(function.period_word()) + axis;
    text += fmt::format("{}.{} = 0x{:08X}u; ", name_of_parameter(word / 4), "xyzw"[word % 4],
                        static_cast<std::uint32_t>(periods[axis]));
  }
  return text;
}

}  // namespace

std::string declared_evaluate(const Function& function, std::string_view name, std::span<const std::int32_t> periods) {
  const auto parameter = [](std::size_t i) { return fmt::format("hn_uvec4 {}", name_of_parameter(i)); };
  return fmt::format("hn_uvec4 {}({}) {{ {}{} }}\n", name, arguments_of(function, parameter),
                     constant_periods(function, periods), function.body);
}

namespace {

std::string declared_inputs(const Evaluation& evaluation) {
  if (in_buffers(evaluation.profile)) return "";
  std::string text;
  for (std::size_t i = 0; i < evaluation.function.parameters(); ++i) {
    text +=
        fmt::format("uniform {}usampler2D input_{};\n", evaluation.profile.es ? "highp " : "", name_of_parameter(i));
  }
  return text;
}

// Four words of a point.
std::string fetched(const Profile& profile, std::string_view at, std::size_t parameter) {
  if (in_buffers(profile)) return fmt::format("points[{} * {} + {}]", at, kInputWords / 4, parameter);
  return fmt::format("texelFetch(input_{}, {}, 0)", name_of_parameter(parameter), at);
}

// evaluate of the words of a point.
std::string evaluated(const Evaluation& evaluation, std::string_view at) {
  const auto argument = [&](std::size_t i) { return fetched(evaluation.profile, at, i); };
  return fmt::format("evaluate({})", arguments_of(evaluation.function, argument));
}

// evaluate of constants, among them the point at hand. Mesa makes -0 of a choice between the constants 0 and -1.0. The
// function is not at fault, so a number that is 0 there hides the words.
std::string evaluated_constants(const Evaluation& evaluation, std::span<const std::uint32_t> words) {
  const std::string_view number = in_buffers(evaluation.profile) ? "at" : "at.x";
  std::string text = "  result = uvec4(0u, 0u, 0u, 0u);\n  hn_uint hidden;\n";
  for (std::size_t i = 0; i < words.size(); i += kInputWords) {
    const auto part = [&](std::size_t parameter) {
      const auto* const w = &words[i + parameter * 4];
      return fmt::format("uvec4(0x{:08X}u, 0x{:08X}u, 0x{:08X}u, 0x{:08X}u)", w[0], w[1], w[2], w[3]);
    };
    text += fmt::format(
        "  hidden = uint({0} ^ {1});\n  if ({0} == {1}) result = evaluate({2}) ^ uvec4(hidden, hidden, hidden, "
        "hidden);\n",
        number, i / kInputWords, arguments_of(evaluation.function, part));
  }
  return text;
}

// The part of main that sets result.
std::string result_of(const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  switch (evaluation.variant.shape) {
    case Shape::inlined: {
      std::string text;
      for (std::size_t i = 0; i < function.parameters(); ++i) {
        text += fmt::format("  hn_uvec4 {} = {};\n", name_of_parameter(i), fetched(evaluation.profile, "at", i));
      }
      return text + fmt::format("  {}\n", inlined(function.body));
    }
    case Shape::in_loop:
      // The words of the last trips move through the result, so that none can be left out.
      return fmt::format(
          R"(  hn_uvec4 last = uvec4(0u, 0u, 0u, 0u);
  for (hn_int i = 0; i < trips; ++i) {{
    {};
    hn_uvec4 v = {};
    last = uvec4(last.y, last.z, last.w, v.x ^ v.y ^ v.z ^ v.w);
  }}
  result = last;
)",
          in_buffers(evaluation.profile) ? "hn_int other = at ^ i" : "hn_ivec2 other = ivec2(at.x ^ i, at.y)",
          evaluated(evaluation, "other"));
    case Shape::constant:
      return evaluated_constants(evaluation, evaluation.variant.constants);
    case Shape::called:
      break;
  }
  return fmt::format("  result = {};\n", evaluated(evaluation, "at"));
}

// The include of a file, with what another language than GLSL needs around it.
std::string included(std::string_view file, const Profile& profile) {
  const std::string include = fmt::format("#include \"{}\"\n", file);
  if (profile.in_glsl()) return include;
  if (profile.language == Language::metal) {
    return fmt::format("#include <metal_stdlib>\n#include \"begin.metal\"\n{}#include \"end.metal\"\n{}{}", include,
                       kNamesInMetal, kVectorNames);
  }
  return fmt::format("#include \"begin.hlsl\"\n{}#include \"end.hlsl\"\n{}{}", include, kNamesInHlsl, kVectorNames);
}

// glslang knows no GL_ARB_shader_bit_encoding. Where a shader is only compiled, a conversion has the same types.
std::string compiling_preamble(const Profile& profile) {
  return preamble(profile,
                  profile.has_bit_casts() ? kBitCasts : "#define float_of(u) float(u)\n#define bits_of(f) uint(f)\n");
}

}  // namespace

std::string evaluation_shader(const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const StageText of_stage = text_of(stage, profile);
  std::string text = running_preamble(profile) + case_names(evaluation) + of_stage.layout;
  text += fmt::format("{}{}{}{}", knobs_of(configuration), variant.knobs, included(function.file, profile),
                      seeding_of(variant, profile));
  if (variant.shape == Shape::in_loop && !in_buffers(profile)) text += "uniform hn_int trips;\n";
  text += declared_inputs(evaluation) + of_stage.declaration + std::string(variant.declarations);
  if (variant.shape != Shape::inlined) text += declared_evaluate(function, "evaluate", variant.periods);
  return text +
         fmt::format("{} {{\n{}{}{}}}\n", of_stage.head, of_stage.beginning, result_of(evaluation), of_stage.end);
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
                           Stage stage, Callees callees) {
  const StageText of_stage = compiled_text_of(stage, profile.spirv);
  std::string text = compiling_preamble(profile) + of_stage.layout;
  text += fmt::format("{}#include \"{}\"\n#include \"{}\"\n", knobs_of(configuration), file, file);
  const std::vector<const Function*> called = called_from(file, callees);
  std::string calls;
  int count = 0;
  for (const std::string_view seeding : {kSeeded, kUnseeded}) {
    text += fmt::format("#undef SEEDED\n#undef SEED\n{}", seeding);
    for (const Function* const function : called) {
      if (!is_declared(*function, configuration)) continue;
      if (seeding == kUnseeded && !(function->has_unseeded && profile.spirv)) continue;
      const auto argument = [](std::size_t i) { return i == 0 ? std::string("r") : fmt::format("r + {}u", i); };
      const std::string name = fmt::format("evaluate{}", count++);
      text += declared_evaluate(*function, name);
      calls += fmt::format("  r ^= {}({});\n", name, arguments_of(*function, argument));
    }
  }
  return text +
         fmt::format(
             "{}void main() {{\n  hn_uvec4 r = uvec4(uint(HN_VERSION_MAJOR), 2u, 3u, 4u);\n{}  result = r;\n{}}}\n",
             of_stage.declaration, calls, of_stage.end);
}

std::string shader_that_evaluates(const Evaluation& evaluation, std::string_view rest) {
  return fmt::format("{}{}{}{}#include \"{}\"\n{}{}{}{}", running_preamble(evaluation.profile), case_names(evaluation),
                     knobs_of(evaluation.configuration), evaluation.variant.knobs, evaluation.function.file,
                     evaluation.variant.seeded ? kSeeded : kUnseeded, evaluation.variant.declarations,
                     declared_evaluate(evaluation.function, "evaluate", evaluation.variant.periods), rest);
}

}  // namespace hn
