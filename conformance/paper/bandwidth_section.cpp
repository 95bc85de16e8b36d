// Compares hash noise with table noise in a shader that memory holds up, which the paper leaves for later: it sweeps
// over the number of further fetches, from a texture far larger than the caches.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/number.hpp"
#include "output/svg.hpp"
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

// The noise of a pixel and as many fetches as "iterations" says. Neighbours fetch neighbouring texels, as shaders do,
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

  double seconds(std::size_t i) const { return timings[i].median(); }
};

std::vector<Curve> curves_of(int dimensions) {
  const auto entry = [](std::string_view name, Form form) { return Entry{&algorithm_named(name), form}; };
  std::vector<Curve> curves;
  curves.push_back({"fetches alone", empty_subject(dimensions), {}, {}});
  curves.push_back({"Perlin/Float", subject_of(entry("float", Form::table), dimensions), {}, {}});
  curves.push_back({"Perlin/Integer", subject_of(entry("integer", Form::table), dimensions), {}, {}});
  curves.push_back({"PartialFNV1, ours", subject_of(entry("partial_fnv1", Form::ours), dimensions), {}, {}});
  curves.push_back({"hashnoise's default", subject_of(entry("lattice", Form::ours), dimensions), {}, {}});
  return curves;
}

// A line through the last three points, and where it meets the time without fetches: there the curve bends, if it does.
struct Bend {
  double seconds_per_fetch = 0.0;
  double at = 0.0;  // fetches
  Ratio left_over;  // how much of the noise's own time is still to be seen with the most fetches: 1 is all of it
};

Bend bend_of(const Curve& curve, const Curve& alone) {
  const std::size_t last = kFetches.size() - 1;
  Bend bend;
  bend.seconds_per_fetch = (curve.seconds(last) - curve.seconds(last - 2)) / (kFetches[last] - kFetches[last - 2]);
  const double at_zero = curve.seconds(last) - bend.seconds_per_fetch * kFetches[last];
  bend.at = bend.seconds_per_fetch > 0.0 ? std::max((curve.seconds(0) - at_zero) / bend.seconds_per_fetch, 0.0) : 0.0;
  Timing left;
  for (std::size_t i = 0; i < curve.timings[0].samples.size(); ++i) {
    const double own = curve.timings[0].samples[i] - alone.timings[0].samples[i];
    if (own > 0.0) left.samples.push_back((curve.timings[last].samples[i] - alone.timings[last].samples[i]) / own);
  }
  bend.left_over = {left.median(), left.spread()};
  return bend;
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

bool is_software(const Laboratory& laboratory) {
  const std::string renderer = describe(laboratory.context).renderer;
  constexpr std::array<std::string_view, 4> kSoftware = {"llvmpipe", "softpipe", "SwiftShader", "lavapipe"};
  return std::any_of(kSoftware.begin(), kSoftware.end(),
                     [&](std::string_view name) { return renderer.find(name) != std::string::npos; });
}

std::string plot(const std::vector<Curve>& curves, int dimensions) {
  std::vector<Series> series;
  const double unit = curves[1].seconds(0);  // Perlin/Float without fetches
  for (const Curve& curve : curves) {
    Series one{curve.name, {}, {}};
    for (std::size_t i = 0; i < kFetches.size(); ++i) {
      one.x.push_back(kFetches[i]);
      one.y.push_back(curve.seconds(i) / unit);
    }
    series.push_back(std::move(one));
  }
  return line_plot(
      {fmt::format("{}D noise with further fetches", dimensions),
       fmt::format("fetches per pixel from {} MiB", kMegabytes), "time, as a multiple of Perlin/Float without them"},
      series);
}

void add_curves(Section& section, Section::Csv& csv, const std::vector<Curve>& curves, int dimensions) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Curve& curve : curves) {
    const Bend bend = bend_of(curve, curves.front());
    const bool alone = &curve == &curves.front();
    nlohmann::json milliseconds = nlohmann::json::array();
    for (std::size_t i = 0; i < kFetches.size(); ++i) {
      milliseconds.push_back(curve.seconds(i) * 1e3);
      csv.rows.push_back({curve.name, fmt::format("{}", dimensions), fmt::format("{}", kFetches[i]),
                          fmt::format("{:.5g}", curve.seconds(i) * 1e3)});
    }
    section.data["curves"].push_back({{"name", curve.name},
                                      {"dimensions", dimensions},
                                      {"milliseconds", milliseconds},
                                      {"bends_at_fetches", bend.at},
                                      {"milliseconds_per_fetch", bend.seconds_per_fetch * 1e3},
                                      {"share_of_noise_left_at_most_fetches", bend.left_over.value},
                                      {"spread_of_that_share", bend.left_over.spread}});
    rows.push_back({{"name", curve.name},
                    {"milliseconds", three_digits(curve.seconds(0) * 1e3)},
                    {"per_fetch", three_digits(bend.seconds_per_fetch * 1e3)},
                    {"bend", fmt::format("{:.1f}", bend.at)},
                    {"left_over", alone ? "no noise"
                                        : fmt::format("{:.0f} ± {:.0f} %", bend.left_over.value * 100.0,
                                                      bend.left_over.spread * 100.0)}});
  }
  section.page["sweeps"].push_back({{"dimensions", dimensions}, {"plot", plot(curves, dimensions)}, {"rows", rows}});
}

}  // namespace

Result<Section> measure_bandwidth(Laboratory& laboratory) {
  Section section;
  section.data = {{"fetches", kFetches},
                  {"width", kWidth},
                  {"height", kHeight},
                  {"texture_bytes", std::size_t{kTextureSide} * kTextureSide * 16},
                  {"curves", nlohmann::json::array()}};
  section.page = {{"software", is_software(laboratory)},
                  {"most", kFetches.back()},
                  {"megabytes", kMegabytes},
                  {"absent", false},
                  {"sweeps", nlohmann::json::array()}};
  GLint most = 0;
  laboratory.context.gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (most < kTextureSide) {
    section.page["absent"] =
        fmt::format("this driver has textures of {} texels at most; the sweep needs {}", most, kTextureSide);
    section.data["absent"] = section.page["absent"];
    return section;
  }
  const LargeTexture texture(laboratory.context.gl());
  Section::Csv csv{"bandwidth.csv", {"noise", "dimensions", "fetches", "milliseconds"}, {}};
  for (const int dimensions : {2, 3}) {
    HN_TRY(const auto curves, sweep(laboratory, dimensions));
    add_curves(section, csv, curves, dimensions);
  }
  section.csv.push_back(std::move(csv));
  return section;
}

}  // namespace hn
