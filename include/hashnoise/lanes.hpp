// Many numbers as one, by the vector extensions of GCC and Clang, and the functions of the library for them: hn_perlin
// of lanes::vec2 is the noise at lanes::kCount points at once.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/lanes.hpp>
//   namespace lanes = hashnoise::lanes;
//   lanes::Float n = lanes::hn_perlin(lanes::vec2(x, y), lanes::Uint(7u));  // n[0] to n[lanes::kCount - 1]
//
// How many lanes there are follows from the flags of the compiler: 16 with AVX-512 (F, BW, DQ and VL), 8 with AVX2,
// else
// 4. `lanes` is another name of a namespace that is named after the instruction set, so that translation units with
// other flags may be linked together.
//
// A condition of an `if`, of a loop and of `?:` has to be the same in all lanes: octaves, a metric. HN_LANES_CHECKED
// makes it an error (std::abort) if it is not. Where it differs, the text of the library uses hn_i_select.
//
// The bits are those of the scalar functions under the same flags: HN_FIXED under any, HN_PRECISE with
// -ffp-contract=off and without fast-math.

#pragma once

#ifndef __GNUC__
#error hashnoise/lanes.hpp needs the vector extensions of GCC or Clang
#endif

// clang-format off
#include "glsl.hpp"
#include "../../glsl/config.glsl"
// clang-format on

#include <concepts>
#include <cstdlib>
#include <type_traits>

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define HN_I_LANES avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define HN_I_LANES avx2
#elif defined(__SSE4_1__)
#define HN_I_LANES sse41
#elif defined(__SSE2__)
#define HN_I_LANES sse2
#elif defined(__aarch64__) && defined(__ARM_NEON)
#define HN_I_LANES neon
#else
#define HN_I_LANES generic
#endif

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__) && defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#define HN_I_LANE_FN [[gnu::always_inline]] inline

namespace hashnoise {
namespace HN_I_LANES {

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
constexpr int kCount = 16;
#elif defined(__AVX2__) && defined(__FMA__)
constexpr int kCount = 8;
#else
constexpr int kCount = 4;
#endif

template <typename S>
using VectorOf [[gnu::vector_size(4 * kCount)]] = S;

using FloatVector = float __attribute__((vector_size(4 * kCount)));
using IntVector = std::int32_t __attribute__((vector_size(4 * kCount)));
using UintVector = std::uint32_t __attribute__((vector_size(4 * kCount)));
using DoubleVector = double __attribute__((vector_size(8 * kCount)));
using LongVector = std::int64_t __attribute__((vector_size(8 * kCount)));

template <typename S>
struct VectorTrait;
template <>
struct VectorTrait<float> {
  using type = FloatVector;
};
template <>
struct VectorTrait<std::int32_t> {
  using type = IntVector;
};
template <>
struct VectorTrait<std::uint32_t> {
  using type = UintVector;
};

struct Mask {
  IntVector v;  // -1 or 0

  HN_I_LANE_FN explicit operator bool() const {
#ifdef HN_LANES_CHECKED
    for (int i = 1; i < kCount; ++i) {
      if (v[i] != v[0]) std::abort();
    }
#endif
    return v[0] != 0;
  }
  HN_I_LANE_FN friend Mask operator&&(Mask a, Mask b) { return {a.v & b.v}; }
  HN_I_LANE_FN friend Mask operator||(Mask a, Mask b) { return {a.v | b.v}; }
  HN_I_LANE_FN friend Mask operator!(Mask a) { return {~a.v}; }
};

template <typename S>
struct Lanes {
  using Vector = typename VectorTrait<S>::type;
  Vector v;

  HN_I_LANE_FN Lanes() : v{} {}
  template <typename T>
  requires std::is_arithmetic_v<T> HN_I_LANE_FN explicit(!std::same_as<S, T>) Lanes(T s)
      : v(Vector{} + static_cast<S>(s)) {}
  template <typename T>
  HN_I_LANE_FN explicit Lanes(Lanes<T> other) : v(__builtin_convertvector(other.v, Vector)) {}
  HN_I_LANE_FN explicit Lanes(Mask mask) : v(__builtin_convertvector(-mask.v, Vector)) {}
  HN_I_LANE_FN explicit Lanes(Vector vector) : v(vector) {}

  HN_I_LANE_FN S operator[](int i) const { return v[i]; }

#define HN_I_LANE_OPERATOR(op)                                                          \
  HN_I_LANE_FN friend Lanes operator op(Lanes a, Lanes b) { return Lanes(a.v op b.v); } \
  HN_I_LANE_FN friend Lanes& operator op##=(Lanes& a, Lanes b) { return a = a op b; }
  HN_I_LANE_OPERATOR(+)
  HN_I_LANE_OPERATOR(-)
  HN_I_LANE_OPERATOR(*)
  HN_I_LANE_OPERATOR(&)
  HN_I_LANE_OPERATOR(|)
  HN_I_LANE_OPERATOR(^)
  HN_I_LANE_OPERATOR(<<)
  HN_I_LANE_OPERATOR(>>)
#undef HN_I_LANE_OPERATOR
  HN_I_LANE_FN friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
  HN_I_LANE_FN friend Lanes& operator++(Lanes& a) { return a = a + S{1}; }

#define HN_I_LANE_COMPARISON(op) \
  HN_I_LANE_FN friend Mask operator op(Lanes a, Lanes b) { return {a.v op b.v}; }
  HN_I_LANE_COMPARISON(<)
  HN_I_LANE_COMPARISON(>)
  HN_I_LANE_COMPARISON(<=)
  HN_I_LANE_COMPARISON(>=)
  HN_I_LANE_COMPARISON(==)
  HN_I_LANE_COMPARISON(!=)
#undef HN_I_LANE_COMPARISON

  HN_I_LANE_FN friend Lanes hn_i_select(Mask condition, Lanes a, Lanes b) { return Lanes(condition.v ? a.v : b.v); }
};

using Float = Lanes<float>;
using Int = Lanes<std::int32_t>;
using Uint = Lanes<std::uint32_t>;

HN_I_LANE_FN Int hn_i_choice(Mask condition, Int a, Int b) { return hn_i_select(condition, a, b); }

HN_I_LANE_FN Float operator/(Float a, Float b) { return Float(a.v / b.v); }

// No processor divides vectors of integers. A quotient of doubles, cut off, is exact for 32-bit words.
HN_I_LANE_FN Uint operator/(Uint a, Uint b) {
  const DoubleVector quotient = __builtin_convertvector(a.v, DoubleVector) / __builtin_convertvector(b.v, DoubleVector);
  return Uint(__builtin_convertvector(__builtin_convertvector(quotient, LongVector), UintVector));
}
HN_I_LANE_FN Uint operator%(Uint a, Uint b) { return a - a / b * b; }

HN_I_LANE_FN Uint floatBitsToUint(Float value) { return Uint((UintVector)value.v); }
HN_I_LANE_FN Float uintBitsToFloat(Uint bits) { return Float((FloatVector)bits.v); }
HN_I_LANE_FN Float abs(Float x) { return uintBitsToFloat(floatBitsToUint(x) & 0x7FFFFFFFu); }

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
HN_I_LANE_FN Float floor(Float x) { return Float((FloatVector)_mm512_roundscale_ps(x.v, 9)); }
HN_I_LANE_FN Float trunc(Float x) { return Float((FloatVector)_mm512_roundscale_ps(x.v, 11)); }
HN_I_LANE_FN Float sqrt(Float x) { return Float((FloatVector)_mm512_sqrt_ps(x.v)); }
HN_I_LANE_FN Float min(Float x, Float y) { return Float((FloatVector)_mm512_min_ps(y.v, x.v)); }
HN_I_LANE_FN Float max(Float x, Float y) { return Float((FloatVector)_mm512_max_ps(y.v, x.v)); }
#elif defined(__AVX2__) && defined(__FMA__)
HN_I_LANE_FN Float floor(Float x) { return Float((FloatVector)_mm256_round_ps(x.v, 9)); }
HN_I_LANE_FN Float trunc(Float x) { return Float((FloatVector)_mm256_round_ps(x.v, 11)); }
HN_I_LANE_FN Float sqrt(Float x) { return Float((FloatVector)_mm256_sqrt_ps(x.v)); }
HN_I_LANE_FN Float min(Float x, Float y) { return Float((FloatVector)_mm256_min_ps(y.v, x.v)); }
HN_I_LANE_FN Float max(Float x, Float y) { return Float((FloatVector)_mm256_max_ps(y.v, x.v)); }
#else
#error
#endif
HN_I_LANE_FN Int min(Int x, Int y) { return hn_i_select(y < x, y, x); }
HN_I_LANE_FN Int max(Int x, Int y) { return hn_i_select(x < y, y, x); }
HN_I_LANE_FN Uint min(Uint x, Uint y) { return hn_i_select(y < x, y, x); }
HN_I_LANE_FN Uint max(Uint x, Uint y) { return hn_i_select(x < y, y, x); }

template <typename T>
requires(requires(T t) { floor(t); }) HN_I_LANE_FN Vector2<T> floor(Vector2<T> v) { return {floor(v.x), floor(v.y)}; }
template <typename T>
requires(requires(T t) { floor(t); }) HN_I_LANE_FN Vector3<T> floor(Vector3<T> v) {
  return {floor(v.x), floor(v.y), floor(v.z)};
}
template <typename T>
requires(requires(T t) { floor(t); }) HN_I_LANE_FN Vector4<T> floor(Vector4<T> v) {
  return {floor(v.x), floor(v.y), floor(v.z), floor(v.w)};
}

using uint = Uint;
using vec2 = Vector2<Float>;
using vec3 = Vector3<Float>;
using vec4 = Vector4<Float>;
using ivec2 = Vector2<Int>;
using ivec3 = Vector3<Int>;
using ivec4 = Vector4<Int>;
using uvec2 = Vector2<Uint>;
using uvec3 = Vector3<Uint>;
using uvec4 = Vector4<Uint>;
using hn_float = Float;
using hn_vec2 = vec2;
using hn_vec3 = vec3;
using hn_vec4 = vec4;
using hn_int = Int;
using hn_ivec2 = ivec2;
using hn_ivec3 = ivec3;
using hn_ivec4 = ivec4;
using hn_uint = Uint;
using hn_uvec2 = uvec2;
using hn_uvec3 = uvec3;
using hn_uvec4 = uvec4;

#define HN_I_PASTE_TOKENS(a, b) a##b
#define HN_I_PASTE(a, b) HN_I_PASTE_TOKENS(a, b)

// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
// clang-format off
inline namespace HN_I_PASTE(hash_, HN_HASH) {
inline namespace HN_I_PASTE(gradient_, HN_GRADIENT) {
inline namespace HN_I_PASTE(arithmetic_, HN_ARITHMETIC) {
#include "../../glsl/hashnoise.glsl"
}
}
}
// clang-format on
#undef float
#undef int
#undef HN_I_PASTE
#undef HN_I_PASTE_TOKENS

}  // namespace HN_I_LANES
namespace lanes = HN_I_LANES;
}  // namespace hashnoise
