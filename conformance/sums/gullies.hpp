// How far hn_gullies may be off in floats, given the bounds of the waves of its octaves. The proof is in
// gullies.cpp.
#pragma once

#include <optional>

namespace hn {

// The bounds of phasor noise at a place of a cell, for waves that are shorter than 3/2, and of its derivatives
// (bounds.inc, which tools/make bounds writes).
struct GulliesBounds {
  double value;            // the error
  double lipschitz;        // how fast it changes: the error per error of the position
  double wave_rate;        // the error per error of the wave
  double slope;            // the same of a component of the vector of its derivatives
  double slope_lipschitz;  // of a component
  double slope_wave_rate;  // of the vector
  double steepest;         // the largest length of the vector
  double fixed_value, fixed_slope;
};

// In the range that the contract takes them in.
struct GulliesArguments {
  double octaves;
  double lacunarity;  // a whole number
  double gain;
  bool exact_positions;  // no fraction is cut to 2^-24
  std::optional<double> footprint;
  double slope;  // how long it is, with each component in [-8, 8]
  double depth;
};

// How far the height and each slope may be off; infinite where no error is bounded.
struct GulliesTolerance {
  double height;
  double slope;
};
GulliesTolerance gullies_tolerance(const GulliesArguments& arguments, const GulliesBounds& bounds);

}  // namespace hn
