// The text of the library over floats that round as badly as GLSL lets them, or over doubles, for the tests of
// tools/make bounds. The file rounded.inc, which rounded.py writes, has a FUNCTION(body) for each function: those of
// the suite's table.
//
// `evaluate` has the results of one of them at points of 16 words, 4 words each. The mode is 0 to nearest, 1 down, 2
// up, 3 either at random, 4 not at all; a*b + c is rounded once with the probability `fuse`. With mode 4 there are 16
// doubles for each point, too, and the word of a float is the index of one; of results, too, there are 4 words and 4
// doubles.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hashnoise/glsl.hpp>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "config.glsl"

// The operands of roots and the divisors of an evaluation in doubles, for who clears it: where one is 0 the text is
// singular.
std::vector<double> singular;

namespace hashnoise {
namespace rounded {

// A literal, or a result of literals alone, such as 1.0f / 6.0f, with its decimals, which a float need not hold.
struct Literal {
  long double exact;

  friend constexpr Literal operator-(Literal a) { return {-a.exact}; }
  friend constexpr Literal operator+(Literal a, Literal b) { return {a.exact + b.exact}; }
  friend constexpr Literal operator-(Literal a, Literal b) { return {a.exact - b.exact}; }
  friend constexpr Literal operator*(Literal a, Literal b) { return {a.exact * b.exact}; }
  friend constexpr Literal operator/(Literal a, Literal b) { return {a.exact / b.exact}; }
};
consteval Literal operator""_f(long double x) { return {x}; }

constexpr int kExact = 4;  // the mode in which nothing rounds

struct Rounding {
  int mode = 0;
  double fuse = 0.0;
  std::uint64_t state = 0;

  double random() {  // in [0, 1)
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 40) * 0x1p-24;
  }

  // One of the two floats around x; x itself, if it is a float, or too small to differ from 0.
  double round(double x) {
    if (mode == kExact) return x;
    const float nearest = static_cast<float>(x);
    if (mode == 0 || static_cast<double>(nearest) == x || std::fabs(x) < 0x1p-126) return static_cast<double>(nearest);
    const bool up = mode == 3 ? random() < 0.5 : mode == 2;
    if ((static_cast<double>(nearest) > x) == up) return static_cast<double>(nearest);
    return static_cast<double>(std::nextafter(nearest, up ? HUGE_VALF : -HUGE_VALF));
  }
};
inline Rounding rounding;

// A float, and where it is a product the exact one, which a sum may take in its place.
struct Rounded {
  double value = 0.0;
  double exact = 0.0;

  Rounded() = default;
  Rounded(float x) : value(static_cast<double>(x)), exact(value) {}
  Rounded(Literal x) : Rounded(of(static_cast<double>(x.exact))) {}
  template <typename Integer>
  requires std::is_integral_v<Integer>
  explicit Rounded(Integer n) : value(rounding.round(static_cast<double>(n))), exact(value) {}
  static Rounded of(double x) {
    Rounded rounded;
    rounded.value = rounded.exact = rounding.round(x);
    return rounded;
  }

  explicit operator int() const { return static_cast<int>(std::clamp(value, -0x1p31, 0x1p31 - 1.0)); }
  explicit operator uint() const { return static_cast<uint>(std::clamp(value, 0.0, 0x1p32 - 1.0)); }

  bool fuses() const { return exact != value && rounding.random() < rounding.fuse; }
  friend Rounded sum(Rounded a, Rounded b, double sign) {
    if (a.fuses()) return of(a.exact + sign * b.value);
    if (b.fuses()) return of(a.value + sign * b.exact);
    return of(a.value + sign * b.value);
  }
  friend Rounded operator+(Rounded a, Rounded b) { return sum(a, b, 1.0); }
  friend Rounded operator-(Rounded a, Rounded b) { return sum(a, b, -1.0); }
  friend Rounded operator*(Rounded a, Rounded b) {
    Rounded product = of(a.value * b.value);
    product.exact = a.value * b.value;
    return product;
  }
  friend Rounded operator/(Rounded a, Rounded b) {
    singular.push_back(b.value);
    return of(a.value / b.value);
  }
  friend Rounded operator-(Rounded a) {
    a.value = -a.value;
    a.exact = -a.exact;
    return a;
  }
  friend Rounded& operator+=(Rounded& a, Rounded b) { return a = a + b; }
  friend Rounded& operator-=(Rounded& a, Rounded b) { return a = a - b; }
  friend Rounded& operator*=(Rounded& a, Rounded b) { return a = a * b; }
  friend bool operator<(Rounded a, Rounded b) { return a.value < b.value; }
  friend bool operator>(Rounded a, Rounded b) { return a.value > b.value; }
  friend bool operator<=(Rounded a, Rounded b) { return a.value <= b.value; }
  friend bool operator>=(Rounded a, Rounded b) { return a.value >= b.value; }
  friend bool operator==(Rounded a, Rounded b) { return a.value == b.value; }
};

using hashnoise::abs;
using hashnoise::floor;
using hashnoise::max;
using hashnoise::min;
inline Rounded exactly(double x) {
  Rounded rounded;
  rounded.value = rounded.exact = x;
  return rounded;
}
inline Rounded floor(Rounded x) { return exactly(std::floor(x.value)); }
inline Rounded trunc(Rounded x) { return exactly(std::trunc(x.value)); }
inline Rounded abs(Rounded x) { return exactly(std::fabs(x.value)); }
inline Rounded sqrt(Rounded x) {
  singular.push_back(x.value);
  return Rounded::of(std::sqrt(x.value));
}
inline Rounded min(Rounded x, Rounded y) { return y < x ? y : x; }
inline Rounded max(Rounded x, Rounded y) { return x < y ? y : x; }
inline Vector2<Rounded> floor(Vector2<Rounded> v) { return {floor(v.x), floor(v.y)}; }
inline Vector3<Rounded> floor(Vector3<Rounded> v) { return {floor(v.x), floor(v.y), floor(v.z)}; }
inline Vector4<Rounded> floor(Vector4<Rounded> v) { return {floor(v.x), floor(v.y), floor(v.z), floor(v.w)}; }
// Without roundings the bits of a double stand for the double, up to their sign: three are kept.
inline double kept[3];
inline uint floatBitsToUint(Rounded x, int i = 0) {
  kept[i] = std::fabs(x.value);
  return std::bit_cast<uint>(static_cast<float>(x.value));
}
inline Rounded uintBitsToFloat(uint bits, int i = 0) {
  const double found = static_cast<double>(std::bit_cast<float>(bits));
  const bool is_that = rounding.mode == kExact && static_cast<double>(static_cast<float>(kept[i])) == std::fabs(found);
  return exactly(is_that ? std::copysign(kept[i], found) : found);
}
inline Vector3<Rounded> uintBitsToFloat(uvec3 v) {
  return {uintBitsToFloat(v.x, 0), uintBitsToFloat(v.y, 1), uintBitsToFloat(v.z, 2)};
}
inline uvec3 floatBitsToUint(Vector3<Rounded> v) {
  return {floatBitsToUint(v.x, 0), floatBitsToUint(v.y, 1), floatBitsToUint(v.z, 2)};
}

using vec2 = Vector2<Rounded>;
using vec3 = Vector3<Rounded>;
using vec4 = Vector4<Rounded>;
using hn_float = Rounded;
using hn_vec2 = vec2;
using hn_vec3 = vec3;
using hn_vec4 = vec4;

#ifdef ERRORS_OWN
#include "own_doubles.hpp"
#endif
// The constructor of a scalar is a keyword of C++.
#define float Rounded
// The exact noise has the sine, and not its polynomial.
Rounded hn_i_polynomial_sine(uint q);
inline Rounded hn_i_quarter_sine(uint q) {
  return rounding.mode == kExact ? exactly(std::sin(std::ldexp(q * std::numbers::pi, -31))) : hn_i_polynomial_sine(q);
}
#include "hashnoise.glsl"
#ifdef ERRORS_OWN
#include "own.hpp"
#endif

// Of an evaluation in doubles: a word is the index of one.
inline const double* arguments = nullptr;
inline std::vector<double> results;
Rounded float_of(uint bits) { return rounding.mode == kExact ? exactly(arguments[bits]) : uintBitsToFloat(bits); }
uint bits_of(Rounded x) {
  if (rounding.mode != kExact) return floatBitsToUint(x);
  results.push_back(x.value);
  return static_cast<uint>(results.size() - 1);
}
#define SEEDED(s) , s
#define SEED(s) s
#define FUNCTION(...) \
  [](uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, [[maybe_unused]] uvec4 d) -> uvec4 { __VA_ARGS__ },
using Body = uvec4 (*)(uvec4, uvec4, uvec4, uvec4);
const Body kBodies[] = {
#include "rounded.inc"
};

}  // namespace rounded
}  // namespace hashnoise
#undef float

extern "C" void evaluate(std::int32_t function, std::int32_t mode, std::uint32_t seed, double fuse, std::int32_t count,
                         const std::uint32_t* in, const double* in_exactly, std::uint32_t* out, double* out_exactly) {
  using namespace hashnoise;
  rounded::rounding = {mode, fuse, seed};
  for (const std::uint32_t* x = in; x != in + 16 * static_cast<std::ptrdiff_t>(count); x += 16) {
    rounded::arguments = in_exactly + (x - in);
    const uvec4 found = rounded::kBodies[function]({x[0], x[1], x[2], x[3]}, {x[4], x[5], x[6], x[7]},
                                                   {x[8], x[9], x[10], x[11]}, {x[12], x[13], x[14], x[15]});
    for (const std::uint32_t word : {found.x, found.y, found.z, found.w}) {
      *out++ = word;
      if (mode == rounded::kExact) *out_exactly++ = word < rounded::results.size() ? rounded::results[word] : 0.0;
    }
    rounded::results.clear();
    if (count > 1) singular.clear();
  }
}
