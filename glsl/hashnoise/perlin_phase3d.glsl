// hashnoise: Perlin noise in space whose gradients rotate with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_PHASE3D_GLSL
#define HN_PERLIN_PHASE3D_GLSL

#include "detail/direction_turning.glsl"
#include "perlin_d3d.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The noise in the numbers of HN_ARITHMETIC. 879 / 1024 is below 1 / 1.1642: the largest value that it has before it is
// scaled (tools/make bounds), where all gradients around a place are in the middle between two edges.
HN_FN hn_i_num hn_i_perlin_phase(hn_i_cell_corners3 corners, hn_i_num3 f, hn_i_num2 rotation, hn_uint seed) {
  hn_uvec4 a = hn_i_corner_hashes(corners, false, seed);
  hn_uvec4 b = hn_i_corner_hashes(corners, true, seed);
  hn_i_num3 t = hn_i_fade(f);
  return hn_i_scaled(hn_i_mixed(rotation, hn_i_cell_of_ramps(a, b, f, t, false), hn_i_cell_of_ramps(a, b, f, t, true)),
                     879);
}

// The noise and its derivatives.
HN_FN hn_vec4 hn_i_perlin_phase_d(hn_i_cell_corners3 corners, hn_i_num3 f, hn_i_num2 rotation, hn_uint seed) {
  hn_uvec4 a = hn_i_corner_hashes(corners, false, seed);
  hn_uvec4 b = hn_i_corner_hashes(corners, true, seed);
  hn_i_num3 t = hn_i_fade(f);
  hn_i_num3 s = hn_i_d_fade(f);
  return hn_i_scaled_d(hn_i_mixed(rotation, hn_i_perlin_d(a, b, f, t, s, false), hn_i_perlin_d(a, b, f, t, s, true)),
                       879);
}

// Perlin noise in space whose gradients rotate with a phase: the field changes in place, and loops after one turn. Each
// rotates across a diagonal of a cell.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   phase    in turns, any float: the field of phase + 1 has the same bits, and at phase + 1/2 it is the negative
//            (HN_FIXED: but for the last bits). A float far from 0 has few bits left for the turn: pass fract(phase)
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  float n = hn_perlin(vec3(uv * 8.0, 0.5), 0.25, 7u);
//   returns  [-1, 1] (proven bound 0.99935), mean 0, 0 at lattice points, twice continuously differentiable, and smooth
//            in the phase. With a phase of 0 it is hn_perlin times 879/985, within the error.
//   error    at most 4.04e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.11e-4
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_perlin, a sine and a cosine of 6 multiplications of floats each, and twice the rest
//   source   Perlin and Neyret, "Flow noise", 2001; docs/reference/contract.md, section 14
HN_FN hn_float hn_perlin(hn_place3 place, hn_float phase, hn_uint seed) {
  return hn_i_value(hn_i_perlin_phase(hn_i_cell_corners(place), place.fraction, hn_i_rotation3(phase), seed));
}
HN_FN hn_float hn_perlin(hn_vec3 p, hn_float phase, hn_uint seed) { return hn_perlin(hn_place(p), phase, seed); }

// The noise with the derivatives along x, y and z, as of hn_perlin_d. The value is as above.
//   example  vec4 n = hn_perlin_d(vec3(uv * 8.0, 0.5), 0.25, 7u);
//   returns  the value and its derivatives, per cell, in [-3.34, 3.34]
//   error    of a derivative at most 1.17e-5. HN_FIXED 4.26e-4
//   cost     as above, and about twice the rest
//   (parameters as above)
HN_FN hn_vec4 hn_perlin_d(hn_place3 place, hn_float phase, hn_uint seed) {
  return hn_i_perlin_phase_d(hn_i_cell_corners(place), place.fraction, hn_i_rotation3(phase), seed);
}
HN_FN hn_vec4 hn_perlin_d(hn_vec3 p, hn_float phase, hn_uint seed) { return hn_perlin_d(hn_place(p), phase, seed); }

#endif
#endif
