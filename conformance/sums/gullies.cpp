#include "sums/gullies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hn {
namespace {

constexpr double kUnit = 0x1p-23;     // the largest relative error of one operation, in any rounding mode
constexpr double kTiny = 0x1p-126;    // the largest error of flushing a subnormal to 0
constexpr double kSettled = 0x1p-96;  // below which HN_PRECISE makes a result 0
constexpr double kInfinite = std::numeric_limits<double>::infinity();

int count_of(const GulliesArguments& arguments) {
  return arguments.octaves < 0x1p-32 ? 0 : static_cast<int>(std::ceil(std::min(arguments.octaves, 32.0)));
}

// Relative, of so many operations.
double rounding_of(int operations) { return std::pow(1.0 + kUnit, operations) - 1.0; }

// The error of clamp(3/2 - e, 0, 1), e = footprint * max(lacunarity, 1)^i computed step by step. It counts up to 3/2
// only.
double fade_error(int i) {
  return 1.501 * (std::pow(1.0 + kUnit, static_cast<double>(i)) - 1.0) + 1.001 * kUnit + 2.0 * kTiny;
}

// The total of the weights, octave by octave: total = gain*total + 1.
struct Total {
  double value = 0.0;
  double error = 0.0;

  void add_octave(double gain) {
    const double product_error = gain * (error + kUnit * (value + error)) + kTiny;
    value = 1.0 + gain * value;
    error = product_error + kUnit * (value + product_error);
  }
};

// Whether no weight, and no number of a Jacobian, overflows. GLSL bounds the error of a division for divisors up to
// 2^126.
bool in_domain(const GulliesArguments& arguments) {
  Total total;
  for (int i = 0; i < count_of(arguments); ++i) total.add_octave(arguments.gain);
  const double growth = std::fabs(arguments.gain * arguments.lacunarity);
  return total.value <= 0x1p126 && std::pow(growth, std::max(count_of(arguments) - 1, 0)) <= 0x1p96;
}

// Each octave, with r = |e|, A = depth * (gain * lacunarity)^i and the fade f of a footprint:
//
//   r = root(e_x*e_x + e_y*e_y);  u = e / (r + 1/8);  s = r / (r + 1/8);  k = 3/2 (-u_y, u_x)
//   sum = sum + gain^i*s*f * v(q, k);  e = clamp(e + A*s*f * g(q, k), -8, 8)
//
// ERRORS OF e. Where e is off by d, s is off by up to d / 8 / (r + 1/8)^2 and u by d / (r + 1/8). With G the largest
// length of g, and G' how fast it changes with k, s*g is off by
//
//   (G / 8 + 3/2 G' r) / (r + 1/8)^2 * d
//
// and this is the larger the nearer r is to 0, or to where it is largest. No octave takes e further than A*f*G*s. So r
// is known to be in a range, and, but for d, it is in that between e and what is computed in its place, too. A clamp
// brings no two vectors further apart. Errors and slopes are lengths.
//
// ROUNDINGS. A square root is within 6 ulp and a quotient within 3 (docs/measured/accuracy.md). The sum of the squares
// rounds twice, which moves the root by one, and the sum with 1/8 once; so r is off by 7, s by 18 and u by 11 of kUnit.
// The square of a slope below 2^-63 may become 0. HN_PRECISE replaces a component of a slope below 2^-32 by 0.

constexpr double kFlat = 1.0 / 8.0;  // how steep ground is where gullies are half as deep as they can be
constexpr double kWave = 3.0 / 2.0;
constexpr double kLargestSlope = 8.0;  // of a component
constexpr double kLargestDepth = 8.0;
constexpr double kLargestHeight = 1.0;   // of v
constexpr double kSmallSlope = 0x1p-31;  // more than the length that 0 replaces
constexpr double kSmallRoot = 0x1p-59;   // what u loses where a square becomes 0, and more
const double kDiagonal = std::sqrt(2.0);

double steepness(double r) { return r / (r + kFlat); }

// The largest (a / 8 + b r) / (r + 1/8)^2 from some r on: it rises up to an r, and falls from there.
double largest_rate(double a, double b, double r) {
  const double at = std::max(r, b > 0.0 ? kFlat * (1.0 - 2.0 * a / b) : 0.0);
  return (a * kFlat + b * at) / ((at + kFlat) * (at + kFlat));
}

// The slope before an octave: from `least` to `most` long, and off by `error`.
struct Slope {
  double least;
  double most;
  double error;
};

// The product of s and f with a number, v or g, of an octave: how large it is at most, and its error.
struct Product {
  double largest;
  double error;
};

// `limit` is the largest length of the number, `wave_rate` how fast it changes with k, and `error` what it is off by at
// a right position and wave.
Product product(const Slope& slope, double limit, double wave_rate, double error, double fade, double fade_off) {
  const double s = steepness(slope.most);
  const double s_error = 18.5 * kUnit * s + kSmallRoot;
  const double u_error = 12.5 * kUnit * s + kSmallRoot;  // with the product with 3/2
  const double number_error = std::min(wave_rate * kWave * u_error + error, 2.0 * limit);
  const double nearest = std::max(slope.least - slope.error, 0.0);
  double off = largest_rate(limit, kWave * wave_rate, nearest) * slope.error;
  off += s * number_error + s_error * (limit + number_error);
  off = fade * off + fade_off * (s + s_error) * (limit + number_error);
  // Both products are of at most 1 and the limit, exact as well as computed.
  return {fade * s * limit, std::min(off, 2.001 * limit)};
}

double fade_of(const GulliesArguments& arguments, int i) {
  if (!arguments.footprint) return 1.0;
  const double size = 2.0 * *arguments.footprint * std::pow(std::max(arguments.lacunarity, 1.0), i);
  return std::clamp(1.5 - size, 0.0, 1.0);
}

Slope next_slope(const Slope& slope, double rate, const Product& step, int i) {
  // The rate has a power of each of gain and lacunarity, and their product; then the depth, s and f, and g.
  const double largest = rate * step.largest;
  double error = rate * step.error;
  error += rounding_of(2 * i + 6) * (largest + error) + rate * kTiny + kTiny;
  error += slope.error;
  const double ends = kDiagonal * kLargestSlope;
  error += kUnit * (std::min(slope.most, ends) + largest + error) + kSmallSlope;
  return {std::max(slope.least - largest, 0.0), std::min(slope.most + largest, ends), std::min(error, 2.0 * ends)};
}

}  // namespace

GulliesTolerance gullies_tolerance(const GulliesArguments& arguments, const GulliesBounds& bounds) {
  const double depth = std::clamp(arguments.depth, 0.0, kLargestDepth);
  if (count_of(arguments) == 0 || depth == 0.0) return {0.0, 0.0};
  if (!in_domain(arguments)) return {kInfinite, kInfinite};
  double position_error = arguments.exact_positions ? 0.0 : 0x1p-24;  // of a coordinate: a tile does not rotate
  Slope slope{std::max(arguments.slope - kSmallSlope, 0.0), arguments.slope, kSmallSlope};
  double weight = 1.0;
  double rate = depth;
  double moved = 0.0;
  double sum = 0.0;
  double sum_error = 0.0;
  Total total;
  for (int i = 0; i < count_of(arguments); ++i) {
    const double fade = fade_of(arguments, i);
    const double fade_off = arguments.footprint ? fade_error(i) : 0.0;
    const Product height = product(slope, kLargestHeight, bounds.wave_rate,
                                   bounds.lipschitz * position_error + bounds.value, fade, fade_off);
    const Product step = product(slope, bounds.steepest, bounds.slope_wave_rate,
                                 kDiagonal * (bounds.slope_lipschitz * position_error + bounds.slope), fade, fade_off);
    const double term_error = weight * height.error;
    sum += weight * height.largest;
    sum_error += term_error + rounding_of(i + 4) * (weight * height.largest + term_error) + 2.0 * kTiny;
    sum_error += kUnit * (sum + sum_error);
    slope = next_slope(slope, rate, step, i);
    moved = std::min(moved + rate * step.largest, 2.0 * kLargestSlope);
    total.add_octave(arguments.gain);
    weight *= arguments.gain;
    rate *= arguments.gain * arguments.lacunarity;
    position_error *= arguments.lacunarity;  // a product with a whole number is exact
  }
  const double most = 2.0 * depth * (total.value + total.error);
  const double height = std::min(depth * (sum_error + kUnit * (sum + sum_error)), most) + kSettled + kTiny;
  const double added = slope.error + kUnit * (moved + slope.error);
  return {height, std::min(added, 2.0 * kLargestSlope * (1.0 + kUnit)) + kSettled};
}

}  // namespace hn
