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

struct Numbers {
  const double* at;

  template <typename Number>
  Numbers& operator>>(Number& x) {
    x = static_cast<Number>(*at++);
    return *this;
  }
  Numbers& operator>>(FloatBounds& bounds) {
    return *this >> bounds.axes >> bounds.cell_error >> bounds.error >> bounds.lipschitz >> bounds.limit;
  }
  Numbers& operator>>(OctaveArguments& arguments) {
    double footprint = 0.0;
    *this >> arguments.largest_coordinate >> arguments.octaves >> arguments.lacunarity >> arguments.gain >>
        arguments.exact_positions >> arguments.strength >> footprint >> arguments.rotates >> arguments.from_cell >>
        arguments.is_detail >> arguments.amplitude;
    if (footprint >= 0.0) arguments.footprint = footprint;
    return *this;
  }
  Numbers& operator>>(GulliesBounds& bounds) {
    return *this >> bounds.value >> bounds.lipschitz >> bounds.wave_rate >> bounds.slope >> bounds.slope_lipschitz >>
           bounds.slope_wave_rate >> bounds.steepest >> bounds.fixed_value >> bounds.fixed_slope;
  }
};

void answer_terms(const SumRule& rule, Numbers in, double* answers) {
  bool is_fixed = false;
  double strength = 0.0;
  double cut = 0.0;
  in >> is_fixed >> strength >> cut;
  const Roundings roundings = is_fixed ? integers(cut) : kFloats;
  const Errors noise_errors(in.at, in.at + kMostOctaves);
  const Proof proof = proof_of(rule.step);
  *answers++ = proof.is_clamped;
  answers = std::ranges::copy(proof.terms(noise_errors, strength, 1.0, roundings).errors, answers).out;
  for (const double error : noise_errors) {
    *answers++ = proof.factor_error ? proof.factor_error(error, strength, roundings) : 0.0;
  }
}

void answer_of(std::string_view what, const SumRule& rule, Numbers in, double* answers) {
  if (what == "terms") return answer_terms(rule, in, answers);
  OctaveArguments arguments{};
  in >> arguments;
  if (what == "gullies") {
    GulliesArguments of{arguments, 0.0, 0.0};
    GulliesBounds bounds{};
    in >> of.slope >> of.depth >> bounds;
    const GulliesTolerance tolerance = gullies_tolerance(of, bounds);
    answers[0] = tolerance.height;
    answers[1] = tolerance.slope;
    return;
  }
  FloatBounds noise{};
  FloatBounds slope{};
  in >> noise >> slope;
  answers[0] = (what == "slope" ? octave_slope_tolerance : octave_tolerance)(rule, arguments, noise, slope);
}

}  // namespace
}  // namespace hn

extern "C" const char* answer(const char* what, const char* name, const double* numbers, double* answers) {
  static std::string problem;
  try {
    const auto* const sum = std::ranges::find(hn::kSums, name, &hn::Sum::name);
    if (sum == std::end(hn::kSums)) throw std::logic_error("the suite has no sum " + std::string(name));
    hn::answer_of(what, sum->rule, {numbers}, answers);
    return "";
  } catch (const std::exception& error) {
    problem = error.what();
    return problem.c_str();
  }
}
