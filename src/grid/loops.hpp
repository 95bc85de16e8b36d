// The loops of kernels over a batch, for the lanes of the translation unit that includes this.
#pragma once

#include <hashnoise/lanes.hpp>
#include <utility>

#include "kernel.hpp"

#ifdef _MSC_VER
#define HN_GRID_NOINLINE __declspec(noinline)
#else
#define HN_GRID_NOINLINE [[gnu::noinline]]
#endif

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {  // a copy for each translation unit: they differ in their flags

using grid::Batch;
using grid::Kernel;
using grid::Octave;
using grid::Options;

using Number = decltype(hn_i_num()[0]);

// The numbers of so many points of a row stay in the first cache. With more of them rows are slower by up to 4% with
// HN_PRECISE.
constexpr int kPointsAtOnce = HN_ARITHMETIC == HN_FAST ? 512 : 256;

template <int D>
using Cell = CellOf<D>;
template <int D>
using Fraction = PlaceOf<D>;
template <int D>
using Place = decltype(hn_place(std::declval<Cell<D>>(), std::declval<Fraction<D>>()));

// Functions of the library that there are on the plane and in space, by their dimensions.
#define HN_GRID_FAMILY(name)                           \
  template <int D, typename... Numbers>                \
  HN_I_INLINE auto name(const Numbers&... n) {         \
    if constexpr (D == 2) return hn_i_##name##2(n...); \
    if constexpr (D == 3) return hn_i_##name##3(n...); \
  }
HN_GRID_FAMILY(direction)
HN_GRID_FAMILY(along)
HN_GRID_FAMILY(ramp_of)
HN_GRID_FAMILY(bilerp_ramps)
HN_GRID_FAMILY(scaled)
HN_GRID_FAMILY(scaled_simplex)
HN_GRID_FAMILY(scaled_smooth)

// HN_FIXED adds a number to a gradient times an offset, so that the last bit of the sum is a unit; nothing is rounded
// (direction.glsl). Then the bits that the sum has beyond those of that number are the result.
template <int D>
constexpr float kBeyond = HN_ARITHMETIC != HN_FIXED ? 0.0f
                          : D == 2                  ? 3.0f
                                                    : 12.0f;
template <int D>
HN_I_INLINE hn_i_num beyond(Float n) {
#if HN_ARITHMETIC == HN_FIXED
  return Int(floatBitsToUint(n) - floatBitsToUint(Float(kBeyond<D>)));
#else
  return n;
#endif
}

// The share of a point in simplex noise, from its weight and its gradient times an offset.
template <int D>
HN_I_INLINE hn_i_num weighted_ramp(hn_i_num weight, hn_i_num n) {
  return hn_i_weighted_ramp(ramp_of<D>(n), weight);
}

// Perlin noise, or value noise, in a cell. of(i) gives a corner, and ramp(corner, x, y) or ramp(corner, x, y, z) its
// ramp at an offset, or its number. The bits of i show along which axes the corner is the upper one.
template <bool kIsPerlin, int D, typename Of, typename Ramp>
HN_I_INLINE hn_i_num between_corners(const Place<D>& place, const Of& of, const Ramp& ramp) {
  const auto f = place.fraction;
  const auto t = hn_i_fade(f);
  const Float x = hn_i_offset(f.x), y = hn_i_offset(f.y);
  const Float x1 = x - 1.0f, y1 = y - 1.0f;
  const auto face = [&](int i, auto... z) HN_I_INLINED {
    const auto a = of(i), b = of(i + 1), c = of(i + 2), d = of(i + 3);
    const hn_i_num4 n(ramp(a, x, y, z...), ramp(b, x1, y, z...), ramp(c, x, y1, z...), ramp(d, x1, y1, z...));
    if constexpr (kIsPerlin) {
      return bilerp_ramps<D>(n, t.x, t.y);
    } else {
      return hn_i_lerp(n, t.x, t.y);
    }
  };
  hn_i_num n;
  if constexpr (D == 2) {
    n = face(0);
  } else {
    const Float z = hn_i_offset(f.z);
    const hn_i_num front = face(0, z);
    n = hn_i_lerp(front, face(4, z - 1.0f), t.z);
  }
  return kIsPerlin ? scaled<D>(n) : hn_i_noise_of_numbers(n);
}

// The options, in all lanes.
template <int D>
struct Arguments {
  Uint seed;
  Cell<D> period;
  Float phase, jitter, bandwidth;
  Fraction<D> wave;
  Int metric, octaves;
  Float lacunarity, gain, strength;
  bool tiled = false;

  HN_I_INLINE explicit Arguments(const Options& o)
      : seed(o.seed),
        period(vector_of<Cell<D>, D>([&](int axis) HN_I_INLINED { return Int(o.period[axis]); })),
        phase(o.phase),
        jitter(o.jitter),
        bandwidth(o.bandwidth),
        wave(vector_of<Fraction<D>, D>([&](int axis) HN_I_INLINED { return Float(o.wave[axis]); })),
        metric(o.metric),
        octaves(o.octaves),
        lacunarity(o.lacunarity),
        gain(o.gain),
        strength(o.strength) {
    for (int axis = 0; axis < D; ++axis) tiled = tiled || o.period[axis] > 0;
  }
};

template <int D>
HN_I_INLINE Cell<D> cells_at(const Batch& b, int i) {
  return vector_of<Cell<D>, D>([&](int axis) HN_I_INLINED { return Int::load(b.cell[axis] + i * b.stride[axis]); });
}
template <int D>
HN_I_INLINE Fraction<D> fractions_at(const Batch& b, int i) {
  return vector_of<Fraction<D>, D>([&](int axis)
                                       HN_I_INLINED { return Float::load(b.place[axis] + i * b.stride[axis]); });
}
template <int D>
HN_I_INLINE Place<D> place_in_cell(const Batch& b, int i) {
  return hn_place(cells_at<D>(b, i), fractions_at<D>(b, i));
}
// AVX-512 has an instruction for the fraction, and conversions that round down. HN_FAST takes both. The fraction is
// rounded once, as that of the text, if perhaps down: no bound of an error depends on the direction.
template <int D>
HN_I_INLINE Place<D> place_at_position(const Batch& b, int i) {
#if HN_ARITHMETIC == HN_FAST && defined(__AVX512F__)
  const auto position = [&](int axis) HN_I_INLINED { return Float::load(b.place[axis] + i * b.stride[axis]).v; };
  return hn_place(vector_of<Cell<D>, D>([&](int axis) HN_I_INLINED {
                    constexpr int kDown = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
                    return Int(detail::IntVector(_mm512_maskz_cvt_roundps_epi32(0xFFFF, position(axis), kDown)));
                  }),
                  vector_of<Fraction<D>, D>([&](int axis) HN_I_INLINED {
                    return Float(detail::FloatVector(_mm512_maskz_reduce_ps(0xFFFF, position(axis), 9)));
                  }));
#else
  return hn_place(fractions_at<D>(b, i));
#endif
}
// The points of either form of a batch.
template <int D>
HN_I_INLINE Place<D> place_at(const Batch& b, int i) {
  return b.cell[0] != nullptr ? place_in_cell<D>(b, i) : place_at_position<D>(b, i);
}

// A place with the period, if there is one. A branch for each vector of points costs little, and the code behind it is
// compiled once.
template <int D>
HN_I_INLINE Place<D> placed(Place<D> place, const Arguments<D>& given) {
  place.period = given.period;
  place.tiled = given.tiled;
  return place;
}

// A noise as sums call it. The place may have a period.
template <int D, typename Result>
using NoiseCall = Result (*)(const Place<D>& place, const Arguments<D>& given);

// The component of a point along an axis.
template <std::size_t Axis, typename Point>
HN_I_INLINE auto& along_axis(Point& point) {
  if constexpr (!requires { point.x; }) {
    return point;
  } else if constexpr (Axis == 0) {
    return point.x;
  } else if constexpr (Axis == 1) {
    return point.y;
  } else if constexpr (Axis == 2) {
    return point.z;
  } else {
    return point.w;
  }
}

// Calls a function with the number of each axis from the first one on.
template <int first, int end, typename Function>
HN_I_INLINE void each_axis(const Function& function) {
  if constexpr (first < end) {
    function(std::integral_constant<int, first>());
    each_axis<first + 1, end>(function);
  }
}

HN_I_INLINE void store(float* const* planes, std::size_t i, hn_derivatives4 n) {
  store(planes, i, vec4(n.value, n.gradient.x, n.gradient.y, n.gradient.z));
  n.gradient.w.store(planes[4] + i);
}

template <typename Value>
HN_I_INLINE void store(const Batch& b, int i, Value n) {
  store(b.value, static_cast<std::size_t>(i), n);
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
