#include "cases/targets.hpp"

namespace hn {

std::vector<Target> targets_of(const Configuration& configuration) {
  std::vector<Target> targets;
  const auto add = [&](const Profile& profile, Stage stage, bool main) { targets.push_back({&profile, stage, main}); };
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

}  // namespace hn
