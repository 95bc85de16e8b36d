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
//   hn_i_scaled2(n), hn_i_scaled3(n)  noise that is interpolated between ramps, on the plane and in space, in [-1, 1]

// 1365 / 1024 and 1228 / 1024 are 1 / 0.75 and 1 / 0.833334, rounded down. 0.75 and 0.833334 are the largest values
// that a noise has before it is scaled, on the plane and in space (tools/bounds). On the line it is 1/2.
HN_FN hn_i_num hn_i_scaled1(hn_i_num n) { return hn_i_scaled(n, 2048); }

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The same from the words of the corners.
HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num2 f) {
  hn_i_num x = hn_i_minus_one(f.x);
  hn_i_num y = hn_i_minus_one(f.y);
  return hn_i_vector(hn_i_ramp(hn_i_direction2(h.x), f.x, f.y), hn_i_ramp(hn_i_direction2(h.y), x, f.y),
                     hn_i_ramp(hn_i_direction2(h.z), f.x, y), hn_i_ramp(hn_i_direction2(h.w), x, y));
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_box2 box, hn_i_num2 f, hn_uint seed) { return hn_i_ramps(hn_i_corners(box, seed), f); }

// The ramps of a face, given the directions of its corners.
HN_FN hn_i_num4 hn_i_ramps(hn_i_num4 d00, hn_i_num4 d10, hn_i_num4 d01, hn_i_num4 d11, hn_i_num3 f, bool back) {
  hn_i_num x = hn_i_octahedral(f.x);
  hn_i_num y = hn_i_octahedral(f.y);
  hn_i_num step = hn_i_octahedral(HN_I_ONE);
  hn_i_num u = hn_i_plus(x, y);
  hn_i_num v = hn_i_minus(x, y);
  hn_i_num w = hn_i_octahedral_z(hn_i_select(back, hn_i_minus_one(f.z), f.z));
  hn_i_num u1 = hn_i_minus(u, step);
  return hn_i_vector(hn_i_ramp(d00, u, v, w), hn_i_ramp(d10, u1, hn_i_minus(v, step), w),
                     hn_i_ramp(d01, u1, hn_i_plus(v, step), w), hn_i_ramp(d11, hn_i_minus(u1, step), v, w));
}

HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num3 f, bool back) {
  return hn_i_ramps(hn_i_direction3(h.x), hn_i_direction3(h.y), hn_i_direction3(h.z), hn_i_direction3(h.w), f, back);
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_box3 box, hn_i_num3 f, bool back, hn_uint seed) {
  return hn_i_ramps(hn_i_corners(box, back, seed), f, back);
}

HN_FN hn_i_num hn_i_scaled2(hn_i_num n) { return hn_i_scaled(n, 1365); }
HN_FN hn_i_num hn_i_scaled3(hn_i_num n) { return hn_i_scaled(n, 1228); }

#endif

#endif
