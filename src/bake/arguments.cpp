#include "bake/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "grid/functions.hpp"

namespace hn {
namespace {

// CLI11 takes "nan" and "inf" for numbers.
CLI::Validator finite() {
  return {[](const std::string& text) {
            double number = 0.0;
            const bool right = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
            return right ? std::string() : fmt::format("{} is not a number", text);
          },
          ""};
}

// A whole number. CLI11 takes 010 for 8, so this writes 10 in its place. The rule has to live on, as those of
// rules.hpp do.
CLI::Validator within(const hashnoise::grid::Rule& rule) {
  return {[&rule](std::string& text) {
            double number = 0.0;
            if (!CLI::detail::lexical_cast(text, number) || number != std::floor(number)) {
              return fmt::format("{} is not a whole number {}", text, words_of(rule));
            }
            std::string problem = problem_of(rule, number);
            if (problem.empty()) text = fmt::format("{:.0f}", number);
            return problem;
          },
          ""};
}

constexpr hashnoise::grid::Rule kColumnsRule = {"columns", true, 1, kLongestAxis, hashnoise::grid::kNone};

template <typename T>
void add_number(CLI::App& app, const std::string& name, T& value, const std::string& what) {
  app.add_option(name, value, what)->type_name("NUMBER")->check(finite())->group("Parameters, as in GLSL");
}

// "perlin, simplex": the noises that have it.
std::string noises_with(bool (hashnoise::grid::NoiseRow::*option)() const) {
  return fmt::format("{}", fmt::join(names_where(hashnoise::grid::kNoiseRows, option), ", "));
}

// The sums that have a strength of that name, each with what it is if it is left out.
std::string owners_of(std::string_view strength) {
  std::vector<std::string> sums;
  for (const auto& row : hashnoise::grid::kSumRows) {
    if (row.strength == strength) sums.push_back(fmt::format("{} (default: {})", row.name, row.usual_strength));
  }
  return fmt::format("Of {}", fmt::join(sums, ", "));
}

void add_parameters(CLI::App& app, BakeOptions& options, Words& words) {
  const char* const group = "Parameters, as in GLSL";
  hashnoise::Settings& settings = options.settings;
  app.add_option("--noise", words.noise,
                 "The noise of a fractal (default: that of the function in GLSL, mostly perlin)")
      ->type_name("NAME")
      ->group(group);
  app.add_option("--seed", settings.seed, "Different seeds give independent fields")
      ->type_name("N")
      ->transform(within(hashnoise::grid::kSeedRule))
      ->capture_default_str()
      ->group(group);
  app.add_option("--period", words.period, "Cells after which the field repeats, along each axis or all; 0 for none")
      ->type_name("X[xY...]")
      ->group(group);
  app.add_option("--octaves", static_cast<std::optional<int>&>(settings.octaves),
                 fmt::format("Of a fractal (default: {})", hashnoise::grid::kOctavesRule.usual))
      ->type_name("N")
      ->transform(within(hashnoise::grid::kOctavesRule))
      ->group(group);
  add_number(app, "--lacunarity", settings.lacunarity,
             fmt::format("Of a fractal: by how much an octave is finer than the one before (default: {})",
                         hashnoise::grid::kLacunarityRule.usual));
  add_number(app, "--gain", settings.gain,
             fmt::format("Of a fractal: by how much an octave is weaker, a factor (default: {})",
                         hashnoise::grid::kGainRule.usual));
  add_number(app, "--strength", settings.strength, owners_of("strength"));
  add_number(app, "--amplitude", settings.amplitude, owners_of("amplitude") + ", in cells");
  add_number(app, "--detail", settings.detail, "Of fbm: octaves as a number with a fraction, in place of --octaves");
  add_number(app, "--footprint", settings.footprint, "Of fbm: the size of a pixel, in cells, which fades octaves out");
  app.add_option("--wave", words.wave,
                 fmt::format("Of {}: the direction in which waves run, times the waves per cell, as in 2.5x-1.5; each "
                             "{} (default: 3 along x)",
                             noises_with(&hashnoise::grid::NoiseRow::has_wave), words_of(hashnoise::grid::kWaveRule)))
      ->type_name("X[xY...]")
      ->group(group);
  add_number(app, "--phase", settings.phase,
             fmt::format("In turns; of {} in 2D and 3D", noises_with(&hashnoise::grid::NoiseRow::has_phase)));
  add_number(app, "--jitter", settings.jitter,
             fmt::format("Of cellular noises: how far points are from the centres of their cells (default: {})",
                         hashnoise::grid::kJitterRule.usual));
  app.add_option("--metric", words.metric,
                 fmt::format("Of {}: {}; the default is the first", noises_with(&hashnoise::grid::NoiseRow::has_metric),
                             fmt::join(hashnoise::grid::kMetricNames, ", ")))
      ->type_name("NAME")
      ->group(group);
  app.add_option("--arithmetic", words.arithmetic,
                 "fixed, precise or fast. The default has the same bits on every machine, and those of shaders with "
                 "HN_FIXED")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(group);
}

void add_expression(CLI::App& app, Words& words) {
  const char* const group = "In place of a function";
  app.add_option("--expression", words.expression,
                 "GLSL, a float or a vec2 to vec4, as in 'hn_fbm(place, 6, 2.0, 0.5, seed) - 0.3 * hn_cellular(p, "
                 "3u).x'. It has p, the position in cells (float to vec4, as --size has numbers); place, where p is "
                 "exactly and in the period; period, an int to ivec4, 0 for none; and seed, a uint")
      ->type_name("GLSL")
      ->group(group);
  app.add_option("--source", words.source, "A file of GLSL with functions that the expression calls")
      ->type_name("FILE")
      ->group(group);
}

void add_places(CLI::App& app, BakeOptions& options, Words& words) {
  const char* const group = "Places";
  app.add_option("--size", words.size, "Points along each axis: one number to four, and as many dimensions")
      ->type_name("X[xY...]")
      ->capture_default_str()
      ->group(group);
  app.add_option("--cells", words.cells,
                 "Cells along each axis; one number is for x, and cells are as large along the others")
      ->type_name("X[xY...]")
      ->capture_default_str()
      ->group(group);
  app.add_option("--origin", words.origin, "The first point, in cells (default: 0 along each axis)")
      ->type_name("X[xY...]")
      ->group(group);
  app.add_flag("--tile", options.tile, "Make the cells the period, so that the file repeats without a seam")
      ->group(group);
}

void add_files(CLI::App& app, BakeOptions& options, Words& words) {
  const char* const group = "The file";
  app.add_option("-o,--out", options.out, "The file")->type_name("FILE")->required()->group(group);
  app.add_option("--format", words.format,
                 "png (16 bits), exr (floats), f32 or r16 (planes of floats or of 16 bits, little-endian, without a "
                 "header), ktx2 or ktx2-float (a texture of 16 bits or of floats); by default the ending of the file's "
                 "name")
      ->type_name("NAME")
      ->group(group);
  app.add_option("--components", options.components, "Which, as in f1,f2; all by default")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group(group);
  app.add_option("--range", words.ranges,
                 "The values that become 0 and 65535; by default the range that the function documents. Once for all "
                 "components, or once for each")
      ->type_name("LEAST:GREATEST")
      ->allow_extra_args(false)
      ->group(group);
  app.add_flag("--normalize", options.normalize, "Map what is there to 0 to 65535, each component by itself")
      ->group(group);
  app.add_option("--layout", words.layout,
                 "Of a volume as a picture: atlas, one picture (the default), or slices, a file for each")
      ->type_name("NAME")
      ->check(CLI::IsMember({"atlas", "slices"}))
      ->group(group);
  app.add_option("--columns", options.columns,
                 "Slices beside each other in an atlas (default: so that it is about a square)")
      ->type_name("N")
      ->transform(within(kColumnsRule))
      ->group(group);
  app.add_flag("--json", options.json, "Print in JSON how it was made")->group(group);
  app.add_option("--threads", options.threads, "How many; nothing in the file depends on it (default: all)")
      ->type_name("N")
      ->transform(within(hashnoise::grid::kThreadsRule))
      ->group(group);
  app.add_option(
         "--instruction-set", words.instruction_set,
         "An instruction set such as avx2 (default: the widest that the processor has); only with --arithmetic fast "
         "values depend on it")
      ->type_name("NAME")
      ->group(group);
}

}  // namespace

void add_options(CLI::App& app, BakeOptions& options, Words& words) {
  app.add_option(
         "FUNCTION", options.function,
         "A noise (perlin, cellular, ...) or a fractal (fbm, ridged, ...), as in GLSL without hn_; or an --expression")
      ->type_name("");
  add_expression(app, words);
  add_parameters(app, options, words);
  add_places(app, options, words);
  add_files(app, options, words);
}

}  // namespace hn
