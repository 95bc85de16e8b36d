#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <hashnoise/detail/closest.hpp>
#include <iterator>
#include <stdexcept>

#include "rules.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

namespace {

constexpr double kMostGrowth = 96.0;  // in octaves of 2: 2^31 times as much is far from 2^127 still

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

std::string quoted(std::string_view text) { return std::string(1, '"').append(text).append(1, '"'); }

std::string listed(const std::vector<std::string_view>& names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

std::string in_dimensions(int dimensions) { return " in " + std::to_string(dimensions) + "D"; }

template <typename Row>
bool has(const Row& row, int dimensions) {
  return row.first_dimension <= dimensions && dimensions <= row.last_dimension;
}

template <typename Rows>
std::vector<std::string_view> names_in(const Rows& rows, int dimensions) {
  return names_where(rows, [=](const auto& row) { return has(row, dimensions); });
}

// The row of a name, or an error that lists the names to choose from, and the nearest one. Only an error needs them.
template <typename Rows, typename Names>
std::size_t find(const Rows& rows, const char* what, const std::string& name, int dimensions,
                 const Names& names_to_choose_from) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.name == name; });
  if (row == rows.end() || !has(*row, dimensions)) {
    const std::vector<std::string_view> names = names_to_choose_from();
    refuse("there is no " + std::string(what) + " " + quoted(name) + in_dimensions(dimensions) +
           detail::suggestion(name, names) + "; there are: " + listed(names));
  }
  return static_cast<std::size_t>(row - rows.begin());
}

void check(const Rule& rule, double value) {
  if (const std::string problem = problem_of(rule, value); !problem.empty()) refuse(problem);
}

// The given number, if it is right, or else the default.
template <typename Number>
Number checked(const Rule& rule, const std::optional<Number>& given) {
  if (!given) return static_cast<Number>(rule.usual);
  check(rule, static_cast<double>(*given));
  return *given;
}

// The noises that a sum takes.
std::vector<std::string_view> summands(Shape shape, int dimensions) {
  return names_where(kNoiseRows, [=](const NoiseRow& row) { return has(row, dimensions) && row.shape == shape; });
}

std::string listed(const std::vector<InstructionSet>& sets) {
  std::vector<std::string_view> names;
  std::transform(sets.begin(), sets.end(), std::back_inserter(names), name);
  return listed(names);
}

InstructionSet chosen(const std::optional<InstructionSet>& wanted) {
  const std::vector<InstructionSet> there = instruction_sets();
  if (there.empty()) {
    refuse("this processor lacks the instructions that hashnoise::grid was compiled for: " +
           listed(compiled_instruction_sets()));
  }
  if (!wanted) return there.front();
  if (std::find(there.begin(), there.end(), *wanted) != there.end()) return *wanted;
  const bool is_set = *wanted >= InstructionSet::kSse41 && *wanted <= InstructionSet::kGeneric;
  refuse((is_set ? "this processor or this build has no " + std::string(name(*wanted))
                 : "instruction_set has to be a value of InstructionSet") +
         "; there are: " + listed(there));
}

// "perlin, simplex and curl"
std::string with_and(std::vector<std::string_view> names) {
  const std::string last(names.back());
  names.pop_back();
  return names.empty() ? last : listed(names) + " and " + last;
}

std::string noises_with(bool (NoiseRow::*option)() const) { return with_and(names_where(kNoiseRows, option)); }
std::string sums_with(std::string_view strength) {
  return "the fractals " + with_and(names_where(kSumRows, [=](const SumRow& row) { return row.strength == strength; }));
}

// A setting, and the condition on the noise or the sum, which is evaluated only where the setting is given.
struct Requirement {
  std::string_view setting;
  bool is_given;
  bool is_had;
  std::string (*owners)();
};

void check_owners(const Settings& settings, const MoreSettings& more, int dimensions, const NoiseRow& noise,
                  const SumRow* sum, bool tiled) {
  const bool is_noise = sum == nullptr;
  const bool is_sum = !is_noise;
  const bool has_phase = (is_noise ? noise.has_phase() : sum->has_phase) && (dimensions == 2 || dimensions == 3);
  const bool is_limited = is_sum && sum == &kSumRows[kFbm] && !tiled;
  const auto has_strength = [&](std::string_view name) { return is_sum && sum->strength == name; };
  constexpr auto of_sums = [] { return std::string("fractals have one"); };
  constexpr auto of_fbm = [] { return std::string("the fractal fbm has one, if it has no period"); };
  const Requirement all[] = {
      {"phase", settings.phase.has_value(), has_phase,
       [] {
         const std::vector<std::string_view> sums =
             names_where(kSumRows, [](const SumRow& row) { return row.has_phase; });
         return noises_with(&NoiseRow::has_phase) + " have one in 2D and 3D, and the fractal " + with_and(sums);
       }},
      {"wave", !settings.wave.empty(), is_noise && noise.has_wave(),
       [] { return noises_with(&NoiseRow::has_wave) + " has one in 2D and 3D"; }},
      {"bandwidth", more.bandwidth.has_value(), is_noise && noise.has_wave(),
       [] { return noises_with(&NoiseRow::has_wave) + " has one in 2D and 3D"; }},
      {"jitter", settings.jitter.has_value(), is_noise && noise.has_jitter(),
       [] { return noises_with(&NoiseRow::has_jitter) + " have one"; }},
      {"metric", settings.metric.has_value(), is_noise && noise.has_metric(),
       [] { return noises_with(&NoiseRow::has_metric) + " have one"; }},
      {"octaves", settings.octaves.has_value(), is_sum, [] { return std::string("fractals have them"); }},
      {"lacunarity", settings.lacunarity.has_value(), is_sum, of_sums},
      {"gain", settings.gain.has_value(), is_sum, of_sums},
      {"strength", settings.strength.has_value(), has_strength("strength"),
       [] { return sums_with("strength") + " have one"; }},
      {"amplitude", settings.amplitude.has_value(), has_strength("amplitude"),
       [] { return sums_with("amplitude") + " have one"; }},
      {"detail", settings.detail.has_value(), is_limited, of_fbm},
      {"footprint", settings.footprint.has_value(), is_limited, of_fbm},
  };
  for (const Requirement& given : all) {
    if (!given.is_given || given.is_had) continue;
    refuse((is_sum ? "the fractal " + quoted(sum->name) : quoted(noise.name)) + in_dimensions(dimensions) +
           (tiled ? " with a period" : "") + " has no " + std::string(given.setting) + "; " + given.owners());
  }
}

// A number for each axis. Without a wave there are 3 waves to a cell along x: enough to show as stripes, and few enough
// for a picture of some cells. Nothing else in a field gives their direction.
void plan_wave(Plan& plan, const std::vector<float>& wave) {
  if (wave.empty()) {
    plan.options.wave[0] = 3.0f;
    return;
  }
  const auto dimensions = static_cast<std::size_t>(plan.dimensions);
  if (wave.size() != dimensions) {
    refuse("wave has " + std::to_string(wave.size()) + (wave.size() == 1 ? " component" : " components") +
           ", and has to have " + std::to_string(dimensions) + in_dimensions(plan.dimensions) + ", one for each axis");
  }
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    check(kWaveRule, static_cast<double>(wave[axis]));
    plan.options.wave[axis] = wave[axis];
  }
}

void plan_noise(Plan& plan, const Settings& settings, NoiseId id, bool tiled) {
  const NoiseKernels& kernels = plan.kernels->noises[id][plan.dimensions - 1];
  plan.shape = kNoiseRows.at(id).shape;
  if (kNoiseRows.at(id).has_wave()) {
    const bool is_plain = plan.options.bandwidth == 0.0f;
    plan.in = !is_plain ? kernels.phase : tiled ? kernels.full : kernels.plain;
  } else if (settings.phase) {
    if (plan.options.metric != static_cast<int>(Metric::kEuclidean)) {
      refuse(quoted(kNoiseRows.at(id).name) + " with a phase has no metric but euclidean");
    }
    plan.in = kernels.phase;
  } else {
    const bool is_usual = plan.options.jitter == 1.0f && plan.options.metric == static_cast<int>(Metric::kEuclidean);
    plan.in = tiled || !is_usual ? kernels.full : kernels.plain;
  }
}

void plan_sum(Plan& plan, const Settings& settings, NoiseId noise, SumId id, bool tiled) {
  const SumRow& row = kSumRows.at(id);
  if (row.takes_noise() && kNoiseRows.at(noise).shape != row.of) {
    refuse("the fractal " + quoted(row.name) + " does not take the noise " + quoted(kNoiseRows.at(noise).name) +
           in_dimensions(plan.dimensions) + "; it takes: " + listed(summands(row.of, plan.dimensions)));
  }
  if (settings.detail && settings.footprint) refuse("detail and footprint exclude each other; leave one out");
  if (settings.detail && settings.octaves) refuse("detail stands in place of octaves; leave one out");
  plan.options.strength = checked(strength_rule(row), strength_of(settings, row));
  const NoiseKernels& of = plan.kernels->noises[noise][plan.dimensions - 1];
  plan.options.sum = settings.detail ? kDetail : settings.footprint ? kFootprint : id;
  if (settings.phase) plan.options.sum = kFlowsWithPhase;
  const SumKernels& kernels = plan.kernels->sums[plan.options.sum][plan.dimensions - 1];
  plan.takes_positions = true;
  plan.shape = row.shape;
  plan.octave = of.octave;
  plan.options.noise = tiled ? of.full : of.plain;
  if (settings.detail || settings.footprint) {
    plan.options.limit =
        settings.detail ? checked(kDetailRule, settings.detail) : checked(kFootprintRule, settings.footprint);
    plan.at = kernels.at;
  } else {
    plan.at = tiled ? kernels.tile : kernels.at;
    plan.in = tiled ? kernels.tile : kernels.in;
  }
}

// Numbers that the functions would change are wrong: they cut a lacunarity off in a tile, and with HN_FIXED they take
// the nearer end. Floats overflow where octaves are too fine or too strong for their number: a position is below 2^31,
// and so is the sum, but for these factors.
void check_octaves(const Plan& plan, Arithmetic arithmetic, bool tiled) {
  const int octaves = plan.options.octaves;
  const auto lacunarity = static_cast<double>(plan.options.lacunarity);
  const auto gain = static_cast<double>(plan.options.gain);
  if (tiled && (lacunarity < 1.0 || lacunarity > kMostLacunarity || std::trunc(lacunarity) != lacunarity)) {
    refuse("lacunarity is " + digits_of(lacunarity) + ", and has to be a whole number from 1 to 255 with a period");
  }
  if (arithmetic == Arithmetic::kFixed) {
    const Rule of_fixed[] = {{"lacunarity", false, 0.0, kMostLacunarity, 2.0}, {"gain", false, 0.0, 1.0, 0.5}};
    for (const Rule& rule : of_fixed) {
      const std::string problem = problem_of(rule, rule.setting == "gain" ? gain : lacunarity);
      if (!problem.empty()) refuse(problem + " with fixed arithmetic");
    }
    return;
  }
  const double finer = std::max(1.0, std::abs(lacunarity));
  const double stronger = std::max(1.0, gain);
  if (octaves < 2 || std::log2(finer * stronger) * (octaves - 1) <= kMostGrowth) return;
  const bool is_gain = stronger > finer;
  const double most = std::exp2(kMostGrowth / (octaves - 1)) / std::min(finer, stronger);
  refuse(std::string(is_gain ? "gain" : "lacunarity") + " is " + digits_of(is_gain ? gain : lacunarity) +
         ", and with " + std::to_string(octaves) + " octaves and a " + (is_gain ? "lacunarity of " : "gain of ") +
         digits_of(is_gain ? lacunarity : gain) + " it has to be at most " +
         digits_of(std::max(1.0, std::floor(most * 100.0) / 100.0)) + ", or floats overflow");
}

}  // namespace

std::vector<std::string> components_of(Shape shape, int dimensions) {
  const std::vector<std::string> axes = {"x", "y", "z", "w"};
  std::vector<std::string> names = {shape == Shape::kDistanceWithSlopes ? "f1" : "value"};
  if (shape == Shape::kTwoDistances) names = {"f1", "f2"};
  if (shape == Shape::kThreeDistances) names = {"f1", "f2", "f3"};
  if (shape == Shape::kValueAndQuadrature) names.emplace_back("quadrature");
  if (shape == Shape::kVector) names = {axes.begin(), axes.begin() + dimensions};
  if (shape != Shape::kWithSlopes && shape != Shape::kDistanceWithSlopes) return names;
  for (int i = 0; i < dimensions; ++i) names.push_back("d" + axes[static_cast<std::size_t>(i)]);
  return names;
}

Plan plan_of(int dimensions, const Settings& settings, const MoreSettings& more) {
  Plan plan{};
  plan.dimensions = dimensions;
  const int arithmetic = static_cast<int>(settings.arithmetic);
  if (arithmetic < 1 || arithmetic > 3) refuse("arithmetic has to be kFast, kPrecise or kFixed");
  const int metric = static_cast<int>(settings.metric.value_or(Metric::kEuclidean));
  if (metric < 1 || metric > static_cast<int>(std::size(kMetricNames))) {
    refuse("metric has to be a value of Metric: " +
           listed(std::vector(std::begin(kMetricNames), std::end(kMetricNames))));
  }
  std::optional<SumId> sum;
  if (!settings.fractal.empty()) {
    const auto names = [&] { return fractals(dimensions); };
    sum = static_cast<SumId>(find(kSumRows, "fractal", settings.fractal, dimensions, names));
  }
  // A sum over noises of its own counts as Perlin noise.
  NoiseId noise = sum && kSumRows.at(*sum).takes_noise() ? kSumRows.at(*sum).usual_noise : kPerlin;
  if (sum && !kSumRows.at(*sum).takes_noise() && !settings.noise.empty()) {
    refuse("the fractal " + quoted(settings.fractal) + " has noises of its own; leave the noise " +
           quoted(settings.noise) + " out");
  }
  if (!settings.noise.empty()) {
    const auto names = [&] { return sum ? summands(kSumRows.at(*sum).of, dimensions) : noises(dimensions); };
    noise = static_cast<NoiseId>(find(kNoiseRows, "noise", settings.noise, dimensions, names));
  }
  bool tiled = false;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    check(kPeriodRule, settings.period[axis]);
    tiled = tiled || settings.period[axis] > 0;
    plan.options.period[axis] = settings.period[axis];
  }
  check_owners(settings, more, dimensions, kNoiseRows.at(noise), sum ? &kSumRows.at(*sum) : nullptr, tiled);
  plan.set = chosen(settings.instruction_set);
  plan.may_fuse = settings.arithmetic == Arithmetic::kFast;
  plan.kernels = &kernels_for(plan.set, settings.arithmetic);
  plan.options.seed = settings.seed;
  plan.options.phase = settings.phase ? checked(kPhaseRule, settings.phase) : 0.0f;  // of the phasor, if there is none
  plan_wave(plan, settings.wave);
  plan.options.bandwidth = checked(kBandwidthRule, more.bandwidth);
  plan.options.jitter = checked(kJitterRule, settings.jitter);
  plan.options.metric = metric;
  plan.options.octaves = checked(kOctavesRule, settings.octaves);
  plan.options.lacunarity = checked(kLacunarityRule, settings.lacunarity);
  plan.options.gain = checked(kGainRule, settings.gain);
  if (sum) {
    if (settings.detail) {
      const float detail = checked(kDetailRule, settings.detail);
      plan.options.octaves = detail < 0x1p-32f ? 0 : static_cast<int>(std::ceil(detail));
    }
    check_octaves(plan, settings.arithmetic, tiled);
    plan_sum(plan, settings, noise, *sum, tiled);
  } else {
    plan_noise(plan, settings, noise, tiled);
  }
  plan.components = static_cast<int>(components_of(plan.shape, dimensions).size());
  return plan;
}

}  // namespace hashnoise::inline HN_I_NAMESPACE::grid

namespace hashnoise::inline HN_I_LIBRARY {

std::vector<std::string_view> noises(int dimensions) { return grid::names_in(grid::kNoiseRows, dimensions); }
std::vector<std::string_view> fractals(int dimensions) { return grid::names_in(grid::kSumRows, dimensions); }

}  // namespace hashnoise::inline HN_I_LIBRARY
