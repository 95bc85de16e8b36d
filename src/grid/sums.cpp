// The kernels of sums, for one instruction set and one arithmetic: the octaves of the library over a noise that is
// called, since there are too many pairs of a sum and a noise to compile. Most sums call the kernels of the noise,
// octave by octave.
#include "loops.hpp"
#include "tables.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// A noise that is called.
template <int D, typename Result>
class NoiseCall {
 public:
  explicit NoiseCall(Octave noise) : octave_(noise) {}

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

// Calls a function with what adds an octave to a sum, with whether that changes the weight of the next one, and with
// whether it carries anything else to it.
template <typename Function>
HN_I_INLINE void with_step(int id, const Function& function) {
  switch (id) {
#define HN_CATALOG_STEP(Id, name, step, end)                                               \
  case grid::k##Id:                                                                        \
    return function([](const hn_i_octave_sum& s, Float n, [[maybe_unused]] Float strength) \
                        HN_I_INLINED { return step; },                                     \
                    std::bool_constant<grid::k##Id == grid::kWeighted>(),                  \
                    std::bool_constant<(grid::k##Id == grid::kRidged || grid::k##Id == grid::kHybrid)>());
#include "catalog.inc"
  }
}

// The result of a sum, from the mean.
HN_I_INLINE hn_i_num end_of(int id, hn_i_num mean) {
  switch (id) {
#define HN_CATALOG_STEP(Id, name, step, end) \
  case grid::k##Id:                          \
    return end;
#include "catalog.inc"
    default:
      return mean;
  }
}

// The octaves at a position, or at a place.
template <int D, typename Position>
HN_I_INLINE auto octaves_at(const Position& p, const Arguments<D>& given) {
  return hn_octaves(p, given.octaves, given.lacunarity, given.gain, given.seed);
}

// hn_i_mean, of at least one octave. With HN_FIXED it has the same integers by one division of doubles in place of
// three divisions of words, for which there are no instructions. sum * 2^18 is exact, since it has 45 bits. A quotient
// that is no integer is at least 1 / total from the next one: far more than the division rounds.
HN_I_INLINE hn_i_num mean_of(hn_i_num sum, hn_i_num total) {
#if HN_ARITHMETIC == HN_FIXED && !defined(HN_LANES_PORTABLE)
  using detail::DoubleVector;
  const DoubleVector dividend = __builtin_convertvector(sum.v, DoubleVector) * 262144.0;
  const DoubleVector quotient = dividend / __builtin_convertvector(total.v, DoubleVector);
  return Int(__builtin_convertvector(quotient, detail::IntVector));
#elif HN_ARITHMETIC == HN_FAST
  return sum * (1.0f / total);  // one division for all points
#else
  return hn_i_mean(sum, total);
#endif
}

// fbm with a detail or a footprint, over a noise that is called.
template <int D, bool kHasDetail>
class ResolvedFbm {
 public:
  HN_I_INLINE ResolvedFbm(Octave noise, const Options&, const Arguments<D>& given) : noise_(noise), given_(given) {
    if constexpr (kHasDetail) {
      given_.octaves = hn_i_whole_octaves(given.limit);
      part_ = hn_i_last_part(given.limit, given_.octaves);
    }
    footprint_ = hn_i_footprint(given.limit);
    total_ = hn_i_total(min(given_.octaves, Int(32)), hn_i_gain(given.gain), part_);
  }

  template <typename Position>
  HN_I_INLINE Float at(Position p) const {
    auto o = octaves_at(p, given_);
    o.sum.part = part_;
    o.sum.footprint = footprint_;
    do {
      const Float n = noise_.octave(o.place, o.seed);
      if constexpr (kHasDetail) {
        hn_add_detail(o, n);
      } else {
        hn_add_footprint(o, n);
      }
    } while (hn_next(o));
    return hn_i_value(hn_i_select(o.sum.octaves < 1, HN_I_NO_WEIGHT, mean_of(o.sum.value, total_)));
  }

 private:
  NoiseCall<D, Float> noise_;
  Arguments<D> given_;
  hn_i_num part_ = HN_I_WEIGHT_ONE;
  hn_i_num footprint_, total_;
};

// Sums with Jacobians, over a noise that is called.
template <int D, typename Result>
class JacobianSum {
 public:
  HN_I_INLINE JacobianSum(Octave noise, const Options&, const Arguments<D>& given) : noise_(noise), given_(given) {}

 protected:
  NoiseCall<D, Result> noise_;
  Arguments<D> given_;
};
template <int D>
using Vector = std::conditional_t<D == 2, vec2, vec3>;
template <int D>
using Slopes = JacobianSum<D, std::conditional_t<D == 2, vec3, vec4>>;

template <int D>
class FbmD : public Slopes<D> {
 public:
  using Slopes<D>::Slopes;
  template <typename Position>
  HN_I_INLINE auto at(Position p) const {
    auto o = octaves_at(p, this->given_);
    auto s = hn_slopes(o);
    do hn_add(o, s, this->noise_.octave(o.place, o.seed));
    while (hn_next(o));
    return hn_mean(o, s);
  }
};

template <int D>
class Erosion : public Slopes<D> {
 public:
  using Slopes<D>::Slopes;
  template <typename Position>
  HN_I_INLINE auto at(Position p) const {
    auto o = octaves_at(p, this->given_);
    auto s = hn_slopes(o);
    do hn_add_eroded(o, s, this->noise_.octave(o.place, o.seed), this->given_.strength);
    while (hn_next(o));
    return hn_mean(o);
  }
};

template <int D, bool kProgressive>
class Warp : public JacobianSum<D, Vector<D>> {
 public:
  using JacobianSum<D, Vector<D>>::JacobianSum;
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
class PerlinWorley : public JacobianSum<3, Float> {
 public:
  using JacobianSum<3, Float>::JacobianSum;
  template <typename Position>
  HN_I_INLINE Float at(Position p) const {
    auto wisps = octaves_at(p, given_);
    do hn_add(wisps, noise_.octave(wisps.place, wisps.seed));
    while (hn_next(wisps));
    const Arguments<3>& given = given_;
    auto billows = hn_octaves(p, min(given.octaves, Int(3)), given.lacunarity, given.gain, hn_i_other_seed(given.seed));
    do hn_add(billows, hn_i_billow_at(nearest_point(billows.place, billows.seed)));
    while (hn_next(billows));
    return hn_i_value(hn_i_either(hn_i_bounded_octave(hn_mean(wisps)), hn_i_bounded_octave(hn_mean(billows))));
  }
};

// The positions of a batch: as they are, or from cells, or in a tile.
template <int D>
struct Positions {
  HN_I_INLINE static auto of(const Batch& b, int i, const Arguments<D>&) { return fractions_at<D>(b, i); }
};
template <int D>
struct Cells {
  HN_I_INLINE static auto of(const Batch& b, int i, const Arguments<D>&) { return place_in_cell<D>(b, i); }
};
// In HN_FIXED both are of one type, and in a tile with all arithmetics: then one kernel takes both.
template <int D>
struct AnyPlace {
  HN_I_INLINE static auto of(const Batch& b, int i, const Arguments<D>&) { return place_at<D>(b, i); }
};
template <int D>
struct Tiles {
  HN_I_INLINE static auto of(const Batch& b, int i, const Arguments<D>& given) {
    return hn_tile(place_at<D>(b, i), given.period);
  }
};

template <int D, typename At, typename Sum>
void at_points(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  const Sum sum(octave, options, given);
  for (int i = 0; i < b.count; i += kCount) store(b, i, sum.at(At::of(b, i, given)));
}

// Where some points are, for octaves that are fixed-point positions, and for those that are not. The arrays are of
// numbers, since those of vectors would be filled with zeros first.
template <int D, bool kIsWhole>
struct BlockPositions {
  // The fraction of a fixed-point position, or the position.
  std::conditional_t<kIsWhole, std::int32_t, float> rest[D][kPointsAtOnce];
  // For kernels that take these. Only the first of the octaves at positions is passed so.
  std::int32_t cell[D][kPointsAtOnce];
  float place[D][kPointsAtOnce];

  template <int axis, typename Octaves>
  HN_I_INLINE void keep(int i, Octaves& o, bool has_cells) {
    if constexpr (kIsWhole) {
      component<axis>(o).y.store(rest[axis] + i);
    } else {
      along<axis>(o.p).store(rest[axis] + i);
    }
    if (!has_cells) return;
    along<axis>(o.place.cell).store(cell[axis] + i);
#if HN_ARITHMETIC == HN_FIXED
    (Float(along<axis>(o.place.fraction)) * (1.0f / HN_I_ONE)).store(place[axis] + i);
#else
    along<axis>(o.place.fraction).store(place[axis] + i);
#endif
  }
  template <int axis, typename Octaves>
  HN_I_INLINE void put(int i, Octaves& o) const {
    if constexpr (kIsWhole) {
      component<axis>(o) = ivec2(Int::load(cell[axis] + i), Int::load(rest[axis] + i));
    } else if constexpr (D == 1) {
      o.p = Float::load(rest[axis] + i);
    } else {
      component<axis>(o.p) = Float::load(rest[axis] + i);
    }
  }
  // Has a batch take these.
  HN_I_INLINE void point(Batch& batch, bool has_cells) const {
    for (int axis = 0; axis < D; ++axis) {
      batch.cell[axis] = has_cells ? cell[axis] : nullptr;
      batch.place[axis] = place[axis];
      if constexpr (!kIsWhole) {
        if (!has_cells) batch.place[axis] = rest[axis];
      }
    }
  }

 private:
  // The component of a position, or the fixed-point position of octaves along an axis.
  template <int axis, typename Point>
  HN_I_INLINE static auto& component(Point& point) {
    if constexpr (axis == 0) {
      return point.x;
    } else if constexpr (axis == 1) {
      return point.y;
    } else if constexpr (axis == 2) {
      return point.z;
    } else {
      return point.w;
    }
  }
};

// Calls a function with the number of each axis from the first one on.
template <int first, int end, typename Function>
HN_I_INLINE void each_axis(const Function& function) {
  if constexpr (first < end) {
    function(std::integral_constant<int, first>());
    each_axis<first + 1, end>(function);
  }
}

// hn_i_rotated_axis and hn_i_shifted in one, for cells up to 2^24: so products fit 32 bits, and no cell is taken apart.
HN_I_INLINE ivec2 next_along(ivec2 a, ivec2 b, int along, int across, int shift) {
  const Int rest = along * a.y + across * b.y + shift * 32;
  const Int low = along * a.x + across * b.x + (rest >> 24);
  return ivec2(low >> 5, ((low & 31) << 19) | ((rest & (HN_I_UNITS_POSITION - 1)) >> 5));
}
// hn_i_advance, for such cells and a lacunarity of 2, which the factors have. A cell becomes 3.4 times as large at
// most.
constexpr double kMostNear = HN_I_UNITS_POSITION;
template <int D, typename Octaves>
HN_I_INLINE void advance_near(Octaves& o) {
  constexpr int kCos = 2 * HN_I_COS_XY, kSin = 2 * HN_I_SIN_XY;
  const ivec2 x = o.x, y = o.y;
  o.x = next_along(x, y, kCos, -kSin, HN_I_SHIFT_X);
  if constexpr (D == 2) {
    o.y = next_along(y, x, kCos, kSin, HN_I_SHIFT_Y);
  } else {
    const ivec2 turned = next_along(y, x, kCos, kSin, 0), z = o.z;
    o.y = next_along(turned, z, HN_I_COS_YZ, -2 * HN_I_SIN_YZ, HN_I_SHIFT_Y);
    o.z = next_along(z, turned, 2 * HN_I_COS_YZ, HN_I_SIN_YZ, HN_I_SHIFT_Z);
  }
  hn_i_update_place(o);
}

// A fractal octave by octave over some points: first the positions of an octave, then the noise there, by its own
// kernel, then the sum. So numbers that all points of an octave share, such as the mixed seed, are computed once, no
// point waits for its octave before, and sums and noises are compiled without each other.
//
// Octaves rotate, but for the first one and those of a tile: so a row stays a row in these alone, and is a line in
// others.
// Along a row of a tile all points have one coordinate along each other axis. These are in `across`, so that numbers
// that depend on them alone are computed once.
template <int D, typename At, bool kIsRowOfTile = false>
void by_octaves(const Batch& batch, const Options& options, Octave) {
  using Position = decltype(At::of(batch, 0, std::declval<const Arguments<D>&>()));
  constexpr bool kIsTiled = std::is_same_v<At, Tiles<D>>;
  constexpr bool kIsWhole = std::is_same_v<Position, Place<D>>;
  constexpr int kMoving = kIsRowOfTile ? 1 : D;  // axes
  constexpr bool kMayBeNear = kIsWhole && !kIsTiled && (D == 2 || D == 3);
  const Batch b = batch;
  const Arguments<D> given(options);
  const hn_i_num total = hn_i_total(min(given.octaves, Int(32)), hn_i_gain(given.gain), HN_I_WEIGHT_ONE);
  const bool is_row = b.stride[D - 1] == 0;
  BlockPositions<D, kIsWhole> spots;
  Number value[kPointsAtOnce], feedback[kPointsAtOnce], weight[kPointsAtOnce];
  float noise[kPointsAtOnce];
  for (int start = 0; start < b.count; start += kPointsAtOnce) {
    Batch now = b;
    now.count = b.count - start < kPointsAtOnce ? b.count - start : kPointsAtOnce;
    now.value[0] = noise;
    bool has_cells = kIsWhole || is_row;
    for (int axis = 0; axis < D; ++axis) {
      if (!kIsRowOfTile) now.stride[axis] = 1;
    }
    auto o = octaves_at(At::of(b, start, given), given);
    auto across = o;
    Int cells(0);  // all bits of their sizes
    for (int i = 0; i < now.count; i += kCount) {
      auto first = octaves_at(At::of(b, start + i, given), given);
      each_axis<0, kMoving>([&](auto axis) HN_I_INLINED { spots.template keep<axis>(i, first, has_cells); });
      if constexpr (kMayBeNear) {
        each_axis<0, D>([&](auto axis) HN_I_INLINED {
          const Int cell = along<axis>(first.place.cell);
          cells |= cell ^ (cell >> 31);
        });
      }
      o.sum.value.store(value + i);
      o.sum.feedback.store(feedback + i);
      o.sum.weight.store(weight + i);
    }
    std::int32_t bits = 0;
    for (int i = 0; i < kCount; ++i) bits |= cells[i];
    double farthest = bits + 1.0;  // that a cell of the octave may be
    Options of_octave = options;
    double scale = 1.0;
    for (int number = 1;; ++number) {
      const bool more = number < options.octaves && number < 32;
      each_axis<kMoving, D>([&](auto axis) HN_I_INLINED { spots.template keep<axis>(0, across, true); });
      if constexpr (kIsTiled) {
        each_axis<0, D>([&](auto axis) HN_I_INLINED { of_octave.period[axis] = along<axis>(across.place.period)[0]; });
      }
      spots.point(now, has_cells);
      const grid::Loops& loops = options.noise;
      (!is_row ? loops.points : kIsTiled || number == 1 ? loops.row : loops.line)(now, of_octave, nullptr);
      with_step(options.sum, [&](const auto& step, auto bends, auto carries) HN_I_INLINED {
        for (int i = 0; i < now.count; i += kCount) {
          o.sum.value = hn_i_num::load(value + i);
          if constexpr (carries) o.sum.feedback = hn_i_num::load(feedback + i);
          if constexpr (bends) o.sum.weight = hn_i_num::load(weight + i);
          const hn_i_octave_sum next = step(o.sum, Float::load(noise + i), given.strength);
          next.value.store(value + i);
          if constexpr (carries) next.feedback.store(feedback + i);
          if constexpr (bends) hn_i_weight_times(next.weight, next.gain).store(weight + i);
        }
        if constexpr (!bends) o.sum.weight = hn_i_weight_times(o.sum.weight, o.sum.gain);
      });
      if (!more) break;
      has_cells = kIsWhole;
      const auto period = across.place.period;
      const auto advance = [&](const auto& to_next) HN_I_INLINED {
        for (int i = 0; i < now.count; i += kCount) {
          each_axis<0, kMoving>([&](auto axis) HN_I_INLINED { spots.template put<axis>(i, o); });
          to_next();
          each_axis<0, kMoving>([&](auto axis) HN_I_INLINED { spots.template keep<axis>(i, o, kIsWhole); });
        }
      };
      if (kMayBeNear && options.lacunarity == 2.0f && farthest <= kMostNear) {
        if constexpr (kMayBeNear) advance([&]() HN_I_INLINED { advance_near<D>(o); });
      } else if constexpr (kIsWhole) {
        advance([&]() HN_I_INLINED {
          if (kIsTiled) o.place.period = period;  // the next octave's follows from it
          hn_i_advance(o);
        });
      } else {
        advance([&]() HN_I_INLINED { o.p = hn_i_next(o.p, o.lacunarity); });
      }
      farthest = 3.4 * farthest + 2.0;
      if constexpr (kIsTiled) hn_i_advance(across);
      of_octave.seed += HN_I_SEED_STEP;
      scale *= static_cast<double>(options.lacunarity < 0.0f ? -options.lacunarity : options.lacunarity);
      now.step = (b.step + b.rounding) * scale;
    }
    for (int i = 0; i < now.count; i += kCount) {
      store(b, start + i, hn_i_value(end_of(options.sum, mean_of(hn_i_num::load(value + i), total))));
    }
  }
}

// A kernel of rows by itself, so that narrow parts of a grid take it, too, and have the bits of the whole.
template <Kernel kernel>
void in_row(const Batch& batch, const Options& options, Octave octave) {
  kernel(batch, options, octave);
}

using grid::always;
using grid::Loops;
using grid::SumKernels;

#if HN_ARITHMETIC == HN_FIXED
template <int D>
using FromPositions = AnyPlace<D>;
template <int D>
using FromCells = AnyPlace<D>;
#else
template <int D>
using FromPositions = Positions<D>;
template <int D>
using FromCells = Cells<D>;
#endif

template <int D, typename Sum>
SumKernels without_period() {
  SumKernels k{};
  k.at = always(at_points<D, FromPositions<D>, Sum>);
  k.in = always(at_points<D, FromCells<D>, Sum>);
  return k;
}
template <int D, typename Sum>
SumKernels kernels_of() {
  SumKernels k = without_period<D, Sum>();
  k.tile = always(at_points<D, Tiles<D>, Sum>);
  return k;
}

template <int D, typename At>
constexpr Loops octave_by_octave() {
  return {by_octaves<D, At>, in_row<by_octaves<D, At>>, nullptr};
}

template <int D>
void enter_sums(SumKernels (&sums)[grid::kSums][4]) {
  const SumKernels any{octave_by_octave<D, FromPositions<D>>(),
                       octave_by_octave<D, FromCells<D>>(),
                       {by_octaves<D, Tiles<D>>, by_octaves<D, Tiles<D>, true>, nullptr}};
  // Sums with Jacobians, and sums over noises of their own, have other kernels, and are entered after these.
#define HN_CATALOG_STEP(Id, ...) sums[grid::k##Id][D - 1] = any;
#include "catalog.inc"
  sums[grid::kDetail][D - 1].at = always(at_points<D, FromPositions<D>, ResolvedFbm<D, true>>);
  sums[grid::kFootprint][D - 1].at = always(at_points<D, FromPositions<D>, ResolvedFbm<D, false>>);
}

void enter(grid::Kernels& kernels) {
  enter_sums<1>(kernels.sums);
  enter_sums<2>(kernels.sums);
  enter_sums<3>(kernels.sums);
  enter_sums<4>(kernels.sums);
  kernels.sums[grid::kFbmD][1] = kernels_of<2, FbmD<2>>();
  kernels.sums[grid::kFbmD][2] = kernels_of<3, FbmD<3>>();
  kernels.sums[grid::kEroded][1] = kernels_of<2, Erosion<2>>();
  kernels.sums[grid::kEroded][2] = kernels_of<3, Erosion<3>>();
  kernels.sums[grid::kWarp][1] = kernels_of<2, Warp<2, false>>();
  kernels.sums[grid::kWarp][2] = kernels_of<3, Warp<3, false>>();
  kernels.sums[grid::kWarpProgressive][1] = kernels_of<2, Warp<2, true>>();
  kernels.sums[grid::kWarpProgressive][2] = kernels_of<3, Warp<3, true>>();
  kernels.sums[grid::kPerlinWorley][2] = kernels_of<3, PerlinWorley>();
}

}  // namespace
}  // namespace HN_LANES

void grid::HASHNOISE_PASTE(sums_, HASHNOISE_TABLE)(Kernels& kernels) { lanes::enter(kernels); }

}  // namespace hashnoise
