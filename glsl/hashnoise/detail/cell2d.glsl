// hashnoise: places on the plane, and the cell of a place: its corners, with or without a period, and their hashes.
// place.glsl and cell.glsl have the other dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_CELL2D_GLSL
#define HN_CELL2D_GLSL

#include "arithmetic.glsl"

// The rest of a fraction and of a position, which the numbers of HN_ARITHMETIC do not hold; with floats it is 0. The
// rest of a position has its sign, as the result of hn_i_rest has.
#if HN_ARITHMETIC != HN_FIXED
#define HN_I_REST(rest) 0
#else
HN_FN hn_int hn_i_rest_of_fraction(hn_float f) {
  return int(min(max(0.0f, f), 1.0f) * HN_I_FLOAT_UNITS_POSITION) - hn_i_to_num(f) * 16;
}
HN_FN hn_int hn_i_rest_of_position(hn_float p) {
  return int(hn_i_beside_cell(p) * HN_I_FLOAT_UNITS_POSITION) - hn_i_rest(p) * 16;
}
#define HN_I_REST(rest) rest
#endif

// The position along one axis. Floats have no rest.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_position_of(hn_int cell, hn_float fraction, hn_int rest) {
  return hn_i_float(cell) + (fraction + hn_i_float(rest));
}
#else
HN_FN hn_float hn_i_position_of(hn_int cell, hn_int fraction, hn_int rest) {
  return hn_i_float(cell) + HN_I_NOT_WHOLE(hn_i_float(fraction * 16 + rest) * (1.0f / HN_I_FLOAT_UNITS_POSITION));
}
#endif

// From here place.glsl is generated from detail/cell2d.glsl, in 3 and 4 dimensions.

#if HN_ARITHMETIC == HN_FAST
HN_FN hn_ivec2 hn_i_cell(hn_vec2 p) { return ivec2(floor(p)); }
HN_FN hn_vec2 hn_i_fraction(hn_vec2 p) {
  HN_I_AS_WRITTEN hn_vec2 f = p - floor(p);
  return f;
}
HN_FN hn_vec2 hn_i_to_num(hn_vec2 f) { return f; }
#else
HN_FN hn_ivec2 hn_i_cell(hn_vec2 p) { return ivec2(hn_i_cell(p.x), hn_i_cell(p.y)); }
HN_FN hn_i_num2 hn_i_fraction(hn_vec2 p) { return hn_i_vector(hn_i_fraction(p.x), hn_i_fraction(p.y)); }
HN_FN hn_i_num2 hn_i_to_num(hn_vec2 f) { return hn_i_vector(hn_i_to_num(f.x), hn_i_to_num(f.y)); }
#endif

// To here place.glsl is generated from detail/cell2d.glsl, in 3 and 4 dimensions.

// From here place.glsl is generated from detail/cell2d.glsl, in 1, 3 and 4 dimensions.

// Where a noise is evaluated. Make it by hn_place and hn_tile; only its cell may be read.
//   cell      the cell; cells wrap at 2^32
//   fraction  where in the cell it is, in the numbers of HN_ARITHMETIC
//   rest      what is beyond those numbers, in units of 2^-24 of a cell. Only fractals with HN_FIXED need it
//   period    cells along each axis
//   tiled     whether it has a period. Octaves are not rotated then, as they would not fit the tile
struct hn_place2 {
  HN_I_MADE(hn_place2)
  hn_ivec2 cell;
  hn_i_num2 fraction;
  hn_ivec2 rest;
  hn_ivec2 period;
  bool tiled;
};

// A place from its parts.
HN_FN hn_place2 hn_i_place(hn_ivec2 cell, hn_i_num2 fraction, hn_ivec2 rest) {
  HN_I_NEW(hn_place2, place);
  place.cell = cell;
  place.fraction = fraction;
  place.rest = rest;
  place.period = ivec2(0, 0);
  place.tiled = false;
  return place;
}

// A place from a cell and a position in it, for large worlds, or worlds that move with the viewer: it names cells
// exactly where a float no longer can.
//   cell     the cell: int, ivec2, ivec3 or ivec4; cells wrap at 2^32
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED and fractals take the nearer end, and for floats
//            of other noises no value is defined
//   example  hn_place2 place = hn_place(ivec2(3, -5), vec2(0.25, 0.75));
//   returns  the place
//   error    none: this loses nothing that the noise does not
//   cost     none that the noise does not have
//   source   docs/reference/contract.md, section 6
HN_FN hn_place2 hn_place(hn_ivec2 cell, hn_vec2 f) {
  return hn_i_place(cell, hn_i_to_num(f),
                    ivec2(HN_I_REST(hn_i_rest_of_fraction(f.x)), HN_I_REST(hn_i_rest_of_fraction(f.y))));
}

// A place from a cell alone: its first corner. So hn_random(hn_place(cell), seed) is the number of a cell.
//   cell     the cell: int, ivec2, ivec3 or ivec4
//   example  float n = hn_random(hn_place(ivec2(3, -5)), 7u);
//   returns  the place
//   error    none
//   cost     none
//   source   as above
HN_FN hn_place2 hn_place(hn_ivec2 cell) { return hn_i_place(cell, hn_i_to_num(vec2(0.0f, 0.0f)), ivec2(0, 0)); }

// A place from a position. hn_perlin(hn_place(p), seed) is hn_perlin(p, seed).
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   example  hn_place2 place = hn_place(uv * 8.0);
//   returns  the place
//   error    floats round the fraction of a small negative position
//   cost     as above
//   source   as above
HN_FN hn_place2 hn_place(hn_vec2 p) {
  return hn_i_place(hn_i_cell(p), hn_i_fraction(p),
                    ivec2(HN_I_REST(hn_i_rest_of_position(p.x)), HN_I_REST(hn_i_rest_of_position(p.y))));
}

// A place in a tile, so that a noise or a fractal repeats after its period, without a seam. Corners and points have the
// hashes of their coordinates modulo the period.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) or hn_place(cell)
//   period   cells along each axis: int, ivec2, ivec3 or ivec4; 0 for none along that axis. Less than 0 is none, too
//   example  float n = hn_perlin(hn_tile(uv * 8.0, ivec2(8, 8)), 7u);
//   returns  the place
//   error    none
//   cost     for the noise a mask along each axis if the period is a constant power of two, else a division; a few
//            comparisons along each axis, and for simplex and cellular noise up to two multiplications
//   source   docs/reference/contract.md, section 6
HN_FN hn_place2 hn_tile(hn_place2 place, hn_ivec2 period) {
  hn_place2 tile = place;
  tile.period = period;
  tile.tiled = true;
  return tile;
}
HN_FN hn_place2 hn_tile(hn_vec2 p, hn_ivec2 period) { return hn_tile(hn_place(p), period); }

// The position of a place, for your own noise in a fractal.
//   place    the place
//   example  vec2 p = hn_position(hn_tile(uv * 8.0, ivec2(8, 8)));
//   returns  its cell and its fraction in one float along each axis
//   error    that of a float, far out
//   source   as of hn_place
HN_FN hn_vec2 hn_position(hn_place2 place) {
  return vec2(hn_i_position_of(place.cell.x, place.fraction.x, place.rest.x),
              hn_i_position_of(place.cell.y, place.fraction.y, place.rest.y));
}

// To here place.glsl is generated from detail/cell2d.glsl, in 1, 3 and 4 dimensions.

// The upper corner of a cell, from its lower corner, both by their spread coordinates. Along an axis the upper one is a
// step further. Without a period a step adds a constant.
HN_FN hn_uint hn_i_upper(hn_uint lower) { return lower + HN_I_STEP_X; }
HN_FN hn_uvec2 hn_i_upper(hn_uvec2 lower) { return uvec2(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y); }

// A coordinate in [0, period); without a period (0, or less) the coordinate as it is. For a power of two it is a mask,
// and for no period, too. For others it is the remainder of floored division. GLSL leaves % of negative numbers
// undefined, so these count back from -1. If the period is a constant, then one of the two is left.
HN_FN hn_uint hn_i_wrap(hn_int c, hn_int period) {
  hn_uint size = uint(max(period, 0));
  hn_uint mask = size - 1u;
  hn_uint rest = uint(hn_i_select(c < 0, -1 - c, c)) % max(size, 1u);
  rest = hn_i_select(c < 0, mask - rest, rest);
  return hn_i_select((size & mask) == 0u, uint(c) & mask, rest);
}

// The spread coordinate of an upper corner. In the last cell of a period it is the argument zero, the spread
// coordinate of 0; in any other it is upper.
HN_FN hn_uint hn_i_upper_at_seam(hn_uint upper, hn_uint c, hn_int period, hn_uint zero) {
  return hn_i_select(c + 1u == uint(max(period, 0)), zero, upper);
}

// The upper corner of a cell with a period. c has the wrapped coordinates of the cell, and hn_i_spread(c) is its lower
// corner.
HN_FN hn_uint hn_i_upper(hn_uint lower, hn_uint c, hn_int period) {
  return hn_i_upper_at_seam(hn_i_upper(lower), c, period, HN_I_ORIGIN_X);
}
HN_FN hn_uvec2 hn_i_upper(hn_uvec2 lower, hn_uvec2 c, hn_ivec2 period) {
  hn_uvec2 upper = hn_i_upper(lower);
  return uvec2(hn_i_upper(lower.x, c.x, period.x), hn_i_upper_at_seam(upper.y, c.y, period.y, 0u));
}

// The hashes of the corners 00, 10, 01, 11 of a square. c0 and c1 are the spread coordinates of its lower and upper
// corner. Other axes and the seed add join to the exclusive or. The first corner has the odd number odd, and all
// four add the even number more. Without a period that number and the steps along x and y are constants, so they are
// added first.
HN_FN hn_uvec4 hn_i_corner_hashes(hn_uvec2 c0, hn_uvec2 c1, hn_uint join, hn_uint odd, hn_uint more) {
  hn_uvec2 a = hn_i_high(c0);
  hn_uvec2 b = hn_i_high(c1);
  a.y ^= join;
  b.y ^= join;
  hn_uint x = hn_i_odd_x(hn_i_step_x(c0.x, c1.x), 0u);
  hn_uint y = hn_i_odd_y(c1.y - c0.y, 0u);
  return uvec4(hn_i_point_hash(a.x ^ a.y, odd + more), hn_i_point_hash(b.x ^ a.y, odd + (x + more)),
               hn_i_point_hash(a.x ^ b.y, odd + (y + more)), hn_i_point_hash(b.x ^ b.y, odd + (x + y + more)));
}

// From here cell.glsl is generated from cell2d.glsl, in 3 and 4 dimensions.

// The fade of a fraction along each axis.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_vec2 hn_i_fade(hn_vec2 f) {
  HN_I_AS_WRITTEN hn_vec2 d = f - 1.0f;
  HN_I_PRECISE hn_vec2 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}
#else
HN_FN hn_ivec2 hn_i_fade(hn_ivec2 f) { return ivec2(hn_i_fade(f.x), hn_i_fade(f.y)); }
#endif

HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 c, hn_ivec2 period) {
  return uvec2(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y));
}

// To here cell.glsl is generated from cell2d.glsl, in 3 and 4 dimensions.

// From here cell.glsl is generated from cell2d.glsl, in 1, 3 and 4 dimensions.

// The spread coordinates of the lower and the upper corner of a cell, wrapped where it has a period. All lattice noises
// are functions of the corners and of the place between them.
struct hn_i_cell_corners2 {
  hn_uvec2 lower;
  hn_uvec2 upper;
};

HN_FN hn_i_cell_corners2 hn_i_cell_corners(hn_place2 place) {
  HN_I_NEW(hn_i_cell_corners2, corners);
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    corners.lower = hn_i_spread(c);
    corners.upper = hn_i_upper(corners.lower, c, place.period);
  } else {
    corners.lower = hn_i_spread(uvec2(place.cell));
    corners.upper = hn_i_upper(corners.lower);
  }
  return corners;
}

// To here cell.glsl is generated from cell2d.glsl, in 1, 3 and 4 dimensions.

HN_FN hn_uvec4 hn_i_corner_hashes(hn_i_cell_corners2 corners, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  return hn_i_corner_hashes(corners.lower, corners.upper, hn_i_seed_join(s), hn_i_odd(corners.lower, s), 0u);
}

#endif
