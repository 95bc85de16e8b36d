// The bounds of octave sums have this in common: the errors of positions, of weights and of operations. The bounds are
// in bounds.cpp and gullies.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "sums/bounds.hpp"

namespace hn {

constexpr double kUnit = 0x1p-23;     // the largest relative error of one operation, in any rounding mode
constexpr double kTiny = 0x1p-126;    // the largest error of flushing a subnormal to 0
constexpr double kSettled = 0x1p-96;  // below which HN_PRECISE makes a result 0
constexpr double kWhole = 0x1p-24;    // the unit of fixed-point positions
constexpr double kInfinite = std::numeric_limits<double>::infinity();

int count_of(const OctaveArguments& arguments);
// Relative, of so many operations.
double rounding_of(int operations);

// Where an octave is: how far from the origin at most, and by how much its position may be off. With rotations these
// are lengths; without, each coordinate is bounded on its own.
struct OctavePosition {
  double position;
  double error;
};

bool rotates(int axes, const OctaveArguments& arguments);
// How much longer a vector can be than its largest coordinate, where lengths are bounded.
double diagonal_of(int axes, const OctaveArguments& arguments);
// The growth of a length by the rotations between two octaves.
double stretch_of(int axes, const OctaveArguments& arguments);
// From a cell the contract cuts the lacunarity.
double cut_lacunarity(const OctaveArguments& arguments);
OctavePosition first_octave(int axes, const OctaveArguments& arguments);
OctavePosition next_octave(int axes, const OctaveArguments& arguments, const OctavePosition& at);

// The error of clamp(3/2 - e, 0, 1), e = footprint * max(lacunarity, 1)^i computed step by step. It counts up to 3/2
// only.
double fade_error(std::size_t i);

// The total of the weights, octave by octave: total = gain*total + 1.
struct Total {
  double value = 0.0;
  double error = 0.0;

  void add_octave(double gain);
};

// GLSL bounds the error of a division only for divisors up to this.
constexpr double kLargestTotal = 0x1p126;

// Whether no weight, and no number of a Jacobian, overflows.
bool in_domain(const OctaveArguments& arguments);

}  // namespace hn
