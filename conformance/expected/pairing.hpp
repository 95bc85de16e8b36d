// Two ways to compute the same values, as data: the metamorphic checks evaluate both on a driver, the page in a
// browser.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "library/shaders.hpp"

namespace hn {

// Two evaluations that must agree, point by point. evaluation.variant.constants may be a part of inputs.
struct Pairing {
  Evaluation evaluation;
  Evaluation other;                         // what it is held against
  std::vector<std::uint32_t> inputs;        // kInputWords per point
  std::vector<std::uint32_t> other_inputs;  // the same for the other; often the same words
  // For each of words() of each point; 0 if every bit counts. kUndecided leaves a word out.
  std::vector<double> allowed;
  bool exact;           // every bit counts
  double factor = 1.0;  // the other's values times this are what is expected
  // How many words of a result are compared, if both have as many.
  std::size_t most_words = kOutputWords;

  std::size_t words() const {
    return std::min({most_words, evaluation.function.outputs.size(), other.function.outputs.size()});
  }

  // Whether each word of a result belongs to another point: to the point itself, and to its neighbours.
  bool in_loop() const { return evaluation.variant.shape == Shape::in_loop; }
};

// The words of another function's columns: those that the function has, and else those of the default.
std::vector<std::uint32_t> inputs_for(const Function& other, const Function& function,
                                      std::span<const std::uint32_t> inputs);

// The points of most metamorphic checks.
inline constexpr std::size_t kPairingPoints = std::size_t{1} << 12;

// A variant of the shader, or another stage, against the plain fragment shader.
Pairing variant_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// Points that are constants in the shader's text, so that the compiler may evaluate the function itself: few of them,
// whatever count is given.
Pairing folded_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// For functions with periods: points a whole number of periods apart,
Pairing period_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// points against the form without periods, whose cell is the remainder, and which is the same where it reaches no seam
// (but of octave sums, which rotate without periods),
Pairing wrapped_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// and periods that are constants in the shader's text.
Pairing constant_period_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// For functions with a phase: whole turns apart; half a turn apart, where the noise is the negative; and without a
// rotation against the noise without a phase, in space times a factor.
Pairing loop_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
Pairing half_turn_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
Pairing phase_zero_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// For octave sums: from a cell and a fraction against the position that is their sum; with a detail that is a whole
// number, and with a footprint that leaves all octaves, against the sum without.
Pairing from_cell_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
Pairing whole_detail_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
Pairing small_footprint_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// For sums that slopes wear down: with a strength of 0, against the sum without slopes.
Pairing zero_strength_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// With a bandwidth of 0, against the noise without one.
Pairing zero_bandwidth_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);
// The value that comes with a derivative, against the noise or the sum without one.
Pairing derivative_value_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points = kPairingPoints);

}  // namespace hn
