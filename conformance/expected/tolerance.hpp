// How far a float result may be from the exact value: the bounds that tools/bounds.py derives (docs/accuracy.md).
#pragma once

#include <cstdint>
#include <span>

#include "library/functions.hpp"

namespace hn {

// The bounds for hn_perlin from a cell and a fraction and from a position, how fast the noise changes (the error per
// error of the position), and how large it can be.
struct NoiseBounds {
  double cell_error;
  double error;
  double lipschitz;
  double range;
};
enum class Gradient { octahedral, sine };
NoiseBounds noise_bounds(int dimensions, Gradient gradient);

enum class OctaveSum { fbm, turbulence, clouds };

struct OctaveArguments {
  double largest_coordinate;  // the largest |p_i|
  int octaves;
  double lacunarity;
  double gain;
  bool exact_positions;  // no octave's position is rounded
};

// octave_tolerance of tools/bounds.py.
double octave_tolerance(OctaveSum kind, int dimensions, const OctaveArguments& arguments,
                        Gradient gradient = Gradient::octahedral);

// The bound for a function at a point given by its input words; 0 where every bit is defined. (Of what fixed arithmetic
// is off the real numbers it says nothing: that has golden files of its own.)
double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs);

}  // namespace hn
