#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "instruction_sets.hpp"

namespace hashnoise::grid {

namespace {

constexpr int kMostOctaves = 1024;  // more than any float shows; a larger number is a mistake that would take long

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
  std::vector<std::string_view> names;
  for (const auto& row : rows) {
    if (has(row, dimensions)) names.push_back(row.name);
  }
  return names;
}

// The row of a name, or an error that lists those that there are.
template <typename Rows>
std::size_t find(const Rows& rows, const char* what, const std::string& name, int dimensions) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.name == name; });
  if (row == rows.end() || !has(*row, dimensions)) {
    refuse("there is no " + std::string(what) + " " + quoted(name) + in_dimensions(dimensions) +
           "; there are: " + listed(names_in(rows, dimensions)));
  }
  return static_cast<std::size_t>(row - rows.begin());
}

void check_number(const char* name, float value, float least, float most) {
  if (value >= least && value <= most) return;  // false for NaN
  refuse(std::string(name) + " is " + std::to_string(value) + ", and has to be from " + std::to_string(least) + " to " +
         std::to_string(most));
}

void check_finite(const char* name, float value) {
  if (!std::isfinite(value)) refuse(std::string(name) + " has to be a finite number");
}

// The noises that a sum takes.
std::vector<std::string_view> summands(Shape shape, int dimensions) {
  std::vector<std::string_view> names;
  for (const NoiseRow& row : kNoiseRows) {
    if (has(row, dimensions) && row.shape == shape) names.push_back(row.name);
  }
  return names;
}

std::vector<std::string_view> names_of(const std::vector<InstructionSet>& sets) {
  std::vector<std::string_view> names;
  std::transform(sets.begin(), sets.end(), std::back_inserter(names), name);
  return names;
}

InstructionSet chosen(const std::optional<InstructionSet>& wanted) {
  const std::vector<InstructionSet> there = instruction_sets();
  if (there.empty()) {
    refuse("this processor lacks the instructions that hashnoise::grid was compiled for: " +
           listed(names_of(compiled_instruction_sets())));
  }
  if (!wanted) return there.front();
  if (std::find(there.begin(), there.end(), *wanted) == there.end()) {
    refuse("this processor or this build has no " + std::string(name(*wanted)) +
           "; there are: " + listed(names_of(there)));
  }
  return *wanted;
}

void plan_noise(Plan& plan, const Settings& settings, NoiseId id, bool tiled) {
  const NoiseRow& row = kNoiseRows.at(id);
  if (settings.detail || settings.footprint) refuse("detail and footprint belong to the sum fbm, and there is no sum");
  if (settings.strength) refuse("strength belongs to the sums ping_pong, weighted and eroded, and there is no sum");
  if (settings.phase && (!row.has_phase || plan.dimensions < 2 || plan.dimensions > 3)) {
    refuse(quoted(row.name) + " has no phase" + in_dimensions(plan.dimensions) +
           "; perlin, perlin_d, simplex and simplex_d have one in 2D and 3D");
  }
  if (settings.jitter != 1.0f && !row.has_jitter) refuse(quoted(row.name) + " has no jitter; cellular noises have one");
  if (settings.metric != Metric::kEuclidean && !row.has_metric) {
    refuse(quoted(row.name) + " has no metric; cellular and cellular_three have one");
  }
  const NoiseKernels& kernels = plan.kernels->noises[id][plan.dimensions - 1];
  plan.shape = row.shape;
  if (settings.phase) {
    plan.in = tiled ? kernels.phase_full : kernels.phase;
  } else {
    plan.in = tiled || settings.jitter != 1.0f || settings.metric != Metric::kEuclidean ? kernels.full : kernels.plain;
  }
  plan.row = plan.in == kernels.plain ? kernels.row : plan.in;
}

void plan_sum(Plan& plan, const Settings& settings, NoiseId noise, SumId id, bool tiled) {
  const SumRow& row = kSumRows.at(id);
  if (kNoiseRows.at(noise).shape != row.of) {
    refuse("the sum " + quoted(row.name) + " does not take the noise " + quoted(kNoiseRows.at(noise).name) +
           in_dimensions(plan.dimensions) + "; it takes: " + listed(summands(row.of, plan.dimensions)));
  }
  if (settings.phase) refuse("a sum has no phase");
  if (settings.jitter != 1.0f) refuse("a sum has no jitter");
  if (settings.metric != Metric::kEuclidean) refuse("a sum has no metric");
  if (settings.strength && row.strength != "strength") {
    refuse("the sum " + quoted(row.name) + " has no strength; ping_pong, weighted and eroded have one");
  }
  if (settings.detail || settings.footprint) {
    if (id != kFbm || tiled) refuse("detail and footprint belong to the sum fbm without a period");
    if (settings.detail && settings.footprint) refuse("detail and footprint exclude each other");
  }
  if (settings.octaves > kMostOctaves) {
    refuse("octaves is " + std::to_string(settings.octaves) + ", and has to be at most " +
           std::to_string(kMostOctaves));
  }
  check_finite("lacunarity", settings.lacunarity);
  check_finite("gain", settings.gain);
  if (settings.gain < 0.0f) refuse("gain is negative, and has to be 0 or more");
  plan.options.strength =
      row.strength == "amplitude" ? settings.amplitude : settings.strength.value_or(row.usual_strength);
  if (!row.strength.empty()) {
    check_number(row.strength.data(), plan.options.strength, 0.0f, row.most_strength);
  }
  const NoiseKernels& of = plan.kernels->noises[noise][plan.dimensions - 1];
  plan.options.sum = settings.detail ? kDetail : settings.footprint ? kFootprint : id;
  SumKernels kernels = plan.kernels->sums[plan.options.sum][plan.dimensions - 1];
  const SumKernels& faster = plan.kernels->sums_of[noise][plan.options.sum][plan.dimensions - 1];
  if (faster.at != nullptr) kernels.at = faster.at;
  if (faster.in != nullptr) kernels.in = faster.in;
  plan.takes_positions = true;
  plan.shape = row.shape;
  plan.octave = tiled ? of.octave_full : of.octave;
  if (settings.detail) {
    check_number("detail", *settings.detail, 0.0f, static_cast<float>(kMostOctaves));
    plan.options.limit = *settings.detail;
    plan.at = kernels.at;
  } else if (settings.footprint) {
    check_finite("footprint", *settings.footprint);
    plan.options.limit = *settings.footprint;
    plan.at = kernels.at;
  } else {
    plan.at = tiled ? kernels.tile_at : kernels.at;
    plan.in = plan.row = tiled ? kernels.tile_in : kernels.in;
  }
}

}  // namespace

int components_of(Shape shape, int dimensions) {
  switch (shape) {
    case Shape::kValue:
      return 1;
    case Shape::kTwoDistances:
      return 2;
    case Shape::kThreeDistances:
      return 3;
    case Shape::kVector:
      return dimensions;
    case Shape::kWithSlopes:
    case Shape::kDistanceWithSlopes:
      return dimensions + 1;
  }
  throw std::logic_error("a shape that there is not");
}

Plan plan_of(int dimensions, const Settings& settings) {
  Plan plan{};
  plan.dimensions = dimensions;
  const auto noise = static_cast<NoiseId>(find(kNoiseRows, "noise", settings.noise, dimensions));
  const int arithmetic = static_cast<int>(settings.arithmetic);
  if (arithmetic < 1 || arithmetic > 3) refuse("arithmetic has to be kFast, kPrecise or kFixed");
  const int metric = static_cast<int>(settings.metric);
  if (metric < 1 || metric > 5) {
    refuse("metric has to be kEuclidean, kSquared, kManhattan, kChebyshev or kHybrid");
  }
  check_number("jitter", settings.jitter, 0.0f, 1.0f);
  if (settings.phase) check_finite("phase", *settings.phase);
  plan.set = chosen(settings.instruction_set);
  plan.kernels = &kernels_for(plan.set, settings.arithmetic);
  plan.options.seed = settings.seed;
  bool tiled = false;
  for (std::size_t axis = 0; axis < settings.period.size(); ++axis) {
    if (axis < static_cast<std::size_t>(dimensions)) tiled = tiled || settings.period[axis] > 0;
    plan.options.period[axis] = settings.period[axis];
  }
  plan.options.phase = settings.phase.value_or(0.0f);
  plan.options.jitter = settings.jitter;
  plan.options.metric = metric;
  plan.options.octaves = settings.octaves;
  plan.options.lacunarity = settings.lacunarity;
  plan.options.gain = settings.gain;
  if (settings.sum.empty()) {
    plan_noise(plan, settings, noise, tiled);
  } else {
    plan_sum(plan, settings, noise, static_cast<SumId>(find(kSumRows, "sum", settings.sum, dimensions)), tiled);
  }
  plan.components = components_of(plan.shape, dimensions);
  return plan;
}

}  // namespace hashnoise::grid

namespace hashnoise {

std::vector<std::string_view> noise_names(int dimensions) { return grid::names_in(grid::kNoiseRows, dimensions); }
std::vector<std::string_view> sum_names(int dimensions) { return grid::names_in(grid::kSumRows, dimensions); }

}  // namespace hashnoise
