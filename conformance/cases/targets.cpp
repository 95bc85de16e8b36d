#include "cases/targets.hpp"

#include <algorithm>

namespace hn {

std::vector<Target> targets_of(const Configuration& configuration) {
  std::vector<Target> targets;
  const auto add = [&](const Profile& profile, Stage stage, bool main) {
    targets.push_back({&profile, stage, main, targets.size()});
  };
  add(main_profile(configuration, false), Stage::fragment, true);
  add(main_profile(configuration, true), Stage::fragment, true);
  const bool precise = configuration.arithmetic == Arithmetic::precise;
  if (!precise) add(profile_named("gl140"), Stage::fragment, false);
  add(main_profile(configuration, false), Stage::vertex, false);
  if (!precise) add(profile_named("es300"), Stage::vertex, false);
  add(profile_named("gl430"), Stage::compute, false);
  if (!precise) add(profile_named("es310"), Stage::compute, false);
  add(profile_named("vulkan"), Stage::compute, false);
  add(profile_named("hlsl60"), Stage::compute, false);
  // By way of vkd3d-compiler, which takes minutes over Jenkins' hash and drops `precise`.
  if (!precise && configuration.default_but_for_arithmetic()) add(profile_named("hlsl50"), Stage::compute, false);
  if (!precise) add(profile_named("msl"), Stage::compute, false);
  if (!precise) add(profile_named("wgsl"), Stage::compute, false);
  return targets;
}

bool has_turn(const Function& function, const Configuration& configuration, std::size_t other) {
  std::size_t number = 0;  // in its family
  std::size_t of = 0;
  for (const Function& relative : all_functions()) {
    if (relative.family != function.family) continue;
    if (relative.id == function.id) number = of;
    ++of;
  }
  return (number + static_cast<std::size_t>(configuration.index) + other) % std::min(of, kMostTurns) == 0;
}

namespace {

// Of vkd3d-compiler: more than half a minute, which is too near the limit of a case.
bool takes_minutes(const Function& function, const Configuration& configuration, const Profile& profile) {
  return profile.name == "hlsl50" && configuration.arithmetic == Arithmetic::fixed && function.is_octave_sum() &&
         function.has_slopes() && function.axes == 3;
}

}  // namespace

Extent extent_of(const Function& function, const Configuration& configuration, const Target& target) {
  // The sine gradient is not the default, but its functions have nothing that is nearer to one.
  const bool defaults =
      configuration.default_but_for_arithmetic() ||
      (function.family == Family::sine_gradient && configuration.name_without_arithmetic() == "lattice+sine");
  const bool main_of_desktop = target.main && !target.profile->es;
  // All of Vulkan's languages become SPIR-V. Each driver shows the bits of that of GLSL.
  const bool of_vulkan = target.profile->platform() == Platform::vulkan && target.profile->in_glsl();
  if (function.is_further()) {
    // Many functions, whose code is that of others for the most part: what differs, one version and stage shows. Every
    // driver shows the bits of the noises themselves; their other forms are compiled and run by one.
    const bool form = function.takes_cell() || function.takes_period();
    const bool promised = defaults && configuration.arithmetic == Arithmetic::fixed && !form;
    if (promised && of_vulkan) return Extent::every_driver;
    if (main_of_desktop) return promised ? Extent::every_driver : Extent::one_driver;
    // A hash is one text in all languages, and what it changes the other functions show.
    if (target.profile->platform() != Platform::opengl && !defaults) return Extent::thorough;
    if (takes_minutes(function, configuration, *target.profile)) return Extent::thorough;
    // The test wgsl.wgpu has all of them; here those that compile in a moment.
    const bool in_wgsl = target.profile->language == Language::wgsl;
    if (promised && in_wgsl && !function.is_costly()) return Extent::one_driver;
    return has_turn(function, configuration, target.number) ? Extent::one_driver : Extent::thorough;
  }
  if (defaults && target.main) return Extent::every_driver;
  if (defaults && of_vulkan && configuration.arithmetic == Arithmetic::fixed) return Extent::every_driver;
  // Another language has the same text, and what its compiler makes of that shows in integers best.
  const bool chosen_defaults = defaults && (target.profile->in_glsl() || has_same_bits(function, configuration));
  const bool chosen = chosen_defaults || main_of_desktop || has_turn(function, configuration, target.number);
  return chosen ? Extent::one_driver : Extent::thorough;
}

}  // namespace hn
