// hashnoise: what the corners of a cell on the plane add to Perlin noise.
// SPDX-License-Identifier: MIT

#ifndef HN_RAMPS2D_GLSL
#define HN_RAMPS2D_GLSL

#include "cell2d.glsl"
#include "direction.glsl"
#if HN_GRADIENT == HN_GRADIENT_SINE
#include "sine_gradient.glsl"
#endif

// Each HN_GRADIENT offers these functions:
//
//   hn_i_ramps(box, f, seed)  what the corners 00, 10, 01, 11 of a cell add at the place f in it
//   hn_i_face2(n, x, y)       interpolates between such four by fades x and y
//   hn_i_scaled2(n)           noise that is interpolated between ramps, in [-1, 1]

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// From the words of the corners, where the gradients may have turned by a quarter.
HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num2 f, bool turned) {
  hn_float x = hn_i_offset(f.x);
  hn_float y = hn_i_offset(f.y);
  hn_float x1 = hn_i_far(x);
  hn_float y1 = hn_i_far(y);
  return hn_i_vector(hn_i_along2(hn_i_direction2(h.x, turned), x, y), hn_i_along2(hn_i_direction2(h.y, turned), x1, y),
                     hn_i_along2(hn_i_direction2(h.z, turned), x, y1),
                     hn_i_along2(hn_i_direction2(h.w, turned), x1, y1));
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_box2 box, hn_i_num2 f, hn_uint seed) {
  return hn_i_ramps(hn_i_corners(box, seed), f, false);
}

HN_FN hn_i_num hn_i_face2(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_edge2(n.x, n.y, x), hn_i_edge2(n.z, n.w, x), y);
}

// Noise before it is scaled, from the words of the corners and the fades.
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 h, hn_i_num2 f, hn_i_num2 t, bool turned) {
  return hn_i_face2(hn_i_ramps(h, f, turned), t.x, t.y);
}

// 1831 / 1024 is just below 1 / 0.55902: the largest value that a noise has before it is scaled, with turning gradients,
// too (tools/make bounds).
HN_FN hn_i_num hn_i_scaled2(hn_i_num n) { return hn_i_scaled(n, 1831); }

#endif

#endif
