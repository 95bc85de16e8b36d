// hashnoise: random numbers of cells, in space.
// SPDX-License-Identifier: MIT
//
// Made from random2d.glsl by tools/make.

#ifndef HN_RANDOM3D_GLSL
#define HN_RANDOM3D_GLSL

// From here random1d.glsl, random3d.glsl and random4d.glsl are generated from random2d.glsl.

#include "hash.glsl"
#include "detail/cell.glsl"

// A random number for each cell: white noise, which jumps from one cell to the next. Place, colour and vary things with
// it: one for each tile, tree or brick.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell) of an ivec3, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent numbers
//   example  float n = hn_random(vec3(uv * 8.0, 0.5), 7u);
//   returns  [0, 1), a multiple of 2^-24, mean 1/2, uniform: hn_unorm(hn_lattice(cell, seed))
//   error    none. With HN_FIXED a negative coordinate less than 2^-20 below a whole number counts to the next cell
//   period   2^32 cells per axis, or the tile's
//   cost     1 hash (none with HN_HASH_LATTICE) and 3 multiplications; 1 more to spread each coordinate, and 2 more for
//            a seed that is not constant
//   source   docs/reference/contract.md, section 17
HN_FN hn_float hn_random(hn_place3 place, hn_uint seed) {
  hn_ivec3 cell = place.cell;
  if (place.tiled) cell = ivec3(hn_i_wrap(place.cell, place.period));
  return hn_unorm(hn_lattice(cell, seed));
}
HN_FN hn_float hn_random(hn_vec3 p, hn_uint seed) { return hn_random(hn_place(p), seed); }
HN_FN hn_float hn_random(hn_vec3 p) { return hn_random(p, 0u); }

// To here random1d.glsl, random3d.glsl and random4d.glsl are generated from random2d.glsl.

#endif
