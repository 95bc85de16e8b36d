// Compares hash noise with table noise in a shader that memory holds up, which the paper leaves for later: it sweeps
// over the number of further fetches, from a texture far larger than the caches.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "paper/laboratory.hpp"

namespace hn {
namespace {

// Tiles of this size fill the texture, so that as many fetches as there are tiles read each texel once.
constexpr int kWidth = 1024;
constexpr int kHeight = 512;
constexpr int kTextureSide = 4096;  // of 16 bytes each: 256 MiB, more than the caches of all but a few GPUs
constexpr int kMegabytes = kTextureSide / 1024 * kTextureSide * 16 / 1024;
constexpr int kAcross = kTextureSide / kWidth;
constexpr int kTiles = kAcross * (kTextureSide / kHeight);
constexpr int kTextureUnit = 10;  // behind those of the tables
constexpr std::array kFetches = {0, 1, 2, 4, 8, 16, 32};
static_assert(kFetches.back() <= kTiles);

class LargeTexture {
 public:
  explicit LargeTexture(const GladGLContext& gl) : gl_(gl) {
    // Different bytes everywhere: pages and blocks that are all the same may be stored once.
    std::vector<float> texels(std::size_t{kTextureSide} * kTextureSide * 4);
    std::uint32_t state = 1;
    for (float& value : texels) {
      state = state * 1664525u + 1013904223u;  // Numerical Recipes' generator: any will do
      value = static_cast<float>(state >> 8) * 0x1p-24f;
    }
    gl_.ActiveTexture(GL_TEXTURE0 + kTextureUnit);
    gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kTextureSide, kTextureSide, 0, GL_RGBA, GL_FLOAT, texels.data());
  }
  ~LargeTexture() { gl_.DeleteTextures(1, &texture_); }
  LargeTexture(const LargeTexture&) = delete;
  LargeTexture& operator=(const LargeTexture&) = delete;

 private:
  const GladGLContext& gl_;
  GLuint texture_ = 0;
};

// The noise of a pixel and as many fetches as "iterations" holds. Neighbours fetch neighbouring texels, as shaders do,
// but no texel is fetched twice in a draw, and each draw starts elsewhere.
std::string sweep_shader(const Subject& subject) {
  std::string text = loop_shader(subject);
  const auto start = text.find("void main()");
  return text.substr(0, start) + fmt::format(R"(uniform sampler2D memory;
uniform int draw_number;
void main() {{
  vec4 sum = vec4(hn_bench(coordinate{}));
  for (int i = 0; i < iterations; ++i) {{
    int tile = (i + draw_number * 7) % {};
    sum += texelFetch(memory, ivec2(gl_FragCoord.xy) + ivec2(tile % {}, tile / {}) * ivec2({}, {}), 0);
  }}
  result = sum * (1.0 / 64.0);
}}
)",
                                             subject.dimensions == 2 ? ".xy" : "", kTiles, kAcross, kAcross, kWidth,
                                             kHeight);
}

struct Curve {
  std::string name;
  Subject subject;
  std::optional<Program> program;
  std::vector<Timing> timings;  // one per number of fetches
};

std::vector<Curve> curves_of(int dimensions) {
  const auto entry = [](std::string_view name, AlgorithmForm form) { return Entry{&algorithm_named(name), form}; };
  std::vector<Curve> curves;
  curves.push_back({"fetches alone", empty_subject(dimensions), {}, {}});
  curves.push_back({"Perlin/Float", subject_of(entry("float", AlgorithmForm::table), dimensions), {}, {}});
  curves.push_back({"Perlin/Integer", subject_of(entry("integer", AlgorithmForm::table), dimensions), {}, {}});
  curves.push_back({"PartialFNV1, ours", subject_of(entry("partial_fnv1", AlgorithmForm::ours), dimensions), {}, {}});
  curves.push_back({"hashnoise's default", subject_of(entry("lattice", AlgorithmForm::ours), dimensions), {}, {}});
  return curves;
}

Result<std::vector<Curve>> sweep(Laboratory& laboratory, int dimensions) {
  std::vector<Curve> curves = curves_of(dimensions);
  std::vector<Workload> workloads;
  for (Curve& curve : curves) {
    auto program = laboratory.build(sweep_shader(curve.subject));
    if (!program) return fail(fmt::format("{}: {}", curve.name, program.error().message), program.error().log);
    const GladGLContext& gl = laboratory.context.gl();
    gl.UseProgram(program->id());
    gl.Uniform1i(gl.GetUniformLocation(program->id(), "memory"), kTextureUnit);
    curve.program = std::move(*program);
    for (const int fetches : kFetches) workloads.push_back({&*curve.program, kWidth, kHeight, fetches});
  }
  HN_TRY(auto timings, laboratory.stopwatch.measure(workloads, std::min(laboratory.rounds, 5)));
  for (std::size_t i = 0; i < timings.size(); ++i) curves[i / kFetches.size()].timings.push_back(std::move(timings[i]));
  return curves;
}

}  // namespace

Result<Section> measure_bandwidth(Laboratory& laboratory) {
  Section section{"bandwidth",
                  {{"texture", fmt::format("{} MiB", kMegabytes)}},
                  {"noise", "dimensions", "fetches", "milliseconds", "spread"}};
  GLint most = 0;
  laboratory.context.gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (most < kTextureSide) {
    section.facts.emplace_back(
        "not measured",
        fmt::format("this driver has textures of {} texels at most; the sweep needs {}", most, kTextureSide));
    return section;
  }
  const LargeTexture texture(laboratory.context.gl());
  for (const int dimensions : {2, 3}) {
    HN_TRY(const auto curves, sweep(laboratory, dimensions));
    for (const Curve& curve : curves) {
      for (std::size_t i = 0; i < kFetches.size(); ++i) {
        section.rows.push_back({curve.name, fmt::format("{}", dimensions), fmt::format("{}", kFetches[i]),
                                fmt::format("{:.5g}", curve.timings[i].median() * 1e3),
                                fmt::format("{:.2g}", curve.timings[i].spread() * 1e3)});
      }
    }
  }
  return section;
}

}  // namespace hn
