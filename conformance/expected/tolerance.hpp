// How far a float result may be from the exact value: the bounds that tools/make bounds derives
// (docs/measured/accuracy.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "library/functions.hpp"

namespace hn {

// The proven bounds of a noise of so many axes, or of a component of its derivative (bounds.inc, which tools/make
// bounds writes).
struct NoiseBounds {
  std::string_view noise;
  int axes;
  std::optional<Gradient> gradient;  // none if the noise has no gradients
  double cell_error;                 // of floats, from a cell and a fraction
  double error;                      // the same from a position
  double lipschitz;                  // how fast the noise changes: the error per error of the position
  double limit;                      // how large it can be, computed in floats
  double fixed_error;                // the same of fixed arithmetic
  double fixed_limit;
};
// They must exist.
const NoiseBounds& noise_bounds(std::string_view noise, int axes, Gradient gradient);
const NoiseBounds& slope_bounds(std::string_view noise, int axes, Gradient gradient);
// The bounds of an output of a noise, or of the noise that an octave sum adds up.
const NoiseBounds& bounds_of(const Function& function, const Configuration& configuration, std::size_t output = 0);
// How far a result may be from the exact one, the real number, in the arithmetic of the configuration.
double error_of(const Function& function, const Configuration& configuration, std::size_t output);

enum class OctaveSum {
#define OCTAVE_SUM(name, ...) name,
#include "library/sums.inc"
};
std::optional<OctaveSum> octave_sum_named(std::string_view name);  // "fbm"
OctaveSum octave_sum_of(const Function& function);
struct OctaveSumFacts {
  std::string_view name;
  std::string_view noise;  // what its GLSL function adds up
  double most_strength;    // or amplitude; 0 if it has none
  double least, greatest;
  bool bounded;  // else it may be as large as the noise, if that is beyond these
};
const OctaveSumFacts& facts_of(OctaveSum sum);
inline std::string_view noise_of(OctaveSum sum) { return facts_of(sum).noise; }

// The tolerance of an output of cellular noise at a point. A derivative is off by as much as its point, divided by the
// distance to the point. Names of cells are right or wrong.
double cellular_tolerance(const Function& function, const Configuration& configuration,
                          std::span<const std::uint32_t> inputs, std::size_t output);

// The bound for an output of a function at a point given by its input words; 0 where every bit is defined. (It does not
// bound the difference of fixed arithmetic from the real numbers: golden files of its own check that arithmetic.)
double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
                 std::size_t output);

}  // namespace hn
