// Many numbers as one, by the vector extensions of GCC and Clang or else side by side, and the functions of the
// library for them: hn_perlin of lanes::vec2 is the noise at lanes::kCount points at once.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/lanes.hpp>
//   namespace lanes = hashnoise::lanes;
//   lanes::Float n = lanes::hn_perlin(lanes::vec2(x, y), lanes::Uint(7u));  // n[0] to n[lanes::kCount - 1]
//
// How many lanes there are follows from the flags of the compiler: 16 with AVX-512 (F, BW, DQ and VL), 8 with AVX2,
// else 4. With other compilers (MSVC) they are 4 numbers side by side, and so they are with GCC and Clang if you define
// HN_LANES_PORTABLE: the bits are the same, and how fast that is depends on the compiler.
//
// The namespace `lanes` is another name of one that is named after the instruction set, so that translation units
// with other flags may be linked together. HN_LANES is its own name.
//
// A condition of an `if`, of a loop and of `?:` has to be the same in all lanes: octaves, a metric. HN_LANES_CHECKED
// makes it an error (std::abort) if it is not. Where it differs from lane to lane, take lanes::select.
//
// The bits are those of the scalar functions under the same flags: HN_FIXED under any, HN_PRECISE with
// -ffp-contract=off and without fast-math.

// clang-format off
#include "glsl.hpp"
#include "../../glsl/hashnoise/detail/knobs.h"  // each time
// clang-format on

#ifndef HN_I_LANES_HPP
#define HN_I_LANES_HPP

// clang-format off
#include "../../glsl/hashnoise/detail/macros_begin.h"
#include "../../glsl/hashnoise/detail/undef_guards.h"
// clang-format on

#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#if defined(__CUDACC__) && defined(__NVCC__)
#error lanes.hpp and grid.hpp are for CPUs, and nvcc does not take them: include them in a .cpp file, or take hashnoise.hpp
#endif

#if !defined(__GNUC__) && !defined(__clang__) && !defined(HN_LANES_PORTABLE)
#define HN_LANES_PORTABLE
#endif

// The widest of the instruction sets that the flags allow.
#if defined(HN_I_OWN_FLOATS)  // conformance/roundings: the bits must not depend on the flags
#define HN_LANES own
#define HN_I_LANE_BYTES 64
#elif defined(HN_LANES_PORTABLE)
#define HN_LANES portable
#define HN_I_LANE_BYTES 16
#elif defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define HN_LANES avx512
#define HN_I_LANE_BYTES 64
// With a mask of all lanes, since GCC 12 warns of the plain ones: they name a variable that has no value.
#define HN_I_X86_INT __m512i
#define HN_I_X86(name, x, ...) _mm512_mask_##name(x, 0xFFFF, __VA_ARGS__)
#define HN_I_X86_ROUND(x, mode) _mm512_mask_roundscale_ps(x, 0xFFFF, x, mode)
#define HN_I_X86_HALVES(a, b) _mm512_mask_blend_epi16(0xAAAAAAAA, a, b)
#elif defined(__AVX2__)
#define HN_LANES avx2
#define HN_I_LANE_BYTES 32
#define HN_I_X86_INT __m256i
#define HN_I_X86(name, x, ...) _mm256_##name(__VA_ARGS__)
#define HN_I_X86_ROUND(x, mode) _mm256_round_ps(x, mode)
#define HN_I_X86_HALVES(a, b) _mm256_blend_epi16(a, b, 0xAA)
#elif defined(__SSE4_1__)
#define HN_LANES sse41
#define HN_I_LANE_BYTES 16
#define HN_I_X86_INT __m128i
#define HN_I_X86(name, x, ...) _mm_##name(__VA_ARGS__)
#define HN_I_X86_ROUND(x, mode) _mm_round_ps(x, mode)
#define HN_I_X86_HALVES(a, b) _mm_blend_epi16(a, b, 0xAA)
#elif defined(__SSE2__)
#define HN_LANES sse2
#define HN_I_LANE_BYTES 16
#define HN_I_X86_INT __m128i
#define HN_I_X86(name, x, ...) _mm_##name(__VA_ARGS__)
#elif defined(__aarch64__) && defined(__ARM_NEON)
#define HN_LANES neon
#define HN_I_LANE_BYTES 16
#define HN_I_NEON
#elif defined(__wasm_simd128__)
#define HN_LANES simd128
#define HN_I_LANE_BYTES 16
#define HN_I_SIMD128
#else
#define HN_LANES generic
#define HN_I_LANE_BYTES 16
#endif

#if defined(HN_I_X86) && HN_I_LANE_BYTES == 16
#include <smmintrin.h>  // compilers read all of immintrin.h in half a second
#elif defined(HN_I_X86)
#include <immintrin.h>
#elif defined(HN_I_NEON)
#include <arm_neon.h>
#elif defined(HN_I_SIMD128)
#include <wasm_simd128.h>
#endif

#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of masks, in the compilers' own headers
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wkeyword-macro"
#else
#pragma GCC diagnostic ignored "-Weffc++"  // of operator&&, which has nothing to leave out
#endif
#endif

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {

constexpr int kCount = HN_I_LANE_BYTES / 4;

namespace detail {

#ifdef HN_LANES_PORTABLE
// The part of the vector extensions that is needed here: a comparison gives all bits, or none. The numbers have names,
// since there are compilers that keep arrays in memory.
template <typename S>
struct Four {
  using Number = S;

  S a, b, c, d;

  HN_I_INLINE S operator[](int i) const { return i == 0 ? a : i == 1 ? b : i == 2 ? c : d; }
  HN_I_INLINE S& operator[](int i) { return i == 0 ? a : i == 1 ? b : i == 2 ? c : d; }

#define HN_I_FOUR_NUMBERS(op) \
  HN_I_INLINE friend Four operator op(Four x, Four y) { return {x.a op y.a, x.b op y.b, x.c op y.c, x.d op y.d}; }
  HN_I_FOUR_NUMBERS(+)
  HN_I_FOUR_NUMBERS(-)
  HN_I_FOUR_NUMBERS(*)
  HN_I_FOUR_NUMBERS(/)
  HN_I_FOUR_NUMBERS(&)
  HN_I_FOUR_NUMBERS(|)
  HN_I_FOUR_NUMBERS(^)
  HN_I_FOUR_NUMBERS(<<)
  HN_I_FOUR_NUMBERS(>>)
#undef HN_I_FOUR_NUMBERS
  HN_I_INLINE friend Four operator-(Four x) { return {-x.a, -x.b, -x.c, -x.d}; }
  HN_I_INLINE friend Four operator-(S s, Four x) { return {s - x.a, s - x.b, s - x.c, s - x.d}; }

#define HN_I_FOUR_ANSWERS(op)                                                                    \
  HN_I_INLINE friend Four<std::int32_t> operator op(Four x, Four y) {                            \
    return {x.a op y.a ? -1 : 0, x.b op y.b ? -1 : 0, x.c op y.c ? -1 : 0, x.d op y.d ? -1 : 0}; \
  }
  HN_I_FOUR_ANSWERS(<)
  HN_I_FOUR_ANSWERS(>)
  HN_I_FOUR_ANSWERS(<=)
  HN_I_FOUR_ANSWERS(>=)
  HN_I_FOUR_ANSWERS(==)
  HN_I_FOUR_ANSWERS(!=)
#undef HN_I_FOUR_ANSWERS
};

using FloatVector = Four<float>;
using IntVector = Four<std::int32_t>;
using UintVector = Four<std::uint32_t>;

template <typename To, typename S>
HN_I_INLINE To converted(Four<S> x) {
  using T = typename To::Number;
  return {static_cast<T>(x.a), static_cast<T>(x.b), static_cast<T>(x.c), static_cast<T>(x.d)};
}
template <typename Vector>
HN_I_INLINE Vector chosen(IntVector if_not_0, Vector x, Vector y) {
  return {if_not_0.a != 0 ? x.a : y.a, if_not_0.b != 0 ? x.b : y.b, if_not_0.c != 0 ? x.c : y.c,
          if_not_0.d != 0 ? x.d : y.d};
}
#else
using FloatVector [[gnu::vector_size(HN_I_LANE_BYTES)]] = float;
using IntVector [[gnu::vector_size(HN_I_LANE_BYTES)]] = std::int32_t;
using UintVector [[gnu::vector_size(HN_I_LANE_BYTES)]] = std::uint32_t;
using DoubleVector [[gnu::vector_size(2 * HN_I_LANE_BYTES)]] = double;
using LongVector [[gnu::vector_size(2 * HN_I_LANE_BYTES)]] = std::int64_t;

template <typename To, typename Vector>
HN_I_INLINE To converted(Vector vector) {
  return __builtin_convertvector(vector, To);
}
template <typename Vector>
HN_I_INLINE Vector chosen(IntVector condition, Vector a, Vector b) {
  return condition ? a : b;
}
#endif

template <typename S>
struct VectorOf;
template <>
struct VectorOf<float> {
  using Type = FloatVector;
};
template <>
struct VectorOf<std::int32_t> {
  using Type = IntVector;
};
template <>
struct VectorOf<std::uint32_t> {
  using Type = UintVector;
};

}  // namespace detail

// The result of a comparison: for each lane all bits, or none.
struct Mask {
  detail::IntVector v;

  HN_I_INLINE explicit operator bool() const {
#ifdef HN_I_DECIDED  // tools/lib/proof/errors: each lane goes its own way
    return HN_I_DECIDED(v);
#else
#ifdef HN_LANES_CHECKED
    for (int i = 1; i < kCount; ++i) {
      if (v[i] != v[0]) std::abort();
    }
#endif
    return v[0] != 0;
#endif
  }
  HN_I_INLINE friend Mask operator&&(Mask a, Mask b) { return {a.v & b.v}; }
};

// kCount numbers. A number is the same in all lanes, if it is of the type of a lane; others have to be converted.
template <typename S>
struct Lanes {
  using Vector = typename detail::VectorOf<S>::Type;
  Vector v;

  HN_I_INLINE Lanes() : v{} {}
  HN_I_INLINE explicit Lanes(Vector vector) : v(vector) {}
  // s - 0 is s, also where s is -0; s + 0 would not be.
  template <typename T>
  requires std::is_arithmetic_v<T> HN_I_INLINE explicit(!std::same_as<S, T>) Lanes(T s)
      : v(number(static_cast<S>(s)) - Vector{}) {}
  // A number that does not fit is undefined, as it is in C++.
  template <typename T>
  HN_I_INLINE explicit Lanes(Lanes<T> other) : v(detail::converted<Vector>(other.v)) {}
  HN_I_INLINE explicit Lanes(Mask mask) : v(detail::converted<Vector>(-mask.v)) {}

  HN_I_INLINE S operator[](int i) const { return v[i]; }

  // One number in all lanes. In WebAssembly the constant of a vector takes 18 bytes, and that of a number 6 at
  // most:
  // where size matters, the compiler is kept from turning the second into the first.
  HN_I_INLINE static S number(S s) {
#if defined(HN_I_SIMD128) && defined(__OPTIMIZE_SIZE__)
    asm("" : "+r"(s));
#endif
    return s;
  }

  // kCount numbers in memory, with any alignment.
  HN_I_INLINE static Lanes load(const S* from) {
    Lanes lanes;
    std::memcpy(&lanes.v, from, sizeof(Vector));
    return lanes;
  }
  HN_I_INLINE void store(S* to) const { std::memcpy(to, &v, sizeof(Vector)); }

#define HN_I_LANE_OPERATOR(op)                                                         \
  HN_I_INLINE friend Lanes operator op(Lanes a, Lanes b) { return Lanes(a.v op b.v); } \
  HN_I_INLINE friend Lanes& operator op##=(Lanes& a, Lanes b) { return a = a op b; }
  HN_I_LANE_OPERATOR(+)
  HN_I_LANE_OPERATOR(-)
  HN_I_LANE_OPERATOR(*)
  HN_I_LANE_OPERATOR(&)
  HN_I_LANE_OPERATOR(|)
  HN_I_LANE_OPERATOR(^)
  HN_I_LANE_OPERATOR(<<)
  HN_I_LANE_OPERATOR(>>)
#undef HN_I_LANE_OPERATOR
  HN_I_INLINE friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
  HN_I_INLINE friend Lanes& operator++(Lanes& a) { return a = a + S{1}; }

#define HN_I_LANE_COMPARISON(op) \
  HN_I_INLINE friend Mask operator op(Lanes a, Lanes b) { return {a.v op b.v}; }
  HN_I_LANE_COMPARISON(<)
  HN_I_LANE_COMPARISON(>)
  HN_I_LANE_COMPARISON(<=)
  HN_I_LANE_COMPARISON(>=)
  HN_I_LANE_COMPARISON(==)
  HN_I_LANE_COMPARISON(!=)

  HN_I_INLINE friend Lanes hn_i_select(Mask condition, Lanes a, Lanes b) {
    return Lanes(detail::chosen(condition.v, a.v, b.v));
  }
};

#ifdef HN_I_OWN_FLOATS
#include HN_I_OWN_FLOATS  // Lanes<float>, with / and sqrt
#endif
#undef HN_I_LANE_COMPARISON

using Float = Lanes<float>;
using Int = Lanes<std::int32_t>;
using Uint = Lanes<std::uint32_t>;

HN_I_INLINE bool hn_i_to_bool(Mask condition) { return static_cast<bool>(condition); }
HN_I_INLINE bool hn_i_any(Mask condition) {
  std::int32_t any = 0;
  for (int i = 0; i < kCount; ++i) any |= condition.v[i];
  return any != 0;
}
HN_I_INLINE Int hn_i_select_int(Mask condition, Int a, Int b) { return hn_i_select(condition, a, b); }

// In each lane a where the condition holds, else b: select(n > 0.0f, n, 0.5f * n). Both are computed.
HN_I_INLINE Float select(Mask condition, Float a, Float b) { return hn_i_select(condition, a, b); }
HN_I_INLINE Int select(Mask condition, Int a, Int b) { return hn_i_select(condition, a, b); }
HN_I_INLINE Uint select(Mask condition, Uint a, Uint b) { return hn_i_select(condition, a, b); }

#ifndef HN_I_OWN_FLOATS
HN_I_INLINE Float operator/(Float a, Float b) { return Float(a.v / b.v); }
#endif

// No processor divides vectors of integers. A quotient of doubles is right, or, under -ffast-math, off by one. b > 0.
HN_I_INLINE Uint operator/(Uint a, Uint b) {
#if defined(HN_LANES_PORTABLE)
  const Uint nearest(a.v / b.v);
#elif defined(HN_I_SIMD128)  // the conversions below would be done lane by lane
  const auto two = [](v128_t x, v128_t y) __attribute__((always_inline)) {
    return wasm_u32x4_trunc_sat_f64x2_zero(
        wasm_f64x2_div(wasm_f64x2_convert_low_u32x4(x), wasm_f64x2_convert_low_u32x4(y)));
  };
  const v128_t x = v128_t(a.v), y = v128_t(b.v);
  const v128_t high = two(wasm_i32x4_shuffle(x, x, 2, 3, 2, 3), wasm_i32x4_shuffle(y, y, 2, 3, 2, 3));
  const Uint nearest(detail::UintVector(wasm_i32x4_shuffle(two(x, y), high, 0, 1, 4, 5)));
#elif defined(HN_I_X86) && HN_I_LANE_BYTES < 64
  // There is no instruction from doubles to longs, but to ints, which a quotient by 2 or more fits. By 1 it is a.
  const Uint divisor = hn_i_select(b == 1u, Uint(2u), b);
  const detail::DoubleVector quotient =
      __builtin_convertvector(a.v, detail::DoubleVector) / __builtin_convertvector(divisor.v, detail::DoubleVector);
  const Int whole(__builtin_convertvector(quotient, detail::IntVector));
  const Uint nearest = hn_i_select(b == 1u, a, Uint(whole));
#else
  const detail::DoubleVector quotient =
      __builtin_convertvector(a.v, detail::DoubleVector) / __builtin_convertvector(b.v, detail::DoubleVector);
  const Uint nearest(
      __builtin_convertvector(__builtin_convertvector(quotient, detail::LongVector), detail::UintVector));
#endif
#if defined(__FAST_MATH__) && !defined(HN_LANES_PORTABLE)
  const Uint below = nearest - Uint(nearest * b > a);
  return below + Uint(a - below * b >= b);
#else
  return nearest;
#endif
}
HN_I_INLINE Uint operator%(Uint a, Uint b) { return a - a / b * b; }

HN_I_INLINE Uint floatBitsToUint(Float x) { return Uint(__builtin_bit_cast(detail::UintVector, x.v)); }
HN_I_INLINE Float uintBitsToFloat(Uint bits) { return Float(__builtin_bit_cast(detail::FloatVector, bits.v)); }
HN_I_INLINE Float abs(Float x) { return uintBitsToFloat(floatBitsToUint(x) & 0x7FFFFFFFu); }

namespace detail {

// A float of 2^23 or more is whole. The others fit an int. The sign is kept, since it may be that of 0.
HN_I_INLINE Float whole(Float x, Float candidate) {
  const Uint sign = floatBitsToUint(x) & 0x80000000u;
  return hn_i_select(abs(x) < 8388608.0f, uintBitsToFloat(floatBitsToUint(candidate) | sign), x);
}
HN_I_INLINE Float cut_off(Float x) { return Float(Int(hn_i_select(abs(x) < 8388608.0f, x, Float(0.0f)))); }

}  // namespace detail

#if defined(HN_I_X86_ROUND)
// Down, and toward 0; without exceptions.
HN_I_INLINE Float floor(Float x) { return Float(HN_I_X86_ROUND(x.v, 9)); }
HN_I_INLINE Float trunc(Float x) { return Float(HN_I_X86_ROUND(x.v, 11)); }
#elif defined(HN_I_NEON)
HN_I_INLINE Float floor(Float x) { return Float(vrndmq_f32(x.v)); }
HN_I_INLINE Float trunc(Float x) { return Float(vrndq_f32(x.v)); }
#elif defined(HN_I_SIMD128)
HN_I_INLINE Float floor(Float x) { return Float(detail::FloatVector(wasm_f32x4_floor(v128_t(x.v)))); }
HN_I_INLINE Float trunc(Float x) { return Float(detail::FloatVector(wasm_f32x4_trunc(v128_t(x.v)))); }
#else
HN_I_INLINE Float floor(Float x) {
  const Float below = detail::cut_off(x);
  return detail::whole(x, below - Float(below > x));
}
HN_I_INLINE Float trunc(Float x) { return detail::whole(x, detail::cut_off(x)); }
#endif

#if defined(HN_I_X86)
HN_I_INLINE Float sqrt(Float x) { return Float(HN_I_X86(sqrt_ps, x.v, x.v)); }
// The instructions return the second operand where neither is less, as those of glsl.hpp return the first.
HN_I_INLINE Float min(Float x, Float y) { return Float(HN_I_X86(min_ps, x.v, y.v, x.v)); }
HN_I_INLINE Float max(Float x, Float y) { return Float(HN_I_X86(max_ps, x.v, y.v, x.v)); }
#else
#ifndef HN_I_OWN_FLOATS
HN_I_INLINE Float sqrt(Float x) {
#if defined(HN_I_NEON)
  return Float(vsqrtq_f32(x.v));
#elif defined(HN_I_SIMD128)
  return Float(detail::FloatVector(wasm_f32x4_sqrt(v128_t(x.v))));
#else
  for (int i = 0; i < kCount; ++i) x.v[i] = hashnoise::sqrt(x.v[i]);
  return x;
#endif
}
#endif
HN_I_INLINE Float min(Float x, Float y) { return hn_i_select(y < x, y, x); }
HN_I_INLINE Float max(Float x, Float y) { return hn_i_select(x < y, y, x); }
#endif
#if defined(HN_I_X86_ROUND)
// GCC 12 does not find these in a comparison and a choice.
#define HN_I_X86_OF_INTEGERS(Integer, Vector, function, instruction)                                                \
  HN_I_INLINE Integer function(Integer x, Integer y) {                                                              \
    return Integer(detail::Vector(HN_I_X86(instruction, HN_I_X86_INT(x.v), HN_I_X86_INT(x.v), HN_I_X86_INT(y.v)))); \
  }
HN_I_X86_OF_INTEGERS(Int, IntVector, min, min_epi32)
HN_I_X86_OF_INTEGERS(Int, IntVector, max, max_epi32)
HN_I_X86_OF_INTEGERS(Uint, UintVector, min, min_epu32)
HN_I_X86_OF_INTEGERS(Uint, UintVector, max, max_epu32)
#else
HN_I_INLINE Int min(Int x, Int y) { return hn_i_select(y < x, y, x); }
HN_I_INLINE Int max(Int x, Int y) { return hn_i_select(x < y, y, x); }
HN_I_INLINE Uint min(Uint x, Uint y) { return hn_i_select(y < x, y, x); }
HN_I_INLINE Uint max(Uint x, Uint y) { return hn_i_select(x < y, y, x); }
#endif

HN_I_INLINE Vector2<Float> floor(Vector2<Float> v) { return {floor(v.x), floor(v.y)}; }
HN_I_INLINE Vector3<Float> floor(Vector3<Float> v) { return {floor(v.x), floor(v.y), floor(v.z)}; }
HN_I_INLINE Vector4<Float> floor(Vector4<Float> v) { return {floor(v.x), floor(v.y), floor(v.z), floor(v.w)}; }

}  // namespace HN_LANES

namespace detail {

// The constructors of vectors: what does not fit becomes the nearest int, and NaN becomes 0, as in glsl.hpp. On x86 the
// instruction makes -2^31 of both, and that is left so: no noise has a value there, only a range.
template <>
HN_I_INLINE HN_LANES::Int convert<HN_LANES::Int, HN_LANES::Float>(HN_LANES::Float value) {
  using namespace HN_LANES;
#if defined(HN_I_X86)
  return Int(HN_LANES::detail::IntVector(HN_I_X86(cvttps_epi32, HN_I_X86_INT(value.v), value.v)));
#elif defined(HN_I_NEON)
  return Int(HN_LANES::detail::IntVector(vcvtq_s32_f32(value.v)));
#else
  const Uint bits = floatBitsToUint(value);
  const Uint magnitude = bits & 0x7FFFFFFFu;
  const Mask fits = magnitude < 0x4F000000u;  // 2^31
  const Uint nearest = hn_i_select(magnitude > 0x7F800000u, Uint(0u), (bits >> 31u) + 0x7FFFFFFFu);
  return hn_i_select(fits, Int(uintBitsToFloat(hn_i_select(fits, bits, Uint(0u)))), Int(nearest));
#endif
}

}  // namespace detail

namespace HN_LANES {

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

#if defined(HN_I_X86_HALVES)
// The squares of lengths of HN_FIXED: falloff.glsl and square_root.glsl leave them out then. One instruction multiplies
// numbers of 16 bits and adds two products, in half the time of a product of 32 bits. So an offset has two digits: the
// low one has 11 bits, and the high one the sign. Two offsets share a lane.
#define HN_I_OWN_SQUARES
HN_I_X86_OF_INTEGERS(Int, IntVector, hn_i_product_of_pairs, madd_epi16)
struct hn_i_digits {
  Int high, low;
};
HN_I_INLINE hn_i_digits hn_i_digits_of(Int x) { return {(x >> 11) & 0xFFFF, x & 2047}; }
HN_I_INLINE hn_i_digits hn_i_digits_of(Int x, Int y) {
  const auto pair = [](Int a, Int b) HN_I_INLINED {
    return Int(detail::IntVector(HN_I_X86_HALVES(HN_I_X86_INT(a.v), HN_I_X86_INT(b.v))));
  };
  return {pair(x >> 11, y << 5), pair(x, y << 16) & 0x07FF07FF};
}
// The sum of the squares, divided by 2^shift and rounded down.
template <std::uint32_t shift, typename... Digits>
HN_I_INLINE Uint hn_i_square_of(Digits... d) {
  const Int high = (hn_i_product_of_pairs(d.high, d.high) + ...), low = (hn_i_product_of_pairs(d.low, d.low) + ...);
  const Int mixed = (hn_i_product_of_pairs(d.high, d.low) + ...);
  return (Uint(high) << (22u - shift)) + (Uint(mixed) << (12u - shift)) + (Uint(low) >> shift);
}
HN_I_INLINE Uint hn_i_square(Int x, Int y) { return hn_i_square_of<10u>(hn_i_digits_of(x, y)); }
HN_I_INLINE Uint hn_i_square(Int x, Int y, Int z) {
  return hn_i_square_of<10u>(hn_i_digits_of(x, y), hn_i_digits_of(z));
}
HN_I_INLINE Uint hn_i_square(Int x, Int y, Int z, Int w) {
  return hn_i_square_of<10u>(hn_i_digits_of(x, y), hn_i_digits_of(z, w));
}
HN_I_INLINE uvec3 hn_i_squares(ivec3 x, ivec3 y) {
  return uvec3(hn_i_square_of<12u>(hn_i_digits_of(x.x, y.x)), hn_i_square_of<12u>(hn_i_digits_of(x.y, y.y)),
               hn_i_square_of<12u>(hn_i_digits_of(x.z, y.z)));
}
HN_I_INLINE uvec3 hn_i_squares(ivec3 x, ivec3 y, ivec3 z) {
  return uvec3(hn_i_square_of<12u>(hn_i_digits_of(x.x, y.x), hn_i_digits_of(z.x)),
               hn_i_square_of<12u>(hn_i_digits_of(x.y, y.y), hn_i_digits_of(z.y)),
               hn_i_square_of<12u>(hn_i_digits_of(x.z, y.z), hn_i_digits_of(z.z)));
}
#endif

#define HN_I_PASTE_TOKENS(a, b) a##b
#define HN_I_PASTE(a, b) HN_I_PASTE_TOKENS(a, b)

// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
// clang-format off
inline namespace HN_I_PASTE(hash_, HN_HASH) {
inline namespace HN_I_PASTE(gradient_, HN_GRADIENT) {
inline namespace HN_I_PASTE(arithmetic_, HN_ARITHMETIC) {
#include "../../glsl/hashnoise/hashnoise.glsl"
}
}
}
// clang-format on
#undef float
#undef int
#undef HN_I_PASTE
#undef HN_I_PASTE_TOKENS

// ---------------------------------------------------------------------------------------------------------------------
// For loops over points.

namespace detail {

template <int D>
struct PointOf;
template <>
struct PointOf<1> {
  using Cell = Int;
  using Place = Float;
};
template <>
struct PointOf<2> {
  using Cell = ivec2;
  using Place = vec2;
};
template <>
struct PointOf<3> {
  using Cell = ivec3;
  using Place = vec3;
};
template <>
struct PointOf<4> {
  using Cell = ivec4;
  using Place = vec4;
};

}  // namespace detail

// A cell, and a position in it or anywhere, in D dimensions: a number for D = 1, else a vector.
template <int D>
using CellOf = typename detail::PointOf<D>::Cell;
template <int D>
using PlaceOf = typename detail::PointOf<D>::Place;

// Such a number or vector of what `component` returns for each axis.
template <typename Vector, int D, typename Function>
HN_I_INLINE Vector vector_of(const Function& component) {
  if constexpr (D == 1) {
    return component(0);
  } else if constexpr (D == 2) {
    return Vector(component(0), component(1));
  } else if constexpr (D == 3) {
    return Vector(component(0), component(1), component(2));
  } else {
    return Vector(component(0), component(1), component(2), component(3));
  }
}

// Writes each component at `i` of a plane of its own.
HN_I_INLINE void store(float* const* planes, std::size_t i, Float n) { n.store(planes[0] + i); }
HN_I_INLINE void store(float* const* planes, std::size_t i, vec2 n) {
  n.x.store(planes[0] + i);
  n.y.store(planes[1] + i);
}
HN_I_INLINE void store(float* const* planes, std::size_t i, vec3 n) {
  store(planes, i, vec2(n.x, n.y));
  n.z.store(planes[2] + i);
}
HN_I_INLINE void store(float* const* planes, std::size_t i, vec4 n) {
  store(planes, i, vec3(n.x, n.y, n.z));
  n.w.store(planes[3] + i);
}

}  // namespace HN_LANES

namespace lanes = HN_LANES;

}  // namespace hashnoise

#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic pop
#endif

#undef HN_I_LANE_BYTES
#undef HN_I_NEON
#undef HN_I_OWN_SQUARES
#undef HN_I_SIMD128
#undef HN_I_X86
#undef HN_I_X86_HALVES
#undef HN_I_X86_INT
#undef HN_I_X86_OF_INTEGERS
#undef HN_I_X86_ROUND

#include "../../glsl/hashnoise/detail/macros_end.h"

#endif
