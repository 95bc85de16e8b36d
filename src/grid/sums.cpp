// The kernels of sums, for one instruction set and one arithmetic: the steps and the macros of the library over a noise
// that is called, since there are too many pairs of a sum and a noise to compile. Those that are asked for most are
// compiled without that call.
#include "loops.hpp"
#include "tables.hpp"

namespace hashnoise {
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

// What the strength is at most: kMostPingPong and so on.
#define HN_CATALOG_SUM(Id, name, first, last, shape, of, noise, strength, usual, most, ...) \
  [[maybe_unused]] constexpr float kMost##Id = most;
#include "catalog.inc"

// What a sum is: how it adds an octave, and what it makes of the mean. The first of these is any of them: beside the
// call of a noise it costs nothing to ask which it is, and all of them would take ten times as long to compile.
struct AnySum {
  std::int32_t id;

  HN_I_INLINE explicit AnySum(const Options& options) : id(options.sum) {}
  HN_I_INLINE hn_num setting(const Options& o, hn_num part) const {
    switch (id) {
      case grid::kPingPong:
        return hn_i_setting(Float(o.strength), kMostPingPong);
      case grid::kWeighted:
        return hn_i_setting(Float(o.strength), kMostWeighted);
      case grid::kDetail:
        return part;
      case grid::kFootprint:
        return hn_i_footprint(Float(o.limit));
      default:
        return hn_num(HN_I_WEIGHT_ONE);
    }
  }
  HN_I_INLINE void add(hn_i_octave_sum& s, Float n) const {
    switch (id) {
      case grid::kTurbulence:
        return hn_i_add_size(s, n);
      case grid::kBillow:
        return hn_i_add_bounded_size(s, n);
      case grid::kRidged:
        return hn_i_add_ridge(s, n);
      case grid::kPingPong:
        return hn_i_add_wave(s, n);
      case grid::kWeighted:
        return hn_i_add_bent(s, n);
      case grid::kDetail:
        return hn_i_add_part(s, n);
      case grid::kFootprint:
        return hn_i_add_resolved(s, n);
      default:
        return hn_i_add(s, n);
    }
  }
  HN_I_INLINE hn_num end(hn_num mean) const {
    switch (id) {
      case grid::kClouds:
        return hn_i_density(mean);
      case grid::kBillow:
        return hn_i_billows(mean);
      case grid::kRidged:
      case grid::kPingPong:
      case grid::kWeighted:
        return hn_i_bounded(mean);
      default:
        return hn_i_unchanged(mean);
    }
  }
};
#define HN_GRID_SUM(Name, add_one, end_with)                                                     \
  struct Name {                                                                                  \
    HN_I_INLINE explicit Name(const Options&) {}                                                 \
    HN_I_INLINE hn_num setting(const Options&, hn_num) const { return hn_num(HN_I_WEIGHT_ONE); } \
    HN_I_INLINE void add(hn_i_octave_sum& s, Float n) const { add_one(s, n); }                   \
    HN_I_INLINE hn_num end(hn_num mean) const { return end_with(mean); }                         \
  };
HN_GRID_SUM(Fbm, hn_i_add, hn_i_unchanged)
HN_GRID_SUM(Ridged, hn_i_add_ridge, hn_i_bounded)

// A sum over a noise, in any dimension: what the macros of octaves.glsl define, from the same steps. What does not
// depend on the point is computed once.
template <int D, typename Noise, typename Sum>
class SumOf {
 public:
  static constexpr bool kClampsInPlaces = false;

  HN_I_INLINE SumOf(Octave noise, const Options& options, const Given<D>& given)
      : noise_(noise), sum_(options), given_(given) {
    hn_num part = HN_I_WEIGHT_ONE;
    if (options.sum == grid::kDetail) {
      given_.octaves = hn_i_whole_octaves(given.limit);
      part = hn_i_last_part(given.limit, given_.octaves);
    }
    option_ = sum_.setting(options, part);
    total_ = hn_i_total(hn_i_octaves(given_.octaves), hn_i_gain(given.gain), part);
  }

  template <typename Position>
  HN_I_INLINE Float at(Position q) const {
    hn_i_octave_sum s = hn_i_begin(given_.octaves, given_.lacunarity, given_.gain, option_, given_.seed);
    HN_I_OCTAVES(noise_.octave, sum_.add)
    return hn_i_value(sum_.end(hn_i_mean(s.sum, total_)));
  }

 private:
  Noise noise_;
  Sum sum_;
  Given<D> given_;
  hn_num option_, total_;
};

// Whether the octaves are those of a tile, which do not turn.
template <typename Position>
HN_I_INLINE bool is_tile(const Position& q) {
  if constexpr (requires { q.tiled; }) {
    return q.tiled;
  } else {
    return false;
  }
}

// Sums with frames. HN_I_OF_ERODED2 and so on are lists of what the macros of frame.glsl take.
#define HN_GRID_FRAMED(options, option, begin, each, onward, finish) \
  HN_I_BEGIN(option) HN_I_FRAMED(noise_.octave, is_tile(q), begin, each, onward, finish)
#define HN_GRID_APPLIED(macro, ...) macro(__VA_ARGS__)
// What these name.
#define HN_GRID_NAMES                                                                   \
  const Int octaves = given_.octaves;                                                   \
  const Float lacunarity = given_.lacunarity, gain = given_.gain;                       \
  [[maybe_unused]] const Float strength = given_.strength, amplitude = given_.strength; \
  const Uint seed = given_.seed;
#define HN_GRID_FRAMED_SUM(Name, D, Value, ...)                                                             \
  template <typename Noise>                                                                                 \
  class Name {                                                                                              \
   public:                                                                                                  \
    static constexpr bool kClampsInPlaces = true;                                                           \
                                                                                                            \
    HN_I_INLINE Name(Octave noise, const Options&, const Given<D>& given) : noise_(noise), given_(given) {} \
    template <typename Position>                                                                            \
    HN_I_INLINE Value at(Position q) const {                                                                \
      HN_GRID_NAMES                                                                                         \
      HN_GRID_APPLIED(HN_GRID_FRAMED, __VA_ARGS__)                                                          \
    }                                                                                                       \
                                                                                                            \
   private:                                                                                                 \
    Noise noise_;                                                                                           \
    Given<D> given_;                                                                                        \
  };
HN_GRID_FRAMED_SUM(FbmD2, 2, vec3, HN_I_OF_FBM_D2)
HN_GRID_FRAMED_SUM(FbmD3, 3, vec4, HN_I_OF_FBM_D3)
HN_GRID_FRAMED_SUM(Eroded2, 2, Float, HN_I_OF_ERODED2)
HN_GRID_FRAMED_SUM(Eroded3, 3, Float, HN_I_OF_ERODED3)
HN_GRID_FRAMED_SUM(Warp2, 2, vec2, HN_I_OF_WARP2)
HN_GRID_FRAMED_SUM(Warp3, 3, vec3, HN_I_OF_WARP3)
HN_GRID_FRAMED_SUM(WarpProgressive2, 2, vec2, HN_I_OF_PROGRESSIVE2)
HN_GRID_FRAMED_SUM(WarpProgressive3, 3, vec3, HN_I_OF_PROGRESSIVE3)

// The positions of a batch: as they are, or from cells, or in a tile.
template <int D>
struct Positions {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>&) { return hn_i_position(fractions_at<D>(b, i)); }
};
template <int D>
struct Cells {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>&) { return hn_i_position(places_at<D>(b, i)); }
};
// In HN_FIXED both are of one type, and in a tile with all arithmetics: then one kernel takes both.
template <int D>
HN_I_INLINE Place<D> place_at(const Batch& b, int i) {
  return b.cell[0] != nullptr ? places_at<D>(b, i) : hn_place(fractions_at<D>(b, i));
}
template <int D>
struct Either {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>&) { return hn_i_position(place_at<D>(b, i)); }
};
template <int D>
struct Tiles {
  HN_I_INLINE static auto of(const Batch& b, int i, const Given<D>& given) {
    return hn_i_position(hn_tile(place_at<D>(b, i), given.period));
  }
};

// A sum with frames takes a lacunarity that is clamped where it starts from places (HN_I_BEGIN_FRAMED_IN).
template <int D, typename At, typename Sum>
void at_points(const Batch& batch, const Options& options, Octave octave) {
  constexpr bool kIsTiled = std::is_same_v<At, Tiles<D>>;
  const Batch b = batch;
  Given<D> given(options);
  const bool is_clamped = Sum::kClampsInPlaces && (kIsTiled || b.cell[0] != nullptr);
  if (is_clamped) given.lacunarity = min(max(given.lacunarity, 0.0f), 255.0f);
  given.lacunarity = hn_i_lacunarity(given.lacunarity, kIsTiled);
  const Sum sum(octave, options, given);
  for (int i = 0; i < b.count; i += kCount) store(b, i, sum.at(At::of(b, i, given)));
}

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
  k.at = at_points<D, FromPositions<D>, Sum>;
  k.in = at_points<D, FromCells<D>, Sum>;
  return k;
}
template <int D, typename Sum>
SumKernels kernels_of() {
  SumKernels k = without_period<D, Sum>();
  k.tile = at_points<D, Tiles<D>, Sum>;
  return k;
}

template <int D>
void enter_sums(SumKernels (&sums)[grid::kSums][4]) {
  const SumKernels any = kernels_of<D, SumOf<D, Called<D, Float>, AnySum>>();
  // Those with frames have kernels of their own, and are entered after these.
#define HN_CATALOG_SUM(Id, name, first, last, shape, of, ...)                                \
  if (grid::Shape::shape == grid::Shape::kValue && grid::Shape::of == grid::Shape::kValue) { \
    sums[grid::k##Id][D - 1] = any;                                                          \
  }
#include "catalog.inc"
  sums[grid::kDetail][D - 1] = any;
  sums[grid::kFootprint][D - 1] = any;
}

// The sums that are asked for most, over the noises that are.
template <int D, typename Noise>
void enter_inlined(SumKernels (&sums)[grid::kSums][4]) {
  sums[grid::kFbm][D - 1] = without_period<D, SumOf<D, Noise, Fbm>>();
  sums[grid::kRidged][D - 1] = without_period<D, SumOf<D, Noise, Ridged>>();
}

void enter(grid::Kernels& kernels) {
  enter_sums<1>(kernels.sums);
  enter_sums<2>(kernels.sums);
  enter_sums<3>(kernels.sums);
  enter_sums<4>(kernels.sums);
  kernels.sums[grid::kFbmD][1] = kernels_of<2, FbmD2<Called<2, vec3>>>();
  kernels.sums[grid::kFbmD][2] = kernels_of<3, FbmD3<Called<3, vec4>>>();
  kernels.sums[grid::kEroded][1] = kernels_of<2, Eroded2<Called<2, vec3>>>();
  kernels.sums[grid::kEroded][2] = kernels_of<3, Eroded3<Called<3, vec4>>>();
  kernels.sums[grid::kWarp][1] = kernels_of<2, Warp2<Called<2, Float>>>();
  kernels.sums[grid::kWarp][2] = kernels_of<3, Warp3<Called<3, Float>>>();
  kernels.sums[grid::kWarpProgressive][1] = kernels_of<2, WarpProgressive2<Called<2, Float>>>();
  kernels.sums[grid::kWarpProgressive][2] = kernels_of<3, WarpProgressive3<Called<3, Float>>>();
  enter_inlined<2, Value<2>>(kernels.sums_of[grid::kValue]);
  enter_inlined<3, Value<3>>(kernels.sums_of[grid::kValue]);
  enter_inlined<2, Perlin<2>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<3, Perlin<3>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<2, Simplex<2>>(kernels.sums_of[grid::kSimplex]);
  enter_inlined<3, Simplex<3>>(kernels.sums_of[grid::kSimplex]);
}

}  // namespace
}  // namespace HN_LANES

void grid::HASHNOISE_PASTE(sums_, HASHNOISE_TABLE)(Kernels& kernels) { lanes::enter(kernels); }

}  // namespace hashnoise
