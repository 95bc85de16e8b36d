// Comparing results with the expected ones, word by word.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "expected/verdict.hpp"
#include "library/shaders.hpp"

namespace hn {

// Units in the last place between two floats: how many floats lie between them, plus one if they differ. NaN has the
// largest distance from everything but NaN.
std::uint64_t ulp_distance(float a, float b);

// Stands for the tolerance of a value that jumps so near that two ways of rounding need not agree (cellular.hpp).
inline constexpr double kUndecided = -1.0;

// The most failures that a case lists; further ones add nothing.
inline constexpr std::size_t kExamplesKept = 8;

// Adds up comparisons; the first value that is off becomes the message, and the first few are kept.
class Comparison {
 public:
  // grid: the input words of all points. The words of a wrong value's point are taken from it.
  Comparison(const Function& function, std::span<const std::uint32_t> grid) : function_(function), grid_(grid) {}

  // For values that must agree in every bit. column: the output of the function, if the value is one.
  void bits(std::span<const std::uint32_t> inputs, std::uint32_t got, std::uint32_t expected,
            std::optional<std::size_t> column = {});
  // Else |got - expected| <= allowed. NaN is never right.
  void number(std::span<const std::uint32_t> inputs, float got, double expected, double allowed,
              std::optional<std::size_t> column = {});
  // For values that are rounded in two ways: equal bits without a tolerance and for names of cells, else near numbers.
  // Undecided values are left out; too many of them are an error.
  void word(std::span<const std::uint32_t> inputs, std::uint32_t got, double expected, std::uint32_t expected_bits,
            std::optional<double> allowed, std::size_t column);
  std::uint64_t left_out() const { return left_out_; }
  // For properties: a value that is right or not, with a sentence on the right value.
  void require(bool right, std::span<const std::uint32_t> inputs, float got, std::string_view should);

  // Continues with other points: later comparisons belong to these, and their numbers follow the earlier ones.
  void next_grid(std::span<const std::uint32_t> grid);

  std::uint64_t mismatches() const { return outcome_.mismatches; }
  bool all_right() const { return mismatches() == 0; }
  // Pass if all values were right, else fail.
  Outcome finish() const;

 private:
  void note_difference(float got, double expected, double allowed);
  void note(std::span<const std::uint32_t> inputs, std::optional<std::size_t> column, std::string_view got,
            std::string expected);

  const Function& function_;
  std::span<const std::uint32_t> grid_;
  std::uint64_t left_out_ = 0;
  std::size_t before_ = 0;  // points of the grids before this one
  Outcome outcome_;
};

// "x=1.5 (3fc00000) seed=7 (00000007)": the input words of a function, for messages.
std::string describe_inputs(const Function& function, std::span<const std::uint32_t> inputs);

// How far an output of a driver and of the twin may differ at a point, unless every bit counts: both may be off the
// exact value by the tolerance. kUndecided where it jumps.
double allowed_to_twin(const Function& function, const Configuration& configuration,
                       std::span<const std::uint32_t> inputs, std::size_t output);
// Compares a result with the twin's at the same point. allowed: as allowed_to_twin, for each output; NaN where that is
// still unknown, which it may be where both have the same bits.
void compare_with_twin(Comparison& comparison, const Evaluation& evaluation, std::span<const std::uint32_t> inputs,
                       std::span<const std::uint32_t> got, std::span<const std::uint32_t> twin,
                       std::span<const double> allowed);
// Compares a result with the values of a golden file.
void compare_with_golden(Comparison& comparison, const Function& function, const Configuration& configuration,
                         std::span<const std::uint32_t> inputs, std::span<const std::uint32_t> got,
                         std::span<const std::uint64_t> values);

}  // namespace hn
