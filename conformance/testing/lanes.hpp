// Four numbers as one, by the vector extensions of GCC and Clang: the tests compile the text of the library for
// this type. A literal must have the type of the numbers beside it, and a condition of an if or a loop must be
// the same for all four; where it differs, the text must use hn_i_select.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstdlib>
#include <hashnoise/glsl.hpp>
#include <type_traits>

namespace lanes {

constexpr int kLanes = 4;

template <typename S>
struct Lanes;

struct Mask {
  std::int32_t v __attribute__((vector_size(16)));  // -1 or 0

  explicit operator bool() const {
    for (int i = 1; i < kLanes; ++i) {
      if (v[i] != v[0]) std::abort();
    }
    return v[0] != 0;
  }
  friend Mask operator&&(Mask a, Mask b) { return {a.v & b.v}; }
};

template <typename S>
struct Lanes {
  typedef S Vector __attribute__((vector_size(16)));
  Vector v;

  Lanes() : v{} {}
  template <typename T>
  requires std::is_arithmetic_v<T>
  explicit(!std::same_as<S, T>) Lanes(T s) : v(Vector{} + static_cast<S>(s)) {}
  template <typename T>
  explicit Lanes(Lanes<T> other) : v(__builtin_convertvector(other.v, Vector)) {}
  explicit Lanes(Mask mask) : v(__builtin_convertvector(-mask.v, Vector)) {}

  template <typename Function>
  static Lanes each(Function function) {
    Lanes result;
    for (int i = 0; i < kLanes; ++i) result.v[i] = function(i);
    return result;
  }
  static Lanes of(Vector v) {
    Lanes result;
    result.v = v;
    return result;
  }

#define LANES_OPERATOR(op)                                                     \
  friend Lanes operator op(Lanes a, Lanes b) { return Lanes::of(a.v op b.v); } \
  friend Lanes& operator op##=(Lanes& a, Lanes b) { return a = a op b; }
  LANES_OPERATOR(+)
  LANES_OPERATOR(-)
  LANES_OPERATOR(*)
  LANES_OPERATOR(/)
  LANES_OPERATOR(%)
  LANES_OPERATOR(&)
  LANES_OPERATOR(|)
  LANES_OPERATOR(^)
  LANES_OPERATOR(<<)
  LANES_OPERATOR(>>)
#undef LANES_OPERATOR
  friend Lanes operator-(Lanes a) { return Lanes::of(-a.v); }
  friend Lanes& operator++(Lanes& a) { return a = a + S{1}; }

#define LANES_COMPARISON(op) \
  friend Mask operator op(Lanes a, Lanes b) { return {a.v op b.v}; }
  LANES_COMPARISON(<)
  LANES_COMPARISON(>)
  LANES_COMPARISON(<=)
  LANES_COMPARISON(>=)
  LANES_COMPARISON(==)
  LANES_COMPARISON(!=)
#undef LANES_COMPARISON

  friend Lanes hn_i_select(Mask condition, Lanes a, Lanes b) {
    return each([=](int i) { return condition.v[i] ? a.v[i] : b.v[i]; });
  }
  friend Lanes min(Lanes a, Lanes b) { return hn_i_select(b < a, b, a); }
  friend Lanes max(Lanes a, Lanes b) { return hn_i_select(a < b, b, a); }
};

using Float = Lanes<float>;
using Int = Lanes<std::int32_t>;
using Uint = Lanes<std::uint32_t>;

inline Int hn_i_choice(Mask condition, Int a, Int b) { return hn_i_select(condition, a, b); }

inline Float floor(Float x) {
  return Float::each([=](int i) { return hashnoise::floor(x.v[i]); });
}
inline Float trunc(Float x) {
  return Float::each([=](int i) { return hashnoise::trunc(x.v[i]); });
}
inline Float abs(Float x) {
  return Float::each([=](int i) { return hashnoise::abs(x.v[i]); });
}
inline Float sqrt(Float x) {
  return Float::each([=](int i) { return hashnoise::sqrt(x.v[i]); });
}
inline Float uintBitsToFloat(Uint bits) { return Float::of((Float::Vector)bits.v); }
inline Uint floatBitsToUint(Float value) { return Uint::of((Uint::Vector)value.v); }

inline hashnoise::Vector2<Float> floor(hashnoise::Vector2<Float> v) { return {floor(v.x), floor(v.y)}; }
inline hashnoise::Vector3<Float> floor(hashnoise::Vector3<Float> v) { return {floor(v.x), floor(v.y), floor(v.z)}; }
inline hashnoise::Vector4<Float> floor(hashnoise::Vector4<Float> v) {
  return {floor(v.x), floor(v.y), floor(v.z), floor(v.w)};
}

}  // namespace lanes
