// hashnoise: places, where noises are evaluated.
// SPDX-License-Identifier: MIT
//
// Every noise and every fractal takes a position, or a place instead:
//
//   hn_perlin(p, 7u)                                   a position
//   hn_perlin(hn_place(cell, f), 7u)                   far out, where a float no longer names cells exactly
//   hn_perlin(hn_tile(p, ivec2(8, 5)), 7u)             a field that repeats after 8 by 5 cells
//   hn_perlin(hn_tile(hn_place(cell, f), period), 7u)  both
//   hn_fbm(hn_tile(p, period), 6, 2.0, 0.5, 7u)        and so on
//
// position.glsl makes places of positions that are integers. Compilers fold the members of a place that are constants:
// a place without a period costs no more than the position.

#ifndef HN_PLACE_GLSL
#define HN_PLACE_GLSL

#include "detail/cell2d.glsl"

// From here place.glsl is generated from detail/cell2d.glsl, in 3 and 4 dimensions.

#if HN_ARITHMETIC == HN_FAST
HN_FN hn_ivec3 hn_i_cell(hn_vec3 p) { return ivec3(floor(p)); }
HN_FN hn_ivec4 hn_i_cell(hn_vec4 p) { return ivec4(floor(p)); }
HN_FN hn_vec3 hn_i_fraction(hn_vec3 p) {
  HN_I_AS_WRITTEN hn_vec3 f = p - floor(p);
  return f;
}
HN_FN hn_vec4 hn_i_fraction(hn_vec4 p) {
  HN_I_AS_WRITTEN hn_vec4 f = p - floor(p);
  return f;
}
HN_FN hn_vec3 hn_i_to_num(hn_vec3 f) { return f; }
HN_FN hn_vec4 hn_i_to_num(hn_vec4 f) { return f; }
#else
HN_FN hn_ivec3 hn_i_cell(hn_vec3 p) { return ivec3(hn_i_cell(p.x), hn_i_cell(p.y), hn_i_cell(p.z)); }
HN_FN hn_ivec4 hn_i_cell(hn_vec4 p) { return ivec4(hn_i_cell(p.x), hn_i_cell(p.y), hn_i_cell(p.z), hn_i_cell(p.w)); }
HN_FN hn_i_num3 hn_i_fraction(hn_vec3 p) {
  return hn_i_vector(hn_i_fraction(p.x), hn_i_fraction(p.y), hn_i_fraction(p.z));
}
HN_FN hn_i_num4 hn_i_fraction(hn_vec4 p) {
  return hn_i_vector(hn_i_fraction(p.x), hn_i_fraction(p.y), hn_i_fraction(p.z), hn_i_fraction(p.w));
}
HN_FN hn_i_num3 hn_i_to_num(hn_vec3 f) { return hn_i_vector(hn_i_to_num(f.x), hn_i_to_num(f.y), hn_i_to_num(f.z)); }
HN_FN hn_i_num4 hn_i_to_num(hn_vec4 f) {
  return hn_i_vector(hn_i_to_num(f.x), hn_i_to_num(f.y), hn_i_to_num(f.z), hn_i_to_num(f.w));
}
#endif

// To here place.glsl is generated from detail/cell2d.glsl, in 3 and 4 dimensions.

// From here place.glsl is generated from detail/cell2d.glsl, in 1, 3 and 4 dimensions.

// Where a noise is evaluated. Make it by hn_place and hn_tile; only its cell may be read.
//   cell      the cell; cells wrap at 2^32
//   fraction  where in the cell it is, in the numbers of HN_ARITHMETIC
//   rest      what is beyond those numbers, in units of 2^-24 of a cell. Only fractals with HN_FIXED need it
//   period    cells along each axis
//   tiled     whether it has a period. Octaves are not rotated then, as they would not fit the tile
struct hn_place1 {
  HN_I_MADE(hn_place1)
  hn_int cell;
  hn_i_num fraction;
  hn_int rest;
  hn_int period;
  bool tiled;
};
struct hn_place3 {
  HN_I_MADE(hn_place3)
  hn_ivec3 cell;
  hn_i_num3 fraction;
  hn_ivec3 rest;
  hn_ivec3 period;
  bool tiled;
};
struct hn_place4 {
  HN_I_MADE(hn_place4)
  hn_ivec4 cell;
  hn_i_num4 fraction;
  hn_ivec4 rest;
  hn_ivec4 period;
  bool tiled;
};

// A place from its parts.
HN_FN hn_place1 hn_i_place(hn_int cell, hn_i_num fraction, hn_int rest) {
  HN_I_NEW(hn_place1, place);
  place.cell = cell;
  place.fraction = fraction;
  place.rest = rest;
  place.period = 0;
  place.tiled = false;
  return place;
}
HN_FN hn_place3 hn_i_place(hn_ivec3 cell, hn_i_num3 fraction, hn_ivec3 rest) {
  HN_I_NEW(hn_place3, place);
  place.cell = cell;
  place.fraction = fraction;
  place.rest = rest;
  place.period = ivec3(0, 0, 0);
  place.tiled = false;
  return place;
}
HN_FN hn_place4 hn_i_place(hn_ivec4 cell, hn_i_num4 fraction, hn_ivec4 rest) {
  HN_I_NEW(hn_place4, place);
  place.cell = cell;
  place.fraction = fraction;
  place.rest = rest;
  place.period = ivec4(0, 0, 0, 0);
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
HN_FN hn_place1 hn_place(hn_int cell, hn_float f) {
  return hn_i_place(cell, hn_i_to_num(f), HN_I_REST(hn_i_rest_of_fraction(f)));
}
HN_FN hn_place3 hn_place(hn_ivec3 cell, hn_vec3 f) {
  return hn_i_place(cell, hn_i_to_num(f),
                    ivec3(HN_I_REST(hn_i_rest_of_fraction(f.x)), HN_I_REST(hn_i_rest_of_fraction(f.y)),
                          HN_I_REST(hn_i_rest_of_fraction(f.z))));
}
HN_FN hn_place4 hn_place(hn_ivec4 cell, hn_vec4 f) {
  return hn_i_place(cell, hn_i_to_num(f),
                    ivec4(HN_I_REST(hn_i_rest_of_fraction(f.x)), HN_I_REST(hn_i_rest_of_fraction(f.y)),
                          HN_I_REST(hn_i_rest_of_fraction(f.z)), HN_I_REST(hn_i_rest_of_fraction(f.w))));
}

// A place from a cell alone: its first corner. So hn_random(hn_place(cell), seed) is the number of a cell.
//   cell     the cell: int, ivec2, ivec3 or ivec4
//   example  float n = hn_random(hn_place(ivec2(3, -5)), 7u);
//   returns  the place
//   error    none
//   cost     none
//   source   as above
HN_FN hn_place1 hn_place(hn_int cell) { return hn_i_place(cell, hn_i_to_num(0.0f), 0); }
HN_FN hn_place3 hn_place(hn_ivec3 cell) {
  return hn_i_place(cell, hn_i_to_num(vec3(0.0f, 0.0f, 0.0f)), ivec3(0, 0, 0));
}
HN_FN hn_place4 hn_place(hn_ivec4 cell) {
  return hn_i_place(cell, hn_i_to_num(vec4(0.0f, 0.0f, 0.0f, 0.0f)), ivec4(0, 0, 0, 0));
}

// A place from a position. hn_perlin(hn_place(p), seed) is hn_perlin(p, seed).
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   example  hn_place2 place = hn_place(uv * 8.0);
//   returns  the place
//   error    floats round the fraction of a small negative position
//   cost     as above
//   source   as above
HN_FN hn_place1 hn_place(hn_float p) {
  return hn_i_place(hn_i_cell(p), hn_i_fraction(p), HN_I_REST(hn_i_rest_of_position(p)));
}
HN_FN hn_place3 hn_place(hn_vec3 p) {
  return hn_i_place(hn_i_cell(p), hn_i_fraction(p),
                    ivec3(HN_I_REST(hn_i_rest_of_position(p.x)), HN_I_REST(hn_i_rest_of_position(p.y)),
                          HN_I_REST(hn_i_rest_of_position(p.z))));
}
HN_FN hn_place4 hn_place(hn_vec4 p) {
  return hn_i_place(hn_i_cell(p), hn_i_fraction(p),
                    ivec4(HN_I_REST(hn_i_rest_of_position(p.x)), HN_I_REST(hn_i_rest_of_position(p.y)),
                          HN_I_REST(hn_i_rest_of_position(p.z)), HN_I_REST(hn_i_rest_of_position(p.w))));
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
HN_FN hn_place1 hn_tile(hn_place1 place, hn_int period) {
  hn_place1 tile = place;
  tile.period = period;
  tile.tiled = true;
  return tile;
}
HN_FN hn_place3 hn_tile(hn_place3 place, hn_ivec3 period) {
  hn_place3 tile = place;
  tile.period = period;
  tile.tiled = true;
  return tile;
}
HN_FN hn_place4 hn_tile(hn_place4 place, hn_ivec4 period) {
  hn_place4 tile = place;
  tile.period = period;
  tile.tiled = true;
  return tile;
}
HN_FN hn_place1 hn_tile(hn_float p, hn_int period) { return hn_tile(hn_place(p), period); }
HN_FN hn_place3 hn_tile(hn_vec3 p, hn_ivec3 period) { return hn_tile(hn_place(p), period); }
HN_FN hn_place4 hn_tile(hn_vec4 p, hn_ivec4 period) { return hn_tile(hn_place(p), period); }

// The position of a place, for your own noise in a fractal.
//   place    the place
//   example  vec2 p = hn_position(hn_tile(uv * 8.0, ivec2(8, 8)));
//   returns  its cell and its fraction in one float along each axis
//   error    that of a float, far out
//   source   as of hn_place
HN_FN hn_float hn_position(hn_place1 place) { return hn_i_position_of(place.cell, place.fraction, place.rest); }
HN_FN hn_vec3 hn_position(hn_place3 place) {
  return vec3(hn_i_position_of(place.cell.x, place.fraction.x, place.rest.x),
              hn_i_position_of(place.cell.y, place.fraction.y, place.rest.y),
              hn_i_position_of(place.cell.z, place.fraction.z, place.rest.z));
}
HN_FN hn_vec4 hn_position(hn_place4 place) {
  return vec4(hn_i_position_of(place.cell.x, place.fraction.x, place.rest.x),
              hn_i_position_of(place.cell.y, place.fraction.y, place.rest.y),
              hn_i_position_of(place.cell.z, place.fraction.z, place.rest.z),
              hn_i_position_of(place.cell.w, place.fraction.w, place.rest.w));
}

// To here place.glsl is generated from detail/cell2d.glsl, in 1, 3 and 4 dimensions.

#endif
