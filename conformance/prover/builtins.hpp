// Plain GLSL beyond the library's text: the built-in functions that GLSL defines by others, and operators.
#pragma once

#include <tuple>

#include "integers.hpp"

namespace hn::prover::own {

using prover::abs, prover::floor, prover::hn_i_select, prover::max, prover::min, prover::sqrt;

template <typename T>
constexpr int kSize = hashnoise::detail::kComponents<T>;
template <int Axis, typename T>
auto axis(const T& v) {
  if constexpr (kSize<T> == 1) {
    return v;
  } else {
    return hashnoise::detail::component<Axis>(v);
  }
}
// A step for each component; scalars are the same for all.
template <typename Step, typename... A>
auto by_axes(const Step& step, const A&... a) {
  constexpr int size = std::max({kSize<A>...});
  using T = decltype(step(axis<0>(a)...));
  if constexpr (size == 2) {
    return hashnoise::Vector2<T>(step(axis<0>(a)...), step(axis<1>(a)...));
  } else if constexpr (size == 3) {
    return hashnoise::Vector3<T>(step(axis<0>(a)...), step(axis<1>(a)...), step(axis<2>(a)...));
  } else {
    return hashnoise::Vector4<T>(step(axis<0>(a)...), step(axis<1>(a)...), step(axis<2>(a)...), step(axis<3>(a)...));
  }
}
template <int... Axes, typename T>
auto swizzled(const T& v) {
  using One = decltype(axis<0>(v));
  using Vectors = std::tuple<hashnoise::Vector2<One>, hashnoise::Vector3<One>, hashnoise::Vector4<One>>;
  return std::tuple_element_t<sizeof...(Axes) - 2, Vectors>(axis<Axes>(v)...);
}

// GLSL defines these by others. A compiler may write mix in either of two ways, which are the same number.
inline Float mix(Float a, Float b, Float t) {
  const Form one = (a + t * (b - a)).form(), other = (a * (Float(1.0f) - t) + b * t).form();
  Form f = with_error(one, hull(one.error(), other.error()));
  f.range = hull(one.range, other.range);
  f.grid = kNoGrid, f.bits = 24;
  return Float::of(f);
}
inline Float fract(Float x) { return x - floor(x); }
inline Float mod(Float x, Float y) { return x - y * floor(x / y); }
inline Float clamp(Float x, Float least, Float most) { return min(max(x, least), most); }
inline Float step(Float edge, Float x) { return hn_i_select(x < edge, Float(0.0f), Float(1.0f)); }
inline Float smoothstep(Float from, Float to, Float x) {
  const Float t = clamp((x - from) / (to - from), Float(0.0f), Float(1.0f));
  return t * t * (Float(3.0f) - Float(2.0f) * t);
}
template <typename V>
requires(kSize<V> > 1) Float dot(V a, V b) {
  Float sum = axis<0>(a) * axis<0>(b) + axis<1>(a) * axis<1>(b);
  if constexpr (2 < kSize<V>) sum += axis<2>(a) * axis<2>(b);
  if constexpr (3 < kSize<V>) sum += axis<3>(a) * axis<3>(b);
  return sum;
}
template <typename V>
requires(kSize<V> > 1) Float length(V v) { return sqrt(dot(v, v)); }

#define PROVER_BY_AXES(name)                                                 \
  template <typename A, typename... B>                                       \
  requires(kSize<A> > 1 || ((kSize<B> > 1) || ...)) auto name(A a, B... b) { \
    return by_axes([](const auto&... x) { return name(x...); }, a, b...);    \
  }
PROVER_BY_AXES(mix)
PROVER_BY_AXES(fract)
PROVER_BY_AXES(mod)
PROVER_BY_AXES(clamp)
PROVER_BY_AXES(step)
PROVER_BY_AXES(smoothstep)
PROVER_BY_AXES(abs)
PROVER_BY_AXES(min)
PROVER_BY_AXES(max)
PROVER_BY_AXES(sqrt)
#undef PROVER_BY_AXES

#define PROVER_REFUSED(name)                  \
  template <typename... A>                    \
  Float name(A...) {                          \
    refuse("GLSL states no error of " #name); \
  }
PROVER_REFUSED(sin)
PROVER_REFUSED(cos)
PROVER_REFUSED(atan)
PROVER_REFUSED(exp)
PROVER_REFUSED(exp2)
PROVER_REFUSED(log)
PROVER_REFUSED(log2)
PROVER_REFUSED(pow)
PROVER_REFUSED(inversesqrt)
#undef PROVER_REFUSED

// Operators on vectors of words that the library does not need, and shifts by a number of the other kind.
#define PROVER_OPERATOR(op)                                                                                \
  template <typename A, typename B>                                                                        \
  requires(kSize<A> == 2 || kSize<A> == 4 || (kSize<A> == 1 && kSize<B> > 1)) auto operator op(A a, B b) { \
    return by_axes([](const auto& x, const auto& y) { return x op y; }, a, b);                             \
  }
PROVER_OPERATOR(^)
PROVER_OPERATOR(&)
PROVER_OPERATOR(|)
#undef PROVER_OPERATOR
inline Uint operator>>(Uint a, Int b) { return a >> Uint(b); }
inline Uint operator<<(Uint a, Int b) { return a << Uint(b); }

inline std::uint32_t element(Int number) {
  if (number.is != Word::kNumber) refuse("an element by an unknown number");
  return number.value;
}

// A condition of one's own text, and ?:, which evaluates only the side that is taken.
struct Truth : Mask {
  Truth(bool b = false) : Mask(Mask::of(b)) {}
  Truth(Mask m) : Mask(std::move(m)) {}
};
inline Float chosen(Literal x) { return Float(x); }
inline Int chosen(int x) { return Int(x); }
inline Uint chosen(unsigned x) { return Uint(x); }
template <typename T>
T chosen(T x) {
  return x;
}
template <typename Yes, typename No>
auto choice(const Truth& c, const Yes& yes, const No& no) {
  if (c.word == 0 && c.v[0] >= 0) return c.v[0] ? chosen(yes()) : chosen(no());
  const auto a = chosen(yes()), b = chosen(no());
  if constexpr (kSize<decltype(chosen(yes()))> == 1) {
    return hn_i_select(c, a, b);
  } else {
    return by_axes([&](const auto& x, const auto& y) { return hn_i_select(c, x, y); }, a, b);
  }
}

}  // namespace hn::prover::own
