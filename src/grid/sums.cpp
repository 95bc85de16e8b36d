// The kernels of sums, for one instruction set and one arithmetic: the octaves of the library over a noise that is
// called, since there are too many pairs of a sum and a noise to compile. Most sums call the kernels of the noise,
// octave by octave.
#include "loops.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// Calls a function with what adds an octave to a sum, with whether that changes the weight of the next one, and with
// whether it carries anything else to it.
template <typename Function>
HN_I_INLINE void with_step(int id, const Function& function) {
  switch (id) {
#define HN_CATALOG_STEP(Id, name, step, end)                                                      \
  case grid::k##Id:                                                                               \
    return function([](auto& o, Float n, [[maybe_unused]] Float strength) HN_I_INLINED { step; }, \
                    std::bool_constant<grid::k##Id == grid::kWeighted>(),                         \
                    std::bool_constant<(grid::k##Id == grid::kRidged || grid::k##Id == grid::kHybrid)>());
#include "catalog.inc"
    default:  // fbm with a detail or a footprint
      return function([](auto& o, Float n, Float)
                          HN_I_INLINED { o.sum.value = hn_i_summed(o.sum.value, hn_i_octave(n), o.sum.part); },
                      std::false_type(), std::false_type());
  }
}

// Prepares such a sum for its total. These take a copy, since what is passed to them stays in memory.
HN_GRID_NOINLINE void start_limits(hn_i_octave_sum& sum, const Options& options) {
  if (options.sum == grid::kDetail) {
    sum.part = hn_i_last_part(Float(options.limit), Int(options.octaves));
  } else {
    sum.footprint = hn_i_footprint(Float(options.limit));
  }
}
// The weight of a part of an octave. Where nothing is left of the next one, the sum is at its end.
HN_GRID_NOINLINE hn_i_num limited(hn_i_octave_sum& sum, hn_i_num weight, const Options& options, int number) {
  if (options.sum == grid::kDetail) {
    return number < options.octaves    ? weight
           : number == options.octaves ? hn_i_weight_times(weight, sum.part)
                                       : hn_i_num(HN_I_NO_WEIGHT);
  }
  const hn_i_num part = hn_i_resolved_part(sum.footprint);
  sum.footprint = hn_i_next_footprint(sum.footprint, Float(options.lacunarity));
  if (hn_i_to_bool(hn_i_resolved_part(sum.footprint) == HN_I_NO_WEIGHT)) sum.at = sum.octaves;
  return hn_i_weight_times(weight, part);
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
// The octaves of a point of a batch, which has positions or cells, and perhaps a period.
template <int D>
HN_I_INLINE auto octaves_of(const Batch& b, int i, const Arguments<D>& given) {
#if HN_ARITHMETIC != HN_FIXED
  if (b.cell[0] == nullptr && !given.tiled) return octaves_at(fractions_at<D>(b, i), given);
#endif
  return octaves_at(placed(place_at<D>(b, i), given), given);
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

// Sums with Jacobians.
template <int D>
using Vector = std::conditional_t<D == 2, vec2, vec3>;
template <int D, bool kIsEroded>
struct SlopeSum {
  using Result = std::conditional_t<D == 2, vec3, vec4>;

  template <typename Noise>
  HN_I_INLINE static auto at(const Batch& b, int i, const Noise& noise, const Arguments<D>& given) {
    auto o = octaves_of(b, i, given);
    auto s = hn_slopes(o);
    do {
      const auto n = noise(o);
      if constexpr (kIsEroded) {
        hn_add_eroded(o, s, n, given.strength);
      } else {
        hn_add(o, s, n);
      }
    } while (hn_next(o));
    if constexpr (kIsEroded) {
      return hn_mean(o);
    } else {
      return hn_mean(o, s);
    }
  }
};

template <int D, bool kIsProgressive>
struct Warp {
  using Result = Vector<D>;

  template <typename Noise>
  HN_I_INLINE static auto at(const Batch& b, int i, const Noise& noise, const Arguments<D>& given) {
    auto o = octaves_of(b, i, given);
    auto s = hn_shifts(o, given.strength);
    do {
      const Vector<D> v = noise(o);
      if constexpr (kIsProgressive) {
        hn_add_progressive(o, s, v);
      } else {
        hn_add(o, s, v);
      }
    } while (hn_next(o));
    return hn_mean(o, s);
  }
};

// Over noises of its own.
struct PerlinWorley {
  using Result = Float;

  template <typename Noise>
  HN_I_INLINE static Float at(const Batch& b, int i, const Noise&, const Arguments<3>& given) {
    Arguments<3> of_billows = given;
    of_billows.octaves = min(given.octaves, Int(3));
    of_billows.seed = hn_i_other_seed(given.seed);
    return hn_i_perlin_worley(octaves_of(b, i, given), octaves_of(b, i, of_billows));
  }
};

template <int D, bool kHasPhase>
struct Flows {
  using Result = Vector<D>;

  template <typename Noise>
  HN_I_INLINE static auto at(const Batch& b, int i, const Noise&, const Arguments<D>& given) {
    if constexpr (kHasPhase) {
      return hn_i_curl_fbm(octaves_of(b, i, given), given.phase);
    } else {
      return hn_i_curl_fbm(octaves_of(b, i, given));
    }
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

template <int D, typename Sum>
void sum_at_points(const Batch& batch, const Options& options, Octave octave) {
  const Batch b = batch;
  const Arguments<D> given(options);
  Arguments<D> of_octave = given;
  const auto noise = [&](const auto& o) HN_I_INLINED {
    of_octave.seed = o.seed;
    return reinterpret_cast<NoiseCall<D, typename Sum::Result>>(octave)(o.place, of_octave);
  };
  for (int i = 0; i < b.count; i += kCount) store(b, i, Sum::at(b, i, noise, given));
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
      along_axis<axis>(o).y.store(rest[axis] + i);
    } else {
      along_axis<axis>(o.p).store(rest[axis] + i);
    }
    if (!has_cells) return;
    along_axis<axis>(o.place.cell).store(cell[axis] + i);
#if HN_ARITHMETIC == HN_FIXED
    (Float(along_axis<axis>(o.place.fraction)) * (1.0f / HN_I_ONE)).store(place[axis] + i);
#else
    along_axis<axis>(o.place.fraction).store(place[axis] + i);
#endif
  }
  template <int axis, typename Octaves>
  HN_I_INLINE void put(int i, Octaves& o) const {
    if constexpr (kIsWhole) {
      along_axis<axis>(o) = ivec2(Int::load(cell[axis] + i), Int::load(rest[axis] + i));
    } else {
      along_axis<axis>(o.p) = Float::load(rest[axis] + i);
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
};

// The rotation and the shift of an octave in one, for cells up to 2^24: so products fit 32 bits, and no cell is taken
// apart.
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
  const bool is_limited = !kIsTiled && options.sum >= grid::kDetail;
  hn_i_octave_sum limits = octaves_at(At::of(b, 0, given), given).sum;
  if (is_limited) start_limits(limits, options);
  const hn_i_num total = hn_i_total(limits);
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
    hn_i_octave_sum of_block = limits;
    Int cells(0);  // all bits of their sizes
    for (int i = 0; i < now.count; i += kCount) {
      auto first = octaves_at(At::of(b, start + i, given), given);
      each_axis<0, kMoving>([&](auto axis) HN_I_INLINED { spots.template keep<axis>(i, first, has_cells); });
      if constexpr (kMayBeNear) {
        each_axis<0, D>([&](auto axis) HN_I_INLINED {
          const Int cell = along_axis<axis>(first.place.cell);
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
      bool more = number < options.octaves && number < 32;
      if (is_limited) {
        o.sum.part = limited(of_block, o.sum.weight, options, number);
        more = more && of_block.at[0] < options.octaves;
      }
      each_axis<kMoving, D>([&](auto axis) HN_I_INLINED { spots.template keep<axis>(0, across, true); });
      if constexpr (kIsTiled) {
        each_axis<0, D>([&](auto axis)
                            HN_I_INLINED { of_octave.period[axis] = along_axis<axis>(across.place.period)[0]; });
      }
      spots.point(now, has_cells);
      const grid::Loops& loops = options.noise;
      (!is_row ? loops.points : kIsTiled || number == 1 ? loops.row : loops.line)(now, of_octave, nullptr);
      with_step(options.sum, [&](const auto& step, auto bends, auto carries) HN_I_INLINED {
        for (int i = 0; i < now.count; i += kCount) {
          o.sum.value = hn_i_num::load(value + i);
          if constexpr (carries) o.sum.feedback = hn_i_num::load(feedback + i);
          if constexpr (bends) o.sum.weight = hn_i_num::load(weight + i);
          step(o, Float::load(noise + i), given.strength);
          o.sum.value.store(value + i);
          if constexpr (carries) o.sum.feedback.store(feedback + i);
          if constexpr (bends) hn_i_weight_times(o.sum.weight, o.sum.gain).store(weight + i);
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
SumKernels sum_kernels() {
  const Loops loops = always(sum_at_points<D, Sum>);
  return {loops, loops, loops};
}

template <int D, typename At>
constexpr Loops octave_by_octave() {
  return {by_octaves<D, At>, in_row<by_octaves<D, At>>, nullptr};
}

template <int D>
void enter_sums(SumKernels (&sums)[grid::kSums][4]) {
  const SumKernels any{octave_by_octave<D, FromPositions<D>>(),
                       octave_by_octave<D, FromCells<D>>(),
                       {by_octaves<D, Tiles<D>>, in_row<by_octaves<D, Tiles<D>, (D > 1)>>, nullptr}};
  // Sums with Jacobians, and sums over noises of their own, have other kernels, and are entered after these.
#define HN_CATALOG_STEP(Id, ...) sums[grid::k##Id][D - 1] = any;
#include "catalog.inc"
  sums[grid::kDetail][D - 1].at = sums[grid::kFootprint][D - 1].at = any.at;
}

template <int D>
void enter_jacobians(SumKernels (&sums)[grid::kSums][4]) {
  sums[grid::kFbmD][D - 1] = sum_kernels<D, SlopeSum<D, false>>();
  sums[grid::kEroded][D - 1] = sum_kernels<D, SlopeSum<D, true>>();
  sums[grid::kWarp][D - 1] = sum_kernels<D, Warp<D, false>>();
  sums[grid::kWarpProgressive][D - 1] = sum_kernels<D, Warp<D, true>>();
  sums[grid::kCurlFbm][D - 1] = sum_kernels<D, Flows<D, false>>();
  sums[grid::kFlowsWithPhase][D - 1] = sum_kernels<D, Flows<D, true>>();
}

void enter_sums(grid::Kernels& kernels) {
  enter_sums<1>(kernels.sums);
  enter_sums<2>(kernels.sums);
  enter_sums<3>(kernels.sums);
  enter_sums<4>(kernels.sums);
  enter_jacobians<2>(kernels.sums);
  enter_jacobians<3>(kernels.sums);
  kernels.sums[grid::kPerlinWorley][2] = sum_kernels<3, PerlinWorley>();
}

}  // namespace
}  // namespace HN_LANES

namespace grid {
HASHNOISE_ENTER(sums, HASHNOISE_TABLE) { lanes::enter_sums(kernels); }
}  // namespace grid

}  // namespace hashnoise
