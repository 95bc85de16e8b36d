// The kernels of sums, for one instruction set and one arithmetic: the octaves of the library over a noise
// that is called, since there are too many pairs of a sum and a noise to compile. Those that are asked for most are
// compiled without that call.
#include "columns.hpp"
#include "loops.hpp"
#include "runs.hpp"
#include "tables.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// A noise that is called.
template <int D, typename Result>
class Called {
 public:
  explicit Called(Octave noise) : octave_(noise) {}

  HN_I_INLINE Result octave(Place<D> place, Uint seed) const {
    return call(place, seed, std::make_index_sequence<D>());
  }

 private:
  template <std::size_t... Axis>
  HN_I_INLINE Result call(Place<D> place, Uint seed, std::index_sequence<Axis...>) const {
    using Types = OctaveOf<D, Result>;
    if (place.tiled) {
      return reinterpret_cast<typename Types::Tiled>(octave_)(
          along<Axis>(place.cell)..., along<Axis>(place.fraction)..., Tile<D>{place.period, Float(1.0f)}, seed);
    }
    return reinterpret_cast<typename Types::Plain>(octave_)(along<Axis>(place.cell)..., along<Axis>(place.fraction)...,
                                                            seed);
  }

  Octave octave_;
};

// A noise that is inlined.
#define HN_GRID_INLINED(Name, name)                                                              \
  template <int D>                                                                               \
  class Name {                                                                                   \
   public:                                                                                       \
    explicit Name(Octave) {}                                                                     \
                                                                                                 \
    HN_I_INLINE Float octave(Place<D> place, Uint seed) const { return hn_##name(place, seed); } \
  };
HN_GRID_INLINED(Value, value)
HN_GRID_INLINED(Perlin, perlin)
HN_GRID_INLINED(Simplex, simplex)

// What a sum is: how it adds an octave, and what it makes of the mean. The first of these is any of them: beside the
// call of a noise it costs nothing to ask which it is, and all of them would take ten times as long to compile.
struct AnySum {
  std::int32_t id;
  Float strength;

  HN_I_INLINE explicit AnySum(const Options& options) : id(options.sum), strength(options.strength) {}
  template <typename Octaves>
  HN_I_INLINE void add(Octaves& o, Float n) const {
    const hn_i_octave_sum s = o.sum;
    switch (id) {
#define HN_CATALOG_STEP(Id, name, step, end) \
  case grid::k##Id:                          \
    o.sum = step;                            \
    return;
#include "catalog.inc"
      case grid::kDetail:
        return hn_add_detail(o, n);
      case grid::kFootprint:
        return hn_add_footprint(o, n);
    }
  }
  HN_I_INLINE hn_i_num end(hn_i_num mean) const {
    switch (id) {
#define HN_CATALOG_STEP(Id, name, step, end) \
  case grid::k##Id:                          \
    return end;
#include "catalog.inc"
      default:
        return mean;
    }
  }
};
struct Fbm {
  static constexpr bool kCarries = false;  // anything to the next octave but the value
  HN_I_INLINE explicit Fbm(const Options&) {}
  template <typename Octaves>
  HN_I_INLINE void add(Octaves& o, Float n) const {
    hn_add(o, n);
  }
  HN_I_INLINE hn_i_num end(hn_i_num mean) const { return mean; }
};
struct Ridged {
  static constexpr bool kCarries = true;
  HN_I_INLINE explicit Ridged(const Options&) {}
  template <typename Octaves>
  HN_I_INLINE void add(Octaves& o, Float n) const {
    hn_add_ridged(o, n);
  }
  HN_I_INLINE hn_i_num end(hn_i_num mean) const { return hn_i_bounded(mean); }
};

// The octaves at a position, or at a place.
template <int D, typename Position>
HN_I_INLINE auto octaves_at(const Position& p, const Given<D>& given) {
  return hn_octaves(p, given.octaves, given.lacunarity, given.gain, given.seed);
}

// hn_i_mean, of octaves of which there is one at least. With HN_FIXED it has the same integers by one division of
// doubles in place of three divisions of words, for which there are no instructions. sum * 2^18 is exact, since it has
// 45 bits. A quotient that is no integer is at least 1 / total from the next one: far more than the division rounds.
HN_I_INLINE hn_i_num mean_of(hn_i_num sum, hn_i_num total) {
#if HN_ARITHMETIC == HN_FIXED && !defined(HN_LANES_PORTABLE)
  using detail::DoubleVector;
  const DoubleVector dividend = __builtin_convertvector(sum.v, DoubleVector) * 262144.0;
  const DoubleVector quotient = dividend / __builtin_convertvector(total.v, DoubleVector);
  return Int(__builtin_convertvector(quotient, detail::IntVector));
#else
  return hn_i_mean(sum, total);
#endif
}

// Any sum over a noise that is called, in any dimension. What does not depend on the point is computed once.
template <int D>
class SumOf {
 public:
  HN_I_INLINE SumOf(Octave noise, const Options& options, const Given<D>& given)
      : noise_(noise), sum_(options), given_(given) {
    if (options.sum == grid::kDetail) {
      given_.octaves = hn_i_whole_octaves(given.limit);
      part_ = hn_i_last_part(given.limit, given_.octaves);
    }
    footprint_ = hn_i_footprint(given.limit);
    total_ = hn_i_total(hn_i_octaves(given_.octaves), hn_i_gain(given.gain), part_);
  }

  template <typename Position>
  HN_I_INLINE Float at(Position p) const {
    auto o = octaves_at(p, given_);
    o.sum.part = part_;
    o.sum.footprint = footprint_;
    do sum_.add(o, noise_.octave(o.place, o.seed)); while (hn_next(o));
    return hn_i_value(sum_.end(hn_i_select(o.sum.octaves < 1, HN_I_NO_WEIGHT, mean_of(o.sum.value, total_))));
  }

 private:
  Called<D, Float> noise_;
  AnySum sum_;
  Given<D> given_;
  hn_i_num part_ = HN_I_WEIGHT_ONE;
  hn_i_num footprint_, total_;
};

// Sums with frames, over a noise that is called.
template <int D, typename Result>
class Framed {
 public:
  HN_I_INLINE Framed(Octave noise, const Options&, const Given<D>& given) : noise_(noise), given_(given) {}

 protected:
  Called<D, Result> noise_;
  Given<D> given_;
};
template <int D>
using Vector = std::conditional_t<D == 2, vec2, vec3>;
template <int D>
using Slopes = Framed<D, std::conditional_t<D == 2, vec3, vec4>>;

template <int D>
class FbmD : public Slopes<D> {
 public:
  using Slopes<D>::Slopes;
  template <typename Position>
  HN_I_INLINE auto at(Position p) const {
    auto o = octaves_at(p, this->given_);
    auto s = hn_slopes(o);
    do hn_add(o, s, this->noise_.octave(o.place, o.seed)); while (hn_next(o));
    return hn_mean(o, s);
  }
};

template <int D>
class Eroded : public Slopes<D> {
 public:
  using Slopes<D>::Slopes;
  template <typename Position>
  HN_I_INLINE auto at(Position p) const {
    auto o = octaves_at(p, this->given_);
    auto s = hn_slopes(o);
    do hn_add_eroded(o, s, this->noise_.octave(o.place, o.seed), this->given_.strength); while (hn_next(o));
    return hn_mean(o);
  }
};

template <int D, bool kProgressive>
class Warp : public Framed<D, Vector<D>> {
 public:
  using Framed<D, Vector<D>>::Framed;
  template <typename Position>
  HN_I_INLINE auto at(Position p) const {
    auto o = octaves_at(p, this->given_);
    auto s = hn_shifts(o, this->given_.strength);
    do {
      const Vector<D> v = this->noise_.octave(o.place, o.seed);
      if constexpr (kProgressive) {
        hn_add_progressive(o, s, v);
      } else {
        hn_add(o, s, v);
      }
    } while (hn_next(o));
    return hn_mean(o, s);
  }
};

// How near the nearest point of cellular noise is. With it inlined in each of its kernels Perlin-Worley noise takes
// half as long again to compile.
HN_GRID_NOINLINE Float nearest_point(const Place<3>& place, Uint seed) { return hn_cellular(place, seed).x; }

// hn_i_perlin_worley, over Perlin noise that is called.
class PerlinWorley : public Framed<3, Float> {
 public:
  using Framed<3, Float>::Framed;
  template <typename Position>
  HN_I_INLINE Float at(Position p) const {
    auto wisps = octaves_at(p, given_);
    do hn_add(wisps, noise_.octave(wisps.place, wisps.seed)); while (hn_next(wisps));
    const Given<3>& given = given_;
    auto billows = hn_octaves(p, min(given.octaves, Int(3)), given.lacunarity, given.gain, hn_i_other_seed(given.seed));
    do hn_add(billows, hn_i_billow_at(nearest_point(billows.place, billows.seed))); while (hn_next(billows));
    return hn_i_value(hn_i_either(hn_i_bounded_octave(hn_mean(wisps)), hn_i_bounded_octave(hn_mean(billows))));
  }
};

// The positions of a batch: as they are, or from cells, or in a tile.
template <int D>
struct Positions {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>&) { return fractions_at<D>(b, i); }
};
template <int D>
struct Cells {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>&) { return places_at<D>(b, i); }
};
// In HN_FIXED both are of one type, and in a tile with all arithmetics: then one kernel takes both.
template <int D>
HN_I_INLINE Place<D> place_at(const Batch& b, int i) {
  return b.cell[0] != nullptr ? places_at<D>(b, i) : hn_place(fractions_at<D>(b, i));
}
template <int D>
struct Either {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>&) { return place_at<D>(b, i); }
};
template <int D>
struct Tiles {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>& given) {
    return hn_tile(place_at<D>(b, i), given.period);
  }
};

template <int D, typename At, typename Sum>
void at_points(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Given<D> given(options);
  const Sum sum(octave, options, given);
  for (int i = 0; i < b.count; i += kCount) store(b, i, sum.at(At::of(b, i, given)));
}

// Where some points are, as positions or as whole positions, along the first axes. The arrays are of numbers, since
// those of vectors would be filled with zeros first.
template <int D, bool kIsWhole, int kPoints>
class Spots {
 public:
  template <typename Octaves>
  HN_I_INLINE void keep(int i, const Octaves& o) {
    if constexpr (kIsWhole) {
      keep_whole(i, 0, o.x);
      if constexpr (D > 1) keep_whole(i, 1, o.y);
      if constexpr (D > 2) keep_whole(i, 2, o.z);
    } else {
      o.p.x.store(at_[0] + i);
      o.p.y.store(at_[1] + i);
      if constexpr (D == 3) o.p.z.store(at_[2] + i);
    }
  }
  template <typename Octaves>
  HN_I_INLINE void put(int i, Octaves& o) const {
    if constexpr (kIsWhole) {
      o.x = whole(i, 0);
      if constexpr (D > 1) o.y = whole(i, 1);
      if constexpr (D > 2) o.z = whole(i, 2);
      hn_i_update_place(o);
    } else {
      o.p = vector_of<Fraction<D>, D>([&](int axis) HN_I_INLINED { return Float::load(at_[axis] + i); });
      o.place.cell = hn_i_cell(o.p);
      o.place.fraction = hn_i_fraction(o.p);
    }
  }
  // The cell of a point along x, and which half of it the point is in.
  HN_I_INLINE std::int32_t cell(int point) const { return static_cast<std::int32_t>(floor_of(at_[0][point])); }
  HN_I_INLINE std::uint32_t half(int point) const {
    const auto at = at_[0][point];
    return (kIsWhole ? rest_[0][point] < 8388608 : at - floor_of(at) < At(0.5)) ? 0u : 1u;
  }
#ifdef HN_GRID_HAS_WINDOWS
  // Keeps those of a vector of others that are the first ones of runs.
  HN_I_INLINE void keep_starts(int i, const Spots& others, int of, Starts starts) {
    for (int axis = 0; axis < D; ++axis) {
      starts.of(Lanes<At>::load(others.at_[axis] + of)).store(at_[axis] + i);
      if constexpr (kIsWhole) starts.of(Int::load(others.rest_[axis] + of)).store(rest_[axis] + i);
    }
  }
#endif

 private:
  using At = std::conditional_t<kIsWhole, std::int32_t, float>;

  HN_I_INLINE static At floor_of(At at) {
    if constexpr (kIsWhole) {
      return at;
    } else {
      return hashnoise::floor(at);
    }
  }
  HN_I_INLINE void keep_whole(int i, int axis, ivec2 x) {
    x.x.store(at_[axis] + i);
    x.y.store(rest_[axis] + i);
  }
  HN_I_INLINE ivec2 whole(int i, int axis) const { return ivec2(Int::load(at_[axis] + i), Int::load(rest_[axis] + i)); }

  At at_[D][kPoints];                             // the cell, or the position
  std::int32_t rest_[kIsWhole ? D : 1][kPoints];  // what a whole position has beside the cell
};

constexpr int kVectors = kPointsAtOnce / kCount;

// What an octave leaves to the next one, at some vectors of points. Along a row of a tile, whose octaves are not
// turned, all points have one coordinate along each other axis. Those are in `across`, so that what depends on them
// alone is computed once.
template <int D, typename Position, bool kCarries, bool kIsRow>
class Reached {
 public:
  template <typename Octaves>
  HN_I_INLINE void keep(int vector, const Octaves& o) {
    spots_.keep(vector * kCount, o);
    o.sum.value.store(value_ + vector * kCount);
    if constexpr (kCarries) o.sum.carried.store(carried_ + vector * kCount);
  }
  template <typename Octaves>
  HN_I_INLINE void put(int vector, Octaves& o, const Octaves& across) const {
    if constexpr (kIsRow) {
      o.y = across.y;
      if constexpr (D == 3) o.z = across.z;
    }
    spots_.put(vector * kCount, o);
    put_sum(vector, o);
  }
  template <typename Octaves>
  HN_I_INLINE void put_sum(int vector, Octaves& o) const {
    o.sum.value = hn_i_num::load(value_ + vector * kCount);
    if constexpr (kCarries) o.sum.carried = hn_i_num::load(carried_ + vector * kCount);
  }
  HN_I_INLINE hn_i_num value(int vector) const { return hn_i_num::load(value_ + vector * kCount); }
  template <typename Octaves>
  HN_I_INLINE static void go_on(Octaves& o) {
    if constexpr (kIsWhole) {
      hn_i_advance(o);
    } else {
      o.p = hn_i_next(o.p, o.lacunarity);
    }
  }

#ifdef HN_GRID_HAS_WINDOWS
  // Whether this is at the seam that a tile has.
  HN_I_INLINE bool is_at_seam() const { return is_at_wrap(spots_.cell(0)); }
  // An octave along a row, if it is not turned: by columns. `add` takes the noise at a vector of points.
  template <typename Columns, typename Octaves, typename Add>
  HN_I_INLINE void by_columns(int vectors, Octaves& o, Octaves across, const Add& add) const {
    Columns columns;
    over_columns(
        columns, 0, vectors * kCount, o.seed,
        [&](int i) HN_I_INLINED {
          return Columns::earliest(static_cast<std::uint32_t>(spots_.cell(i)), spots_.half(i));
        },
        [&](int i) HN_I_INLINED {
          put(i / kCount, o, across);
          return o.place;
        },
        [&](int i, hn_i_num n) HN_I_INLINED { add(i / kCount, hn_i_value(n)); });
  }
  // Any octave along a row: by runs.
  template <typename Pieces, typename Octaves, typename Add>
  HN_I_INLINE void by_runs(int vectors, Octaves& o, const Add& add) const {
    Spots<D, kIsWhole, kPoints + kCount> first;
    const auto place_at = [&](int v) HN_I_INLINED {
      spots_.put(v * kCount, o);
      return o.place;
    };
    Pieces pieces;
    over_runs(
        pieces, vectors, o.seed, place_at,
        [&](int v, Starts starts, int run) HN_I_INLINED { first.keep_starts(run, spots_, v * kCount, starts); },
        [&](int run) HN_I_INLINED {
          first.put(run, o);
          return o.place;
        },
        [&](int v, hn_i_num n) HN_I_INLINED {
          put_sum(v, o);
          add(v, hn_i_value(n));
        });
  }
#endif

 private:
  static constexpr bool kIsWhole = std::is_same_v<Position, Place<D>>;
  static constexpr int kPoints = kVectors * kCount;
  using Number = decltype(hn_i_num()[0]);

  Spots<kIsRow ? 1 : D, kIsWhole, kPoints + kCount> spots_;
  Number value_[kPoints], carried_[kCarries ? kPoints : 1];
};

// Octave by octave over some points, in place of point by point over the octaves. So what all points of an octave
// share, such as the mixed seed and constants, is made once for them, and no point waits for its octave before. Along a
// row whose points are near each other, those in one piece of the lattice share more: by columns in octaves that are
// not turned, which are the first one and all of a tile, and by runs in others.
template <int D, typename At, typename Noise, typename Sum, bool kIsRow, typename Columns = void,
          typename Pieces = void>
void by_octaves(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Given<D> given(options);
  const Sum sum(options);
  const Noise noise(octave);
  const hn_i_num total = hn_i_total(hn_i_octaves(given.octaves), hn_i_gain(given.gain), HN_I_WEIGHT_ONE);
  constexpr bool kIsTiled = std::is_same_v<At, Tiles<D>>;
  Reached<D, decltype(At::of(b, 0, given)), Sum::kCarries, kIsRow> reached;
  for (int start = 0; start < b.count; start += kVectors * kCount) {
    const int left = (b.count - start) / kCount;
    const int vectors = left < kVectors ? left : kVectors;
    auto o = octaves_at(At::of(b, start, given), given);
    for (int v = 0; v < vectors; ++v) reached.keep(v, octaves_at(At::of(b, start + v * kCount, given), given));
    auto across = o;
    double step = b.step, scale = 1.0;
    for (int number = 1;; ++number) {
      const bool more = number < options.octaves;
      const auto period = o.place.period;
      const auto add = [&](int v, Float n) HN_I_INLINED {
        sum.add(o, n);
        if (o.place.tiled) o.place.period = period;  // of which going on makes the next one
        if (more) reached.go_on(o);
        reached.keep(v, o);
      };
      bool is_added = false;
      if constexpr (!std::is_void_v<Columns>) {
        const bool is_turned = !kIsTiled && number > 1;
        if (!is_turned && step <= Columns::kMostStep && !(kIsTiled && reached.is_at_seam())) {
          reached.template by_columns<Columns>(vectors, o, across, add);
          is_added = true;
        }
      }
      if constexpr (!std::is_void_v<Pieces>) {
        if (!is_added && step <= Pieces::kMostStep) {
          reached.template by_runs<Pieces>(vectors, o, add);
          is_added = true;
        }
      }
      scale *= static_cast<double>(options.lacunarity < 0.0f ? -options.lacunarity : options.lacunarity);
      step = (b.step + b.rounding) * scale;
      for (int v = 0; v < vectors && !is_added; ++v) {
        reached.put(v, o, across);
        if (o.place.tiled) o.place.period = period;
        add(v, noise.octave(o.place, o.seed));
      }
      if (!more) break;
      if constexpr (kIsRow) hn_i_advance(across);
      o.seed += HN_I_SEED_STEP;
      o.sum.weight = hn_i_weight_times(o.sum.weight, o.sum.gain);
    }
    for (int v = 0; v < vectors; ++v) {
      store(b, start + v * kCount, hn_i_value(sum.end(mean_of(reached.value(v), total))));
    }
  }
}

// A kernel of rows by itself, so that narrow parts of a grid take it, too, and have the bits of the whole.
template <Kernel kernel>
void in_row(const Batch& batch, const Options& options, Octave octave) {
  kernel(batch, options, octave);
}
template <Kernel kernel, typename Columns>
constexpr grid::Loops loops_of() {
  return {kernel, std::is_void_v<Columns> ? kernel : in_row<kernel>};
}

using grid::both;
using grid::SumKernels;

#if HN_ARITHMETIC == HN_FIXED
template <int D>
using FromPositions = Either<D>;
template <int D>
using FromCells = Either<D>;
#else
template <int D>
using FromPositions = Positions<D>;
template <int D>
using FromCells = Cells<D>;
#endif

template <int D, typename Sum>
SumKernels without_period() {
  SumKernels k{};
  k.at = both(at_points<D, FromPositions<D>, Sum>);
  k.in = both(at_points<D, FromCells<D>, Sum>);
  return k;
}
template <int D, typename Noise, typename Sum, typename Columns, typename Pieces>
SumKernels octave_by_octave() {
  SumKernels k{};
  k.at = loops_of<by_octaves<D, FromPositions<D>, Noise, Sum, false, Columns, Pieces>, Columns>();
  k.in = loops_of<by_octaves<D, FromCells<D>, Noise, Sum, false, Columns, Pieces>, Columns>();
  return k;
}
template <int D, typename Sum>
SumKernels kernels_of() {
  SumKernels k = without_period<D, Sum>();
  k.tile = both(at_points<D, Tiles<D>, Sum>);
  return k;
}

template <int D>
void enter_sums(SumKernels (&sums)[grid::kSums][4]) {
  const SumKernels any = kernels_of<D, SumOf<D>>();
  // Those with frames, and those of noises of their own, have other kernels, and are entered after these.
#define HN_CATALOG_STEP(Id, ...) sums[grid::k##Id][D - 1] = any;
#include "catalog.inc"
  sums[grid::kDetail][D - 1] = any;
  sums[grid::kFootprint][D - 1] = any;
}

// The sums that are asked for most, over the noises that are.
template <int D, typename Noise, typename Columns = void, typename Pieces = void>
void enter_inlined(SumKernels (&sums)[grid::kSums][4]) {
  sums[grid::kFbm][D - 1] = octave_by_octave<D, Noise, Fbm, Columns, Pieces>();
  sums[grid::kRidged][D - 1] = octave_by_octave<D, Noise, Ridged, Columns, Pieces>();
  if constexpr (!std::is_void_v<Columns>) {
    sums[grid::kFbm][D - 1].tile = {by_octaves<D, Tiles<D>, Noise, Fbm, false>,
                                    by_octaves<D, Tiles<D>, Noise, Fbm, true, Columns>};
  }
}

void enter(grid::Kernels& kernels) {
  enter_sums<1>(kernels.sums);
  enter_sums<2>(kernels.sums);
  enter_sums<3>(kernels.sums);
  enter_sums<4>(kernels.sums);
  kernels.sums[grid::kFbmD][1] = kernels_of<2, FbmD<2>>();
  kernels.sums[grid::kFbmD][2] = kernels_of<3, FbmD<3>>();
  kernels.sums[grid::kEroded][1] = kernels_of<2, Eroded<2>>();
  kernels.sums[grid::kEroded][2] = kernels_of<3, Eroded<3>>();
  kernels.sums[grid::kWarp][1] = kernels_of<2, Warp<2, false>>();
  kernels.sums[grid::kWarp][2] = kernels_of<3, Warp<3, false>>();
  kernels.sums[grid::kWarpProgressive][1] = kernels_of<2, Warp<2, true>>();
  kernels.sums[grid::kWarpProgressive][2] = kernels_of<3, Warp<3, true>>();
  kernels.sums[grid::kPerlinWorley][2] = kernels_of<3, PerlinWorley>();
#ifdef HN_GRID_HAS_WINDOWS
  enter_inlined<2, Value<2>, ValueColumns<2>, ValuePieces<2>>(kernels.sums_of[grid::kValue]);
  enter_inlined<3, Value<3>, ValueColumns<3>, ValuePieces<3>>(kernels.sums_of[grid::kValue]);
  enter_inlined<2, Perlin<2>, PerlinColumns<2>, PerlinPieces<2>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<3, Perlin<3>, PerlinColumns<3>, PerlinPieces<3>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<2, Simplex<2>, SimplexColumns<2>, SimplexPieces>(kernels.sums_of[grid::kSimplex]);
  enter_inlined<3, Simplex<3>, SimplexColumns<3>>(kernels.sums_of[grid::kSimplex]);
#else
  enter_inlined<2, Value<2>>(kernels.sums_of[grid::kValue]);
  enter_inlined<3, Value<3>>(kernels.sums_of[grid::kValue]);
  enter_inlined<2, Perlin<2>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<3, Perlin<3>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<2, Simplex<2>>(kernels.sums_of[grid::kSimplex]);
  enter_inlined<3, Simplex<3>>(kernels.sums_of[grid::kSimplex]);
#endif
}

}  // namespace
}  // namespace HN_LANES

void grid::HASHNOISE_PASTE(sums_, HASHNOISE_TABLE)(Kernels& kernels) { lanes::enter(kernels); }

}  // namespace hashnoise
