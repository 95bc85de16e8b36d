#include "bake/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <hashnoise/detail/closest.hpp>
#include <numeric>
#include <utility>

#include "bake/arguments.hpp"
#include "base/result.hpp"
#include "base/strings.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "grid/functions.hpp"
#include "grid/rules.hpp"

namespace hn {
namespace {

using hashnoise::detail::suggestion;

constexpr double kMostCells = 1 << 30;  // so that positions fit into 64 bits, in units of 2^-32

constexpr std::array kFormats = {
    std::pair{Format::png, std::string_view("png")},   std::pair{Format::exr, std::string_view("exr")},
    std::pair{Format::f32, std::string_view("f32")},   std::pair{Format::r16, std::string_view("r16")},
    std::pair{Format::ktx2, std::string_view("ktx2")}, std::pair{Format::ktx2_float, std::string_view("ktx2-float")}};

// A number and nothing behind it.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(number)) return std::nullopt;
  }
  return number;
}

// "1024x512": a number for each axis.
template <typename Number>
Result<std::vector<Number>> axes_of(std::string_view option, std::string_view text, Number least, Number most,
                                    std::string_view example) {
  std::vector<Number> numbers;
  for (const std::string_view part : split(text, 'x')) {
    const auto number = number_of<Number>(part);
    if (!number || *number < least || *number > most) {
      return fail(fmt::format("{} {}: {} is not a number from {} to {}; it wants one for each axis, as in {}", option,
                              in_quotes(text), in_quotes(part), least, most, example));
    }
    numbers.push_back(*number);
  }
  if (numbers.size() > 4) return fail(fmt::format("{} {}: there are at most four axes", option, in_quotes(text)));
  return numbers;
}

std::string dimensions_of(const std::vector<int>& size) { return fmt::format("{}D", size.size()); }

std::vector<std::string> texts_of(const std::vector<std::string_view>& names) { return {names.begin(), names.end()}; }

// A hint for a word that is none of the names.
std::string choice(std::string_view word, const std::vector<std::string>& names) {
  return fmt::format("{}; there are {}", suggestion(word, names), fmt::join(names, ", "));
}

bool has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::ranges::count(names, name) != 0;
}

// The noise of a sum whose noise is not named is that of the function in GLSL.
std::string noise_of(std::string_view sum) {
  return std::string(hashnoise::grid::kNoiseRows[hashnoise::grid::sum_row(sum).usual_noise].name);
}

// An expression names its noises itself, and with them all that noises and sums have.
Result<void> choose_expression(BakeOptions& options, const Words& words) {
  if (!options.function.empty()) {
    return fail(fmt::format("{} is one argument too many: --expression stands in place of a function",
                            in_quotes(options.function)));
  }
  const hashnoise::Settings& settings = options.settings;
  const std::pair<std::string_view, bool> given[] = {{"--noise", words.noise.has_value()},
                                                     {"--octaves", settings.octaves.has_value()},
                                                     {"--lacunarity", settings.lacunarity.has_value()},
                                                     {"--gain", settings.gain.has_value()},
                                                     {"--strength", settings.strength.has_value()},
                                                     {"--amplitude", settings.amplitude.has_value()},
                                                     {"--detail", settings.detail.has_value()},
                                                     {"--footprint", settings.footprint.has_value()},
                                                     {"--wave", words.wave.has_value()},
                                                     {"--phase", settings.phase.has_value()},
                                                     {"--jitter", settings.jitter.has_value()},
                                                     {"--metric", words.metric.has_value()},
                                                     {"--instruction-set", words.instruction_set.has_value()}};
  for (const auto& [option, is_given] : given) {
    if (!is_given) continue;
    return fail(fmt::format("{} is for a function; {}", option,
                            option == "--instruction-set"
                                ? "an expression is compiled for every processor of this kind"
                                : "write it into the --expression, as in hn_fbm(p, 6, 2.0, 0.5)"));
  }
  options.function = "expression";
  options.expression = Expression{*words.expression, words.source.value_or("")};
  return {};
}

Result<void> choose_function(BakeOptions& options, const Words& words) {
  if (words.expression) return choose_expression(options, words);
  if (words.source) return fail("--source has functions for an --expression, and there is none");
  if (options.function.empty()) {
    return fail("a function is missing, such as fbm, or an --expression; see --help");
  }
  const std::optional<std::string>& noise = words.noise;
  const int dimensions = static_cast<int>(options.size.size());
  const auto noises = hashnoise::noises(dimensions);
  const auto sums = hashnoise::fractals(dimensions);
  if (has(sums, options.function)) {
    options.settings.fractal = options.function;
    if (!hashnoise::grid::sum_row(options.function).takes_noise()) {
      if (!noise) return {};
      return fail(fmt::format("--noise: the fractal {} has noises of its own; leave it out", options.function));
    }
    options.settings.noise = noise.value_or(noise_of(options.function));
    if (has(noises, options.settings.noise)) return {};
    return fail(fmt::format("--noise: there is no noise {} in {}{}", in_quotes(options.settings.noise),
                            dimensions_of(options.size), choice(options.settings.noise, texts_of(noises))));
  }
  if (!has(noises, options.function)) {
    auto names = texts_of(noises);
    names.insert(names.end(), sums.begin(), sums.end());
    return fail(fmt::format("there is no noise or fractal {} in {}{}", in_quotes(options.function),
                            dimensions_of(options.size), choice(options.function, names)));
  }
  if (noise) {
    return fail(fmt::format("--noise is for a fractal, and {} is a noise itself; the fractals are {}", options.function,
                            fmt::join(sums, ", ")));
  }
  options.settings.noise = options.function;
  return {};
}

// One number stands for the first axis; the cells are as large along the others.
Result<void> choose_cells(BakeOptions& options, const std::string& text) {
  HN_TRY(options.cells, axes_of("--cells", text, 0.0, kMostCells, "8x4"));
  if (options.cells.size() == 1) {
    const double size = options.cells.front() / options.size.front();
    for (std::size_t axis = 1; axis < options.size.size(); ++axis) options.cells.push_back(size * options.size[axis]);
  }
  if (options.cells.size() != options.size.size()) {
    return fail(fmt::format("--cells {} has {} axes, and --size has {}; give one number for each, or one for all",
                            in_quotes(text), options.cells.size(), options.size.size()));
  }
  for (const double cells : options.cells) {
    if (!(cells > 0.0 && cells <= kMostCells)) {
      return fail(fmt::format("--cells {}: {} along an axis is not more than 0 and at most {}", in_quotes(text), cells,
                              kMostCells));
    }
  }
  return {};
}

Result<void> choose_tile(BakeOptions& options, const std::optional<std::string>& period) {
  using hashnoise::grid::kPeriodRule;
  auto& periods = options.settings.period;
  if (period) {
    HN_TRY(auto given, axes_of("--period", *period, static_cast<int>(kPeriodRule.least),
                               static_cast<int>(kPeriodRule.most), "8x8"));
    if (given.size() == 1) given.resize(options.size.size(), given.front());
    if (given.size() != options.size.size()) {
      return fail(
          fmt::format("--period {} has {} axes, and --size has {}; give one number for each, 0 for an axis "
                      "without a period, or one for all",
                      in_quotes(*period), given.size(), options.size.size()));
    }
    std::ranges::copy(given, periods.begin());
  }
  if (!options.tile) return {};
  if (period)
    return fail("--tile makes the cells of the picture the period, and --period names another; leave one out");
  for (std::size_t axis = 0; axis < options.cells.size(); ++axis) {
    const double cells = options.cells[axis];
    if (cells != std::floor(cells)) {
      return fail(
          fmt::format("--tile wants whole numbers of cells, and along axis {} there are {}; name them all, as in "
                      "--cells {}",
                      "xyzw"[axis], cells, fmt::join(std::vector<int>(options.size.size(), 8), "x")));
    }
    periods[axis] = static_cast<std::int32_t>(cells);
  }
  return {};
}

Result<void> choose_origin(BakeOptions& options, const std::optional<std::string>& text) {
  options.origin.assign(options.size.size(), 0.0);
  if (!text) return {};
  HN_TRY(options.origin, axes_of("--origin", *text, -kMostCells, kMostCells, "1000000x-3.5"));
  if (options.origin.size() == options.size.size()) return {};
  return fail(fmt::format("--origin {} has {} axes, and --size has {}; give one number for each", in_quotes(*text),
                          options.origin.size(), options.size.size()));
}

// The form is that of --origin, which has numbers with signs, too. The field knows which function has a wave.
Result<void> choose_wave(BakeOptions& options, const std::optional<std::string>& text) {
  using hashnoise::grid::kWaveRule;
  if (!text) return {};
  HN_TRY(const auto wave, axes_of("--wave", *text, kWaveRule.least, kWaveRule.most, "2.5x-1.5"));
  if (wave.size() != options.size.size()) {
    return fail(fmt::format("--wave {} has {} axes, and --size has {}; give one number for each", in_quotes(*text),
                            wave.size(), options.size.size()));
  }
  for (const double along : wave) options.settings.wave.push_back(static_cast<float>(along));
  return {};
}

Result<void> choose_format(BakeOptions& options, const std::string& format) {
  std::string name = format;
  if (name.empty()) {
    name = options.out.extension().string();
    name.erase(0, std::min<std::size_t>(name.size(), 1));
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  }
  for (const auto& [known, its_name] : kFormats) {
    if (name != its_name) continue;
    options.format = known;
    return {};
  }
  if (!format.empty())
    return fail(
        fmt::format("--format: there is no {}; there are png, exr, f32, r16, ktx2 and ktx2-float", in_quotes(format)));
  return fail(
      fmt::format("--out {}: the name does not state the format{}; end it with .png, .exr, .f32, .r16 or .ktx2, or "
                  "give --format png, exr, f32 (planes of floats), r16 (planes of 16 bits), ktx2 or ktx2-float",
                  in_quotes(options.out.string()),
                  name == "raw" ? ", since some programs take 16 bits for .raw and others floats" : ""));
}

Result<void> choose_ranges(BakeOptions& options, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    const auto least = number_of<double>(std::string_view(text).substr(0, colon));
    const auto greatest =
        colon == std::string::npos ? std::nullopt : number_of<double>(std::string_view(text).substr(colon + 1));
    if (!least || !greatest || !(*least < *greatest)) {
      return fail(
          fmt::format("--range {}: it wants two numbers, the smaller one first, as in --range -1:1", in_quotes(text)));
    }
    if (!std::isfinite(*greatest - *least)) {
      return fail(
          fmt::format("--range {}: its ends are too far apart; values are floats, of 3.4e38 at most", in_quotes(text)));
    }
    options.ranges.push_back({*least, *greatest});
  }
  if (options.normalize && !options.ranges.empty()) {
    return fail("--normalize finds the range, and --range names it; leave one out");
  }
  if (!has_16_bits(options.format) && (options.normalize || !options.ranges.empty())) {
    return fail(fmt::format("{} is for 16 bits; {} holds the values as they are",
                            options.normalize ? "--normalize" : "--range", name_of(options.format)));
  }
  if (options.expression && has_16_bits(options.format) && !options.normalize && options.ranges.empty()) {
    return fail(
        fmt::format("no range is documented for an expression, and {} has 16 bits; name one with --range "
                    "LEAST:GREATEST, let --normalize find it, or write floats: .exr, .f32 or --format ktx2-float",
                    name_of(options.format)));
  }
  return {};
}

Result<void> choose_layout(BakeOptions& options, const std::string& layout) {
  if (layout.empty() && options.columns == 0) return {};
  const bool is_picture = options.format == Format::png || options.format == Format::exr;
  if (!is_picture || options.size.size() < 3) {
    return fail(fmt::format("{} is for volumes in pictures: a --size of three or four axes, as PNG or EXR",
                            layout.empty() ? "--columns" : "--layout"));
  }
  options.layout = layout == "slices" ? Layout::slices : Layout::atlas;
  if (options.columns != 0 && options.layout == Layout::slices) return fail("--columns is for --layout atlas");
  return {};
}

// Metrics, arithmetics and instruction sets by their names.
template <typename T>
Result<T> chosen(std::string_view option, std::string_view word, const std::vector<std::pair<std::string, T>>& table) {
  std::vector<std::string> names;
  for (const auto& [name, value] : table) {
    if (name == word) return value;
    names.push_back(name);
  }
  return fail(fmt::format("{}: there is no {}{}", option, in_quotes(word), choice(word, names)));
}

Result<void> interpret(BakeOptions& options, const Words& words) {
  using namespace hashnoise;
  HN_TRY(options.size, axes_of("--size", words.size, 1, kLongestAxis, "1024x1024, or 128x128x64 for a volume"));
  HN_DO(choose_function(options, words));
  HN_DO(choose_cells(options, words.cells));
  HN_DO(choose_tile(options, words.period));
  HN_DO(choose_origin(options, words.origin));
  HN_DO(choose_wave(options, words.wave));
  HN_DO(choose_format(options, words.format));
  HN_DO(choose_ranges(options, words.ranges));
  HN_DO(choose_layout(options, words.layout));
  HN_TRY(options.settings.arithmetic,
         chosen<Arithmetic>(
             "--arithmetic", words.arithmetic,
             {{"fixed", Arithmetic::kFixed}, {"precise", Arithmetic::kPrecise}, {"fast", Arithmetic::kFast}}));
  if (words.metric) {
    std::vector<std::pair<std::string, Metric>> metrics;
    for (const std::string_view metric : grid::kMetricNames) {
      metrics.emplace_back(metric, static_cast<Metric>(metrics.size() + 1));
    }
    HN_TRY(options.settings.metric, chosen<Metric>("--metric", *words.metric, metrics));
  }
  if (!words.instruction_set) return {};
  std::vector<std::pair<std::string, InstructionSet>> sets;
  for (const InstructionSet set : instruction_sets()) sets.emplace_back(name(set), set);
  HN_TRY(options.settings.instruction_set, chosen<InstructionSet>("--instruction-set", *words.instruction_set, sets));
  return {};
}

tl::unexpected<Stop> wrong_usage(const std::string& message) { return tl::unexpected(Stop{kBadUsage, {}, message}); }

tl::unexpected<Stop> unexpected_argument(const CLI::App& app) {
  const auto left = app.remaining();
  const auto found = std::ranges::find_if(left, [](const std::string& argument) { return argument != "--"; });
  const std::string argument = found == left.end() ? std::string() : *found;
  if (!argument.starts_with('-')) {
    return wrong_usage(fmt::format("{} is one argument too many; see --help", in_quotes(argument)));
  }
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(fmt::format("--{}", name));
  }
  const std::string word = argument.substr(0, argument.find('='));
  return wrong_usage(fmt::format("there is no option {}{}; see --help", in_quotes(word), suggestion(word, names)));
}

}  // namespace

std::string_view name_of(Format format) {
  return std::ranges::find(kFormats, format, &decltype(kFormats)::value_type::first)->second;
}

tl::expected<BakeOptions, Stop> parse_options(int argc, const char* const* argv) {
  CLI::App app("Writes a noise, a fractal of it or an expression as a picture, a volume or raw numbers.", "hn-bake");
  app.set_version_flag("--version", library_version());
  app.footer(
      "Exit status: 0 done, 1 values could not be computed or the file not be written, 2 bad usage, 4 it could not be "
      "built, or an expression could not, 130 ended by Ctrl-C (SIGINT), 143 by SIGTERM, 129 by SIGHUP.");
  BakeOptions options;
  Words words;
  add_options(app, options, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return unexpected_argument(app);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return wrong_usage(fmt::format("{}; see --help", error.what()));
    std::ostringstream out;
    std::ostringstream err;
    app.exit(error, out, err);
    return tl::unexpected(Stop{0, out.str(), err.str()});
  }
  const auto done = interpret(options, words);
  if (!done) return wrong_usage(done.error().text());
  return options;
}

}  // namespace hn
