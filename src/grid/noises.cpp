// The kernels of noises, for one instruction set and one arithmetic: the text of the library in a loop.
#include "loops.hpp"
#include "tables.hpp"

namespace hashnoise {
namespace HN_LANES {
namespace {

// A noise in a cell, by how it is called: plain, with everything that may be chosen (full), with a phase, and both.
#define HN_GRID_NOISE(kind, name, ...)                                                             \
  struct name##_##kind {                                                                           \
    template <int D>                                                                               \
    HN_I_INLINE static auto at(Cell<D> cell, Place<D> f, [[maybe_unused]] const Given<D>& given) { \
      return hn_##name(cell, f, __VA_ARGS__);                                                      \
    }                                                                                              \
  };
#define HN_GRID_PLAIN(name) HN_GRID_NOISE(plain, name, given.seed)
#define HN_GRID_PERIODIC(name) HN_GRID_PLAIN(name) HN_GRID_NOISE(full, name, given.period, given.seed)
#define HN_GRID_PHASED(name)                          \
  HN_GRID_PERIODIC(name)                              \
  HN_GRID_NOISE(phase, name, given.phase, given.seed) \
  HN_GRID_NOISE(phase_full, name, given.period, given.phase, given.seed)
#define HN_GRID_JITTERED(name) HN_GRID_PLAIN(name) HN_GRID_NOISE(full, name, given.period, given.jitter, given.seed)
#define HN_GRID_METRIC(name) \
  HN_GRID_PLAIN(name) HN_GRID_NOISE(full, name, given.period, given.jitter, given.metric, given.seed)

HN_GRID_PERIODIC(value)
HN_GRID_PERIODIC(value_cubic)
HN_GRID_PHASED(perlin)
HN_GRID_PHASED(simplex)
HN_GRID_PERIODIC(simplex_smooth)
HN_GRID_METRIC(cellular)
HN_GRID_METRIC(cellular_three)
HN_GRID_JITTERED(cellular_d)
HN_GRID_JITTERED(cellular_smooth)
HN_GRID_JITTERED(cell_border)
HN_GRID_PERIODIC(curl)
HN_GRID_PERIODIC(value_d)
HN_GRID_PHASED(perlin_d)
HN_GRID_PHASED(simplex_d)

// In 4D the gradient is a parameter.
#define HN_GRID_GRADIENT4(kind, name, ...)                                       \
  struct name##4_##kind{template <int D> HN_I_INLINE static ValueAndGradient at( \
      ivec4 cell, vec4 f, const Given<4>& given){ValueAndGradient n;             \
  n.value = hn_##name(cell, f, __VA_ARGS__, n.gradient);                         \
  return n;                                                                      \
  }                                                                              \
  }                                                                              \
  ;
#define HN_GRID_PERIODIC4(name)              \
  HN_GRID_GRADIENT4(plain, name, given.seed) \
  HN_GRID_GRADIENT4(full, name, given.period, given.seed)
HN_GRID_PERIODIC4(value_d)
HN_GRID_PERIODIC4(perlin_d)
HN_GRID_PERIODIC4(simplex_d)

template <int D, typename Noise>
void at_points(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Given<D> given(options);
  for (int i = 0; i < b.count; i += kCount) {
    store(b, i, Noise::template at<D>(cells_at<D>(b, i), places_at<D>(b, i), given));
  }
}

// Along a row: what depends on the other axes is computed once.
template <int D, typename Noise>
void along_row(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Given<D> given(options);
  Cell<D> cell = cells_at<D>(b, 0);
  Place<D> f = places_at<D>(b, 0);
  for (int i = 0; i < b.count; i += kCount) {
    cell.x = Int::load(b.cell[0] + i);
    f.x = Float::load(b.place[0] + i);
    store(b, i, Noise::template at<D>(cell, f, given));
  }
}

// A noise for sums, and for kernels of its own that call it: see OctaveOf.
template <int D, typename Noise, typename Axes = std::make_index_sequence<D>>
struct Called;
template <int D, typename Noise, std::size_t... Axis>
struct Called<D, Noise, std::index_sequence<Axis...>> {
  [[gnu::noinline]] static auto plain(ForEach<Int, Axis>... cell, ForEach<Float, Axis>... f, Uint seed) {
    Given<D> given{Options{}};
    given.seed = seed;
    return Noise::template at<D>(Cell<D>(cell...), Place<D>(f...), given);
  }
  [[gnu::noinline]] static auto tiled(ForEach<Int, Axis>... cell, ForEach<Float, Axis>... f, const Tile<D>& tile,
                                      Uint seed) {
    Given<D> given{Options{}};
    given.period = tile.period;
    given.seed = seed;
    given.jitter = tile.jitter;
    return Noise::template at<D>(Cell<D>(cell...), Place<D>(f...), given);
  }

  // Kernels that call these for each vector of points.
  static void plain_at_points(const Batch& batch, const Options& options, Octave) {
    const Batch b = batch;
    const Uint seed(options.seed);
    for (int i = 0; i < b.count; i += kCount) {
      const Cell<D> cell = cells_at<D>(b, i);
      const Place<D> f = places_at<D>(b, i);
      store(b, i, plain(along<Axis>(cell)..., along<Axis>(f)..., seed));
    }
  }
  static void tiled_at_points(const Batch& batch, const Options& options, Octave) {
    const Batch b = batch;
    const Given<D> given(options);
    const Tile<D> tile{given.period, given.jitter};
    for (int i = 0; i < b.count; i += kCount) {
      const Cell<D> cell = cells_at<D>(b, i);
      const Place<D> f = places_at<D>(b, i);
      store(b, i, tiled(along<Axis>(cell)..., along<Axis>(f)..., tile, given.seed));
    }
  }
};

using grid::NoiseKernels;

template <int D, typename Plain, typename Full>
NoiseKernels kernels_of() {
  NoiseKernels k{};
  k.plain = at_points<D, Plain>;
  k.row = k.plain;
  k.full = at_points<D, Full>;
  return k;
}
template <int D, typename Plain, typename Full>
NoiseKernels with_rows() {
  NoiseKernels k = kernels_of<D, Plain, Full>();
  k.row = along_row<D, Plain>;
  return k;
}
template <int D, typename Plain, typename Full>
NoiseKernels with_octaves(NoiseKernels k) {
  k.octave = reinterpret_cast<Octave>(&Called<D, Plain>::plain);
  k.octave_full = reinterpret_cast<Octave>(&Called<D, Full>::tiled);
  return k;
}
// A noise that may take so long that a call of it does not show: in HN_FIXED and in space. There its kernels call what
// sums call, so that it is compiled once; two such noises are a fifth of all code of noises. A call costs 5 to 14 % of
// what others take.
template <int D, typename Plain, typename Full>
NoiseKernels slow_with_octaves() {
#if HN_ARITHMETIC == HN_FIXED
  if constexpr (D == 3) {
    NoiseKernels k{};
    k.plain = Called<D, Plain>::plain_at_points;
    k.row = k.plain;
    k.full = Called<D, Full>::tiled_at_points;
    return with_octaves<D, Plain, Full>(k);
  }
#endif
  return with_octaves<D, Plain, Full>(kernels_of<D, Plain, Full>());
}
template <int D, typename Phase, typename Full>
NoiseKernels with_phase(NoiseKernels k) {
  k.phase = at_points<D, Phase>;
  k.phase_full = at_points<D, Full>;
  return k;
}

#define HN_GRID_OF(D, name) kernels_of<D, name##_plain, name##_full>()
#define HN_GRID_ROWS(D, name) with_rows<D, name##_plain, name##_full>()
#define HN_GRID_SLOW(D, name) slow_with_octaves<D, name##_plain, name##_full>()
#define HN_GRID_OCTAVES(D, name, kernels) with_octaves<D, name##_plain, name##_full>(kernels)
#define HN_GRID_PHASE(D, name, kernels) with_phase<D, name##_phase, name##_phase_full>(kernels)

// On the plane and in space.
template <int D>
void enter(NoiseKernels (&noises)[grid::kNoises][4]) {
  const auto at = [&](grid::NoiseId id) -> NoiseKernels& { return noises[id][D - 1]; };
  at(grid::kValue) = HN_GRID_OCTAVES(D, value, HN_GRID_ROWS(D, value));
  at(grid::kValueD) = HN_GRID_OCTAVES(D, value_d, HN_GRID_OF(D, value_d));
  at(grid::kValueCubic) = HN_GRID_OCTAVES(D, value_cubic, HN_GRID_ROWS(D, value_cubic));
  at(grid::kPerlin) = HN_GRID_PHASE(D, perlin, HN_GRID_OCTAVES(D, perlin, HN_GRID_ROWS(D, perlin)));
  at(grid::kPerlinD) = HN_GRID_PHASE(D, perlin_d, HN_GRID_OCTAVES(D, perlin_d, HN_GRID_OF(D, perlin_d)));
  at(grid::kSimplex) = HN_GRID_PHASE(D, simplex, HN_GRID_OCTAVES(D, simplex, HN_GRID_ROWS(D, simplex)));
  at(grid::kSimplexD) = HN_GRID_PHASE(D, simplex_d, HN_GRID_OCTAVES(D, simplex_d, HN_GRID_OF(D, simplex_d)));
  at(grid::kSimplexSmooth) = HN_GRID_OCTAVES(D, simplex_smooth, HN_GRID_ROWS(D, simplex_smooth));
  at(grid::kCellular) = HN_GRID_ROWS(D, cellular);
  at(grid::kCellularThree) = HN_GRID_OF(D, cellular_three);
  at(grid::kCellularD) = HN_GRID_OF(D, cellular_d);
  at(grid::kCellularSmooth) = HN_GRID_SLOW(D, cellular_smooth);
  at(grid::kCellBorder) = HN_GRID_SLOW(D, cell_border);
  at(grid::kCurl) = HN_GRID_OF(D, curl);
}

void enter_line(NoiseKernels (&noises)[grid::kNoises][4]) {
  noises[grid::kValue][0] = HN_GRID_OCTAVES(1, value, HN_GRID_OF(1, value));
  noises[grid::kValueD][0] = HN_GRID_OF(1, value_d);
  noises[grid::kValueCubic][0] = HN_GRID_OCTAVES(1, value_cubic, HN_GRID_OF(1, value_cubic));
  noises[grid::kPerlin][0] = HN_GRID_OCTAVES(1, perlin, HN_GRID_OF(1, perlin));
  noises[grid::kPerlinD][0] = HN_GRID_OF(1, perlin_d);
}

void enter_4d(NoiseKernels (&noises)[grid::kNoises][4]) {
  noises[grid::kValue][3] = HN_GRID_OCTAVES(4, value, HN_GRID_OF(4, value));
  noises[grid::kValueD][3] = HN_GRID_OF(4, value_d4);
  noises[grid::kPerlin][3] = HN_GRID_OCTAVES(4, perlin, HN_GRID_OF(4, perlin));
  noises[grid::kPerlinD][3] = HN_GRID_OF(4, perlin_d4);
  noises[grid::kSimplex][3] = HN_GRID_OCTAVES(4, simplex, HN_GRID_OF(4, simplex));
  noises[grid::kSimplexD][3] = HN_GRID_OF(4, simplex_d4);
}

// A place in a cell is a float, and in HN_FIXED a multiple of 2^-20: what the noise makes of it is the fraction again.
void split(const float* position, int count, std::int32_t* cell, float* place) {
  for (int i = 0; i < count; i += kCount) {
    const Float p = Float::load(position + i);
    hn_i_cell(p).store(cell + i);
#if HN_ARITHMETIC == HN_FIXED
    (Float(hn_i_fraction(p)) * (1.0f / HN_I_ONE)).store(place + i);
#else
    hn_i_fraction(p).store(place + i);
#endif
  }
}

void widen(const float* value, int count, float* least, float* greatest) {
  Float low = Float::load(least);
  Float high = Float::load(greatest);
  int i = 0;
  for (; i + kCount <= count; i += kCount) {
    const Float n = Float::load(value + i);
    low = min(low, n);
    high = max(high, n);
  }
  low.store(least);
  high.store(greatest);
  for (; i < count; ++i) {
    least[0] = value[i] < least[0] ? value[i] : least[0];
    greatest[0] = greatest[0] < value[i] ? value[i] : greatest[0];
  }
}

void enter(grid::Kernels& kernels) {
  enter_line(kernels.noises);
  enter<2>(kernels.noises);
  enter<3>(kernels.noises);
  enter_4d(kernels.noises);
  kernels.split = split;
  kernels.widen = widen;
}

}  // namespace
}  // namespace HN_LANES

void grid::HASHNOISE_PASTE(noises_, HASHNOISE_TABLE)(Kernels& kernels) { lanes::enter(kernels); }

}  // namespace hashnoise
