// How far an octave sum of floats may be off: the text of the library over numbers that count how far they are off
// (numbers.hpp), with its noises as summaries. The suite and tools/make bounds compile it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace hn::sums {

// The bounds of a noise, or of a component of its derivative, from a cell and a fraction (bounds.inc).
struct Summary {
  double error = 0.0, lipschitz = 0.0, limit = 0.0;
};
struct Noise {
  Summary value, slope;   // all 0 if there is none
  double steepest = 0.0;  // the longest gradient
  Noise() = default;
  Noise(int axes, const Summary& of_value, const Summary& of_slope = {});
};
// The noises that sums of the library add up, by the number of axes.
struct Noises {
  std::array<Noise, 5> perlin, perlin_d, value_vector, cellular_d, curl, curl_phase;
};

// The error of each output of a row of the suite's table of functions, at these words, against the exact sums of
// docs/reference/contract.md at the same floats. It is infinite where no error is bounded. A step without a proof
// throws.
using Errors = std::array<double, 4>;
Errors errors_of(std::string_view function, std::span<const std::uint32_t> words, const Noises& noises);

}  // namespace hn::sums
