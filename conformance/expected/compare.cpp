#include "expected/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "expected/cellular.hpp"
#include "expected/golden.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

// Such a part of the values of a case may be left out; with more it would be no test.
constexpr double kMostLeftOut = 1.0 / 8.0;

// Maps floats to integers in their order, with -0 and 0 together.
std::int64_t ordinal(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto magnitude = static_cast<std::int64_t>(bits & 0x7FFFFFFFu);
  return bits >> 31 ? -magnitude : magnitude;
}

bool is_float(WordType type) { return type == WordType::f32 || type == WordType::f64; }

std::string describe(float value) { return fmt::format("{:.9g} ({:08x})", value, std::bit_cast<std::uint32_t>(value)); }

std::string describe(WordType type, std::uint32_t word) {
  if (is_float(type)) return describe(std::bit_cast<float>(word));
  if (type == WordType::i32) return fmt::format("{} ({:08x})", static_cast<std::int32_t>(word), word);
  return fmt::format("{} ({:08x})", word, word);
}

}  // namespace

std::uint64_t ulp_distance(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) {
    return std::isnan(a) && std::isnan(b) ? 0 : std::numeric_limits<std::uint32_t>::max();
  }
  const std::int64_t difference = ordinal(a) - ordinal(b);
  return static_cast<std::uint64_t>(difference < 0 ? -difference : difference);
}

std::string describe_inputs(const Function& function, std::span<const std::uint32_t> inputs) {
  std::string text;
  for (std::size_t i = 0; i < function.inputs.size(); ++i) {
    const Column& column = function.inputs[i];
    if (!text.empty()) text += ' ';
    text += fmt::format("{}={}", column.name, describe(column.type, inputs[i]));
  }
  return text;
}

void Comparison::bits(std::span<const std::uint32_t> inputs, std::uint32_t got, std::uint32_t expected,
                      std::optional<std::size_t> column) {
  ++outcome_.samples;
  if (got == expected) return;
  const WordType type = function_.outputs[column.value_or(0)].type;
  if (is_float(type))
    note_difference(std::bit_cast<float>(got), static_cast<double>(std::bit_cast<float>(expected)), 0.0);
  note(inputs, column, describe(type, got), describe(type, expected));
}

void Comparison::number(std::span<const std::uint32_t> inputs, float got, double expected, double allowed,
                        std::optional<std::size_t> column) {
  ++outcome_.samples;
  note_difference(got, expected, allowed);
  // Written so that a NaN difference fails.
  if (std::fabs(static_cast<double>(got) - expected) <= allowed) return;
  // Nothing is near an infinity or NaN.
  const std::string within = std::isfinite(expected) ? fmt::format(" within {:.3g}", allowed) : "";
  note(inputs, column, describe(got), describe(static_cast<float>(expected)) + within);
}

void Comparison::word(std::span<const std::uint32_t> inputs, std::uint32_t got, double expected,
                      std::uint32_t expected_bits, std::optional<double> allowed, std::size_t column) {
  if (allowed == kUndecided) {
    ++left_out_;
  } else if (!allowed || function_.is_name(column)) {
    bits(inputs, got, expected_bits, column);
  } else {
    number(inputs, std::bit_cast<float>(got), expected, *allowed, column);
  }
}

void Comparison::note_difference(float got, double expected, double allowed) {
  const double difference = std::fabs(static_cast<double>(got) - expected);
  outcome_.max_ulp = std::max(outcome_.max_ulp, ulp_distance(got, static_cast<float>(expected)));
  // JSON has no NaN; infinity is recorded as the largest double.
  if (difference <= outcome_.max_abs) return;
  constexpr double kLargest = std::numeric_limits<double>::max();
  outcome_.max_abs = std::isfinite(difference) ? difference : kLargest;
  outcome_.allowed = std::min(allowed, kLargest);
}

void Comparison::next_grid(std::span<const std::uint32_t> grid) {
  before_ += grid_.size() / kInputWords;
  grid_ = grid;
}

void Comparison::require(bool right, std::span<const std::uint32_t> inputs, float got, std::string_view should) {
  ++outcome_.samples;
  if (!right) note(inputs, std::nullopt, describe(got), std::string(should));
}

void Comparison::note(std::span<const std::uint32_t> inputs, std::optional<std::size_t> column, std::string_view got,
                      std::string expected) {
  if (outcome_.mismatches++ >= kExamplesKept) return;
  const auto point = before_ + static_cast<std::size_t>(inputs.data() - grid_.data()) / kInputWords;
  const bool named = column && function_.outputs.size() > 1;
  Mismatch mismatch{point,
                    {inputs.begin(), inputs.end()},
                    describe_inputs(function_, inputs),
                    named ? fmt::format("{}={}", function_.outputs[*column].name, got) : std::string(got),
                    std::move(expected)};
  if (outcome_.examples.empty()) {
    outcome_.message =
        fmt::format("first at {}: got {}, expected {}", mismatch.inputs, mismatch.got, mismatch.expected);
  }
  outcome_.examples.push_back(std::move(mismatch));
}

Outcome Comparison::finish() const {
  Outcome outcome = outcome_;
  if (outcome.mismatches != 0) outcome.status = Status::fail;
  const auto all = static_cast<double>(outcome.samples + left_out_);
  if (outcome.mismatches == 0 && static_cast<double>(left_out_) > kMostLeftOut * all) {
    outcome.status = Status::error;
    outcome.message = fmt::format("{} of {} values were left out", left_out_, outcome.samples + left_out_);
  }
  if (outcome.samples == 0) {
    outcome.status = Status::error;
    outcome.message = "nothing was compared";
  }
  return outcome;
}

double allowed_to_twin(const Function& function, const Configuration& configuration,
                       std::span<const std::uint32_t> inputs, std::size_t output) {
  if (function.jumps(output) && is_undecided(function, configuration, inputs)) return kUndecided;
  return 2.0 * tolerance(function, configuration, inputs, output);
}

void compare_with_twin(Comparison& comparison, const Evaluation& evaluation, std::span<const std::uint32_t> inputs,
                       std::span<const std::uint32_t> got, std::span<const std::uint32_t> twin,
                       std::span<const double> allowed) {
  for (std::size_t word = 0; word < evaluation.function.outputs.size(); ++word) {
    const bool exact = has_same_bits(evaluation.function, evaluation.configuration);
    double of = allowed[word];
    if (std::isnan(of) && !exact) {
      of = got[word] == twin[word] ? 0.0 : allowed_to_twin(evaluation.function, evaluation.configuration, inputs, word);
    }
    comparison.word(inputs, got[word], static_cast<double>(std::bit_cast<float>(twin[word])), twin[word],
                    exact ? std::nullopt : std::optional(of), word);
  }
}

void compare_with_golden(Comparison& comparison, const Function& function, const Configuration& configuration,
                         std::span<const std::uint32_t> inputs, std::span<const std::uint32_t> got,
                         std::span<const std::uint64_t> values) {
  for (std::size_t word = 0; word < values.size(); ++word) {
    if (has_exact_values(function, configuration) || function.is_name(word)) {
      comparison.bits(inputs, got[word], result_bits(function.outputs[word], values[word]), word);
    } else {
      comparison.number(inputs, std::bit_cast<float>(got[word]), std::bit_cast<double>(values[word]),
                        tolerance(function, configuration, inputs, word), word);
    }
  }
}

}  // namespace hn
