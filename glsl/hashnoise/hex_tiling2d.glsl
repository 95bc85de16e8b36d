// hashnoise: three weighted patches around each position, for textures that do not repeat (hex tiling).
// SPDX-License-Identifier: MIT

#ifndef HN_HEX_TILING2D_GLSL
#define HN_HEX_TILING2D_GLSL

#include "detail/triangular_lattice.glsl"
#include "hash.glsl"

// The three hexagons that overlap at a position, a component for each. Their centres are the corners of a triangle.
struct hn_hexes {
  hn_vec3 weights;  // not negative; their sum is 1
  hn_uvec3 words;   // a random hash for each hexagon: hn_lattice of its centre
  hn_vec3 x;        // from the centres to the position, in cells: (x.x, y.x) is the vector from the first, and so on
  hn_vec3 y;
};

// A number of a fraction as a float, which is exact. No 0 is negative.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_fraction_to_float(hn_float f) { return hn_i_flushed(f); }
#else
HN_FN hn_float hn_i_fraction_to_float(hn_int f) {
  return HN_I_NOT_WHOLE(hn_i_float(f) * (1.0f / HN_I_FLOAT_UNITS_FRACTION));
}
#endif
HN_FN hn_float hn_i_in_cells(hn_i_num step) { return hn_i_fraction_to_float(step) * 0.5f; }  // a step is half a cell
HN_FN hn_vec3 hn_i_in_cells(hn_i_num3 steps) {
  return vec3(hn_i_in_cells(steps.x), hn_i_in_cells(steps.y), hn_i_in_cells(steps.z));
}

// Hex tiling, for textures that never repeat: the three hexagons that overlap at a position, with their weights. Each
// has a random hash of its own. Sample your texture three times, moved and rotated by the hashes, and mix the samples
// by the weights. No seam shows, since a hexagon changes where its weight is 0. Hexagons are one cell wide and one
// high; docs/guide/hex-tiling.md has two ways of mixing.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; different seeds give independent hashes
//   example  hn_hexes n = hn_hex_tiling(uv * 8.0, 7u);
//   returns  weights, hashes (words) and offsets (x, y). The weights are in [0, 1], continuous, and change by at most
//            sqrt(5) per cell; an offset is at most 0.56 long
//   error    at most 4.77e-7 against the exact weights, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            2.87e-6. From a cell at most 2.99e-7; of the offset at most 2.38e-7. HN_FIXED 9.54e-7. Where a corner
//            changes, up to the error, it may be either
//   period   2^31 cells per axis, or the tile's
//   cost     3 hashes (none with HN_HASH_LATTICE) and 12 multiplications; 2 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Heitz and Neyret, "High-performance by-example noise using a histogram-preserving blending operator",
//            2018, for the three weights; docs/reference/contract.md, section 20
HN_FN hn_hexes hn_hex_tiling(hn_place2 place, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  hn_i_triangle2 corners = hn_i_triangle(place, skewed);
  hn_i_num u = hn_i_fract(skewed.x);
  hn_i_num v = hn_i_fract(skewed.y);
  hn_i_num most = max(u, v);
  hn_i_num least = min(u, v);
  hn_uint s = hn_i_scramble(seed);
  HN_I_NEW(hn_hexes, hexes);
  hexes.weights = vec3(hn_i_fraction_to_float(hn_i_minus(HN_I_ONE, most)),
                       hn_i_fraction_to_float(hn_i_minus(most, least)), hn_i_fraction_to_float(least));
  hexes.words = uvec3(hn_i_lattice(corners.first, s), hn_i_lattice(corners.middle, s), hn_i_lattice(corners.last, s));
  hexes.x = hn_i_in_cells(hn_i_triangle_x(skewed));
  hexes.y = hn_i_in_cells(hn_i_triangle_y(skewed));
  return hexes;
}
HN_FN hn_hexes hn_hex_tiling(hn_vec2 p, hn_uint seed) { return hn_hex_tiling(hn_place(p), seed); }

#endif
