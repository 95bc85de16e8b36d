// The kernels of noises, for one instruction set and one arithmetic: the text of the library in a loop.
#include "at_points.hpp"
#include "columns.hpp"
#include "loops.hpp"
#include "runs.hpp"
#include "tables.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// A noise at a place, by how it is called: plain, in a tile with everything that may be chosen (full), with a phase,
// and both.
#define HN_GRID_NOISE(kind, name, in, ...) HN_GRID_CALL(name##_##kind, hn_##name, in, __VA_ARGS__)
#define HN_GRID_CALL(type, function, in, ...)                                                \
  struct type {                                                                              \
    template <int D>                                                                         \
    HN_I_INLINE static auto at(Place<D> place, [[maybe_unused]] const Arguments<D>& given) { \
      return function(in, __VA_ARGS__);                                                      \
    }                                                                                        \
  };
#define HN_GRID_TILE hn_tile(place, given.period)
// By the noise's inputs. A noise without a phase has no struct for it.
#define HN_GRID_WITHOUT_PHASE(name, ...)               \
  HN_GRID_NOISE(plain, name, place, given.seed)        \
  HN_GRID_NOISE(full, name, HN_GRID_TILE, __VA_ARGS__) \
  struct name##_phase;                                 \
  struct name##_phase_full;
#define HN_GRID_kNothing(name) HN_GRID_WITHOUT_PHASE(name, given.seed)
#define HN_GRID_kJitter(name) HN_GRID_WITHOUT_PHASE(name, given.jitter, given.seed)
#define HN_GRID_kJitterAndMetric(name) HN_GRID_WITHOUT_PHASE(name, given.jitter, given.metric, given.seed)
#define HN_GRID_kPhase(name)                                 \
  HN_GRID_NOISE(plain, name, place, given.seed)              \
  HN_GRID_NOISE(full, name, HN_GRID_TILE, given.seed)        \
  HN_GRID_NOISE(phase, name, place, given.phase, given.seed) \
  HN_GRID_NOISE(phase_full, name, HN_GRID_TILE, given.phase, given.seed)
#define HN_GRID_kJitterAndMetricAndPhase(name)                                                \
  HN_GRID_NOISE(plain, name, place, given.seed)                                               \
  HN_GRID_NOISE(full, name, HN_GRID_TILE, given.jitter, given.metric, given.seed)             \
  HN_GRID_CALL(name##_phase, hn_##name##_phase, place, given.phase, given.jitter, given.seed) \
  HN_GRID_CALL(name##_phase_full, hn_##name##_phase, HN_GRID_TILE, given.phase, given.jitter, given.seed)
// A noise with a wave always has a phase: 0 if none is given.
#define HN_GRID_kPhaseAndWave(name)                                            \
  HN_GRID_NOISE(plain, name, place, given.wave, given.phase, given.seed)       \
  HN_GRID_NOISE(full, name, HN_GRID_TILE, given.wave, given.phase, given.seed) \
  using name##_phase = name##_plain;                                           \
  using name##_phase_full = name##_full;

#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes) HN_GRID_##takes(name)
#include "catalog.inc"

// The columns of a row, for noises that have them, and whether they are in a tile.
template <int D, typename Noise>
struct ColumnsOf {
  using Type = void;
};
#ifdef HN_GRID_HAS_WINDOWS
#define HN_GRID_COLUMNS(noise, Columns)             \
  HN_GRID_COLUMNS_OF(noise##_plain, Columns, false) \
  HN_GRID_COLUMNS_OF(noise##_full, Columns, true)
#define HN_GRID_COLUMNS_OF(noise, Columns, tiled)         \
  template <int D>                                        \
  requires(D == 2 || D == 3) struct ColumnsOf<D, noise> { \
    using Type = Columns<D>;                              \
    static constexpr bool kTiled = tiled;                 \
  };
HN_GRID_COLUMNS(value, ValueColumns)
HN_GRID_COLUMNS(perlin, PerlinColumns)
HN_GRID_COLUMNS(simplex, SimplexColumns)
HN_GRID_COLUMNS(simplex_smooth, SmoothSimplexColumns)
HN_GRID_COLUMNS(cellular, CellularColumns)
#endif

// The kernel of a noise for points on a line. In a tile octaves are not rotated, so lines other than rows do not occur.
template <int D, typename Noise>
struct PiecesOf {
  using Type = void;
};
#ifdef HN_GRID_HAS_WINDOWS
template <int D>
requires(D == 2 || D == 3) struct PiecesOf<D, value_plain> {
  using Type = ValuePieces<D>;
};
template <int D>
requires(D == 2 || D == 3) struct PiecesOf<D, perlin_plain> {
  using Type = PerlinPieces<D>;
};
#endif

template <int D, typename Noise>
HN_I_INLINE auto noise_at(const Place<D>& place, const Arguments<D>& given) {
  if constexpr ((D == 2 || D == 3) && std::is_same_v<Noise, simplex_plain>) {
    return hn_i_value(simplex_at(place, given.seed));
  } else if constexpr ((D == 2 || D == 3) && std::is_same_v<Noise, perlin_plain>) {
    return hn_i_value(perlin_at(place, given.seed));
  } else if constexpr ((D == 2 || D == 3) && std::is_same_v<Noise, value_plain>) {
    return hn_i_value(value_at(place, given.seed));
  } else {
    return Noise::template at<D>(place, given);
  }
}

// Whether two vectors of points are computed side by side. Most steps of a noise wait for the one before, so a second
// chain of them takes a tenth off the time, where the registers hold both.
template <int D, typename Noise>
constexpr bool kAreTwo = ((D == 2 || (D == 3 && kCount == 16)) &&
                          (std::is_same_v<Noise, value_plain> || std::is_same_v<Noise, perlin_plain>)) ||
                         (D == 2 && std::is_same_v<Noise, simplex_plain>);

template <int D, typename Noise, typename PlaceAt>
HN_I_INLINE void at_places(const Batch& b, const Arguments<D>& given, const PlaceAt& place) {
  int i = 0;
  if constexpr (kAreTwo<D, Noise>) {
    for (; i + 2 * kCount <= b.count; i += 2 * kCount) {
      const auto first = noise_at<D, Noise>(place(i), given), second = noise_at<D, Noise>(place(i + kCount), given);
      store(b, i, first);
      store(b, i + kCount, second);
    }
  }
  for (; i < b.count; i += kCount) store(b, i, noise_at<D, Noise>(place(i), given));
}

template <int D, typename Noise>
void at_points(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  if (b.cell[0] != nullptr) {
    at_places<D, Noise>(b, given, [&](int i) HN_I_INLINED { return place_in_cell<D>(b, i); });
  } else {
    at_places<D, Noise>(b, given, [&](int i) HN_I_INLINED { return place_at_position<D>(b, i); });
  }
}

// Along a row: what depends on the other axes is computed once.
template <int D, typename Noise>
void along_row(const Batch& batch, const Options& options, Octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  using Columns = typename ColumnsOf<D, Noise>::Type;
  if constexpr (!std::is_void_v<Columns>) {
    constexpr bool kTiled = ColumnsOf<D, Noise>::kTiled;
    if (b.step <= Columns::kMostStep && options.metric == HN_METRIC_EUCLIDEAN) {
      const auto tile_of = [&](const Place<D>& place) HN_I_INLINED {
        if constexpr (kTiled) {
          return hn_tile(place, given.period);
        } else {
          return place;
        }
      };
      const auto at_seam = [&](const Place<D>& place) HN_I_INLINED { return Noise::template at<D>(place, given); };
      if constexpr (std::is_constructible_v<Columns, Float>) {
        Columns columns(given.jitter);
        return along_columns<D, kTiled>(columns, b, given.seed, tile_of, at_seam);
      } else {
        Columns columns;  // Columns() would be filled with zeros in each row
        return along_columns<D, kTiled>(columns, b, given.seed, tile_of, at_seam);
      }
    }
  }
  Cell<D> cell = cells_at<D>(b, 0);
  Fraction<D> f = fractions_at<D>(b, 0);
  for (int i = 0; i < b.count; i += kCount) {
    cell.x = Int::load(b.cell[0] + i);
    f.x = Float::load(b.place[0] + i);
    store(b, i, Noise::template at<D>(hn_place(cell, f), given));
  }
}

// Along another line.
template <int D, typename Noise>
void along_line(const Batch& batch, const Options& options, Octave octave) {
#ifdef HN_GRID_HAS_WINDOWS
  using Pieces = typename PiecesOf<D, Noise>::Type;
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
  at_points<D, Noise>(batch, options, octave);
}

// A noise for sums, and for kernels of its own that call it: see OctaveOf.
template <int D, typename Noise, typename Axes = std::make_index_sequence<D>>
struct NoiseCall;
template <int D, typename Noise, std::size_t... Axis>
struct NoiseCall<D, Noise, std::index_sequence<Axis...>> {
  HN_GRID_NOINLINE static auto plain(ForEach<Int, Axis>... cell, ForEach<hn_i_num, Axis>... fraction, Uint seed) {
    Arguments<D> given{Options{}};
    given.seed = seed;
    return Noise::template at<D>(place(cell..., fraction...), given);
  }
  HN_GRID_NOINLINE static auto tiled(ForEach<Int, Axis>... cell, ForEach<hn_i_num, Axis>... fraction,
                                     const Tile<D>& tile, Uint seed) {
    Arguments<D> given{Options{}};
    given.period = tile.period;
    given.seed = seed;
    given.jitter = tile.jitter;
    return Noise::template at<D>(place(cell..., fraction...), given);
  }

  // Kernels that call these for each vector of points.
  static void plain_at_points(const Batch& batch, const Options& options, Octave) {
    const Batch b = batch;
    const Uint seed(options.seed);
    for (int i = 0; i < b.count; i += kCount) {
      const Place<D> at = place_at<D>(b, i);
      store(b, i, plain(along<Axis>(at.cell)..., along<Axis>(at.fraction)..., seed));
    }
  }
  static void tiled_at_points(const Batch& batch, const Options& options, Octave) {
    const Batch b = batch;
    const Arguments<D> given(options);
    const Tile<D> tile{given.period, given.jitter};
    for (int i = 0; i < b.count; i += kCount) {
      const Place<D> at = place_at<D>(b, i);
      store(b, i, tiled(along<Axis>(at.cell)..., along<Axis>(at.fraction)..., tile, given.seed));
    }
  }

 private:
  HN_I_INLINE static Place<D> place(ForEach<Int, Axis>... cell, ForEach<hn_i_num, Axis>... fraction) {
    using Numbers = decltype(Place<D>::fraction);
    return hn_i_place(Cell<D>(cell...), Numbers(fraction...), Cell<D>(ForEach<Int, Axis>(0)...));
  }
};

using grid::always;
using grid::NoiseKernels;

// The kernels of a noise.
template <int D, grid::Shape shape, grid::Inputs takes, typename Plain, typename Full, typename Phase,
          typename PhaseFull>
NoiseKernels kernels_of() {
  constexpr bool kIsFlatOrInSpace = D == 2 || D == 3;
  constexpr bool kIsSearched = takes == grid::Inputs::kJitter && shape == grid::Shape::kValue;
  // Sums of noises with slopes, and of vectors, are in 2D and 3D.
  constexpr bool kIsSummed = shape == grid::Shape::kValue ||
                             ((shape == grid::Shape::kWithSlopes || shape == grid::Shape::kVector) && kIsFlatOrInSpace);
  // Where it was measured to be faster: for others what the axes share is little of the whole.
  constexpr bool kIsFasterInRows =
      kIsFlatOrInSpace && ((shape == grid::Shape::kValue && !kIsSearched) || shape == grid::Shape::kTwoDistances);
  // A search may take so long that a call of it does not show: in HN_FIXED and in space. There its kernels call what
  // sums call, so that it is compiled once; two such noises are a fifth of all code of noises. A call costs 5 to 14 %
  // of what others take.
  constexpr bool kIsCalled = HN_ARITHMETIC == HN_FIXED && D == 3 && kIsSearched;
  NoiseKernels k{};
  if constexpr (kIsCalled) {
    k.plain = always(NoiseCall<D, Plain>::plain_at_points);
    k.full = always(NoiseCall<D, Full>::tiled_at_points);
  } else {
    k.plain = always(at_points<D, Plain>);
    k.full = always(at_points<D, Full>);
  }
  if constexpr (kIsFasterInRows) k.plain.row = along_row<D, Plain>;
  if constexpr (!std::is_void_v<typename ColumnsOf<D, Full>::Type>) k.full.row = along_row<D, Full>;
  if constexpr (!std::is_void_v<typename PiecesOf<D, Plain>::Type>) k.plain.line = along_line<D, Plain>;
  if constexpr (kIsSummed) {
    k.octave = reinterpret_cast<Octave>(&NoiseCall<D, Plain>::plain);
    k.octave_full = reinterpret_cast<Octave>(&NoiseCall<D, Full>::tiled);
  }
  constexpr bool kHasPhase = takes == grid::Inputs::kPhase || takes == grid::Inputs::kJitterAndMetricAndPhase;
  if constexpr (kHasPhase && kIsFlatOrInSpace) {
    k.phase = always(at_points<D, Phase>);
    k.phase_full = always(at_points<D, PhaseFull>);
  }
  if constexpr (takes == grid::Inputs::kPhaseAndWave) {
    k.phase = k.plain;
    k.phase_full = k.full;
  }
  return k;
}

template <int D>
void enter(NoiseKernels (&noises)[grid::kNoises][4]) {
#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes)                                                      \
  if constexpr (first <= D && D <= last) {                                                                         \
    noises[grid::k##Id][D - 1] = kernels_of<D, grid::Shape::shape, grid::Inputs::takes, name##_plain, name##_full, \
                                            name##_phase, name##_phase_full>();                                    \
  }
#include "catalog.inc"
}

// A place in a cell is a float, and in HN_FIXED a multiple of 2^-20: the noise gets the fraction again.
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

// Infinities and NaNs have an exponent of ones. One more reaches the sign.
bool are_finite(const float* numbers, int count) {
  Uint any(0u);
  const auto take = [&](Float n) HN_I_INLINED { any |= (floatBitsToUint(n) & 0x7F800000u) + 0x00800000u; };
  int i = 0;
  for (; i + kCount <= count; i += kCount) take(Float::load(numbers + i));
  for (; i < count; ++i) take(Float(numbers[i]));
  return !hn_i_any((any & 0x80000000u) != 0u);
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

void grid::HASHNOISE_PASTE(noises_, HASHNOISE_TABLE)(Kernels& kernels) { lanes::enter(kernels); }

}  // namespace hashnoise
