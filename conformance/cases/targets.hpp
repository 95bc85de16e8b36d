// In which versions and stages the cases evaluate functions, and how often in a run.
#pragma once

#include <vector>

#include "library/functions.hpp"
#include "library/profile.hpp"

namespace hn {

// Where a case belongs.
enum class Extent {
  every_driver,  // for each driver
  one_driver,    // run --deal runs it on one of the drivers that can
  thorough,      // run --thorough alone runs it
};

// A version and a stage in which functions are evaluated.
struct Target {
  const Profile* profile;
  Stage stage;
  bool main;  // one of the versions in which a configuration has most of its cases: of desktop OpenGL, or of ES
};

// The targets of a configuration: its main versions, GLSL without bit casts, the other stages, and Vulkan's.
std::vector<Target> targets_of(const Configuration& configuration);

}  // namespace hn
