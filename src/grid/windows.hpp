// What is kept for the corners of cells, many of them side by side, and how points find it: a vector of points takes
// the numbers of their corners from memory with one instruction each, a window, where these are near each other.
#pragma once

#include "loops.hpp"
#if defined(__SSE4_1__)
#include <immintrin.h>
#define HN_GRID_HAS_WINDOWS
#elif defined(__aarch64__) && defined(__ARM_NEON)
#include <arm_neon.h>
#define HN_GRID_HAS_WINDOWS
#endif

#ifdef HN_GRID_HAS_WINDOWS

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// Takes of kCount numbers in memory that with the index of each lane.
class Window {
 public:
#if defined(__AVX2__)
  HN_I_INLINE explicit Window(Int index) : index_(index.v) {}
#else
  // The instruction takes bytes.
  HN_I_INLINE explicit Window(Int index) : index_((index * 0x04040404 + 0x03020100).v) {}
#endif

  template <typename S>
  HN_I_INLINE Lanes<S> of(const S* from) const {
    using Vector = typename Lanes<S>::Vector;
    const Vector numbers = Lanes<S>::load(from).v;
#if defined(__AVX512F__)
    return Lanes<S>(Vector(_mm512_maskz_permutexvar_epi32(0xFFFF, __m512i(index_), __m512i(numbers))));
#elif defined(__AVX2__)
    return Lanes<S>(Vector(_mm256_permutevar8x32_epi32(__m256i(numbers), __m256i(index_))));
#elif defined(__SSE4_1__)
    return Lanes<S>(Vector(_mm_shuffle_epi8(__m128i(numbers), __m128i(index_))));
#else
    return Lanes<S>(Vector(vqtbl1q_u8(uint8x16_t(numbers), uint8x16_t(index_))));
#endif
  }

 private:
  detail::IntVector index_;
};

// For each lane from `a`, or where the condition holds from `b`.
template <typename S>
HN_I_INLINE Lanes<S> of_either(const S* a, Int index_a, const S* b, Int index_b, Mask is_b) {
#if defined(__AVX512F__)
  using Vector = typename Lanes<S>::Vector;
  const Int index = hn_i_select(is_b, index_b + kCount, index_a);
  return Lanes<S>(
      Vector(_mm512_permutex2var_epi32(__m512i(Lanes<S>::load(a).v), __m512i(index.v), __m512i(Lanes<S>::load(b).v))));
#else
  return hn_i_select(is_b, Window(index_b).of(b), Window(index_a).of(a));
#endif
}

HN_I_INLINE hn_i_num one() { return hn_i_num(Number{1}); }

// A gradient as it is kept: a direction, and by how much it is to be lengthened. With HN_FAST it is lengthened before
// it is kept. That rounds nothing, since both have few bits. It leaves each point less to do, and less to round.
#if HN_ARITHMETIC == HN_FAST
constexpr int kGradient2 = 2, kGradient3 = 3;
HN_I_INLINE vec2 kept(vec3 d) { return vec2(hn_i_times_one_plus(d.x, d.z), hn_i_times_one_plus(d.y, d.z)); }
HN_I_INLINE vec3 kept(vec4 d) {
  return vec3(hn_i_times_one_plus(d.x, d.w), hn_i_times_one_plus(d.y, d.w), hn_i_times_one_plus(d.z, d.w));
}
// What it adds at an offset. In space u and v stand for x and y, as in direction.glsl. In triangles the integers of its
// length have a unit of their own.
HN_I_INLINE Float ramp(vec2 g, Float x, Float y) { return hn_i_dot(g, x, y); }
HN_I_INLINE Float ramp(vec3 g, Float u, Float v, Float w) { return hn_i_dot(g, u, v, w); }
HN_I_INLINE Float triangle_ramp(vec2 g, Float x, Float y) { return hn_i_dot(g, x, y); }
#else
constexpr int kGradient2 = 3, kGradient3 = 4;
HN_I_INLINE hn_i_num3 kept(hn_i_num3 d) { return d; }
HN_I_INLINE hn_i_num4 kept(hn_i_num4 d) { return d; }
HN_I_INLINE hn_i_num ramp(hn_i_num3 d, hn_i_num x, hn_i_num y) { return hn_i_ramp(d, x, y); }
HN_I_INLINE hn_i_num ramp(hn_i_num4 d, hn_i_num u, hn_i_num v, hn_i_num w) { return hn_i_ramp(d, u, v, w); }
HN_I_INLINE hn_i_num triangle_ramp(hn_i_num3 d, hn_i_num x, hn_i_num y) {
  return hn_i_triangle_times_one_plus(hn_i_dot_direction(d, x, y), d.z);
}
#endif
HN_I_INLINE auto kept2(Uint word) { return kept(hn_i_direction2(word)); }
HN_I_INLINE auto kept3(Uint word) { return kept(hn_i_direction3(word)); }
HN_I_INLINE auto kept_of_triangle(Uint word) { return kept(hn_i_triangle_direction(word)); }
// That of smooth simplex noise in space is lengthened twice as much.
HN_I_INLINE auto kept_of_smooth(Uint word) {
  hn_i_num4 d = hn_i_direction3(word);
  d.w = hn_i_plus(d.w, d.w);
  return kept(d);
}

// The ramps of a face of a cell, as in ramps.glsl: x, y and z are the offsets from its corner 00.
template <typename Gradient>
HN_I_INLINE hn_i_num4 face_ramps(Gradient g00, Gradient g10, Gradient g01, Gradient g11, hn_i_num x, hn_i_num y,
                                 hn_i_num z) {
  const hn_i_num a = hn_i_octahedral(x), b = hn_i_octahedral(y), step = hn_i_octahedral(HN_I_ONE);
  const hn_i_num u = hn_i_plus(a, b), v = hn_i_minus(a, b), w = hn_i_octahedral_z(z);
  const hn_i_num u1 = hn_i_minus(u, step);
  return hn_i_vector(ramp(g00, u, v, w), ramp(g10, u1, hn_i_minus(v, step), w), ramp(g01, u1, hn_i_plus(v, step), w),
                     ramp(g11, hn_i_minus(u1, step), v, w));
}

// Numbers of one corner, in each of kPlaces places.
template <int kNumbers, int kPlaces>
class Corners {
 public:
  HN_I_INLINE void put(int at, hn_i_num n) { keep(at, n); }
  HN_I_INLINE void put(int at, hn_i_num2 n) { keep(at, n.x, n.y); }
  HN_I_INLINE void put(int at, hn_i_num3 n) { keep(at, n.x, n.y, n.z); }
  HN_I_INLINE void put(int at, hn_i_num4 n) { keep(at, n.x, n.y, n.z, n.w); }
  // For each lane those that are so far behind a place.
  HN_I_INLINE auto of(int at, Int index) const {
    const Window window(index);
    return joined([&](int i) HN_I_INLINED { return window.of(number_[i] + at); });
  }
  // The ones behind these. Where registers are wide, both are taken from one.
  HN_I_INLINE auto behind(int at, Int index) const { return kCount == 16 ? of(at, index + 1) : of(at + 1, index); }
  // These, or those of another corner where the condition holds.
  HN_I_INLINE auto or_of(int at, Int index, const Corners& other, int other_at, Int other_index, Mask is_other) const {
    return joined([&](int i) HN_I_INLINED {
      return of_either(number_[i] + at, index, other.number_[i] + other_at, other_index, is_other);
    });
  }

 private:
  template <typename Function>
  HN_I_INLINE static auto joined(const Function& number) {
    if constexpr (kNumbers == 1) {
      return number(0);
    } else if constexpr (kNumbers == 2) {
      return hn_i_vector(number(0), number(1));
    } else if constexpr (kNumbers == 3) {
      return hn_i_vector(number(0), number(1), number(2));
    } else {
      return hn_i_vector(number(0), number(1), number(2), number(3));
    }
  }
  template <typename... Numbers>
  HN_I_INLINE void keep(int at, Numbers... n) {
    int i = 0;
    (n.store(number_[i++] + at), ...);
  }

  Number number_[kNumbers][kPlaces];
};

// The point of the lattice of simplex noise on the plane that is so far from twice the cell. Along x it may be cells
// away.
HN_I_INLINE uvec2 triangle_point(const Place<2>& place, Int x, Int y) {
  const Int cell = Int(Uint(place.cell.x) + Uint(x >> 1));
  if (!place.tiled) return uvec2(hn_i_doubled(Uint(cell), x & 1), hn_i_doubled(Uint(place.cell.y), y));
  const uvec2 c = hn_i_wrap(ivec2(cell, place.cell.y), place.period);
  return uvec2(hn_i_doubled(c.x, x & 1, place.period.x), hn_i_doubled(c.y, y, place.period.y));
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise

#endif
