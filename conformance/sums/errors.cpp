#include "sums/errors.hpp"

#include <algorithm>
#include <cmath>

namespace hn {
namespace {

// By how much the rotations of a position make a length larger at most: those in the planes of x and y and of z and w.
// The one between them makes lengths in its plane smaller, but not that along x.
const double kStretch = std::hypot(25.0, 20.0) / 32.0;
constexpr std::array kLargestShift = {11.0 / 32.0, 19.0 / 32.0, 23.0 / 32.0, 27.0 / 32.0};  // between octaves, by axes

double largest_shift(int axes) { return kLargestShift[static_cast<std::size_t>(axes) - 1]; }

}  // namespace

int count_of(const OctaveArguments& arguments) {
  return arguments.octaves < 0x1p-32 ? 0 : static_cast<int>(std::ceil(std::min(arguments.octaves, 32.0)));
}

double rounding_of(int operations) { return std::pow(1.0 + kUnit, operations) - 1.0; }

// --- Positions ---
//
// Without rotations a position goes by q = q*lacunarity + shift, and each coordinate is bounded on its own. Else the
// steps are, with c = lacunarity*25/32 and s = lacunarity*5/8, and in space d = lacunarity*29/32 and e =
// lacunarity*13/32,
//
//   2D: x' = (c*x - s*y) + 11/32;  y' = (s*x + c*y) + 19/32
//   3D: v = s*x + c*y;  x' as before;  y' = (29/32*v - e*z) + 19/32;  z' = (13/32*v + d*z) + 23/32
//   4D: u = 13/32*v + d*z;  x', y' as before;  z' = (25/32*u - s*w) + 23/32;  w' = (20/32*u + c*w) + 27/32
//   1D: as without rotations
//
// and lengths are bounded, which rotations stretch by kStretch, coordinates by much more. A coordinate goes through no
// more than 2 n roundings, the last of them behind the shift, of terms whose magnitudes sum to no more than the
// stretched length (Cauchy). Terms below 2^-126 may become 0.

bool rotates(int axes, const OctaveArguments& arguments) { return arguments.rotates && axes > 1; }

double diagonal_of(int axes, const OctaveArguments& arguments) {
  return rotates(axes, arguments) ? std::sqrt(axes) : 1.0;
}

double stretch_of(int axes, const OctaveArguments& arguments) {
  if (!rotates(axes, arguments)) return 1.0;
  return axes == 4 ? kStretch * kStretch : kStretch;
}

double cut_lacunarity(const OctaveArguments& arguments) { return std::trunc(arguments.lacunarity * 0x1p23) / 0x1p23; }

namespace {

OctavePosition next_straight(int axes, const OctaveArguments& arguments, const OctavePosition& at) {
  const double lacunarity = std::fabs(arguments.lacunarity);
  const double product_error = lacunarity * (at.error + kUnit * (at.position + at.error) + kTiny) + kTiny;
  const double position = lacunarity * at.position + largest_shift(axes);
  return {position, product_error + kUnit * (position + product_error)};
}

OctavePosition next_rotated(int axes, const OctaveArguments& arguments, const OctavePosition& at) {
  const double shift = largest_shift(axes);
  const double diagonal = std::sqrt(axes);
  const double stretch = std::fabs(arguments.lacunarity) * stretch_of(axes, arguments);
  const double reach = at.position + at.error;
  const double of_coordinate = rounding_of(2 * axes) * stretch * reach + kUnit * shift + kTiny * (4.0 * reach + 8.0);
  return {stretch * at.position + diagonal * shift, stretch * at.error + diagonal * of_coordinate};
}

// A coordinate of a fixed-point position is cut to a multiple of 2^-24, and the lacunarity to one of 2^-23; the product
// is rounded down, and so are both coordinates after each rotation.
OctavePosition next_whole(int axes, const OctaveArguments& arguments, const OctavePosition& at) {
  const double ratio = cut_lacunarity(arguments);
  const double diagonal = diagonal_of(axes, arguments);
  double error = ratio * at.error + (arguments.lacunarity - ratio) * at.position + diagonal * kWhole;
  for (int plane = 0; rotates(axes, arguments) && plane < axes - 1; ++plane) {
    error = (plane % 2 == 0 ? kStretch : 1.0) * error + std::sqrt(2.0) * kWhole;
  }
  return {arguments.lacunarity * stretch_of(axes, arguments) * at.position + diagonal * largest_shift(axes), error};
}

}  // namespace

OctavePosition first_octave(int axes, const OctaveArguments& arguments) {
  const double diagonal = diagonal_of(axes, arguments);
  return {diagonal * arguments.largest_coordinate,
          arguments.from_cell && !arguments.exact_positions ? diagonal * kWhole : 0.0};
}

OctavePosition next_octave(int axes, const OctaveArguments& arguments, const OctavePosition& at) {
  OctavePosition next = arguments.from_cell        ? next_whole(axes, arguments, at)
                        : rotates(axes, arguments) ? next_rotated(axes, arguments, at)
                                                   : next_straight(axes, arguments, at);
  if (arguments.exact_positions) next.error = 0.0;
  return next;
}

double fade_error(std::size_t i) {
  return 1.501 * (std::pow(1.0 + kUnit, static_cast<double>(i)) - 1.0) + 1.001 * kUnit + 2.0 * kTiny;
}

void Total::add_octave(double gain) {
  const double product_error = gain * (error + kUnit * (value + error)) + kTiny;
  value = 1.0 + gain * value;
  error = product_error + kUnit * (value + product_error);
}

bool in_domain(const OctaveArguments& arguments) {
  Total total;
  for (int i = 0; i < count_of(arguments); ++i) total.add_octave(arguments.gain);
  const double growth = std::fabs(arguments.gain * arguments.lacunarity);
  return total.value <= kLargestTotal && std::pow(growth, std::max(count_of(arguments) - 1, 0)) <= 0x1p96;
}

}  // namespace hn
