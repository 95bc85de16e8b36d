// The cases that evaluate functions on the driver: which there are follows from the tables of functions and
// configurations.
#include <algorithm>

#include "cases/targets.hpp"
#include "cases/value_checks.hpp"

namespace hn {
namespace {

// What holds for a function by its row alone. It is the library's doing more than the driver's: one driver is enough.
void add_properties(std::vector<Case>& cases, const Evaluation& evaluation, Extent extent) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const auto add = [&](std::string_view name, Check* check) {
    cases.push_back({name_of(evaluation, name), CheckKind{evaluation, check}, extent});
  };
  const bool once = configuration.is_default();  // for what does not depend on the knobs
  if (once && function.has_unseeded()) add("unseeded", check_unseeded);
  // HN_FIXED converts a noise of the user's to an integer.
  const bool takes_noise = once || configuration.name == "lattice+fixed";
  if (takes_noise && function.is_octave_sum()) add("other_noise", check_other_noise);
  if (function.is_cellular() && !profile.es) {
    add("search", check_search);
    if (function.id.ends_with("cellular_nearest") || function.id.ends_with("cell_border_nearest")) {
      add("cell_names", check_cell_names);
    }
    if (function.bound == "cell_border" && !function.takes_period()) add("border", check_border);
  }
  if (function.is_octave_sum() && function.has_slopes()) {
    // The errors of sums in integers are no part of this suite: golden files have their bits.
    if (configuration.arithmetic != Arithmetic::fixed) add("derivative", check_slope_sum);
  }
  // With periods the field has no values but those that it has without.
  if (function.exact() || function.takes_period()) {
    if (function.is_noise() && function.has_slopes()) add("derivative", check_derivative);
    return;
  }
  add("range", check_range);
  // A hash changes no value's size.
  if (configuration.hash == default_configuration().hash) add("finite", check_finite);
  if (function.family == Family::curl) add("divergence", check_divergence);
  if (!function.is_noise()) return;
  if (configuration.hash == default_configuration().hash && !function.inputs_are_units()) add("seams", check_seams);
  if (function.has_slopes()) add("derivative", check_derivative);
  if (function.starts_from_integers()) return;
  if (function.is_gradient_noise() && !function.is_slope(0)) add("zero", check_zero);
  // With the sine gradient a hash is as weak as published. With derivatives the field is the same.
  if (!configuration.hash_only() || function.is_derived()) return;
  add("seeds", check_seeds);
  add("mirror", check_mirror);
}

}  // namespace

CaseName name_of(const Evaluation& evaluation, std::string_view check) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  return {.function = std::string(function.id),
          .configuration = std::string(configuration_name(function, configuration)),
          .arithmetic = std::string(arithmetic_name(function, configuration)),
          .stage = stage,
          .profile = std::string(profile.name),
          .check = std::string(check)};
}

void add_value_cases(std::vector<Case>& cases) {
  for (const Function& function : all_functions()) {
    for (const Configuration& configuration : all_configurations()) {
      for (const Target& target : targets_of(configuration)) {
        const Evaluation evaluation{function, configuration, *target.profile, {}, target.stage};
        const Extent extent = extent_of(function, configuration, target);
        if (covers(configuration, function)) {
          cases.push_back({name_of(evaluation, "golden"), GoldenKind{evaluation}, extent});
          // In OpenGL the other stages are held against this one. A browser has no twin.
          const Platform platform = target.profile->platform();
          if (target.stage == Stage::fragment || platform == Platform::vulkan || platform == Platform::metal) {
            cases.push_back({name_of(evaluation, "twin"), CheckKind{evaluation, check_twin}, extent});
          }
          if (target.main) add_properties(cases, evaluation, std::max(extent, Extent::one_driver));
        }
        add_metamorphic_cases(cases, evaluation, target, extent);
      }
    }
  }
}

}  // namespace hn
