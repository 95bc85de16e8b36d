// hashnoise: what the corners of a cell add to Perlin noise.
// SPDX-License-Identifier: MIT

#ifndef HN_RAMPS_GLSL
#define HN_RAMPS_GLSL

#include "cell.glsl"
#include "direction.glsl"
#include "sine_gradient.glsl"

// Each HN_GRADIENT offers these functions to a noise on the plane and in space:
//
//   hn_i_ramps(box, f, seed)          what the corners 00, 10, 01, 11 of a cell add at the place f in it
//   hn_i_ramps(box, f, back, seed)    in space, the same for the corners of its front face or of its back face along z
//   hn_i_face2(n, x, y)               interpolates between such four by fades x and y; hn_i_face3(n, x, y)
//   hn_i_scaled2(n), hn_i_scaled3(n)  noise that is interpolated between ramps, on the plane and in space, in [-1, 1]

HN_FN hn_i_num hn_i_scaled1(hn_i_num n) { return hn_i_scaled(n, 2048); }

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
HN_FN hn_i_num4 hn_i_ramps(hn_i_box2 box, hn_i_num2 f, hn_uint seed) {
  return hn_i_ramps(hn_i_corners(box, seed), f, false);
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_box3 box, hn_i_num3 f, bool back, hn_uint seed) {
  return hn_i_ramps(hn_i_corners(box, back, seed), f, back, false);
}

HN_FN hn_i_num hn_i_face2(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_edge2(n.x, n.y, x), hn_i_edge2(n.z, n.w, x), y);
}
HN_FN hn_i_num hn_i_face3(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_edge3(n.x, n.y, x), hn_i_edge3(n.z, n.w, x), y);
}

// Noise before it is scaled, from the words of the corners, in space of both faces, and the fades.
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 h, hn_i_num2 f, hn_i_num2 t, bool turned) {
  return hn_i_face2(hn_i_ramps(h, f, turned), t.x, t.y);
}
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 front, hn_uvec4 back, hn_i_num3 f, hn_i_num3 t, bool turned) {
  return hn_i_lerp(hn_i_face3(hn_i_ramps(front, f, false, turned), t.x, t.y),
                   hn_i_face3(hn_i_ramps(back, f, true, turned), t.x, t.y), t.z);
}

// 1831 / 1024 and 985 / 1024 are just below 1 / 0.55902 and 1 / 1.0385: the largest values that a noise has before it is
// scaled, on the plane and in space, with turning gradients, too (tools/make bounds). On the line it is 1/2.
HN_FN hn_i_num hn_i_scaled2(hn_i_num n) { return hn_i_scaled(n, 1831); }
HN_FN hn_i_num hn_i_scaled3(hn_i_num n) { return hn_i_scaled(n, 985); }

#endif

#endif
