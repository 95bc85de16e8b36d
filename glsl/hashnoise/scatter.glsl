// hashnoise: scattered points that are no nearer to each other than a radius, without a list of them.
// SPDX-License-Identifier: MIT
//
// Each cell has a candidate: a random point of the cell. It is kept if no candidate within the radius has a larger
// hash. So the cells around it decide alone, and every program gets the same points.
//
// Everything in this file is exact: the same bits with every HN_ARITHMETIC and on every driver.
// docs/reference/contract.md, section 19, defines each value.

#ifndef HN_SCATTER_GLSL
#define HN_SCATTER_GLSL

#include "detail/block.glsl"
#include "numbers.glsl"

// The candidate of a cell with the hash h, in units of 2^-15 cells.
HN_FN hn_ivec2 hn_i_candidate2(hn_uint h) {
  hn_uint r = hn_rehash(h, 1u);
  return ivec2(int(r >> 17u), int((r >> 2u) & 32767u));
}
HN_FN hn_ivec3 hn_i_candidate3(hn_uint h) {
  hn_ivec2 p = hn_i_candidate2(h);
  return ivec3(p.x, p.y, int(hn_rehash(h, 2u) >> 17u));
}

// The square of the radius in these units.
HN_FN hn_uint hn_i_square_of_reach(hn_float radius) {
  hn_uint reach = uint(min(max(0.0f, radius), 1.0f) * 32768.0f);
  return reach * reach;
}

// The square of an offset. A longer one counts as 1 cell, where no radius reaches: so a sum of three fits a uint.
HN_FN hn_uint hn_i_square_below_cell(hn_int d) {
  hn_uint size = uint(min(max(d, d * -1), 32768));
  return size * size;
}

// The square of the distance to the nearest rival so far, and to one more, which has the hash rival and the square
// other. A rival whose hash is smaller than h does not count.
HN_FN hn_uint hn_i_nearest_rival(hn_uint square, hn_uint h, hn_uint rival, hn_uint other) {
  return hn_i_select(rival < h, square, min(square, other));
}

// The result for a candidate with the hash h, by the square of its nearest rival and of the reach.
HN_FN hn_uint hn_i_unbeaten(hn_uint h, hn_uint square, hn_uint reach) {
  hn_uint none = 0u;
  return hn_i_select(square < reach, none, hn_rehash(h, 5u) | 1u);
}

// The candidate point of a cell on the plane. hn_scattered returns whether it is kept.
//   cell     the cell: an ivec2
//   place    in place of the cell: hn_tile(hn_place(cell), period), for example (place.glsl). Its cell and period count
//   seed     any uint: 7u, not 7; different seeds give independent points
//   example  vec2 at = hn_scatter_point(ivec2(3, -5), 7u);
//   returns  where in the cell it is: [0, 1) along each axis, multiples of 2^-15; uniform
//   error    none
//   period   2^32 cells per axis, or the tile's
//   cost     1 hash (none with HN_HASH_LATTICE) and 7 multiplications; 2 more for a seed that is not constant
//   source   docs/reference/contract.md, section 19
HN_FN hn_vec2 hn_scatter_point(hn_place2 place, hn_uint seed) {
  hn_ivec2 cell = place.cell;
  if (place.tiled) cell = ivec2(hn_i_wrap(place.cell, place.period));
  hn_ivec2 p = hn_i_candidate2(hn_lattice(cell, seed));
  return vec2(hn_i_float(p.x), hn_i_float(p.y)) * (1.0f / 32768.0f);
}
HN_FN hn_vec2 hn_scatter_point(hn_ivec2 cell, hn_uint seed) { return hn_scatter_point(hn_place(cell), seed); }

// Whether the point of a cell on the plane is kept. No two kept points are nearer than the radius, so things at them do
// not overlap. Nothing is stored, and the order of the cells does not matter.
//   cell     the cell: an ivec2
//   place    in place of the cell: hn_tile(hn_place(cell), period), for example (place.glsl). A tile repeats without a
//            seam
//   radius   the least distance, in cells; in [0, 1], usually 0.5 to 1; numbers outside count as the nearer end. It is
//            cut off to a multiple of 2^-15
//   seed     any uint: 7u, not 7; as for hn_scatter_point
//   example  uint h = hn_scattered(ivec2(3, -5), 0.75, 7u);
//   returns  0 if the point is dropped; else a random hash of the point, which is odd
//   error    none
//   period   2^32 cells per axis, or the tile's
//   cost     9 hashes (none with HN_HASH_LATTICE) and 80 multiplications
//   source   Matern, "Spatial variation", 1960 (his second process); docs/reference/contract.md, section 19
HN_FN hn_uint hn_scattered(hn_place2 place, hn_float radius, hn_uint seed) {
  hn_i_neighbourhood2 cells = hn_i_neighbourhood(place);
  hn_uint s = hn_i_scramble(seed);
  hn_uint h = hn_i_lattice(cells.cell, s);
  hn_ivec2 own = hn_i_candidate2(h);
  hn_uint reach = hn_i_square_of_reach(radius);
  hn_uint nearest = reach;
  for (hn_int j = -1; j <= 1; ++j) {
    hn_uint y = hn_i_triple_at(hn_i_coordinates_y(cells), j);
    for (hn_int i = -1; i <= 1; ++i) {
      hn_uint x = hn_i_triple_at(hn_i_coordinates_x(cells), i);
      hn_uint rival = hn_i_lattice(uvec2(x, y), s);
      hn_ivec2 other = hn_i_candidate2(rival);
      hn_uint square =
          hn_i_square_below_cell(other.x - own.x + i * 32768) + hn_i_square_below_cell(other.y - own.y + j * 32768);
      if ((i | j) != 0) nearest = hn_i_nearest_rival(nearest, h, rival, square);
    }
  }
  return hn_i_unbeaten(h, nearest, reach);
}
HN_FN hn_uint hn_scattered(hn_ivec2 cell, hn_float radius, hn_uint seed) {
  return hn_scattered(hn_place(cell), radius, seed);
}

// The candidate point of a cell in space. hn_scattered returns whether it is kept.
//   cell     the cell: an ivec3
//   place    in place of the cell: hn_tile(hn_place(cell), period), for example (place.glsl)
//   seed     any uint: 7u, not 7; different seeds give independent points
//   example  vec3 at = hn_scatter_point(ivec3(3, -5, 2), 7u);
//   returns  where in the cell it is: [0, 1) along each axis, multiples of 2^-15; uniform
//   error    none
//   period   2^32 cells per axis, or the tile's
//   cost     1 hash (none with HN_HASH_LATTICE) and 10 multiplications; 2 more for a seed that is not constant
//   source   docs/reference/contract.md, section 19
HN_FN hn_vec3 hn_scatter_point(hn_place3 place, hn_uint seed) {
  hn_ivec3 cell = place.cell;
  if (place.tiled) cell = ivec3(hn_i_wrap(place.cell, place.period));
  hn_ivec3 p = hn_i_candidate3(hn_lattice(cell, seed));
  return vec3(hn_i_float(p.x), hn_i_float(p.y), hn_i_float(p.z)) * (1.0f / 32768.0f);
}
HN_FN hn_vec3 hn_scatter_point(hn_ivec3 cell, hn_uint seed) { return hn_scatter_point(hn_place(cell), seed); }

// Whether the point of a cell in space is kept. No two kept points are nearer than the radius.
//   cell     the cell: an ivec3
//   place    in place of the cell: hn_tile(hn_place(cell), period), for example (place.glsl)
//   radius   the least distance, in cells; in [0, 1], usually 0.5 to 1; numbers outside count as the nearer end. It is
//            cut off to a multiple of 2^-15
//   seed     any uint: 7u, not 7; as for hn_scatter_point
//   example  uint h = hn_scattered(ivec3(3, -5, 2), 0.75, 7u);
//   returns  0 if the point is dropped; else a random hash of the point, which is odd
//   error    none
//   period   2^32 cells per axis, or the tile's
//   cost     27 hashes (none with HN_HASH_LATTICE) and 330 multiplications
//   source   Matern, "Spatial variation", 1960 (his second process); docs/reference/contract.md, section 19
HN_FN hn_uint hn_scattered(hn_place3 place, hn_float radius, hn_uint seed) {
  hn_i_neighbourhood3 cells = hn_i_neighbourhood(place);
  hn_uint s = hn_i_scramble(seed);
  hn_uint h = hn_i_lattice(cells.cell, s);
  hn_ivec3 own = hn_i_candidate3(h);
  hn_uint reach = hn_i_square_of_reach(radius);
  hn_uint nearest = reach;
  for (hn_int k = -1; k <= 1; ++k) {
    hn_uint z = hn_i_triple_at(hn_i_coordinates_z(cells), k);
    for (hn_int j = -1; j <= 1; ++j) {
      hn_uint y = hn_i_triple_at(hn_i_coordinates_y(cells), j);
      for (hn_int i = -1; i <= 1; ++i) {
        hn_uint x = hn_i_triple_at(hn_i_coordinates_x(cells), i);
        hn_uint rival = hn_i_lattice(uvec3(x, y, z), s);
        hn_ivec3 other = hn_i_candidate3(rival);
        hn_uint square = hn_i_square_below_cell(other.x - own.x + i * 32768) +
                         hn_i_square_below_cell(other.y - own.y + j * 32768) +
                         hn_i_square_below_cell(other.z - own.z + k * 32768);
        if ((i | j | k) != 0) nearest = hn_i_nearest_rival(nearest, h, rival, square);
      }
    }
  }
  return hn_i_unbeaten(h, nearest, reach);
}
HN_FN hn_uint hn_scattered(hn_ivec3 cell, hn_float radius, hn_uint seed) {
  return hn_scattered(hn_place(cell), radius, seed);
}

#endif
