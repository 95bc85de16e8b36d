// hashnoise: the points whose waves phasor noise sums on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR_POINTS2D_GLSL
#define HN_PHASOR_POINTS2D_GLSL

#include "phasor.glsl"
#include "triangular_lattice.glsl"

// The hashes of the corners of a triangle, the offsets from them, and how near they are; the wave and the phase of all.
struct hn_i_wave_points2 {
  hn_uvec3 h;
  hn_i_num3 x;
  hn_i_num3 y;
  hn_i_num3 t;
  hn_i_num2 k;
  hn_uint angle;
};
HN_FN hn_i_wave_points2 hn_i_wave_points(hn_place2 place, hn_vec2 wave, hn_float phase, hn_uint seed) {
  HN_I_NEW(hn_i_wave_points2, p);
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  p.h = hn_i_triangle(place, skewed, seed);
  p.x = hn_i_triangle_x(skewed);
  p.y = hn_i_triangle_y(skewed);
  p.t = hn_i_triangle_falloff(p.x, p.y);
  p.k = hn_i_vector(hn_i_waves(wave.x), hn_i_waves(wave.y));
  p.angle = hn_i_angle(phase);
  return p;
}

// A sum of waves is at most 1024 / 762 (tools/make bounds).
HN_FN hn_i_num2 hn_i_scaled_waves2(hn_i_num2 n) { return hn_i_vector(hn_i_scaled(n.x, 762), hn_i_scaled(n.y, 762)); }

#endif
