// hashnoise: what the corners of a cell in space add to Perlin noise.
// SPDX-License-Identifier: MIT

#ifndef HN_RAMPS3D_GLSL
#define HN_RAMPS3D_GLSL

#include "cell.glsl"
#include "direction3d.glsl"
#if HN_GRADIENT == HN_GRADIENT_SINE
#include "sine_gradient.glsl"
#endif

// Each HN_GRADIENT offers these functions:
//
//   hn_i_ramps(box, f, back, seed)  what the corners of the front face of a cell, or of its back face along z, add at the
//                                   place f in it
//   hn_i_face3(n, x, y)             interpolates between such four by fades x and y
//   hn_i_scaled3(n)                 noise that is interpolated between ramps, in [-1, 1]

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// From the words of the corners of a face, where the gradients may have turned by a quarter.
HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num3 f, bool back, bool turned) {
  hn_float x = hn_i_offset(f.x);
  hn_float y = hn_i_offset(f.y);
  hn_float x1 = hn_i_far(x);
  hn_float y1 = hn_i_far(y);
  hn_float z = hn_i_offset(hn_i_select(back, hn_i_minus_one(f.z), f.z));
  return hn_i_vector(
      hn_i_along3(h.x, hn_i_signs(h.x, turned), x, y, z), hn_i_along3(h.y, hn_i_signs(h.y, turned), x1, y, z),
      hn_i_along3(h.z, hn_i_signs(h.z, turned), x, y1, z), hn_i_along3(h.w, hn_i_signs(h.w, turned), x1, y1, z));
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_box3 box, hn_i_num3 f, bool back, hn_uint seed) {
  return hn_i_ramps(hn_i_corners(box, back, seed), f, back, false);
}

HN_FN hn_i_num hn_i_face3(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_edge3(n.x, n.y, x), hn_i_edge3(n.z, n.w, x), y);
}

// Noise before it is scaled, from the words of the corners of both faces and the fades.
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 front, hn_uvec4 back, hn_i_num3 f, hn_i_num3 t, bool turned) {
  return hn_i_lerp(hn_i_face3(hn_i_ramps(front, f, false, turned), t.x, t.y),
                   hn_i_face3(hn_i_ramps(back, f, true, turned), t.x, t.y), t.z);
}

// 985 / 1024 is just below 1 / 1.0385: the largest value that a noise has before it is scaled, with turning gradients,
// too (tools/make bounds).
HN_FN hn_i_num hn_i_scaled3(hn_i_num n) { return hn_i_scaled(n, 985); }

#endif

#endif
