// Rows of grids whose points are so near each other that neighbours share cells. Along such a row the corners of all
// points lie in few columns, so what depends on a corner alone is computed once for a column, many columns at a time. A
// point finds it by the number of its column. Numbers and their order are those of the library, and so are the bits.
#pragma once

#include "loops.hpp"
#if defined(__SSE4_1__)
#include <immintrin.h>
#define HN_GRID_HAS_WINDOWS
#elif defined(__aarch64__) && defined(__ARM_NEON)
#include <arm_neon.h>
#define HN_GRID_HAS_WINDOWS
#endif

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

constexpr int kPointsAtOnce = 256;  // their columns stay in the first cache

#ifdef HN_GRID_HAS_WINDOWS

// Takes of kCount numbers in memory that with the index of each lane.
class Window {
 public:
#if defined(__AVX2__)
  HN_I_INLINE explicit Window(Int index) : index_(index.v) {}
#else
  // The instruction takes bytes.
  HN_I_INLINE explicit Window(Int index) : index_((index * 0x04040404 + 0x03020100).v) {}
#endif

  template <typename S>
  HN_I_INLINE Lanes<S> of(const S* from) const {
    using Vector = typename Lanes<S>::Vector;
    const Vector numbers = Lanes<S>::load(from).v;
#if defined(__AVX512F__)
    return Lanes<S>(Vector(_mm512_maskz_permutexvar_epi32(0xFFFF, __m512i(index_), __m512i(numbers))));
#elif defined(__AVX2__)
    return Lanes<S>(Vector(_mm256_permutevar8x32_epi32(__m256i(numbers), __m256i(index_))));
#elif defined(__SSE4_1__)
    return Lanes<S>(Vector(_mm_shuffle_epi8(__m128i(numbers), __m128i(index_))));
#else
    return Lanes<S>(Vector(vqtbl1q_u8(uint8x16_t(numbers), uint8x16_t(index_))));
#endif
  }

 private:
  detail::IntVector index_;
};

// For each lane from `a`, or where the condition holds from `b`.
template <typename S>
HN_I_INLINE Lanes<S> of_either(const S* a, Int index_a, const S* b, Int index_b, Mask is_b) {
#if defined(__AVX512F__)
  using Vector = typename Lanes<S>::Vector;
  const Int index = hn_i_select(is_b, index_b + kCount, index_a);
  return Lanes<S>(Vector(_mm512_permutex2var_epi32(__m512i(Lanes<S>::load(a).v), __m512i(index.v),
                                                   __m512i(Lanes<S>::load(b).v))));
#else
  return hn_i_select(is_b, Window(index_b).of(b), Window(index_a).of(a));
#endif
}

using Number = decltype(hn_i_num()[0]);

constexpr int kMostColumns = kPointsAtOnce + 2 * kCount;

// Numbers of a corner in each column. The components of a direction are such numbers. The last one comes already
// multiplied by the offset along its axis, which is the same in all of the row. So for the points that offset is 1.
template <int kNumbers>
class Corners {
 public:
  HN_I_INLINE void put(int column, hn_i_num3 d, hn_i_num offset) {
    d.y = d.y * offset;
    keep(column, d.x, d.y, d.z);
  }
  HN_I_INLINE void put(int column, hn_i_num4 d, hn_i_num offset) {
    d.z = d.z * offset;
    keep(column, d.x, d.y, d.z, d.w);
  }
  // In the columns of points, from that column on, and in the next ones.
  HN_I_INLINE auto of(int column, Int index) const {
    const Window window(index);
    return direction([&](int i) HN_I_INLINED { return window.of(number_[i] + column); });
  }
  // Where there are registers to spare, both are taken from one.
  HN_I_INLINE auto behind(int column, Int index) const {
    return kCount == 16 ? of(column, index + 1) : of(column + 1, index);
  }
  // The same, or where the condition holds from the corners of another row.
  HN_I_INLINE auto or_of(int column, Int index, const Corners& other, int other_column, Int other_index,
                         Mask is_other) const {
    return direction([&](int i) HN_I_INLINED {
      return of_either(number_[i] + column, index, other.number_[i] + other_column, other_index, is_other);
    });
  }

 private:
  template <typename Function>
  HN_I_INLINE static auto direction(const Function& number) {
    if constexpr (kNumbers == 3) {
      return hn_i_vector(number(0), number(1), number(2));
    } else {
      return hn_i_vector(number(0), number(1), number(2), number(3));
    }
  }
  template <typename... Numbers>
  HN_I_INLINE void keep(int column, Numbers... n) {
    int i = 0;
    (n.store(number_[i++] + column), ...);
  }

  Number number_[kNumbers][kMostColumns];
};
HN_I_INLINE hn_i_num one() { return hn_i_num(Number{1}); }

// Each noise has
//
//   kMostStep              up to this distance of points the columns of kCount of them fit a window, and they gain
//   earliest(cell, half)   a column that is not behind those of a point and of all further points; `half` is 1 in the
//                          far half of the cell, else 0
//   number(place)          the column of a point
//   kBefore, kBehind       how many columns are needed before the earliest of all points, and behind that of the last
//   put(column, number, place, seed)
//                          keeps the corners in columns of these numbers, in a row through the place
//   noise(column, index, place)
//                          the noise, from the earliest column and how far behind it the points' columns are
//
// The corners of Perlin noise: in each column there are two in the plane and four in space. Columns have the numbers of
// their cells.
template <int D>
class PerlinColumns {
 public:
  static constexpr double kMostStep = 0.5;
  static constexpr int kBefore = 0;
  static constexpr int kBehind = 1;

  HN_I_INLINE static std::uint32_t earliest(std::uint32_t cell, std::uint32_t) { return cell; }
  HN_I_INLINE static Int number(const Place<D>& place) { return place.cell.x; }
  HN_I_INLINE void put(int column, Int number, Place<D> place, Uint seed) {
    place.cell.x = number;
    const auto box = hn_i_box(place);
    const auto f = place.fraction;
    if constexpr (D == 2) {
      const auto h = hn_i_corners(box, seed);
      corners_[0].put(column, hn_i_direction2(h.x), f.y);
      corners_[1].put(column, hn_i_direction2(h.z), hn_i_minus_one(f.y));
    } else {
      for (int face = 0; face < 2; ++face) {
        const auto h = hn_i_corners(box, face == 1, seed);
        const hn_i_num z = face == 0 ? f.z : hn_i_minus_one(f.z);
        corners_[2 * face].put(column, hn_i_direction3(h.x), z);
        corners_[2 * face + 1].put(column, hn_i_direction3(h.z), z);
      }
    }
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<D>& place) const {
    const auto f = place.fraction;
    const auto t = hn_i_fade(f);
    if constexpr (D == 2) {
      const hn_i_num x = hn_i_minus_one(f.x);
      return hn_i_scaled2(hn_i_lerp(hn_i_vector(hn_i_ramp(corners_[0].of(column, index), f.x, one()),
                                                hn_i_ramp(corners_[0].behind(column, index), x, one()),
                                                hn_i_ramp(corners_[1].of(column, index), f.x, one()),
                                                hn_i_ramp(corners_[1].behind(column, index), x, one())),
                                    t.x, t.y));
    } else {
      const auto face = [&](int first) HN_I_INLINED {
        return hn_i_lerp(hn_i_ramps(corners_[first].of(column, index), corners_[first].behind(column, index),
                                    corners_[first + 1].of(column, index), corners_[first + 1].behind(column, index),
                                    hn_i_vector(f.x, f.y, one()), false),
                         t.x, t.y);
      };
      return hn_i_scaled3(hn_i_lerp(face(0), face(2), t.z));
    }
  }

 private:
  Corners<D + 1> corners_[D == 2 ? 2 : 4];
};

template <int D>
class SimplexColumns;

// The corners of simplex noise on the plane: those of the lower row, and those of the upper one, which is half a step
// further. Columns have the numbers of points of the lower row, but for a shift that all points have.
template <>
class SimplexColumns<2> {
 public:
  static constexpr double kMostStep = 0.125;
  static constexpr int kBefore = 1;
  static constexpr int kBehind = 3;

  // What is along y adds 1 at most, and another 1 by a rounding.
  HN_I_INLINE static std::uint32_t earliest(std::uint32_t cell, std::uint32_t half) { return 2u * cell + half; }
  HN_I_INLINE static Int number(const Place<2>& place) {
    return Int(hn_i_doubled(Uint(place.cell.x), hn_i_floor(hn_i_skewed(place.fraction).x)));
  }
  HN_I_INLINE void put(int column, Int number, const Place<2>& place, Uint seed) {
    const hn_i_num2 skewed = hn_i_skewed(place.fraction);
    const Int row = hn_i_floor(skewed.y);
    const Int shift = hn_i_column_of(skewed) - hn_i_floor(skewed.x);
    // From twice the cell on, as of a place in it.
    const Int lower = Int(Uint(number) - 2u * Uint(place.cell.x)) + shift;
    const Uint s = hn_i_mix(seed);
    const auto direction = [&](Int x, Int y) HN_I_INLINED {
      return hn_i_triangle_direction(hn_i_seeded_word(hn_i_spread(point(place, x, y)), s));
    };
    const hn_i_num3 y = hn_i_triangle_y(skewed);
    lower_.put(column, direction(lower, row), y.x);
    upper_.put(column, direction(lower + (row & 1), row + 1), y.z);
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<2>& place) const {
    const hn_i_num2 skewed = hn_i_skewed(place.fraction);
    const hn_i_num3 x = hn_i_triangle_x(skewed);
    const hn_i_num3 t = hn_i_triangle_falloff(x, hn_i_triangle_y(skewed));
    const hn_i_num3 middle =
        upper_.or_of(column - 1, index, lower_, column + 1, index, hn_i_fract(skewed.x) > hn_i_fract(skewed.y));
    hn_i_num n = weighted(lower_.of(column, index), x.x, t.x);
    n = hn_i_plus(n, weighted(middle, x.y, t.y));
    return hn_i_scaled_simplex2(hn_i_plus(n, weighted(upper_.behind(column - 1, index), x.z, t.z)));
  }

 private:
  // The point of the integer lattice that is so far from twice the cell. Along x it may be cells away.
  HN_I_INLINE static uvec2 point(const Place<2>& place, Int x, Int y) {
    const Int cell = Int(Uint(place.cell.x) + Uint(x >> 1));
    if (!place.tiled) return uvec2(hn_i_doubled(Uint(cell), x & 1), hn_i_doubled(Uint(place.cell.y), y));
    const uvec2 c = hn_i_wrap(ivec2(cell, place.cell.y), place.period);
    return uvec2(hn_i_doubled(c.x, x & 1, place.period.x), hn_i_doubled(c.y, y, place.period.y));
  }
  HN_I_INLINE static hn_i_num weighted(hn_i_num3 d, hn_i_num x, hn_i_num t) {
    return hn_i_weighted_ramp(hn_i_triangle_times_one_plus(hn_i_dot_direction(d, x, one()), d.z), hn_i_weight_plane(t));
  }

  Corners<3> lower_, upper_;
};

// The points of simplex noise in space. Along y and z the row is in the same places of all cells. So it is the same
// neighbour of the nearest corner in whose direction the row is, if it is not the one along x that is nearer: there are
// two rows of corners, and two of centres. Columns have the numbers of their cells.
template <>
class SimplexColumns<3> {
 public:
  static constexpr double kMostStep = 0.25;
  static constexpr int kBefore = 1;
  static constexpr int kBehind = 1;

  HN_I_INLINE static std::uint32_t earliest(std::uint32_t cell, std::uint32_t) { return cell; }
  HN_I_INLINE static Int number(const Place<3>& place) { return place.cell.x; }
  HN_I_INLINE void put(int column, Int number, Place<3> place, Uint seed) {
    place.cell.x = number;
    const hn_i_block3 block = hn_i_block(place);
    const hn_i_num3 f = place.fraction;
    const hn_i_num4 y = hn_i_offsets(f.y), z = hn_i_offsets(f.z);
    const hn_i_num size_y = hn_i_size(y.x), size_z = hn_i_size(z.x);
    const uvec3 corner = hn_i_nearer(f, block.cell, block.following);
    const uvec3 across = hn_i_nearer(f, block.following, block.cell);
    const uvec3 beyond = hn_i_nearer(f, block.previous, block.following);
    const Uint x = block.cell.x, s = hn_i_mix(seed);
    const auto put_corner = [&](Corners<4>& row, Uint cy, Uint cz, hn_i_num offset) HN_I_INLINED {
      row.put(column, hn_i_direction3(hn_i_seeded_word(uvec3(x, cy, cz), s)), offset);
    };
    const auto put_centre = [&](Corners<4>& row, Uint cy, Uint cz, hn_i_num offset) HN_I_INLINED {
      const Uint h = hn_i_word(uvec3(x, cy, cz), hn_i_seed_join(s) ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM);
      row.put(column, hn_i_direction3(h), offset);
    };
    put_corner(corners_, corner.y, corner.z, z.x);
    put_corner(next_corners_, hn_i_select(size_y >= size_z, across.y, corner.y),
               hn_i_select(size_z >= size_y, across.z, corner.z), hn_i_select(size_z >= size_y, z.y, z.x));
    put_centre(centres_, block.cell.y, block.cell.z, z.z);
    put_centre(next_centres_, hn_i_select(size_y <= size_z, beyond.y, block.cell.y),
               hn_i_select(size_z <= size_y, beyond.z, block.cell.z), hn_i_select(size_z <= size_y, z.w, z.z));
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<3>& place) const {
    const hn_i_num3 f = place.fraction;
    hn_i_num4 x, y, z, t;
    hn_i_four_points(hn_i_block3{}, f, Uint(0u), x, y, z, t);  // without the words
    const auto size_of = [](hn_i_num along) HN_I_INLINED { return hn_i_size(hn_i_offsets(along).x); };
    const hn_i_num size = size_of(f.x);
    const hn_i_num larger = max(size_of(f.y), size_of(f.z));
    const hn_i_num smaller = min(size_of(f.y), size_of(f.z));
    const Mask is_behind = f.x > hn_i_quarters(2);
    const Int near = index + Int(is_behind), far = index + Int(f.x <= hn_i_quarters(2));
    const Int corner = hn_i_select(size >= larger, far, near);
    const Int centre = index + hn_i_select(size <= smaller, hn_i_select(is_behind, Int(2), Int(0)), Int(1));
    hn_i_num n = weighted(corners_.of(column, near), x.x, y.x, t.x);
    n = hn_i_plus(n, weighted(corners_.or_of(column, corner, next_corners_, column, corner, size <= larger), x.y, y.y,
                              t.y));
    n = hn_i_plus(n, weighted(centres_.of(column, index), x.z, y.z, t.z));
    n = hn_i_plus(n, weighted(centres_.or_of(column - 1, centre, next_centres_, column - 1, centre, size >= smaller),
                              x.w, y.w, t.w));
    return hn_i_scaled_simplex3(n);
  }

 private:
  HN_I_INLINE static hn_i_num weighted(hn_i_num4 d, hn_i_num x, hn_i_num y, hn_i_num t) {
    return hn_i_weighted_ramp(
        hn_i_ramp(d, hn_i_octahedral(hn_i_plus(x, y)), hn_i_octahedral(hn_i_minus(x, y)), hn_i_octahedral_z(one())),
        hn_i_weight4(t));
  }

  Corners<4> corners_, next_corners_, centres_, next_centres_;
};

#endif

// Some points of a row, from `start` on and before `end`: uses the noise at each vector of them, whose place place_at
// gives. earliest_at gives that of a single point. There are no more points than kPointsAtOnce.
template <typename Columns, typename EarliestAt, typename PlaceAt, typename Use>
HN_I_INLINE void over_columns(Columns& columns, int start, int end, Uint seed, const EarliestAt& earliest_at,
                              const PlaceAt& place_at, const Use& use) {
  Int lane;
  for (int i = 0; i < kCount; ++i) lane.v[i] = i;
  // Numbers wrap at 2^32, so it is their distance that tells which is the lower one.
  const auto distance = static_cast<std::int32_t>(earliest_at(end - 1) - earliest_at(start));
  const bool falls = distance < 0;
  const int last = (falls ? -distance : distance) + Columns::kBefore + Columns::kBehind;
  const std::uint32_t lowest = earliest_at(falls ? end - 1 : start) - Columns::kBefore;
  const auto place = place_at(start);
  for (int column = 0; column <= last; column += kCount) {
    columns.put(column, Int(Uint(lowest + static_cast<std::uint32_t>(column))) + lane, place, seed);
  }
  for (int i = start; i < end; i += kCount) {
    const std::uint32_t earliest = earliest_at(falls ? i + kCount - 1 : i);
    const auto at = place_at(i);
    const Int index(Uint(Columns::number(at)) - Uint(earliest));
    use(i, columns.noise(static_cast<int>(earliest - lowest), index, at));
  }
}

// Whether the 1024 cells from this one on, to both sides, reach the last cell, behind which the first one comes. A tile
// has a seam there: the next column has other corners than the cell.
HN_I_INLINE bool is_at_wrap(std::int32_t cell) { return cell < -2147482624 || cell > 2147482624; }

// Along a row whose points are no further from each other than Columns::kMostStep. tile_of gives the place that a noise
// is asked for, of one without a period; at a seam noise_at is asked, point by point.
template <int D, typename Columns, bool kTiled, typename TileOf, typename NoiseAt>
HN_I_INLINE void along_columns(const Batch& batch, Uint seed, const TileOf& tile_of, const NoiseAt& noise_at) {
  const Batch b = batch;
  Cell<D> cell = cells_at<D>(b, 0);
  Fraction<D> f = fractions_at<D>(b, 0);
  const auto place_at = [&](int i) HN_I_INLINED {
    cell.x = Int::load(b.cell[0] + i);
    f.x = Float::load(b.place[0] + i);
    return hn_place(cell, f);
  };
  const auto earliest_at = [&](int i) HN_I_INLINED {
    return Columns::earliest(static_cast<std::uint32_t>(b.cell[0][i]), b.place[0][i] < 0.5f ? 0u : 1u);
  };
  Columns columns;
  for (int start = 0; start < b.count; start += kPointsAtOnce) {
    const int end = b.count - start < kPointsAtOnce ? b.count : start + kPointsAtOnce;
    if (kTiled && is_at_wrap(b.cell[0][start])) {
      for (int i = start; i < end; i += kCount) store(b, i, noise_at(place_at(i)));
      continue;
    }
    over_columns(
        columns, start, end, seed, earliest_at, [&](int i) HN_I_INLINED { return tile_of(place_at(i)); },
        [&](int i, hn_i_num n) HN_I_INLINED { store(b, i, hn_i_value(n)); });
  }
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
