// How far an octave sum of floats may be from the exact one, given the bounds of its noise. The proofs are in
// bounds.cpp. The suite and tools/make bounds compile it, so it includes the standard library and what tools/make
// catalog makes, and nothing else.
#pragma once

#include <optional>

namespace hn {

// The bounds of a noise, or of the components of its derivative.
struct FloatBounds {
  int axes;
  double cell_error;  // of floats, from a cell and a fraction
  double error;       // the same from a position
  double lipschitz;   // how fast the noise changes: the error per error of the position
  double limit;       // how large it can be, computed in floats
};

// The step of an octave: a step of detail/octave.glsl, or the step of a sum with derivatives or displacements.
enum class SumStep {
#define SUM_STEP(name) name,
#include "library/sums.inc"
};
// The result of a sum, from the mean of its octaves.
enum class SumMean {
#define SUM_MEAN(name) name,
#include "library/sums.inc"
};

struct SumRule {
  SumStep step;
  SumMean mean;
  double most_strength;  // or amplitude; 0 if it has none
};

// In the range that the contract takes them in: with a period the lacunarity is a whole number.
struct OctaveArguments {
  double largest_coordinate;  // the largest |p_i|; from a cell, |cell + f|
  double octaves;             // a float of them is a detail
  double lacunarity;
  double gain;
  bool exact_positions;  // the caller's promise: no octave's position is rounded
  double strength = 0.0;
  std::optional<double> footprint = {};
  bool rotates = true;  // it does not with a period
  bool from_cell = false;
  bool is_detail = false;
  double amplitude = 0.0;
};

// Whether a sum with it needs the Jacobians of its octaves.
bool has_jacobian(SumStep step);
// Whether a noise beyond [-1, 1] counts as the nearer end.
bool is_clamped(SumStep step);

// The largest error of an octave sum over a noise, against the exact sums of docs/reference/contract.md at the same
// floats; of a sum of vectors, of a component. `slope` are the bounds of the derivative of the noise: an erosion
// and a warp need them. From a cell the sum is defined for a lacunarity in [0, 255]; the error is infinite where no
// error is bounded. A step or a mean without a proof throws, and so do the functions above.
double octave_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                        const FloatBounds& slope);
// The tolerance of a component of the derivative of the sum.
double octave_slope_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                              const FloatBounds& slope);

}  // namespace hn
