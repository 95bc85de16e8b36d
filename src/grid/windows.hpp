// Numbers of the corners of cells, many of them side by side: a vector of points takes the numbers of its corners from
// memory with one instruction each, a window, where these are near each other.
#pragma once

#include "loops.hpp"
#if defined(__SSE4_1__) || (defined(__aarch64__) && defined(__ARM_NEON))  // lanes.hpp has their instructions
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
  const Int index = select(is_b, index_b + kCount, index_a);
  return Lanes<S>(
      Vector(_mm512_permutex2var_epi32(__m512i(Lanes<S>::load(a).v), __m512i(index.v), __m512i(Lanes<S>::load(b).v))));
#else
  return select(is_b, Window(index_b).of(b), Window(index_a).of(a));
#endif
}

// The terms of a gradient along a row, where the offset along each axis but x is the same: x * line.x + line.y. In
// space the component that is 0 adds nothing that could be rounded, either.
template <int D, typename... Z>
HN_I_INLINE vec2 line(Uint word, hn_i_num y, Z... z) {
  const auto g = direction<D>(word, false);
  const Float n = g.y * hn_i_offset(y) + kBeyond<D>;
  if constexpr (D == 2) {
    return vec2(g.x, n);
  } else {
    return vec2(g.x, n + g.z * hn_i_offset(z...));
  }
}
template <int D>
HN_I_INLINE hn_i_num along_line(vec2 line, Float x) {
  return beyond<D>(line.x * x + line.y);
}

// Numbers of one corner, in each of kPlaces places.
template <int kNumbers, int kPlaces, typename S = float>
class Corners {
 public:
  HN_I_INLINE void put(int at, Lanes<S> n) { keep(at, n); }
  template <typename Vector>
  HN_I_INLINE void put(int at, const Vector& n) {
    if constexpr (kNumbers == 2) {
      keep(at, n.x, n.y);
    } else {
      keep(at, n.x, n.y, n.z);
    }
  }
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
      return vector_of<std::conditional_t<std::is_same_v<S, float>, vec2, ivec2>, 2>(number);
    } else {
      return vector_of<std::conditional_t<std::is_same_v<S, float>, vec3, ivec3>, 3>(number);
    }
  }
  template <typename... Numbers>
  HN_I_INLINE void keep(int at, Numbers... n) {
    int i = 0;
    (n.store(number_[i++] + at), ...);
  }

  S number_[kNumbers][kPlaces];
};

// The hash of a point with the mixed seed alone.
template <typename Point>
HN_I_INLINE Uint seeded_hash(const Point& point, Uint s) {
  return hn_i_point_hash(point, hn_i_seed_join(s), s);
}

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
}  // namespace hashnoise::inline HN_I_NAMESPACE

#endif
