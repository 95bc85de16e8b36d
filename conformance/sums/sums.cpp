#include "sums/sums.hpp"

#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "sums/text.hpp"

namespace hn::sums {
namespace {

constexpr double kSettled = 0x1p-96;  // below which HN_PRECISE makes a result 0

using Body = uvec4 (*)(uvec4, uvec4, uvec4, uvec4);

#define float Float
#define int Int
const std::unordered_map<std::string_view, Body> kBodies = {
#define FUNCTION(...)
#define SUM_FUNCTION(id, family, configurations, columns, ...)                                              \
  {id, [](uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, [[maybe_unused]] uvec4 d) -> uvec4 { \
     __VA_ARGS__                                                                                            \
   }},
#ifdef SUMS_OWN
#include "bodies.inc"
#else
#include "library/bodies.inc"
#endif
};
#undef float
#undef int

Errors errors_of(Body body, std::span<const Uint, 16> words, const Noises& of) {
  const prover::Proving rounding_up;
  noises = &of;
  uvec4 in[4];
  for (std::size_t i = 0; i < 4; ++i) in[i] = {words[4 * i], words[4 * i + 1], words[4 * i + 2], words[4 * i + 3]};
  try {
    const uvec4 found = body(in[0], in[1], in[2], in[3]);
    Errors errors = {found.x.off, found.y.off, found.z.off, found.w.off};
    for (double& error : errors) {
      if (std::isnan(error)) error = HUGE_VAL;
      if (error > 0.0 && HN_ARITHMETIC != HN_FIXED) error += kSettled;
    }
    return errors;
  } catch (Unbounded) {
    return {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  } catch (const Unseen& unseen) {
    throw std::logic_error("conformance/sums has no proof of " + unseen.step);
  }
}

}  // namespace

// Components of at most m whose magnitudes have a sum of at most L have the largest length where as many as can be are
// m, and one is the rest.
Noise::Noise(int axes, const Summary& of_value, const Summary& of_slope)
    : value(of_value), slope(of_slope), steepest(of_value.lipschitz) {
  if (slope.limit == 0.0) return;
  const double full = std::floor(value.lipschitz / slope.limit), rest = value.lipschitz - full * slope.limit;
  steepest = std::min(std::hypot(std::sqrt(full) * slope.limit, rest), std::sqrt(axes) * slope.limit);
}

Errors errors_of(std::string_view function, std::span<const std::uint32_t> words, const Noises& of) {
  std::array<Uint, 16> in;
  std::ranges::copy(words, in.begin());
  return errors_of(kBodies.at(function), in, of);
}

}  // namespace hn::sums
