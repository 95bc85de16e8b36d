// Numbers that count how far they are off, for the text of sums: each operation adds its rounding, in any rounding
// mode, with products fused or not (docs/measured/accuracy.md, "Fast and precise"). Where a Proving lives, all ends are
// rounded outward.
//
// A number is in [lo, hi], exact as well as computed, and both are no further apart than `off`.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>

#include "interval.hpp"

namespace hn::sums {

using prover::Interval;

struct Unseen {  // a step without a proof
  std::string step;
};
[[noreturn]] inline void refuse(const char* step) { throw Unseen{step}; }
struct Unbounded {};  // no error is bounded

constexpr double kTiny = 0x1p-126;  // results below may become 0
constexpr double kUnit = 0x1p-23;   // the largest relative rounding
constexpr int kNoGrid = -300;

// More of a number than its error:
//
//   kCoordinate  of a vector: a part of its error is that of one error of the vector, which is no longer than `length`,
//                and the rest is its own. The vector itself is no longer than `reach`. A rotation makes no vector
//                longer, but each coordinate
//   kSquares     a sum of the squares of such coordinates
//   kSquare      of a number that is off by `length`, and further off by `own`
enum Kind : signed char { kPlain, kCoordinate, kSquares, kSquare };
struct More {
  Kind kind = kPlain;
  unsigned char axes = 0;  // a bit for each
  std::int32_t vector = 0;
  double length = 0, own = 0, reach = HUGE_VAL;
};

struct Number {
  double lo = 0, hi = 0, off = 0;
  int grid = 0;  // the computed number is a multiple of 2^grid
  More of = {};

  double size() const { return std::max(std::fabs(lo), std::fabs(hi)); }
  bool is_exact() const { return off == 0 && lo == hi; }
  bool is_zero() const { return lo == 0 && hi == 0; }
};

inline int grid_of(double x) {
  if (x == 0) return 1000;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return static_cast<int>(bits >> 52 & 0x7FF) - 1075 + std::countr_zero(bits | std::uint64_t{1} << 52);
}
inline Number known(double x) { return {x, x, 0, grid_of(x)}; }
inline Number between(double lo, double hi, double off) { return {lo, hi, off, kNoGrid}; }
// The distance of floats that are no larger.
inline double ulp(double size) {
  const std::uint64_t below = std::bit_cast<std::uint64_t>(size * 0x1p-23) - (size > 0);
  return std::bit_cast<double>(below & 0x7FF0000000000000u);
}
inline double power_of_two(int exponent) { return std::bit_cast<double>(std::uint64_t(exponent + 1023) << 52); }
// Further off by errors in [least, most].
inline Number off_by(Number x, double least, double most) {
  const double more = std::max(-least, most);
  x.lo = -(-least - x.lo), x.hi += most, x.off += more;
  if (x.of.kind != kSquares) x.of.own += more;
  return x;
}
// Below 2^-126 it may become 0.
inline Number flushed(const Number& x) {
  return x.grid >= -126 || x.lo >= kTiny || x.hi <= -kTiny ? x : off_by(x, -kTiny, kTiny);
}
// A float that is made of x: nothing happens if x is one.
inline Number rounded(Number x) {
  const double size = x.size();
  if (!(size < 0x1p127)) throw Unbounded{};
  if (x.is_exact()) x.grid = grid_of(x.lo);
  if (x.grid >= -149 && size <= power_of_two(std::min(x.grid + 24, 1000))) return x;
  // A float next to a number between two floats is between them, too.
  const double error = ulp(size), lo = -static_cast<double>(static_cast<float>(-x.lo));
  const double hi = static_cast<double>(static_cast<float>(x.hi));
  x = off_by(x, -error, error);
  x.lo = lo, x.hi = hi, x.grid = kNoGrid;
  return flushed(x);
}

inline More if_linear(const More& of) { return of.kind == kCoordinate ? of : More{}; }
inline Number negative(const Number& a) { return {-a.hi, -a.lo, a.off, a.grid, if_linear(a.of)}; }
inline Number plus(const Number& a, const Number& b) {
  Number x{-(-a.lo - b.lo), a.hi + b.hi, a.off + b.off, std::min(a.grid, b.grid)};
  const More &u = a.of, &v = b.of;
  if (u.kind == kSquares && v.kind == kSquares) {
    const bool one = u.vector == v.vector && (u.axes & v.axes) == 0;
    x.of = {kSquares,
            static_cast<unsigned char>(u.axes | v.axes),
            u.vector,
            std::max(u.length, v.length),
            std::hypot(u.own, v.own),
            std::hypot(u.reach, v.reach)};
    if (!one) x.of.axes = 255, x.of.length = 0, x.of.own = std::hypot(u.length + u.own, v.length + v.own);
  } else if (u.kind == kCoordinate && v.kind == kCoordinate && u.axes == v.axes) {
    x.of = {kCoordinate,         u.axes,        (u.vector * 8191 + v.vector) & 0x7FFFFFFF,
            u.length + v.length, u.own + v.own, u.reach + v.reach};
  } else if (u.kind == kCoordinate || v.kind == kCoordinate) {
    const Number& other = u.kind == kCoordinate ? b : a;
    x.of = u.kind == kCoordinate ? u : v;
    x.of.own += other.off, x.of.reach += 2 * other.size();  // of up to four
  }
  return x;
}
inline Number times(const Number& a, const Number& b) {
  const Interval range = Interval{a.lo, a.hi} * Interval{b.lo, b.hi};
  Number x{range.lo, range.hi, a.off * b.size() + b.off * a.size(), std::max(a.grid + b.grid, kNoGrid)};
  const More& u = a.of;
  if (u.kind == kCoordinate && b.of.kind != kCoordinate) {
    const double by = b.size();
    x.of = {kCoordinate, u.axes, u.vector, by * u.length, by * u.own + b.off * a.size(), by * u.reach};
  }
  return x;
}
// The product of two squares is the square of the product. (r + l) (s + m) = r s + l (s + m) + m r.
inline More root_of_product(const Number& a, const Number& b, bool same) {
  if (same) return {kSquare, 0, 0, a.off, 0};
  const bool are_squares = b.of.kind == kSquare;
  if (a.of.kind != kSquare || !(are_squares || (b.is_exact() && b.lo >= 0))) return {};
  const More of = are_squares ? b.of : More{};
  return {kSquare, 0, 0, a.of.length * std::sqrt(b.size()) + of.length * std::sqrt(a.size()),
          a.of.own * b.size() + of.own * a.size()};
}
// Twice a number.
inline Number doubled(const Number& a) {
  Number x = plus(a, a);
  if (a.of.kind == kSquare) x.of = {kSquare, 0, 0, std::sqrt(2.0) * a.of.length, 2 * a.of.own};
  return x;
}
// The error of a square follows from its root's, too.
inline Number squared(Number x) {
  if (x.of.kind == kSquare) x.off = std::min(x.off, 2 * x.of.length * std::sqrt(x.size()) + x.of.own);
  return x;
}
inline int new_name() {
  static thread_local int last = 0;
  return ++last;
}
inline bool is_power_of_two(const Number& x) {
  return x.is_exact() && x.lo != 0 && (std::bit_cast<std::uint64_t>(x.lo) & 0xFFFFFFFFFFFFFu) == 0;
}
// An exact bound takes no coordinate further from another.
inline Number least(const Number& a, const Number& b) {
  if (a.hi <= b.lo) return a;
  if (b.hi <= a.lo) return b;
  return {std::min(a.lo, b.lo), std::min(a.hi, b.hi), std::max(a.off, b.off), std::min(a.grid, b.grid),
          b.is_exact()   ? a.of
          : a.is_exact() ? b.of
                         : More{}};
}
inline Number magnitude(const Number& a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return negative(a);
  return {0, a.size(), a.off, a.grid};
}
inline bool is_less(const Number& a, const Number& b) {
  if (a.hi < b.lo) return true;
  if (a.lo >= b.hi) return false;
  throw Unbounded{};
}

// --- The types of the text ---

template <bool Signed>
struct Integer;

struct Float : Number {
  int name = new_name();
  int cell = 0;  // it is the floor of the number with that name; -1: a fraction beside such a floor
  Float() : Float(known(0)) {}
  template <std::same_as<float> T>
  Float(T x) : Float(known(static_cast<double>(x))) {}
  template <std::integral T>
  explicit Float(T x) : Float(rounded(known(static_cast<double>(x)))) {}
  explicit Float(const Number& x) : Number(x) { off = std::min(off, hi - lo); }
  template <bool Signed>
  explicit Float(const Integer<Signed>& x);

  // Nothing is computed from a fraction of a cell that may be another in exact arithmetic: summaries alone take it.
  friend const Float& seen(const Float& a) {
    if (a.cell < 0) refuse("a fraction of a number that rounds");
    return a;
  }
  friend Float operator+(const Float& x, const Float& y) {
    const Float &a = seen(x), &b = seen(y);
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return Float(a.name == b.name ? doubled(a) : rounded(plus(a, b)));
  }
  friend Float operator-(const Float& minuend, const Float& b) {
    const Float& a = seen(minuend);
    seen(b);
    if (b.cell != a.name) return Float(rounded(plus(a, negative(b))));
    // A fraction of a cell: the exact number is as far from its cell, which may be another. It has no more than 24 bits
    // behind the point, but where a is below 0, and rounds to these.
    Number x{0, 1, a.off, a.grid, a.of};
    if (a.grid < -24) x = off_by(x, -0x1p-24, 0x1p-24);
    x.lo = -a.off, x.hi = 1 + a.off;
    Float fraction(x);
    if (a.off > 0) fraction.cell = -1;
    return fraction;
  }
  friend Float operator*(const Float& left, const Float& right) {
    const Float &a = seen(left), &b = seen(right);
    if (a.is_zero() || b.is_zero()) return Float();
    Number x = times(a, b);
    const bool same = a.name == b.name;
    if (same) x.lo = std::max(x.lo, 0.0);
    More of = root_of_product(a, b, same);
    // A float times a power of two is one, but below 2^-126.
    x = is_power_of_two(a) || is_power_of_two(b) ? flushed(x) : rounded(x);
    if (of.kind == kSquare) {  // a relative rounding moves the root by half of it
      of.length += kUnit / 2 * std::sqrt(x.size()), of.own += kTiny;
      x.of = of;
    }
    x = squared(x);
    return Float(x);
  }
  // GLSL bounds its error for divisors up to 2^126 only.
  friend Float operator/(const Float& a, const Float& b) {
    seen(a), seen(b);
    if (!(b.lo > 0 && b.hi < 0x1p126)) throw Unbounded{};
    const double inverse = 1 / b.lo;
    const Interval range = Interval{a.lo, a.hi} * Interval{-(-1 / b.hi), inverse};
    Number x = between(range.lo, range.hi, 0);
    x.off = (a.off + x.size() * b.off) * inverse;
    const double error = 2.5 * ulp(x.size()) + kTiny;
    return Float(off_by(x, -error, error));
  }
  friend Float operator-(const Float& a) { return Float(negative(seen(a))); }
  friend Float& operator+=(Float& a, const Float& b) { return a = a + b; }
  friend Float& operator-=(Float& a, const Float& b) { return a = a - b; }
  friend Float& operator*=(Float& a, const Float& b) { return a = a * b; }
  friend Float min(const Float& a, const Float& b) { return Float(least(seen(a), seen(b))); }
  friend Float max(const Float& a, const Float& b) { return -min(-a, -b); }
  friend Float abs(const Float& a) { return Float(magnitude(seen(a))); }
  friend Float sqrt(const Float& a) {
    seen(a);
    const double least = a.lo > 0 ? std::sqrt(a.lo) * (1 - 0x1p-50) : 0, most = std::sqrt(std::max(a.hi, 0.0));
    const double off = std::min(std::sqrt(a.off), least > 0 ? a.off / (2 * least) : HUGE_VAL);
    const double error = 6 * ulp(most) + kTiny;
    return Float(off_by(between(least, most, off), -error, error));
  }
  friend Float floor(const Float& a) {
    seen(a);
    if (a.is_exact()) return Float(known(std::floor(a.lo)));
    Float x(Number{std::floor(a.lo), std::floor(a.hi), a.off + 1, 0});
    x.cell = a.name;
    return x;
  }
  friend Float trunc(const Float& a) {
    if (!a.is_exact()) refuse("what is cut off towards 0");
    return Float(known(std::trunc(a.lo)));
  }
  friend Float sin(const Float&) { refuse("a sine"); }
  friend Float cos(const Float&) { refuse("a cosine"); }
  friend bool operator<(const Float& a, const Float& b) { return is_less(seen(a), seen(b)); }
  friend bool operator>(const Float& a, const Float& b) { return b < a; }
  friend bool operator<=(const Float& a, const Float& b) { return !(b < a); }
  friend bool operator>=(const Float& a, const Float& b) { return !(a < b); }
  // Only whether nothing is left of an octave: the sum ends there, and loses nothing if it does not.
  friend bool operator==(const Float& a, const Float& b) { return a.is_exact() && b.is_exact() && a.lo == b.lo; }
};

// A literal of a text whose floats may hold fewer digits than it has.
inline Float operator""_f(long double x) {
  const auto exact = static_cast<double>(x);
  return static_cast<long double>(exact) == x && grid_of(exact) >= std::ilogb(exact == 0 ? 1 : exact) - 23
             ? Float(known(exact))
             : Float(off_by(between(exact, exact, 0), -2 * ulp(std::fabs(exact)), 2 * ulp(std::fabs(exact))));
}

// Signed or not: an unsigned number stands for itself modulo 2^32.
template <bool Signed>
struct Integer : Number {
  using Native = std::conditional_t<Signed, std::int32_t, std::uint32_t>;
  bool any = false;       // nothing is known of it, and nothing depends on it
  bool is_float = false;  // it is the word of this float
  int name = new_name();
  Integer() : Number(known(0)) {}
  template <std::integral T>
  explicit(!std::same_as<T, Native>) Integer(T x) : Number(known(static_cast<Native>(x))) {}
  explicit Integer(const Number& x) : Number(x) {}
  template <bool Other>
  requires(Other != Signed) explicit Integer(const Integer<Other>& x) : Number(x), any(x.any), is_float(x.is_float) {
    if (is_known()) *this = Integer(static_cast<Native>(x.native()));
  }
  // Cut off towards 0.
  explicit Integer(const Float& x) : Number(seen(x)) {
    if (x.grid >= 0) return;
    const double part = x.grid < -50 ? 1 : 1 - std::ldexp(1.0, x.grid);
    if (x.is_exact()) {
      static_cast<Number&>(*this) = plus(x, known(0));
      const double cut = std::trunc(x.lo);
      off = std::fabs(x.lo - cut), lo = std::min(x.lo, cut), hi = std::max(x.hi, cut);
      of = {};
    } else {
      static_cast<Number&>(*this) = off_by(x, x.hi > 0 ? -part : 0, x.lo < 0 ? part : 0);
    }
    grid = 0;
  }
  static Integer unknown() {
    Integer x;
    x.any = true;
    return x;
  }
  // Beyond 32 bits it wraps, which does no harm where nothing follows from it.
  Integer held() const {
    if (size() < (Signed ? 0x1p31 : 0x1p32)) return *this;
    return Integer(Number{-0x1p31, 0x1p31, HUGE_VAL});
  }
  bool is_known() const { return !any && !is_float && is_exact() && std::fabs(lo) < 0x1p32; }
  Native native() const { return static_cast<Native>(static_cast<std::int64_t>(lo)); }

  template <typename Step, typename Numbers>
  static Integer made(const Integer& a, const Integer& b, const Step& step, const Numbers& numbers) {
    if (a.is_known() && b.is_known()) return Integer(static_cast<Native>(step(a.native(), b.native())));
    if (a.any || b.any) return unknown();
    return Integer(numbers(a, b)).held();
  }
#define SUMS_OPERATOR(op, with)                                                                                  \
  friend Integer operator op(const Integer& a, const Integer& b) {                                               \
    return made(                                                                                                 \
        a, b, [](Native x, Native y) { return static_cast<std::uint32_t>(x) op static_cast<std::uint32_t>(y); }, \
        [&](const Number& x, const Number& y) -> Number { return with; });                                       \
  }                                                                                                              \
  friend Integer& operator op##=(Integer& a, const Integer& b) { return a = a op b; }
  SUMS_OPERATOR(+, a.name == b.name ? doubled(x) : plus(x, y))
  SUMS_OPERATOR(-, plus(x, negative(y)))
  SUMS_OPERATOR(*, times(x, y))
#undef SUMS_OPERATOR
#define SUMS_OPERATOR(op, with)                                                            \
  friend Integer operator op(const Integer& a, const Integer& b) {                         \
    return made(                                                                           \
        a, b, [](Native x, Native y) { return x op y; },                                   \
        [](const Number& x, [[maybe_unused]] const Number& y) -> Number { return with; }); \
  }                                                                                        \
  friend Integer& operator op##=(Integer& a, const Integer& b) { return a = a op b; }
  SUMS_OPERATOR(<<, times(x, known(std::ldexp(1.0, static_cast<int>(y.lo)))))
  SUMS_OPERATOR(>>, shifted(x, static_cast<int>(y.lo)))
  SUMS_OPERATOR(/, (refuse("a quotient of integers"), x))
  SUMS_OPERATOR(%, (refuse("a rest of integers"), x))
  SUMS_OPERATOR(&, (refuse("bits of an integer"), x))
  SUMS_OPERATOR(|, (refuse("bits of an integer"), x))
  SUMS_OPERATOR(^, (refuse("bits of an integer"), x))
#undef SUMS_OPERATOR
  static Number shifted(const Number& x, int by) {
    const double part = x.grid >= by ? 0 : 1 - std::ldexp(1.0, std::max(x.grid, 0) - by);
    Number y = off_by(times(x, known(std::ldexp(1.0, -by))), -part, 0);
    y.grid = std::max(0, x.grid - by);
    return y;
  }
  friend Integer operator-(const Integer& a) { return Integer(Native(0)) - a; }
  friend Integer& operator++(Integer& a) { return a = a + Integer(Native(1)); }
  friend Integer min(const Integer& a, const Integer& b) { return Integer(least(a, b)); }
  friend Integer max(const Integer& a, const Integer& b) { return Integer(negative(least(negative(a), negative(b)))); }
  friend bool operator<(const Integer& a, const Integer& b) { return is_less(a, b); }
  friend bool operator>(const Integer& a, const Integer& b) { return is_less(b, a); }
  friend bool operator<=(const Integer& a, const Integer& b) { return !is_less(b, a); }
  friend bool operator>=(const Integer& a, const Integer& b) { return !is_less(a, b); }
  friend bool operator==(const Integer& a, const Integer& b) { return a.is_exact() && b.is_exact() && a.lo == b.lo; }
};
using Int = Integer<true>;
using Uint = Integer<false>;
template <bool Signed>
Float::Float(const Integer<Signed>& x) : Float(rounded(x)) {}

inline Uint floatBitsToUint(const Float& x) {
  Uint word{static_cast<const Number&>(x)};
  word.is_float = true;
  return word;
}
inline Float uintBitsToFloat(const Uint& word) {
  if (word.is_float) return Float(static_cast<const Number&>(word));
  if (!word.is_known()) refuse("the float of a word");
  const float x = std::bit_cast<float>(word.native());
  if (!std::isfinite(x)) throw Unbounded{};
  return Float(x);
}

}  // namespace hn::sums
