// Rows of grids whose points are so near each other that neighbours share cells. Along such a row the corners of all
// points lie in few columns, so what depends on a corner alone is computed once for a column, many columns at a time. A
// point finds it by the number of its column. Numbers and their order are the library's, and so are the bits,
// but for Perlin noise with HN_FAST.
#pragma once

#include "windows.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

#ifdef HN_GRID_HAS_WINDOWS

constexpr int kMostColumns = kPointsAtOnce + 2 * kCount;

// The numbers of a corner in each column.
template <int kNumbers, typename S = float>
using InColumns = Corners<kNumbers, kMostColumns, S>;
using Lines = InColumns<2>;

constexpr bool kIsWide = kCount > 4;

// Each noise has
//
//   kMostStep              up to this distance of points the columns of kCount of them fit a window, also where places
//                          are rounded to halves of a cell, and they gain
//   earliest(cell, half)   a column that is not behind those of a point and of all further points; `half` is 1 in the
//                          far half of the cell, else 0
//   number(place)          the column of a point
//   kBefore, kBehind       how many columns are needed before the earliest of all points, and behind that of the last
//   put(column, number, place, seed)
//                          keeps the corners in columns of these numbers, in a row through the place
//   noise(column, index, place)
//                          the noise, from the earliest column and how far behind it the points' columns are
//
// Columns may have the numbers of their cells.
template <int D>
class CellNumbers {
 public:
  static constexpr int kBehind = 1;

  HN_I_INLINE static std::uint32_t earliest(std::uint32_t cell, std::uint32_t) { return cell; }
  HN_I_INLINE static Int number(const Place<D>& place) { return place.cell.x; }
};

// The corners of Perlin noise: in each column there are two in the plane and four in space. Along the row the fades of
// the other axes are the same, too. With HN_FAST a column is interpolated by these before it is kept, so that one line
// is left. In space that rounds at most 17 times, to the nearest, and the error that the noise states allows for 10
// roundings in any mode; on the plane 11 and 9.
template <int D>
class PerlinColumns : public CellNumbers<D> {
 public:
  static constexpr double kMostStep = 0.85;
  static constexpr int kBefore = 0;

  HN_I_INLINE void put(int column, Int number, Place<D> place, Uint seed) {
    place.cell.x = number;
    const auto corners = hn_i_cell_corners(place);
    const auto f = place.fraction;
    const auto t = hn_i_fade(f);
    if constexpr (D == 2) {
      const auto h = hn_i_corner_hashes(corners, seed);
      put_pair(0, column, line<2>(h.x, f.y), line<2>(h.z, f.y - HN_I_ONE), t.y);
    } else {
      const auto one = [&](Uint word, bool upper, bool back) HN_I_INLINED {
        return line<3>(word, upper ? f.y - HN_I_ONE : f.y, back ? f.z - HN_I_ONE : f.z);
      };
      const auto front = hn_i_corner_hashes(corners, false, seed), back = hn_i_corner_hashes(corners, true, seed);
#if HN_ARITHMETIC == HN_FAST
      put_pair(0, column, between(one(front.x, false, false), one(front.z, true, false), t.y),
               between(one(back.x, false, true), one(back.z, true, true), t.y), t.z);
#else
      put_pair(0, column, one(front.x, false, false), one(front.z, true, false), t.y);
      put_pair(2, column, one(back.x, false, true), one(back.z, true, true), t.y);
#endif
    }
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<D>& place) const {
    const auto f = place.fraction;
    const Float x = hn_i_offset(f.x), x1 = x - 1.0f;
    const auto ramp = [](vec2 line, Float along_x) HN_I_INLINED { return along_line<D>(line, along_x); };
#if HN_ARITHMETIC == HN_FAST
    const Float n =
        hn_i_lerp(ramp(corners_[0].of(column, index), x), ramp(corners_[0].behind(column, index), x1), hn_i_fade(f.x));
    return scaled<D>(n);
#else
    const auto t = hn_i_fade(f);
    const auto face = [&](int i) HN_I_INLINED {
      return hn_i_num4(ramp(corners_[i].of(column, index), x), ramp(corners_[i].behind(column, index), x1),
                       ramp(corners_[i + 1].of(column, index), x), ramp(corners_[i + 1].behind(column, index), x1));
    };
    if constexpr (D == 2) {
      return scaled<2>(bilerp_ramps<2>(face(0), t.x, t.y));
    } else {
      return scaled<3>(hn_i_lerp(bilerp_ramps<3>(face(0), t.x, t.y), bilerp_ramps<3>(face(2), t.x, t.y), t.z));
    }
#endif
  }

 private:
#if HN_ARITHMETIC == HN_FAST
  static constexpr int kLines = 1;
  HN_I_INLINE static vec2 between(vec2 a, vec2 b, Float t) {
    return vec2(hn_i_lerp(a.x, b.x, t), hn_i_lerp(a.y, b.y, t));
  }
  HN_I_INLINE void put_pair(int i, int column, vec2 lower, vec2 upper, Float t) {
    corners_[i].put(column, between(lower, upper, t));
  }
#else
  static constexpr int kLines = D == 2 ? 2 : 4;
  HN_I_INLINE void put_pair(int i, int column, vec2 lower, vec2 upper, hn_i_num) {
    corners_[i].put(column, lower);
    corners_[i + 1].put(column, upper);
  }
#endif

  Lines corners_[kLines];
};

// The numbers of value noise.
template <int D>
class ValueColumns : public CellNumbers<D> {
 public:
  static constexpr double kMostStep = 0.85;
  static constexpr int kBefore = 0;

  HN_I_INLINE void put(int column, Int number, Place<D> place, Uint seed) {
    place.cell.x = number;
    const auto corners = hn_i_cell_corners(place);
    if constexpr (D == 2) {
      const auto h = hn_i_corner_hashes(corners, seed);
      numbers_[0].put(column, hn_i_number(h.x));
      numbers_[1].put(column, hn_i_number(h.z));
    } else {
      for (int face = 0; face < 2; ++face) {
        const auto h = hn_i_corner_hashes(corners, face == 1, seed);
        numbers_[2 * face].put(column, hn_i_number(h.x));
        numbers_[2 * face + 1].put(column, hn_i_number(h.z));
      }
    }
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<D>& place) const {
    const auto t = hn_i_fade(place.fraction);
    const auto face = [&](int first) HN_I_INLINED {
      return hn_i_lerp(hn_i_num4(numbers_[first].of(column, index), numbers_[first].behind(column, index),
                                 numbers_[first + 1].of(column, index), numbers_[first + 1].behind(column, index)),
                       t.x, t.y);
    };
    if constexpr (D == 2) {
      return hn_i_noise_of_numbers(face(0));
    } else {
      return hn_i_noise_of_numbers(hn_i_lerp(face(0), face(2), t.z));
    }
  }

 private:
  InColumns<1, Number> numbers_[D == 2 ? 2 : 4];
};

// The nearest corner of a cell along each axis, the one opposite, and where the centre beyond is.
struct Neighbours {
  uvec3 corner, across, beyond;
};
HN_I_INLINE Neighbours around(const hn_i_neighbourhood3& cells, hn_i_num3 f) {
  return {hn_i_nearer(f, cells.cell, cells.following), hn_i_nearer(f, cells.following, cells.cell),
          hn_i_nearer(f, cells.previous, cells.following)};
}

template <int D>
class SimplexColumns;

// The corners of simplex noise on the plane: those of the lower row, and those of the upper one, which is half a step
// further. Columns have the numbers of points of the lower row, but for a shift that all points have.
template <>
class SimplexColumns<2> {
 public:
  static constexpr double kMostStep = kIsWide ? 0.25 : 0.125;
  static constexpr int kBefore = 1;
  static constexpr int kBehind = 3;

  // The skew by y moves a point at most one column; rounding can add one more.
  HN_I_INLINE static std::uint32_t earliest(std::uint32_t cell, std::uint32_t half) { return 2u * cell + half; }
  HN_I_INLINE static Int number(const Place<2>& place) {
    return Int(hn_i_doubled(Uint(place.cell.x), hn_i_floor(hn_i_skewed(place.fraction).x)));
  }
  HN_I_INLINE void put(int column, Int number, const Place<2>& place, Uint seed) {
    const hn_i_num2 skewed = hn_i_skewed(place.fraction);
    const Int row = hn_i_floor(skewed.y);
    // From twice the cell on, as of a place in it.
    const Int lower = Int(Uint(number) - 2u * Uint(place.cell.x)) - min(row, Int(1));
    const Uint s = hn_i_scramble(seed);
    const auto word = [&](Int x, Int y)
                          HN_I_INLINED { return seeded_hash(hn_i_spread(triangle_point(place, x, y)), s); };
    const hn_i_num3 y = hn_i_triangle_y(skewed);
    lower_.put(column, line<2>(word(lower, row), y.x));
    upper_.put(column, line<2>(word(lower + (row & 1), row + 1), y.z));
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<2>& place) const {
    const hn_i_num2 skewed = hn_i_skewed(place.fraction);
    const hn_i_num3 x = hn_i_triangle_x(skewed);
    const hn_i_num3 t = hn_i_triangle_falloff(x, hn_i_triangle_y(skewed));
    const auto middle =
        upper_.or_of(column - 1, index, lower_, column + 1, index, hn_i_fract(skewed.x) > hn_i_fract(skewed.y));
    hn_i_num n = weighted(lower_.of(column, index), x.x, t.x);
    n += weighted(middle, x.y, t.y);
    return scaled_simplex<2>(n + weighted(upper_.behind(column - 1, index), x.z, t.z));
  }

 private:
  HN_I_INLINE static hn_i_num weighted(vec2 line, hn_i_num x, hn_i_num t) {
    return weighted_ramp<2>(hn_i_weight_plane(t), along_line<2>(line, hn_i_offset(x)));
  }

  Lines lower_, upper_;
};

// The points of simplex noise in space. Along y and z the row is in the same places of all cells. So it is the same
// neighbour of the nearest corner in whose direction the row is, if it is not the one along x that is nearer: there are
// two rows of corners, and two of centres.
template <>
class SimplexColumns<3> : public CellNumbers<3> {
 public:
  static constexpr double kMostStep = kIsWide ? 0.6 : 0.25;
  static constexpr int kBefore = 1;

  HN_I_INLINE void put(int column, Int number, Place<3> place, Uint seed) {
    place.cell.x = number;
    const hn_i_neighbourhood3 cells = hn_i_neighbourhood(place);
    const hn_i_num3 f = place.fraction;
    const hn_i_num4 y = hn_i_offsets(f.y), z = hn_i_offsets(f.z);
    const hn_i_num size_y = hn_i_magnitude(y.x), size_z = hn_i_magnitude(z.x);
    const auto [corner, across, beyond] = around(cells, f);
    const Uint x = cells.cell.x, s = hn_i_scramble(seed);
    const auto put_corner = [&](Lines& row, Uint cy, Uint cz, hn_i_num along_y, hn_i_num along_z) HN_I_INLINED {
      row.put(column, line<3>(seeded_hash(uvec3(x, cy, cz), s), along_y, along_z));
    };
    const auto put_centre = [&](Lines& row, Uint cy, Uint cz, hn_i_num along_y, hn_i_num along_z) HN_I_INLINED {
      const Uint h = hn_i_point_hash(uvec3(x, cy, cz), hn_i_seed_join(s) ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM);
      row.put(column, line<3>(h, along_y, along_z));
    };
    const Mask next_y = size_y >= size_z, next_z = size_z >= size_y;  // of a corner, and of a centre the other one
    put_corner(corners_, corner.y, corner.z, y.x, z.x);
    put_corner(next_corners_, select(next_y, across.y, corner.y), select(next_z, across.z, corner.z),
               select(next_y, y.y, y.x), select(next_z, z.y, z.x));
    put_centre(centres_, cells.cell.y, cells.cell.z, y.z, z.z);
    put_centre(next_centres_, select(next_z, beyond.y, cells.cell.y), select(next_y, beyond.z, cells.cell.z),
               select(next_z, y.w, y.z), select(next_y, z.w, z.z));
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<3>& place) const {
    const hn_i_num3 f = place.fraction;
    hn_i_num4 x, y, z, t;
    hn_i_four_points(hn_i_neighbourhood3{}, f, Uint(0u), x, y, z, t);  // without the words
    const auto size_of = [](hn_i_num along) HN_I_INLINED { return hn_i_magnitude(hn_i_offsets(along).x); };
    const hn_i_num size = size_of(f.x);
    const hn_i_num larger = max(size_of(f.y), size_of(f.z));
    const hn_i_num smaller = min(size_of(f.y), size_of(f.z));
    const Mask is_behind = f.x > HN_I_ONE / 2;
    const Int near = index + Int(is_behind), far = index + Int(f.x <= HN_I_ONE / 2);
    const Int corner = select(size >= larger, far, near);
    const Int centre = index + select(size <= smaller, select(is_behind, Int(2), Int(0)), Int(1));
    hn_i_num n = weighted(corners_.of(column, near), x.x, t.x);
    n += weighted(corners_.or_of(column, corner, next_corners_, column, corner, size <= larger), x.y, t.y);
    n += weighted(centres_.of(column, index), x.z, t.z);
    n += weighted(centres_.or_of(column - 1, centre, next_centres_, column - 1, centre, size >= smaller), x.w, t.w);
    return scaled_simplex<3>(n);
  }

 private:
  HN_I_INLINE static hn_i_num weighted(vec2 line, hn_i_num x, hn_i_num t) {
    return weighted_ramp<3>(hn_i_weight4(t), along_line<3>(line, hn_i_offset(x)));
  }

  Lines corners_, next_corners_, centres_, next_centres_;
};

// A place in steps of the triangular lattice, two to a cell.
HN_I_INLINE hn_i_num2 in_steps(hn_i_num2 f) { return hn_i_num2(f.x + f.x, f.y + f.y); }

template <int D>
class SmoothSimplexColumns;

// The corners of smooth simplex noise on the plane: two of the lower row, and two of the upper one.
template <>
class SmoothSimplexColumns<2> {
 public:
  static constexpr double kMostStep = kIsWide ? 0.25 : 0.125;
  static constexpr int kBefore = 1;
  static constexpr int kBehind = 4;

  HN_I_INLINE static std::uint32_t earliest(std::uint32_t cell, std::uint32_t half) { return 2u * cell + half - 1u; }
  HN_I_INLINE static Int number(const Place<2>& place) {
    const hn_i_num2 p = in_steps(place.fraction);
    return Int(hn_i_doubled(Uint(place.cell.x), hn_i_floor(hn_i_in_row(p.x, hn_i_floor(p.y)))));
  }
  HN_I_INLINE void put(int column, Int number, const Place<2>& place, Uint seed) {
    const hn_i_num y = in_steps(place.fraction).y;
    const Int row = hn_i_floor(y);
    const Int x = Int(Uint(number) - 2u * Uint(place.cell.x));
    const Uint s = hn_i_scramble(seed);
    const auto word = [&](Int of_row)
                          HN_I_INLINED { return seeded_hash(hn_i_spread(triangle_point(place, x, of_row)), s); };
    lower_.put(column, line<2>(word(row), hn_i_fract(y)));
    upper_.put(column, line<2>(word(row + 1), hn_i_fract(y) - HN_I_ONE));
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<2>& place) const {
    const hn_i_num2 p = in_steps(place.fraction);
    const Int row = hn_i_floor(p.y);
    const hn_i_num lower = hn_i_in_row(p.x, row), upper = hn_i_in_row(p.x, row + 1);
    const Int of_upper = index + (hn_i_floor(upper) - hn_i_floor(lower) + 1);
    const hn_i_num x = hn_i_fract(lower), of_x = hn_i_fract(upper);
    const hn_i_num y = hn_i_fract(p.y), of_y = y - HN_I_ONE;
    hn_i_num n = weighted(lower_.of(column, index), x, y);
    n += weighted(lower_.behind(column, index), x - HN_I_ONE, y);
    n += weighted(upper_.of(column - 1, of_upper), of_x, of_y);
    n += weighted(upper_.behind(column - 1, of_upper), of_x - HN_I_ONE, of_y);
    return scaled_smooth<2>(n);
  }

 private:
  HN_I_INLINE static hn_i_num weighted(vec2 line, hn_i_num x, hn_i_num y) {
    return weighted_ramp<2>(hn_i_weight3(hn_i_falloff(hn_i_square(x, y), 1024, 1)),
                            along_line<2>(line, hn_i_offset(x)));
  }

  Lines lower_, upper_;
};

// The points of smooth simplex noise in space: corners and centres in the four rows of each that are next to the row.
// The first bit of a row's number is 1 if it is further off along y, and the second one, along z.
template <>
class SmoothSimplexColumns<3> : public CellNumbers<3> {
 public:
  static constexpr double kMostStep = kIsWide ? 0.6 : 0.25;
  static constexpr int kBefore = 1;

  HN_I_INLINE void put(int column, Int number, Place<3> place, Uint seed) {
    place.cell.x = number;
    const hn_i_neighbourhood3 cells = hn_i_neighbourhood(place);
    const hn_i_num3 f = place.fraction;
    const hn_i_num4 y = hn_i_offsets(f.y), z = hn_i_offsets(f.z);
    const auto [corner, across, beyond] = around(cells, f);
    const Uint s = hn_i_scramble(seed), join = hn_i_seed_join(s);
    for (int row = 0; row < 4; ++row) {
      const bool far_y = (row & 1) != 0, far_z = (row & 2) != 0;
      const uvec3 c(cells.cell.x, far_y ? across.y : corner.y, far_z ? across.z : corner.z);
      corners_[row].put(column, line<3>(hn_i_point_hash(c, join, s), far_y ? y.y : y.x, far_z ? z.y : z.x));
      const uvec3 d(cells.cell.x, far_y ? beyond.y : cells.cell.y, far_z ? beyond.z : cells.cell.z);
      const Uint h = hn_i_point_hash(d, join ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM);
      centres_[row].put(column, line<3>(h, far_y ? y.w : y.z, far_z ? z.w : z.z));
    }
  }
  HN_I_INLINE hn_i_num noise(int column, Int index, const Place<3>& place) const {
    const hn_i_num3 f = place.fraction;
    const hn_i_num4 x = hn_i_offsets(f.x), y = hn_i_offsets(f.y), z = hn_i_offsets(f.z);
    const hn_i_num3 size = hn_i_num3(hn_i_magnitude(x.x), hn_i_magnitude(y.x), hn_i_magnitude(z.x));
    const hn_i_num3 inner = hn_i_num3(hn_i_magnitude(x.z), hn_i_magnitude(y.z), hn_i_magnitude(z.z));
    const Mask is_behind = f.x > HN_I_ONE / 2;
    const Int near = index + Int(is_behind), far = index + Int(f.x <= HN_I_ONE / 2);
    const Int next = index + select(is_behind, Int(2), Int(0));
    return scaled_smooth<3>(
        cube(corners_, {column, near}, {column, far}, x.x, x.y, size, hn_i_square(x.x, y.x, z.x)) +
        cube(centres_, {column, index}, {column - 1, next}, x.z, x.w, inner, hn_i_square(x.z, y.z, z.z)));
  }

 private:
  struct Side {
    int column;
    Int index;
  };
  // For points of one kind, the nearest one and its three neighbours. d and e are the offsets along x from
  // the nearest point and from the one opposite.
  HN_I_INLINE static hn_i_num cube(const Lines (&rows)[4], Side near, Side far, hn_i_num d, hn_i_num e, hn_i_num3 size,
                                   hn_i_square_number q) {
    const hn_i_num total = size.x + size.y + size.z;
    const auto neighbour = [&](int row, Side one, Side other, hn_i_num of_one, hn_i_num of_other,
                               hn_i_num along) HN_I_INLINED {
      const hn_i_num twice = along + along;
      const Mask is_other = total - twice > HN_I_ONE / 2;
      const hn_i_num more = min(HN_I_ONE - twice, 2 * HN_I_ONE - (total + total) + twice);
      return weighted(rows[row].or_of(one.column, one.index, rows[3 - row], other.column, other.index, is_other),
                      select(is_other, of_other, of_one), hn_i_falloff(hn_i_square_plus(q, more), 768, 1));
    };
    hn_i_num a = weighted(rows[0].of(near.column, near.index), d, hn_i_falloff(q, 768, 1));
    a += neighbour(0, far, near, e, d, size.x);
    a += neighbour(1, near, far, d, e, size.y);
    return a + neighbour(2, near, far, d, e, size.z);
  }
  HN_I_INLINE static hn_i_num weighted(vec2 line, hn_i_num x, hn_i_num t) {
    return weighted_ramp<3>(hn_i_weight5(t), along_line<3>(line, hn_i_offset(x)));
  }

  Lines corners_[4], centres_[4];
};

// The feature points of cellular noise in the Euclidean metric, in the cells of the row and in those around it. Along x
// offsets from points are kept for the middle of the cell. Across the row an offset is the same in all of it, so its
// square is kept. In space this holds with HN_FIXED alone, since offsets of floats come along the diagonals there.
template <int D>
class CellularColumns : public CellNumbers<D> {
 public:
  static constexpr double kMostStep = 0.85;
  static constexpr int kBefore = 1;

  HN_I_INLINE explicit CellularColumns(Float jitter) : jitter_(hn_i_jitter(jitter)) {}
  HN_I_INLINE void put(int column, Int number, Place<D> place, Uint seed) {
    place.cell.x = number;
    const auto cells = hn_i_neighbourhood(place);
    const auto d = hn_i_from_centre(place.fraction);
    const Uint s = hn_i_scramble(seed);
    const hn_i_num none(Number{0});
    const hn_i_num3 middle(none, none, none), y = hn_i_row(d.y);
    const auto words_of = [&](auto... z) HN_I_INLINED {
      using Point = decltype(cells.cell);
      const auto word = [&](Uint cy) HN_I_INLINED { return seeded_hash(Point(cells.cell.x, cy, z...), s); };
      return uvec3(word(cells.previous.y), word(cells.cell.y), word(cells.following.y));
    };
    if constexpr (D == 2) {
      const uvec3 words = words_of();
      const hn_i_num3 from_x = hn_i_from_x(words, middle, jitter_), from_y = hn_i_from_y(words, y, jitter_);
      points_[0].put(column, kept(from_x.x, from_y.x));
      points_[1].put(column, kept(from_x.y, from_y.y));
      points_[2].put(column, kept(from_x.z, from_y.z));
    } else {
      const hn_i_num3 z = hn_i_row(d.z);
      const Uint cz[] = {cells.previous.z, cells.cell.z, cells.following.z};
      const hn_i_num offset[] = {z.x, z.y, z.z};
      for (int slab = 0; slab < 3; ++slab) {
        const uvec3 words = words_of(cz[slab]);
        const hn_i_num3 w = hn_i_from_z(words, hn_i_num3(offset[slab], offset[slab], offset[slab]), jitter_);
        // Along x, y and z with HN_FIXED, else along x + y, x - y and z, and the y of the row is left to the points.
        const hn_i_num3 across = HN_ARITHMETIC == HN_FIXED ? y : middle;
        const hn_i_num3 u = hn_i_from_u(words, middle, across, jitter_);
        const hn_i_num3 v = hn_i_from_v(words, middle, across, jitter_);
        points_[3 * slab].put(column, kept(u.x, v.x, w.x));
        points_[3 * slab + 1].put(column, kept(u.y, v.y, w.y));
        points_[3 * slab + 2].put(column, kept(u.z, v.z, w.z));
      }
    }
  }
  HN_I_INLINE vec2 noise(int column, Int index, const Place<D>& place) const {
    const auto d = hn_i_from_centre(place.fraction);
    const hn_i_num3 x = hn_i_row(d.x);
    [[maybe_unused]] const hn_i_num3 y = hn_i_row(d.y);
    auto best = hn_i_far_away();
    for (int row = 0; row < (D == 2 ? 3 : 9); ++row) {
      const auto rank = [&](hn_i_num along, int next) HN_I_INLINED {
        return square(points_[row].of(column + next, index), along, row % 3 == 0 ? y.x : row % 3 == 1 ? y.y : y.z);
      };
      best = hn_i_insert(best, hn_i_ranks(rank(x.x, -1), rank(x.y, 0), rank(x.z, 1)), 0, 1);
    }
    return hn_i_two_distances(best, HN_METRIC_EUCLIDEAN);
  }

 private:
#if HN_ARITHMETIC == HN_FIXED
  // A square as in square_root.glsl: by digits of 11 bits; the high one may be negative here.
  static constexpr int kNumbers = 3;
  HN_I_INLINE static Uint high_square(Int x) {
    const Uint high = Uint(x >> 11);
    return high * ((high << 10u) + Uint(x & 2047));
  }
  HN_I_INLINE static Uint low_square(Int x) { return Uint(x & 2047) * Uint(x & 2047); }
  HN_I_INLINE static ivec3 kept(Int x, Int y, Int z = Int(0)) {
    return ivec3(x, Int(high_square(y) + high_square(z)), Int(low_square(y) + low_square(z)));
  }
  HN_I_INLINE static Uint square(ivec3 point, Int x, Int) {
    const Int from = x + point.x;
    return Uint(point.y) + high_square(from) + ((Uint(point.z) + low_square(from)) >> 12u);
  }
#else
  static constexpr int kNumbers = D;
  HN_I_INLINE static vec2 kept(Float x, Float y) { return vec2(x, y * y); }
  HN_I_INLINE static Float square(vec2 point, Float x, Float) {
    const Float from = x + point.x;
    return from * from + point.y;
  }
  HN_I_INLINE static vec3 kept(Float u, Float v, Float z) { return vec3(u, v, z * z); }
  HN_I_INLINE static Float square(vec3 point, Float x, Float y) {
    const Float u = x + y + point.x, v = x - y + point.y;
    return (u * u + v * v) * 0.5f + point.z;
  }
#endif

  hn_i_num jitter_;
  InColumns<kNumbers, Number> points_[D == 2 ? 3 : 9];
};

#endif

// Some points of a row, from `start` on and before `end`: uses the noise at each vector of them, whose place place_at
// gives. earliest_at gives that of a single point. There are no more points than kPointsAtOnce.
template <typename Columns, typename EarliestAt, typename PlaceAt, typename Use>
HN_I_INLINE void over_columns(Columns& columns, int start, int end, Uint seed, const EarliestAt& earliest_at,
                              const PlaceAt& place_at, const Use& use) {
  Int lane;
  for (int i = 0; i < kCount; ++i) lane.v[i] = i;
  // Numbers wrap at 2^32, so the sign of their distance shows which is the lower one.
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

// Whether the columns of a row may reach the last cell, behind which the first one comes: its points are less than a
// cell from each other. A tile has a seam there: the next column has other corners than the cell.
HN_I_INLINE bool is_near_wrap(const Batch& row) {
  const std::int32_t reach = 2147483647 - 1024 - row.count, cell = row.cell[0][0];
  return cell < -reach || cell > reach;
}

HN_I_INLINE Float value_of(hn_i_num n) { return hn_i_value(n); }
HN_I_INLINE vec2 value_of(vec2 distances) { return distances; }

// Along a row whose points are no further from each other than Columns::kMostStep. tile_of gives the place in the noise
// without a period.
template <int D, typename Columns, typename TileOf>
HN_I_INLINE void along_columns(Columns& columns, const Batch& batch, Uint seed, const TileOf& tile_of) {
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
  for (int start = 0; start < b.count; start += kPointsAtOnce) {
    const int end = b.count - start < kPointsAtOnce ? b.count : start + kPointsAtOnce;
    over_columns(
        columns, start, end, seed, earliest_at, [&](int i) HN_I_INLINED { return tile_of(place_at(i)); },
        [&](int i, auto n) HN_I_INLINED { store(b, i, value_of(n)); });
  }
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise::inline HN_I_NAMESPACE
