#include "sums/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sums/errors.hpp"

namespace hn {
namespace {

constexpr double kLargestFall = 8.0;  // of a component of the slopes that an erosion sums, beyond which it is cut off

double strength_of(const SumRule& rule, const OctaveArguments& arguments) {
  return std::clamp(arguments.strength, 0.0, rule.most_strength);
}

double amplitude_of(const SumRule& rule, const OctaveArguments& arguments) {
  return std::clamp(arguments.amplitude, 0.0, rule.most_strength);
}

// One value for each octave.
using Errors = std::vector<double>;

// An octave, before its weight.
struct Terms {
  Errors errors;
  double limit;  // how large a term can be, as it is computed
};

// By how much an operation is off: in floats, and in integers, where numbers from 0 to 1 are rounded down to 2^-18.
struct Roundings {
  bool is_fixed;
  double number;    // of a number of at most 1, such as 1 - |n|
  double relative;  // of a product
  double lost;      // by a product besides, whatever it is
  double cut;       // of the strength, before the step
};
constexpr Roundings kFloats = {false, kUnit, kUnit, 2.0 * kTiny, 0.0};
constexpr Roundings integers(double cut) { return {true, 0x1p-18, 0.0, 0x1p-18, cut}; }

// The proof of a step, as values and functions.
struct Proof {
  bool is_clamped;
  Terms (*terms)(const Errors& noise_errors, double strength, double limit, const Roundings&);
  // The error of the factor of later weights that follows from an octave's noise; none if there is no such factor.
  double (*factor_error)(double noise_error, double strength, const Roundings&);
  double (*tolerance)(const SumRule&, const OctaveArguments&, const FloatBounds& noise, const FloatBounds& slope);
};
Proof proof_of(SumStep step);

// The error of a noise, or a component of its derivative, at a position that is off.
double error_at(const OctaveArguments& arguments, const FloatBounds& bounds, double lipschitz, double limit,
                double position_error) {
  // A noise that jumps is as good as any only where its position is exact.
  const double of_position = position_error > 0.0 ? lipschitz * position_error : 0.0;
  return std::min(of_position + (arguments.from_cell ? bounds.cell_error : bounds.error), 2.0 * limit);
}

// The errors of all octaves, where positions do not depend on the noise.
Errors errors_at(const OctaveArguments& arguments, const FloatBounds& bounds, double lipschitz, double limit) {
  OctavePosition at = first_octave(bounds.axes, arguments);
  Errors errors;
  for (int i = 0; i < count_of(arguments); ++i) {
    errors.push_back(error_at(arguments, bounds, lipschitz, limit, at.error));
    at = next_octave(bounds.axes, arguments, at);
  }
  return errors;
}

// --- An octave, before its weight ---

// An absolute value is exact and brings no two values further apart.
Terms as_they_are(const Errors& noise_errors, double, double limit, const Roundings&) { return {noise_errors, limit}; }

// d = 1 - |n|;  r = d*d*min(2*r, 1)
//
// A root g = sqrt(r) follows from d min(sqrt(2) g, 1). So an error of d moves g by as much, what was there before by
// sqrt(2) times that, and r by twice what g is moved by: it grows as sqrt(2)^i, and not as 2^i. Relative errors of r
// move g by half of them. The loss of products does not depend on r, and is counted with r: it doubles.
Terms ridges(const Errors& noise_errors, double, double, const Roundings& of) {
  Terms terms{{}, 1.0};
  double root = 0.0;
  double lost = 0.0;
  for (const double noise_error : noise_errors) {
    const double products = terms.errors.empty() ? 1.0 : 2.0;
    root = noise_error + of.number + std::sqrt(2.0) * root + products * of.relative * (1.0 + of.relative) / 2.0;
    lost = 2.0 * lost + products * of.lost;
    terms.errors.push_back(std::min(2.0 * root + lost, 1.0));
  }
  return terms;
}

// d = (1 + n)/2;  t = d*min(2*t, 1). Both factors are at most 1, so an error of t doubles. The first product is exact.
Terms heights(const Errors& noise_errors, double, double, const Roundings& of) {
  Terms terms{{}, 1.0};
  double error = 0.0;
  for (const double noise_error : noise_errors) {
    error = noise_error / 2.0 + of.number + 2.0 * error + (terms.errors.empty() ? 0.0 : of.relative + of.lost);
    terms.errors.push_back(std::min(error, 1.0));
  }
  return terms;
}

// t = (n + 1)*strength;  t = t - 2*floor(t/2);  z = min(t, 2 - t);  2*z - 1
//
// Only n + 1 and the product of t round: 2 - t is exact for t from 1 on. The difference may be fused with the product,
// so that t is less than 0 or more than 2 by the rounding of the product; this counts twice, then. In integers t is
// rounded down to 2^-30, and the term to 2^-21.
Terms waves(const Errors& noise_errors, double strength, double, const Roundings& of) {
  Terms terms{{}, 1.001};
  for (const double noise_error : noise_errors) {
    const double product = strength * (noise_error + of.relative * (2.0 + noise_error));
    const double t = product + 2.0 * (of.is_fixed ? of.cut + 0x1p-31 : kUnit * (2.0 * strength + product) + kTiny);
    terms.errors.push_back(
        std::min(2.0 * t + (of.is_fixed ? 0x1p-21 : kUnit * (1.0 + 2.0 * t)), of.is_fixed ? 2.0 : 2.001));
  }
  return terms;
}

// 1 - strength*(0.5 - 0.5*n)
double bend_error(double noise_error, double strength, const Roundings& of) {
  return std::min(strength * (noise_error / 2.0 + of.number + of.relative) + of.cut + of.number, 1.0);
}

// --- The mean ---

// The total of a detail's weights.
double detail_total(const OctaveArguments& arguments) {
  double total = 0.0;
  const int count = count_of(arguments);
  for (int i = 0; i < count; ++i) {
    const double part = i > 0 && i == count - 1 ? std::min(arguments.octaves, 32.0) - i : 1.0;
    total += std::pow(arguments.gain, i) * part;
  }
  return total;
}

// The bounds of the mean of the octaves. Each *_error bounds the error of its float.
//
//   sum = sum + amplitude*noise(q);  total = gain*total + 1;  amplitude = amplitude*gain;  value = sum / total
//   bent:       amplitude = amplitude*factor before that
//   footprint:  amplitude*fade, in place of the amplitude, adds to the sum: factor_errors are the fades'
//   detail:     the last amplitude is multiplied with its share, with which the total begins
//
// A term is at most the limit, exact as well as computed, so |sum| is at most limit * total; a division errs by up to
// 2.5 ulp. The total of a detail has terms that are not negative, each through no more than so many roundings.
double mean_error(const SumRule& rule, const OctaveArguments& arguments, double noise_limit, const Errors& noise_errors,
                  const Errors& factor_errors = {}) {
  const double strength = strength_of(rule, arguments);
  const Proof proof = proof_of(rule.step);
  const auto [term_errors, limit] = proof.terms(noise_errors, strength, noise_limit, kFloats);
  const double gain = arguments.gain;
  double amplitude = 1.0;
  double amplitude_error = 0.0;
  Total total;
  double sum_error = 0.0;
  for (std::size_t i = 0; i < noise_errors.size(); ++i) {
    double used_error = amplitude_error;
    const double most_amplitude = amplitude + amplitude_error;
    if (!factor_errors.empty()) used_error += most_amplitude * (factor_errors[i] + kUnit) + kTiny;
    if (arguments.is_detail) used_error += kUnit * most_amplitude + kTiny;
    sum_error += (amplitude + used_error) * (term_errors[i] + kUnit * limit) + limit * used_error + kTiny;
    total.add_octave(gain);
    sum_error += kUnit * (limit * total.value + sum_error);
    amplitude_error = gain * (amplitude_error + kUnit * most_amplitude) + kTiny;
    amplitude *= gain;
    if (proof.factor_error != nullptr) {
      const double factor_error = proof.factor_error(noise_errors[i], strength, kFloats) + kTiny;
      const double most = amplitude + amplitude_error;
      amplitude_error =
          std::min(amplitude_error + amplitude * factor_error, most) + kUnit * most + (1.0 + gain) * kTiny;
    }
  }
  if (total.value > kLargestTotal) return kInfinite;
  if (arguments.is_detail) {
    const int count = count_of(arguments);
    total.value = detail_total(arguments);
    total.error = total.value * rounding_of(2 * count) + 2.0 * total.value * count * kTiny;
  }
  const double error = (sum_error + limit * total.error) / (total.value - total.error);
  return error + 2.5 * kUnit * (limit + error) + kTiny;
}

// --- Derivatives and displacements ---
//
// The Jacobian of an octave is gain * lacunarity to the power of the octave, times rotations. So its columns have that
// length, but for what rotations stretch, and no vector becomes longer by more. Without rotations each axis is on its
// own, and coordinates stand for lengths. The lipschitz of a noise is the largest sum of the magnitudes of its
// derivatives: it bounds the lengths of gradients, and with them how far noise changes with the length of a step.

struct Jacobian {
  double length = 1.0;  // of a column, and how much longer a vector becomes
  double error = 0.0;   // of a column, as a length
};

// A number goes through 2 n operations, as the coordinate of a position does, of terms whose magnitudes sum to no more
// than the stretched length: the growth, the product with it, and a product and a sum for each of the rotations.
Jacobian next_jacobian(int axes, const OctaveArguments& arguments, const Jacobian& jacobian) {
  const double growth = arguments.gain * std::fabs(arguments.lacunarity) * stretch_of(axes, arguments);
  const double reach = jacobian.length + jacobian.error;
  double of_number = rounding_of(2 * axes) * growth * reach + kTiny * (4.0 * reach + 8.0);
  if (arguments.from_cell) {
    const double cut = arguments.lacunarity - cut_lacunarity(arguments);
    of_number += arguments.gain * cut * stretch_of(axes, arguments) * reach;
  }
  return {growth * jacobian.length, growth * jacobian.error + diagonal_of(axes, arguments) * of_number};
}

// Components of at most m whose magnitudes have a sum of at most L have the largest length where as many as can be are
// m, and one is the rest.
double longest_gradient(const FloatBounds& noise, const FloatBounds& slope) {
  const double full = std::floor(noise.lipschitz / slope.limit);
  const double rest = noise.lipschitz - full * slope.limit;
  return std::min(std::hypot(std::sqrt(full) * slope.limit, rest), std::sqrt(noise.axes) * slope.limit);
}

// How fast a noise changes: with a length, or with the largest coordinate.
double steepest(const OctaveArguments& arguments, const FloatBounds& noise, const FloatBounds& slope) {
  return rotates(noise.axes, arguments) ? longest_gradient(noise, slope) : noise.lipschitz;
}

// The largest slope of 1 / (1 + strength r^2) for r up to `reach`: it is steepest where strength r^2 = 1/3.
double steepest_fall(double strength, double reach) {
  const double r = strength > 0.0 ? std::min(reach, 1.0 / std::sqrt(3.0 * strength)) : reach;
  const double divisor = 1.0 + strength * r * r;
  return 2.0 * strength * r / (divisor * divisor);
}

// The errors of the factors 1 / (1 + strength |e|^2) of an erosion, and of their products with the weights:
//
//   e = clamp(rotated(e) + g, -8, 8);  1 / (strength*(e_x*e_x + e_y*e_y [+ e_z*e_z]) + 1) * weight
//
// A coordinate goes through 2 (n - 1) operations in the rotations, and one more. A clamp brings no two vectors further
// apart. The divisor goes through n + 2 operations of terms that are not negative.
Errors fall_errors(double strength, const OctaveArguments& arguments, const FloatBounds& noise,
                   const FloatBounds& slope) {
  const int axes = noise.axes;
  const double diagonal = std::sqrt(axes);
  const double ends = kLargestFall * diagonal;
  const double longest = longest_gradient(noise, slope);
  const double stretch = stretch_of(axes, arguments);
  const double rounding = rotates(axes, arguments) ? rounding_of(2 * (axes - 1)) : 0.0;
  const double of_factor = rounding_of(axes + 2) + 3.5 * kUnit + 1000.0 * kTiny;
  double error = 0.0;
  double reach = 0.0;
  Errors errors;
  for (const double slope_error : errors_at(arguments, slope, slope.lipschitz, slope.limit)) {
    error = stretch * error + diagonal * (rounding * stretch * (reach + error) + 8.0 * kTiny);
    error += diagonal * slope_error;
    error = std::min(error + kUnit * (stretch * reach + longest + error) + diagonal * kTiny, 2.0 * ends);
    reach = std::min(stretch * reach + longest, ends);
    errors.push_back(std::min(steepest_fall(strength, ends) * error + of_factor, 1.001));
  }
  return errors;
}

// A mean of n / (1 + strength |e|^2).
double eroded_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                        const FloatBounds& slope) {
  Errors terms = errors_at(arguments, noise, steepest(arguments, noise, slope), noise.limit);
  const Errors falls = fall_errors(strength_of(rule, arguments), arguments, noise, slope);
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i] += noise.limit * falls[i];
  return mean_error(rule, arguments, noise.limit, terms);
}

// The errors of the noise of each octave of a progressive warp; no component is beyond 1:
//
//   rate = amplitude / total;  q = q + (J v)*rate
//
// A coordinate of J v goes through n operations; the error of the noise comes back through the position in this way.
// From a cell what a position moves by is cut to 2^-24, and so is its fraction. HN_PRECISE replaces a step below 2^-96
// by 0.
Errors progressive_errors(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                          const FloatBounds& slope) {
  const int axes = noise.axes;
  const int count = count_of(arguments);
  const double diagonal = diagonal_of(axes, arguments);
  const double lipschitz = steepest(arguments, noise, slope);
  Total total;
  for (int i = 0; i < count; ++i) total.add_octave(arguments.gain);
  const double rate = amplitude_of(rule, arguments) / total.value;
  double rate_error = rate * total.error / (total.value - total.error);
  rate_error += 2.5 * kUnit * (rate + rate_error) + kTiny;
  OctavePosition at = first_octave(axes, arguments);
  Jacobian jacobian;
  Errors errors;
  for (int i = 0; i < count; ++i) {
    errors.push_back(error_at(arguments, noise, lipschitz, 1.0, at.error));
    const double of_matrix = diagonal * jacobian.error;
    const double step = jacobian.length * diagonal;
    const double step_error = jacobian.length * diagonal * errors.back() + of_matrix * diagonal +
                              diagonal * rounding_of(axes) * (jacobian.length + of_matrix) * diagonal +
                              4.0 * axes * kTiny;
    const double moved = rate * step;
    double moved_error = rate * step_error + rate_error * (step + step_error);
    moved_error += kUnit * (moved + moved_error) + diagonal * kSettled;
    at.error += moved_error;
    at.error += arguments.from_cell ? 2.0 * diagonal * kWhole : kUnit * (at.position + moved + at.error);
    at.position += moved;
    at = next_octave(axes, arguments, at);
    jacobian = next_jacobian(axes, arguments, jacobian);
  }
  return errors;
}

// amplitude * clamp(mean, -1, 1)
double shift_tolerance(const SumRule& rule, const OctaveArguments& arguments, const Errors& noise_errors) {
  const double error = std::min(mean_error(rule, arguments, 1.0, noise_errors), 2.0);
  return amplitude_of(rule, arguments) * (error + kUnit) + kSettled + kTiny;
}

double warp_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                      const FloatBounds& slope) {
  return shift_tolerance(rule, arguments, errors_at(arguments, noise, steepest(arguments, noise, slope), 1.0));
}

double progressive_tolerance(const SumRule& rule, const OctaveArguments& given, const FloatBounds& noise,
                             const FloatBounds& slope) {
  OctaveArguments arguments = given;
  arguments.exact_positions = false;  // of what moves, none is
  return shift_tolerance(rule, arguments, progressive_errors(rule, arguments, noise, slope));
}

// A sum of values. In a footprint each weight has a factor more.
double value_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                       const FloatBounds&) {
  const double limit = is_clamped(rule.step) ? std::min(noise.limit, 1.0) : noise.limit;
  const Errors errors = errors_at(arguments, noise, noise.lipschitz, limit);
  Errors factor_errors;
  for (std::size_t i = 0; arguments.footprint && i < errors.size(); ++i) factor_errors.push_back(fade_error(i));
  return mean_error(rule, arguments, limit, errors, factor_errors);
}

// --- Proofs by name ---
//
// No switch has a default: a step or a mean that is new has no proof, and is refused by its name.

[[noreturn]] void refuse(const std::string& what) {
  throw std::logic_error("conformance/sums/bounds.cpp has no proof of the " + what +
                         ": write it, and name it in the switch");
}

// For refuse, by their numbers.
constexpr auto kSteps = std::to_array<const char*>({
#define SUM_STEP(name) "step " #name,
#include "library/sums.inc"
});
constexpr auto kMeans = std::to_array<const char*>({
#define SUM_MEAN(name) "mean " #name,
#include "library/sums.inc"
});

Proof proof_of(SumStep step) {
  switch (step) {
    case SumStep::noise:
    case SumStep::turbulence:
    case SumStep::fbm_d:
      return {false, as_they_are, nullptr, value_tolerance};
    case SumStep::billow:
      return {true, as_they_are, nullptr, value_tolerance};
    case SumStep::ridged:
      return {true, ridges, nullptr, value_tolerance};
    case SumStep::hybrid:
      return {true, heights, nullptr, value_tolerance};
    case SumStep::ping_pong:
      return {true, waves, nullptr, value_tolerance};
    case SumStep::weighted:
      return {true, as_they_are, bend_error, value_tolerance};
    case SumStep::eroded:
      return {false, as_they_are, nullptr, eroded_tolerance};
    case SumStep::warp:
      return {true, as_they_are, nullptr, warp_tolerance};
    case SumStep::warp_progressive:
      return {true, as_they_are, nullptr, progressive_tolerance};
  }
  refuse(kSteps.at(static_cast<std::size_t>(step)));
}

//   billows = 2*mean - 1
//   t = clamp(2*mean + 0.25, 0, 1);  density = t*t*(3 - 2*t)
//
// The clamp leaves no more than 1, whatever the limit; the smoothstep has slopes up to 3/2 and three roundings,
// relative to a value of at most 1. A bounded mean is cut off, which brings no two values further apart.
double end_tolerance(SumMean end, double error) {
  switch (end) {
    case SumMean::as_it_is:
      return error;
    case SumMean::bounded:
      return error;
    case SumMean::density:
      return 1.5 * (2.0 * error + kUnit) + 3.001 * kUnit;
    case SumMean::billows:
      return 2.0 * error + kUnit * (1.0 + 2.0 * error);
  }
  refuse(kMeans.at(static_cast<std::size_t>(end)));
}

}  // namespace

bool has_jacobian(SumStep step) { return proof_of(step).tolerance != value_tolerance; }

bool is_clamped(SumStep step) { return proof_of(step).is_clamped; }

double octave_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                        const FloatBounds& slope) {
  const Proof proof = proof_of(rule.step);
  if (arguments.from_cell && !(arguments.lacunarity >= 0.0 && arguments.lacunarity <= 255.0)) return kInfinite;
  if (count_of(arguments) == 0) return end_tolerance(rule.mean, 0.0);
  if (has_jacobian(rule.step) && !in_domain(arguments)) return kInfinite;
  return end_tolerance(rule.mean, proof.tolerance(rule, arguments, noise, slope));
}

//   in the plane, with the Jacobian (c, s):  D_x = D_x + (c*g_x + s*g_y);  D_y = D_y + (c*g_y - s*g_x)
//   in space, along each axis:               D = D + ((R_x*g_x + R_y*g_y) + R_z*g_z)
//   value = D / total
//
// The products of a column with a gradient have magnitudes whose sum is at most the product of lengths (Cauchy).
double octave_slope_tolerance(const SumRule& rule, const OctaveArguments& arguments, const FloatBounds& noise,
                              const FloatBounds& slope) {
  if (rule.step != SumStep::fbm_d)
    refuse(std::string("derivatives of the ") + kSteps.at(static_cast<std::size_t>(rule.step)));
  if (arguments.from_cell && !(arguments.lacunarity >= 0.0 && arguments.lacunarity <= 255.0)) return kInfinite;
  if (count_of(arguments) == 0) return 0.0;
  if (!in_domain(arguments)) return kInfinite;
  const int axes = noise.axes;
  const double diagonal = diagonal_of(axes, arguments);
  const double longest = rotates(axes, arguments) ? longest_gradient(noise, slope) : slope.limit;
  Jacobian jacobian;
  Total total;
  double largest = 0.0;
  double sum_error = 0.0;
  for (const double error : errors_at(arguments, slope, slope.lipschitz, slope.limit)) {
    const double reach = jacobian.length + jacobian.error;
    sum_error += reach * diagonal * error + jacobian.error * longest;
    sum_error += rounding_of(axes) * reach * (longest + diagonal * error) + 2.0 * axes * kTiny;
    largest += jacobian.length * longest;
    sum_error += kUnit * (largest + sum_error);
    total.add_octave(arguments.gain);
    jacobian = next_jacobian(axes, arguments, jacobian);
  }
  const double mean = largest / total.value;
  const double error = (sum_error + mean * total.error) / (total.value - total.error);
  return error + 2.5 * kUnit * (mean + error) + kSettled + kTiny;
}

}  // namespace hn
