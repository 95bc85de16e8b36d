// In which versions and stages the cases evaluate functions, and how often in a run.
#pragma once

#include <cstddef>
#include <vector>

#include "library/configurations.hpp"
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

// Those of a configuration: its main versions, GLSL without bit casts, and the other stages.
std::vector<Target> targets_of(const Configuration& configuration);

// Settings are chosen pairwise. Every function meets every configuration in the main version of desktop OpenGL, and with
// the defaults every target; the third pair, of configuration and target, is met by one function in kTurns. All else is
// thorough. So a function more has few cases more, and none less for the others.
inline constexpr std::size_t kTurns = 5;
Extent extent_of(std::size_t function, const Configuration& configuration, const Target& target);
// The same for what has but one turn in kTurns.
bool has_turn(std::size_t function, const Configuration& configuration, std::size_t number);

}  // namespace hn
