// The kernels of noises, for one instruction set and one arithmetic: the text of the library in a loop.
#include "at_points.hpp"
#include "columns.hpp"
#include "loops.hpp"
#include "runs.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// A noise at a place, by how it is called: plain, with everything that may be chosen (full), and with a phase, if it
// has one.
#define HN_GRID_NOISE(type, name, ...)                                                              \
  struct type {                                                                                     \
    template <int D>                                                                                \
    HN_I_INLINE static auto at(const Place<D>& place, [[maybe_unused]] const Arguments<D>& given) { \
      return hn_##name(place, __VA_ARGS__);                                                         \
    }                                                                                               \
  };
// One kernel is for both where what may be chosen is a factor that is 1 in the other, or is nothing.
#define HN_GRID_ONE(name, ...)                   \
  HN_GRID_NOISE(name##_plain, name, __VA_ARGS__) \
  using name##_full = name##_plain;              \
  struct name##_phase;
#define HN_GRID_kNothing(name) HN_GRID_ONE(name, given.seed)
#define HN_GRID_kJitter(name) HN_GRID_ONE(name, given.jitter, given.seed)
#define HN_GRID_kPhase(name)    \
  HN_GRID_ONE(name, given.seed) \
  HN_GRID_NOISE(name##_phase, name, given.phase, given.seed)
#define HN_GRID_kJitterAndMetric(name)                                     \
  HN_GRID_NOISE(name##_plain, name, given.seed)                            \
  HN_GRID_NOISE(name##_full, name, given.jitter, given.metric, given.seed) \
  struct name##_phase;
#define HN_GRID_kJitterAndMetricAndPhase(name)                             \
  HN_GRID_NOISE(name##_plain, name, given.seed)                            \
  HN_GRID_NOISE(name##_full, name, given.jitter, given.metric, given.seed) \
  HN_GRID_NOISE(name##_phase, name##_phase, given.phase, given.jitter, given.seed)
// A noise with a wave always has a phase: 0 if none is given.
#define HN_GRID_kBandwidthAndPhaseAndWave(name)                          \
  HN_GRID_NOISE(name##_plain, name, given.wave, given.phase, given.seed) \
  using name##_full = name##_plain;                                      \
  HN_GRID_NOISE(name##_phase, name, given.wave, given.bandwidth, given.phase, given.seed)

#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes) HN_GRID_##takes(name)
#include "catalog.inc"

// Noises that have columns of a row, or pieces of a line. In a tile octaves are not rotated, so lines other than rows
// do not occur there.
using grid::NoiseId;
template <int D, NoiseId id>
struct ColumnsOf {
  using Type = void;
};
template <int D, NoiseId id>
constexpr bool kIsPlainLattice = (D == 2 || D == 3) && (id == grid::kPerlin || id == grid::kValue);
#ifdef HN_GRID_HAS_WINDOWS
#define HN_GRID_COLUMNS(Id, Columns) \
  template <int D>                   \
  requires(D == 2 || D == 3) struct ColumnsOf<D, grid::k##Id> { using Type = Columns<D>; };
HN_GRID_COLUMNS(Value, ValueColumns)
HN_GRID_COLUMNS(Perlin, PerlinColumns)
HN_GRID_COLUMNS(Simplex, SimplexColumns)
HN_GRID_COLUMNS(SimplexSmooth, SmoothSimplexColumns)
HN_GRID_COLUMNS(Cellular, CellularColumns)
#endif

// Noises without a period that have code of their own for points.
template <int D, NoiseId id>
constexpr bool kIsOwn = kIsPlainLattice<D, id> || ((D == 2 || D == 3) && id == grid::kSimplex);
template <int D, NoiseId id>
HN_I_INLINE hn_i_num own_at(const Place<D>& place, Uint seed) {
  if constexpr (id == grid::kSimplex) {
    return simplex_at(place, seed);
  } else {
    return lattice_noise_at<id == grid::kPerlin, D>(place, seed);
  }
}

// Two vectors of points are computed side by side where the registers hold both. Most steps of a noise wait for the one
// before, so a second chain of them takes a tenth off the time.
template <int D, NoiseId id>
constexpr bool kAreTwo = (kIsPlainLattice<D, id> && (D == 2 || kCount == 16)) || (D == 2 && id == grid::kSimplex);

// Cells and positions have loops of their own: with a branch for each vector of points simplex noise in space takes up
// to 12 % longer.
template <int D, NoiseId id>
void own_at_points(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Uint seed(options.seed);
  const auto at_places = [&](const auto& place) HN_I_INLINED {
    const auto noise = [&](int i) HN_I_INLINED { return hn_i_value(own_at<D, id>(place(i), seed)); };
    int i = 0;
    if constexpr (kAreTwo<D, id>) {
      for (; i + 2 * kCount <= b.count; i += 2 * kCount) {
        const auto first = noise(i), second = noise(i + kCount);
        store(b, i, first);
        store(b, i + kCount, second);
      }
    }
    for (; i < b.count; i += kCount) store(b, i, noise(i));
  };
  if (b.cell[0] != nullptr) {
    at_places([&](int i) HN_I_INLINED { return place_in_cell<D>(b, i); });
  } else {
    at_places([&](int i) HN_I_INLINED { return place_at_position<D>(b, i); });
  }
}

template <int D, typename Noise, bool kMayTile = true>
void at_points(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  for (int i = 0; i < b.count; i += kCount) {
    auto place = place_at<D>(b, i);
    if constexpr (kMayTile) place = placed(place, given);
    store(b, i, Noise::template at<D>(place, given));
  }
}

// Without a period. Two loops, for which GCC keeps the constants of a noise outside: with one loop simplex_smooth in
// space takes up to 6 % longer.
template <int D, typename Noise>
void at_points_apart(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  const auto at_places = [&](const auto& place) HN_I_INLINED {
    for (int i = 0; i < b.count; i += kCount) store(b, i, Noise::template at<D>(place(i), given));
  };
  if (b.cell[0] != nullptr) {
    at_places([&](int i) HN_I_INLINED { return place_in_cell<D>(b, i); });
  } else {
    at_places([&](int i) HN_I_INLINED { return place_at_position<D>(b, i); });
  }
}

// Along a row: what depends on the other axes is computed once. Cellular noise in space has little of it, and in a tile
// its code takes long to compile.
template <int D, typename Noise, NoiseId id, bool kTiled>
void along_row(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  const auto tile_of = [&](const Place<D>& place) HN_I_INLINED {
    if constexpr (kTiled) {
      return hn_tile(place, given.period);
    } else {
      return place;
    }
  };
  using Columns = typename ColumnsOf<D, id>::Type;
  if constexpr (!std::is_void_v<Columns>) {
    if (b.step <= Columns::kMostStep && options.metric == HN_METRIC_EUCLIDEAN && !(kTiled && is_near_wrap(b))) {
      if constexpr (std::is_constructible_v<Columns, Float>) {
        Columns columns(given.jitter);
        return along_columns<D>(columns, b, given.seed, tile_of);
      } else {
        Columns columns;  // Columns() would be filled with zeros in each row
        return along_columns<D>(columns, b, given.seed, tile_of);
      }
    }
  }
  if constexpr (kTiled && id == grid::kCellular && D == 3) {
    at_points<D, Noise>(batch, options, nullptr);
  } else {
    Cell<D> cell = cells_at<D>(b, 0);
    Fraction<D> f = fractions_at<D>(b, 0);
    for (int i = 0; i < b.count; i += kCount) {
      cell.x = Int::load(b.cell[0] + i);
      f.x = Float::load(b.place[0] + i);
      store(b, i, Noise::template at<D>(tile_of(hn_place(cell, f)), given));
    }
  }
}

// Along another line.
template <int D, NoiseId id>
void along_line(const Batch& batch, const Options& options, Octave octave) {
#ifdef HN_GRID_HAS_WINDOWS
  using Pieces = CornerPieces<id == grid::kPerlin, D>;
  if (batch.step <= Pieces::kMostStep) {
    const Batch b = batch;
    const Uint seed(options.seed);
    Pieces pieces;
    for (int start = 0; start < b.count; start += kPointsAtOnce) {
      const int left = b.count - start;
      over_runs(
          pieces, (left < kPointsAtOnce ? left : kPointsAtOnce) / kCount, seed,
          [&](int v) HN_I_INLINED { return place_at<D>(b, start + v * kCount); },
          [&](int v, hn_i_num n) HN_I_INLINED { store(b, start + v * kCount, hn_i_value(n)); });
    }
    return;
  }
#endif
  own_at_points<D, id>(batch, options, octave);
}

// A noise that sums call.
template <int D, typename Noise>
HN_GRID_NOINLINE auto called(const Place<D>& place, const Arguments<D>& given) {
  return Noise::template at<D>(place, given);
}

using grid::always;
using grid::NoiseKernels;

// The kernels of a noise.
template <int D, NoiseId id, grid::Shape shape, grid::Inputs takes, typename Plain, typename Full, typename Phase>
NoiseKernels kernels_of() {
  constexpr bool kIsFlatOrInSpace = D == 2 || D == 3;
  constexpr bool kIsSearched = takes == grid::Inputs::kJitter && shape == grid::Shape::kValue;
  // Sums of values take the loops of the noise.
  constexpr bool kIsCalled = (shape == grid::Shape::kWithSlopes || shape == grid::Shape::kVector) && kIsFlatOrInSpace;
  // Where it was measured to be faster: for others what the axes share is little of the whole.
  constexpr bool kIsFasterInRows =
      kIsFlatOrInSpace && ((shape == grid::Shape::kValue && !kIsSearched) || shape == grid::Shape::kTwoDistances);
  NoiseKernels k{};
  // With one kernel for both, lists of simplex_smooth take AVX2 up to 4 % longer, and in space up to 6 %.
  constexpr bool kIsBoth = std::is_same_v<Plain, Full> && id != grid::kSimplexSmooth;
  if constexpr (id == grid::kSimplexSmooth && D == 3) {
    k.plain = always(at_points_apart<D, Plain>);
  } else {
    k.plain = always(at_points<D, Plain, kIsBoth>);
  }
  k.full = always(at_points<D, Full>);
  if constexpr (kIsOwn<D, id>) k.plain = always(own_at_points<D, id>);
  if constexpr (kIsFasterInRows) k.plain.row = along_row<D, Plain, id, false>;
  if constexpr (!std::is_void_v<typename ColumnsOf<D, id>::Type>) k.full.row = along_row<D, Full, id, true>;
  if constexpr (kIsPlainLattice<D, id>) k.plain.line = along_line<D, id>;
  if constexpr (kIsCalled) k.octave = reinterpret_cast<Octave>(&called<D, Plain>);
  constexpr bool kHasPhase = takes == grid::Inputs::kPhase || takes == grid::Inputs::kJitterAndMetricAndPhase ||
                             takes == grid::Inputs::kBandwidthAndPhaseAndWave;
  if constexpr (kHasPhase && kIsFlatOrInSpace) {
    k.phase = always(at_points<D, Phase>);
  }
  return k;
}

template <int D>
void enter(NoiseKernels (&noises)[grid::kNoises][4]) {
#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes)                                                      \
  if constexpr (first <= D && D <= last) {                                                                         \
    noises[grid::k##Id][D - 1] = kernels_of<D, grid::k##Id, grid::Shape::shape, grid::Inputs::takes, name##_plain, \
                                            name##_full, name##_phase>();                                          \
  }
#include "catalog.inc"
}

// A place in a cell is a float, and in HN_FIXED a multiple of 2^-20: the noise gets the fraction again.
void split(const float* position, int count, std::int32_t* cell, float* place) {
  for (int i = 0; i < count; i += kCount) {
    const auto at = hn_place(Float::load(position + i));
    at.cell.store(cell + i);
    (Float(at.fraction) * (1.0f / HN_I_ONE)).store(place + i);
  }
}

// Infinities and NaNs have an exponent of ones. One more reaches the sign.
bool are_finite(const float* numbers, int count) {
  std::uint32_t any = 0;
  for (int i = 0; i < count; ++i) any |= (__builtin_bit_cast(std::uint32_t, numbers[i]) & 0x7F800000u) + 0x00800000u;
  return any < 0x80000000u;
}

void widen(const float* value, int count, float* least, float* greatest) {
  Float low = Float::load(least), high = Float::load(greatest);
  int i = 0;
  for (; i + kCount <= count; i += kCount) {
    const Float n = Float::load(value + i);
    low = min(low, n);
    high = max(high, n);
  }
  low.store(least);
  high.store(greatest);
  for (; i < count; ++i) {
    *least = value[i] < *least ? value[i] : *least;
    *greatest = *greatest < value[i] ? value[i] : *greatest;
  }
}

void enter_noises(grid::Kernels& kernels) {
  enter<1>(kernels.noises);
  enter<2>(kernels.noises);
  enter<3>(kernels.noises);
  enter<4>(kernels.noises);
  kernels.split = split;
  kernels.are_finite = are_finite;
  kernels.widen = widen;
}

}  // namespace
}  // namespace HN_LANES

namespace grid {
HASHNOISE_ENTER(noises, HASHNOISE_TABLE) { lanes::enter_noises(kernels); }
}  // namespace grid

}  // namespace hashnoise
