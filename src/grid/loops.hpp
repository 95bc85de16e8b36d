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

// The options, in all lanes.
template <int D>
struct Arguments {
  Uint seed;
  Cell<D> period;
  Float phase, jitter;
  Fraction<D> wave;
  Int metric, octaves;
  Float lacunarity, gain, strength, limit;

  HN_I_INLINE explicit Arguments(const Options& o)
      : seed(o.seed),
        period(vector_of<Cell<D>, D>([&](int axis) HN_I_INLINED { return Int(o.period[axis]); })),
        phase(o.phase),
        jitter(o.jitter),
        wave(vector_of<Fraction<D>, D>([&](int axis) HN_I_INLINED { return Float(o.wave[axis]); })),
        metric(o.metric),
        octaves(o.octaves),
        lacunarity(o.lacunarity),
        gain(o.gain),
        strength(o.strength),
        limit(o.limit) {}
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
  return hn_i_place(vector_of<Cell<D>, D>([&](int axis) HN_I_INLINED {
                      constexpr int kDown = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
                      return Int(detail::IntVector(_mm512_maskz_cvt_roundps_epi32(0xFFFF, position(axis), kDown)));
                    }),
                    vector_of<Fraction<D>, D>([&](int axis) HN_I_INLINED {
                      return Float(detail::FloatVector(_mm512_maskz_reduce_ps(0xFFFF, position(axis), 9)));
                    }),
                    Cell<D>());
#else
  return hn_place(fractions_at<D>(b, i));
#endif
}
// The points of either form of a batch.
template <int D>
HN_I_INLINE Place<D> place_at(const Batch& b, int i) {
  return b.cell[0] != nullptr ? place_in_cell<D>(b, i) : place_at_position<D>(b, i);
}

// The arguments of a noise with a period beside the point and the seed.
template <int D>
struct Tile {
  Cell<D> period;
  Float jitter;
};

// A noise as sums call it, with the numbers of each axis by themselves, since they are passed in registers then.
template <typename Number, std::size_t>
using ForEach = Number;
template <int D, typename Result, typename Axes = std::make_index_sequence<D>>
struct OctaveOf;
template <int D, typename Result, std::size_t... Axis>
struct OctaveOf<D, Result, std::index_sequence<Axis...>> {
  using Plain = Result (*)(ForEach<Int, Axis>... cell, ForEach<hn_i_num, Axis>... fraction, Uint seed);
  using Tiled = Result (*)(ForEach<Int, Axis>... cell, ForEach<hn_i_num, Axis>... fraction, const Tile<D>& tile,
                           Uint seed);
};

// The component of a point along an axis.
template <std::size_t Axis, typename Point>
HN_I_INLINE auto along(const Point& point) {
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
