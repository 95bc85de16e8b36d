// The bounds of octave sums (bounds.cpp, gullies.cpp) as a library, for tools/make bounds. `answer` takes what to
// answer, the name of a sum, and numbers, and writes numbers:
//
//   value, slope   of the arguments in their order (bounds.hpp; a footprint of -1 is none), and of the bounds of the
//                  noise and of its derivative: the tolerance
//   gullies        of the arguments, the length of the slope, the depth, and GULLIES_BOUNDS: those of the height and of
//                  a slope
//   terms          of whether it is in integers, the strength that is used, how far that is cut, and the errors of 32
//                  noises: whether the step cuts a noise off, then the errors of 32 terms and of the factors of the
//                  weights behind them
//
// It returns a sentence where there is no proof.
#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sums/bounds.cpp"
#include "sums/errors.cpp"
#include "sums/gullies.cpp"

namespace hn {
namespace {

struct Sum {
  std::string_view name;
  SumRule rule;
};
constexpr Sum kSums[] = {
#define OCTAVE_SUM(name, noise, most, least, greatest, bounded, step, mean) \
  {#name, {SumStep::step, SumMean::mean, most}},
#include "library/sums.inc"
};
constexpr int kMostOctaves = 32;

constexpr int kArguments = 11;  // numbers of OctaveArguments
constexpr int kBounds = 5;      // and of FloatBounds

OctaveArguments arguments_of(const double* n) {
  const std::optional<double> footprint = n[6] >= 0.0 ? std::optional(n[6]) : std::nullopt;
  return {n[0], n[1], n[2], n[3], n[4] != 0.0, n[5], footprint, n[7] != 0.0, n[8] != 0.0, n[9] != 0.0, n[10]};
}

FloatBounds bounds_of(const double* n) { return {static_cast<int>(n[0]), n[1], n[2], n[3], n[4]}; }

void answer_terms(const SumRule& rule, const double* n, double* answers) {
  const double strength = n[1];
  const Roundings roundings = n[0] != 0.0 ? integers(n[2]) : kFloats;
  const Errors noise_errors(n + 3, n + 3 + kMostOctaves);
  const Proof proof = proof_of(rule.step);
  *answers++ = proof.is_clamped;
  answers = std::ranges::copy(proof.terms(noise_errors, strength, 1.0, roundings).errors, answers).out;
  for (const double error : noise_errors) {
    *answers++ = proof.factor_error != nullptr ? proof.factor_error(error, strength, roundings) : 0.0;
  }
}

void answer_gullies(const double* n, double* answers) {
  const double* const rest = n + kArguments;
  const double* const b = rest + 2;
  const GulliesTolerance tolerance =
      gullies_tolerance({arguments_of(n), rest[0], rest[1]}, {b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8]});
  answers[0] = tolerance.height;
  answers[1] = tolerance.slope;
}

void answer_of(std::string_view what, const SumRule& rule, const double* n, double* answers) {
  if (what == "terms") return answer_terms(rule, n, answers);
  if (what == "gullies") return answer_gullies(n, answers);
  answers[0] = (what == "slope" ? octave_slope_tolerance : octave_tolerance)(
      rule, arguments_of(n), bounds_of(n + kArguments), bounds_of(n + kArguments + kBounds));
}

}  // namespace
}  // namespace hn

extern "C" const char* answer(const char* what, const char* name, const double* numbers, double* answers) {
  static std::string problem;
  try {
    const auto* const sum = std::ranges::find(hn::kSums, name, &hn::Sum::name);
    if (sum == std::end(hn::kSums)) throw std::logic_error("the suite has no sum " + std::string(name));
    hn::answer_of(what, sum->rule, numbers, answers);
    return "";
  } catch (const std::exception& error) {
    problem = error.what();
    return problem.c_str();
  }
}
