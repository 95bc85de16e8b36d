// The kernels of sums, for one instruction set and one arithmetic: the macros of the library over a noise that is
// called, since there are too many pairs of a sum and a noise to compile. Those that are asked for most are compiled
// without that call.
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

 protected:
  HN_I_INLINE Result octave(Cell<D> cell, Place<D> f, Uint seed) const {
    return call(cell, f, seed, std::make_index_sequence<D>());
  }
  HN_I_INLINE Result octave(Cell<D> cell, Place<D> f, Cell<D> period, Uint seed) const {
    return call(cell, f, period, seed, std::make_index_sequence<D>());
  }

 private:
  template <std::size_t... Axis>
  HN_I_INLINE Result call(Cell<D> cell, Place<D> f, Uint seed, std::index_sequence<Axis...>) const {
    return reinterpret_cast<typename OctaveOf<D, Result>::Plain>(octave_)(along<Axis>(cell)..., along<Axis>(f)...,
                                                                          seed);
  }
  template <std::size_t... Axis>
  HN_I_INLINE Result call(Cell<D> cell, Place<D> f, const Cell<D>& period, Uint seed,
                          std::index_sequence<Axis...>) const {
    return reinterpret_cast<typename OctaveOf<D, Result>::Tiled>(octave_)(along<Axis>(cell)..., along<Axis>(f)...,
                                                                          period, seed);
  }

  Octave octave_;
};

// A noise that is inlined.
#define HN_GRID_INLINED(Name, name)                                                                          \
  template <int D>                                                                                           \
  class Name {                                                                                               \
   public:                                                                                                   \
    explicit Name(Octave) {}                                                                                 \
                                                                                                             \
   protected:                                                                                                \
    HN_I_INLINE Float octave(Cell<D> cell, Place<D> f, Uint seed) const { return hn_##name(cell, f, seed); } \
  };
HN_GRID_INLINED(Value, value)
HN_GRID_INLINED(Perlin, perlin)
HN_GRID_INLINED(Simplex, simplex)

// The sums of a dimension, as members, so that they reach the noise.
#define HN_GRID_SUMS(N)                                                                                                \
  template <typename Noise>                                                                                            \
  class Sums##N : public Noise {                                                                                       \
   public:                                                                                                             \
    using Noise::Noise;                                                                                                \
    using Noise::octave;                                                                                               \
    HN_FBM##N##D(fbm, octave) HN_FBM_PERIOD##N##D(fbm, octave) HN_FBM_LIMITED##N##D(limited, octave) HN_TURBULENCE##N  \
        ##D(turbulence, octave) HN_TURBULENCE_PERIOD##N##D(turbulence, octave) HN_CLOUDS##N                            \
        ##D(clouds, octave) HN_CLOUDS_PERIOD##N##D(clouds, octave) HN_BILLOW##N##D(billow, octave) HN_BILLOW_PERIOD##N \
        ##D(billow, octave) HN_RIDGED##N##D(ridged, octave) HN_RIDGED_PERIOD##N##D(ridged, octave) HN_PING_PONG##N     \
        ##D(ping_pong, octave) HN_PING_PONG_PERIOD##N##D(ping_pong, octave) HN_WEIGHTED##N                             \
        ##D(weighted, octave) HN_WEIGHTED_PERIOD##N##D(weighted, octave)                                               \
  };
HN_GRID_SUMS(1)
HN_GRID_SUMS(2)
HN_GRID_SUMS(3)
HN_GRID_SUMS(4)

#define HN_GRID_WARPS(N)                                                                         \
  template <typename Noise>                                                                      \
  class Warps##N : public Noise {                                                                \
   public:                                                                                       \
    using Noise::Noise;                                                                          \
    using Noise::octave;                                                                         \
    HN_WARP##N##D(warp, octave) HN_WARP_PERIOD##N##D(warp, octave) HN_WARP_PROGRESSIVE##N        \
        ##D(warp_progressive, octave) HN_WARP_PROGRESSIVE_PERIOD##N##D(warp_progressive, octave) \
  };
HN_GRID_WARPS(2)
HN_GRID_WARPS(3)

#define HN_GRID_SLOPES(N)                                                           \
  template <typename Noise>                                                         \
  class Slopes##N : public Noise {                                                  \
   public:                                                                          \
    using Noise::Noise;                                                             \
    using Noise::octave;                                                            \
    HN_FBM_D##N##D(fbm_d, octave) HN_FBM_D_PERIOD##N##D(fbm_d, octave) HN_ERODED##N \
        ##D(eroded, octave) HN_ERODED_PERIOD##N##D(eroded, octave)                  \
  };
HN_GRID_SLOPES(2)
HN_GRID_SLOPES(3)

// How a sum is called behind the place: with a strength or an amplitude, or without.
#define HN_GRID_CALL(name, ...)                                                          \
  struct name##_call {                                                                   \
    template <typename Sums, int D, typename... At>                                      \
    HN_I_INLINE static auto of(Sums& sums, const Given<D>& given, At... at) {            \
      return sums.name(at..., given.octaves, given.lacunarity, given.gain, __VA_ARGS__); \
    }                                                                                    \
  };
HN_GRID_CALL(fbm, given.seed)
HN_GRID_CALL(turbulence, given.seed)
HN_GRID_CALL(clouds, given.seed)
HN_GRID_CALL(billow, given.seed)
HN_GRID_CALL(ridged, given.seed)
HN_GRID_CALL(ping_pong, given.strength, given.seed)
HN_GRID_CALL(weighted, given.strength, given.seed)
HN_GRID_CALL(fbm_d, given.seed)
HN_GRID_CALL(eroded, given.strength, given.seed)
HN_GRID_CALL(warp, given.strength, given.seed)
HN_GRID_CALL(warp_progressive, given.strength, given.seed)
struct detail_call {
  template <typename Sums, int D, typename At>
  HN_I_INLINE static auto of(Sums& sums, const Given<D>& given, At at) {
    return sums.limited(at, given.limit, given.lacunarity, given.gain, given.seed);
  }
};
struct footprint_call {
  template <typename Sums, int D, typename At>
  HN_I_INLINE static auto of(Sums& sums, const Given<D>& given, At at) {
    return sums.limited(at, given.limit, given.octaves, given.lacunarity, given.gain, given.seed);
  }
};

template <int D, typename Sums, typename Call>
void at_positions(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Given<D> given(options);
  Sums sums(octave);
  for (int i = 0; i < b.count; i += kCount) store(b, i, Call::of(sums, given, places_at<D>(b, i)));
}
template <int D, typename Sums, typename Call>
void in_cells(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Given<D> given(options);
  Sums sums(octave);
  for (int i = 0; i < b.count; i += kCount) store(b, i, Call::of(sums, given, cells_at<D>(b, i), places_at<D>(b, i)));
}
template <int D, typename Sums, typename Call>
void tile_at_positions(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Given<D> given(options);
  Sums sums(octave);
  for (int i = 0; i < b.count; i += kCount) store(b, i, Call::of(sums, given, places_at<D>(b, i), given.period));
}
template <int D, typename Sums, typename Call>
void tile_in_cells(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Given<D> given(options);
  Sums sums(octave);
  for (int i = 0; i < b.count; i += kCount) {
    store(b, i, Call::of(sums, given, cells_at<D>(b, i), places_at<D>(b, i), given.period));
  }
}

using grid::SumKernels;

template <int D, typename Sums, typename Call>
SumKernels kernels_of() {
  SumKernels k{};
  k.at = at_positions<D, Sums, Call>;
  k.in = in_cells<D, Sums, Call>;
  k.tile_at = tile_at_positions<D, Sums, Call>;
  k.tile_in = tile_in_cells<D, Sums, Call>;
  return k;
}

template <int D, typename Sums>
void enter_sums(SumKernels (&sums)[grid::kSums][4]) {
  const auto at = [&](grid::SumId id) -> SumKernels& { return sums[id][D - 1]; };
  at(grid::kFbm) = kernels_of<D, Sums, fbm_call>();
  at(grid::kFbm).detail = at_positions<D, Sums, detail_call>;
  at(grid::kFbm).footprint = at_positions<D, Sums, footprint_call>;
  at(grid::kTurbulence) = kernels_of<D, Sums, turbulence_call>();
  at(grid::kClouds) = kernels_of<D, Sums, clouds_call>();
  at(grid::kBillow) = kernels_of<D, Sums, billow_call>();
  at(grid::kRidged) = kernels_of<D, Sums, ridged_call>();
  at(grid::kPingPong) = kernels_of<D, Sums, ping_pong_call>();
  at(grid::kWeighted) = kernels_of<D, Sums, weighted_call>();
}

template <int D, typename Warps, typename Slopes>
void enter_framed(SumKernels (&sums)[grid::kSums][4]) {
  const auto at = [&](grid::SumId id) -> SumKernels& { return sums[id][D - 1]; };
  at(grid::kWarp) = kernels_of<D, Warps, warp_call>();
  at(grid::kWarpProgressive) = kernels_of<D, Warps, warp_progressive_call>();
  at(grid::kFbmD) = kernels_of<D, Slopes, fbm_d_call>();
  at(grid::kEroded) = kernels_of<D, Slopes, eroded_call>();
}

// The sums that are asked for most, over the noises that are.
template <int D, typename Sums>
void enter_inlined(SumKernels (&sums)[grid::kSums][4]) {
  sums[grid::kFbm][D - 1].at = at_positions<D, Sums, fbm_call>;
  sums[grid::kFbm][D - 1].in = in_cells<D, Sums, fbm_call>;
  sums[grid::kRidged][D - 1].at = at_positions<D, Sums, ridged_call>;
  sums[grid::kRidged][D - 1].in = in_cells<D, Sums, ridged_call>;
}

void enter(grid::Kernels& kernels) {
  enter_sums<1, Sums1<Called<1, Float>>>(kernels.sums);
  enter_sums<2, Sums2<Called<2, Float>>>(kernels.sums);
  enter_sums<3, Sums3<Called<3, Float>>>(kernels.sums);
  enter_sums<4, Sums4<Called<4, Float>>>(kernels.sums);
  enter_framed<2, Warps2<Called<2, Float>>, Slopes2<Called<2, vec3>>>(kernels.sums);
  enter_framed<3, Warps3<Called<3, Float>>, Slopes3<Called<3, vec4>>>(kernels.sums);
  enter_inlined<2, Sums2<Value<2>>>(kernels.sums_of[grid::kValue]);
  enter_inlined<3, Sums3<Value<3>>>(kernels.sums_of[grid::kValue]);
  enter_inlined<2, Sums2<Perlin<2>>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<3, Sums3<Perlin<3>>>(kernels.sums_of[grid::kPerlin]);
  enter_inlined<2, Sums2<Simplex<2>>>(kernels.sums_of[grid::kSimplex]);
  enter_inlined<3, Sums3<Simplex<3>>>(kernels.sums_of[grid::kSimplex]);
}

}  // namespace
}  // namespace HN_LANES

void grid::HASHNOISE_PASTE(sums_, HASHNOISE_TABLE)(Kernels& kernels) { lanes::enter(kernels); }

}  // namespace hashnoise
