#include "bench/subject.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "bench/files.hpp"

namespace hn {
namespace {

// One float of whatever an expression is. The parts of a vector are added up, so that none of them is idle.
constexpr std::string_view kValueOf = R"(
float hn_bench_value(float v) { return v; }
float hn_bench_value(int v) { return intBitsToFloat(v); }
float hn_bench_value(uint v) { return uintBitsToFloat(v); }
float hn_bench_value(ivec2 v) { return intBitsToFloat(v.x ^ v.y); }
float hn_bench_value(ivec3 v) { return intBitsToFloat(v.x ^ v.y ^ v.z); }
float hn_bench_value(ivec4 v) { return intBitsToFloat(v.x ^ v.y ^ v.z ^ v.w); }
float hn_bench_value(vec2 v) { return v.x + v.y; }
float hn_bench_value(vec3 v) { return v.x + v.y + v.z; }
float hn_bench_value(vec4 v) { return v.x + v.y + v.z + v.w; }
#ifdef HN_ARITHMETIC_GLSL
float hn_bench_value(hn_derivatives4 n) { return n.value + hn_bench_value(n.gradient); }
float hn_bench_value(hn_derivatives2x2 n) { return hn_bench_value(n.value + n.dx + n.dy); }
float hn_bench_value(hn_derivatives2x3 n) { return hn_bench_value(n.value + n.dx + n.dy + n.dz); }
float hn_bench_value(hn_derivatives3x3 n) { return hn_bench_value(n.value + n.dx + n.dy + n.dz); }
#endif
// The outputs of functions.
ivec2 hn_bench_cell2;
ivec3 hn_bench_cell3;
vec2 hn_bench_offset2;
vec3 hn_bench_offset3;
)";

std::string function_of_subject(const Subject& subject) {
  return fmt::format("{}{}float hn_bench(vec{} p) {{ return hn_bench_value({}); }}\n", subject.prelude, kValueOf,
                     subject.dimensions, subject.expression);
}

std::string_view position(const Subject& subject) { return subject.dimensions == 2 ? "coordinate.xy" : "coordinate"; }

}  // namespace

Subject empty_subject(int dimensions) {
  return {fmt::format("empty{}", dimensions), dimensions, "", dimensions == 2 ? "p.x + p.y" : "p.x + p.y + p.z"};
}

Subject float_subject(int dimensions) {
  return {fmt::format("table.float{}", dimensions), dimensions,
          "#define TABLE_ARITHMETIC 1\n#include \"tables.glsl\"\n", "table_perlin(p)"};
}

Subject integer_subject(int dimensions) {
  return {fmt::format("table.integer{}", dimensions), dimensions,
          "#define TABLE_ARITHMETIC 2\n#include \"tables.glsl\"\n", "table_perlin(p)"};
}

std::string subject_id(const Function& function, const Configuration& configuration) {
  return fmt::format("{}.{}", function.id, function.family == Family::independent ? "any" : configuration.name);
}

std::vector<Subject> library_subjects(const Configuration& configuration) {
  std::vector<Subject> subjects;
  for (const Function& function : all_functions()) {
    // A row without a call is measured by another, which calls the same.
    if (!covers(configuration, function) || function.call.empty()) continue;
    subjects.push_back({subject_id(function, configuration), function.axes < 3 ? 2 : 3,
                        fmt::format("{}#include \"{}\"\n", knobs_of(configuration), function.file),
                        std::string(function.call), main_profile(configuration, false).name});
  }
  return subjects;
}

std::vector<Subject> library_subjects() {
  std::vector<Subject> subjects;
  for (const Configuration& configuration : all_configurations()) {
    for (Subject& subject : library_subjects(configuration)) subjects.push_back(std::move(subject));
  }
  // A noise of the user's own, which costs nothing: what is left is the sum itself.
  for (const int dimensions : {2, 3}) {
    subjects.push_back(
        {fmt::format("fbm.fbm{}.own_noise", dimensions), dimensions,
         fmt::format("#include \"fbm{0}d.glsl\"\n"
                     "float own_fbm(hn_octaves{0} o) {{\n"
                     "  do hn_add(o, hn_position(o.place).x - float(o.place.cell.x)); while (hn_next(o));\n"
                     "  return hn_mean(o);\n"
                     "}}\n",
                     dimensions),
         "own_fbm(hn_octaves(p, 6, 2.0, 0.5, 0u))"});
  }
  return subjects;
}

Subject foreign_subject(std::string_view name, std::string_view file, std::string_view expression, int dimensions,
                        std::string_view profile) {
  // A function of our own insists on a float. GLSL would make one of a whole number.
  constexpr std::string_view kOnlyFloat =
      "vec4 hn_bench_set;\n"  // for what the function sets
      "struct hn_bench_no_float { int bits; };\n"
      "float hn_bench_float(float v) { return v; }\n"
      "hn_bench_no_float hn_bench_float(int v) { return hn_bench_no_float(v); }\n"
      "hn_bench_no_float hn_bench_float(uint v) { return hn_bench_no_float(int(v)); }\n";
  return {fmt::format("{}{}", name, dimensions), dimensions,
          fmt::format("#include \"{}\"\n{}float hn_bench_foreign(vec{} p) {{\n  return hn_bench_float({}\n  );\n}}\n",
                      file, kOnlyFloat, dimensions, expression),
          "hn_bench_foreign(p)", profile};
}

std::string quad_shader(const Subject& subject) {
  // The subject's text comes first: a foreign file may have #extension lines.
  return fmt::format(R"({}#ifdef VULKAN
layout(location = 0) in vec3 coordinate;
layout(location = 0) out vec4 result;
#else
in vec3 coordinate;
out vec4 result;
#endif
void main() {{ result = vec4(vec3(hn_bench({}) * 0.5 + 0.5), 1.0); }}
)",
                     function_of_subject(subject), position(subject));
}

std::string loop_shader(const Subject& subject) {
  return fmt::format(R"({}in vec3 coordinate;
out vec4 result;
uniform int iterations;
void main() {{
  uint sum = 0u;
  vec3 at = coordinate;
  for (int i = 0; i < iterations; ++i) {{
    sum ^= floatBitsToUint(hn_bench(at{}));
    at += vec3(5.3125, 3.4375, 2.1875);
  }}
  result = vec4(float(sum & 0xFFFFu) / 65535.0);
}}
)",
                     function_of_subject(subject), subject.dimensions == 2 ? ".xy" : "");
}

std::string value_shader(const Subject& subject) {
  return fmt::format(R"(uniform usampler2D input_a;
out uvec4 result;
{}void main() {{
  vec3 coordinate = uintBitsToFloat(texelFetch(input_a, ivec2(gl_FragCoord.xy), 0).xyz);
  result = uvec4(floatBitsToUint(hn_bench({})), 0u, 0u, 0u);
}}
)",
                     function_of_subject(subject), position(subject));
}

std::string quad_vertex_shader() {
  return fmt::format(R"(out vec3 coordinate;
void main() {{
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
  coordinate = vec3(corner * {:.1f} + 40.0, corner.x * 4.0 - corner.y * 4.0 + 20.0);
}}
)",
                     kQuadCells / 2.0);
}

SourceSet with_comparison_shaders(SourceSet sources) {
  for (const std::string_view name : {"tables.glsl", "perlin.glsl"}) {
    sources.add(std::string(name), std::string(text_of(kBenchFiles, name)), fmt::format("conformance/bench/{}", name));
  }
  return sources;
}

}  // namespace hn
