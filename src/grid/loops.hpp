// The loops of kernels over a batch, for the lanes of the translation unit that includes this.
#pragma once

#include <hashnoise/lanes.hpp>

#include "kernel.hpp"

namespace hashnoise {
namespace HN_LANES {
namespace {  // a copy for each translation unit: they differ in their flags

using grid::Batch;
using grid::Kernel;
using grid::Octave;
using grid::Options;

template <int D>
struct Types;
template <>
struct Types<1> {
  using Cell = Int;
  using Place = Float;
};
template <>
struct Types<2> {
  using Cell = ivec2;
  using Place = vec2;
};
template <>
struct Types<3> {
  using Cell = ivec3;
  using Place = vec3;
};
template <>
struct Types<4> {
  using Cell = ivec4;
  using Place = vec4;
};
template <int D>
using Cell = typename Types<D>::Cell;
template <int D>
using Place = typename Types<D>::Place;

// A vector of what `component` returns for each axis.
template <typename Vector, int D, typename Function>
HN_I_INLINE Vector vector_of(Function component) {
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

// The options, in all lanes.
template <int D>
struct Given {
  Uint seed;
  Cell<D> period;
  Float phase, jitter;
  Int metric, octaves;
  Float lacunarity, gain, strength, limit;

  HN_I_INLINE explicit Given(const Options& o)
      : seed(o.seed),
        period(vector_of<Cell<D>, D>([&](int axis) __attribute__((always_inline)) { return Int(o.period[axis]); })),
        phase(o.phase),
        jitter(o.jitter),
        metric(o.metric),
        octaves(o.octaves),
        lacunarity(o.lacunarity),
        gain(o.gain),
        strength(o.strength),
        limit(o.limit) {}
};

template <int D>
HN_I_INLINE Cell<D> cells_at(const Batch& b, int i) {
  return vector_of<Cell<D>, D>(
      [&](int axis) __attribute__((always_inline)) { return Int::load(b.cell[axis] + i * b.stride[axis]); });
}
template <int D>
HN_I_INLINE Place<D> places_at(const Batch& b, int i) {
  return vector_of<Place<D>, D>(
      [&](int axis) __attribute__((always_inline)) { return Float::load(b.place[axis] + i * b.stride[axis]); });
}

// A value and four derivatives, which no vector holds.
struct ValueAndGradient {
  Float value;
  vec4 gradient;
};

HN_I_INLINE void store(const Batch& b, int i, Float n) { n.store(b.value[0] + i); }
HN_I_INLINE void store(const Batch& b, int i, vec2 n) {
  n.x.store(b.value[0] + i);
  n.y.store(b.value[1] + i);
}
HN_I_INLINE void store(const Batch& b, int i, vec3 n) {
  store(b, i, vec2(n.x, n.y));
  n.z.store(b.value[2] + i);
}
HN_I_INLINE void store(const Batch& b, int i, vec4 n) {
  store(b, i, vec3(n.x, n.y, n.z));
  n.w.store(b.value[3] + i);
}
HN_I_INLINE void store(const Batch& b, int i, ValueAndGradient n) {
  store(b, i, vec4(n.value, n.gradient.x, n.gradient.y, n.gradient.z));
  n.gradient.w.store(b.value[4] + i);
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
