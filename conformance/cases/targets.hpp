// In which versions and stages the cases evaluate functions, and how often in a run.
#pragma once

#include <cstddef>
#include <vector>

#include "library/functions.hpp"
#include "library/profile.hpp"

namespace hn {

// Where a case belongs.
enum class Extent {
  every_driver,  // what each driver must show
  one_driver,    // run --deal runs it on one of the drivers that can
  thorough,      // run --thorough alone runs it
};

// A version and a stage in which functions are evaluated.
struct Target {
  const Profile* profile;
  Stage stage;
  bool main;  // one of the versions in which a configuration has most of its cases: of desktop OpenGL, or of ES
  std::size_t number;
};

// Those of a configuration: its main versions, GLSL without bit casts, the other stages, and what Vulkan runs.
std::vector<Target> targets_of(const Configuration& configuration);

// Settings are chosen pairwise. Every pair of a function and a configuration is run, in the main version of desktop
// OpenGL; and every pair of a function and a target, with the defaults. A pair of a configuration and a target is run
// with at least one function of each family, one in kMostTurns of a large family. Of further functions, the pairs of a
// function and a target are run for one in kMostTurns. The rest is thorough.
inline constexpr std::size_t kMostTurns = 5;
Extent extent_of(const Function& function, const Configuration& configuration, const Target& target);
// Whether a function takes its turn in its family with this configuration, and the target or variant `other`.
bool has_turn(const Function& function, const Configuration& configuration, std::size_t other);

}  // namespace hn
