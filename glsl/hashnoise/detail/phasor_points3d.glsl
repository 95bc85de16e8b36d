// hashnoise: the points whose waves phasor noise sums in space.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR_POINTS3D_GLSL
#define HN_PHASOR_POINTS3D_GLSL

#include "body_centred_lattice.glsl"
#include "phasor.glsl"

// The hashes of the four points around a place, the offsets from them, and how near they are; the wave and the phase of
// all.
struct hn_i_wave_points3 {
  hn_uvec4 h;
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 t;
  hn_i_num3 k;
  hn_uint angle;
};
HN_FN hn_i_wave_points3 hn_i_wave_points(hn_place3 place, hn_vec3 wave, hn_float phase, hn_uint seed) {
  HN_I_NEW(hn_i_wave_points3, p);
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 t;
  p.h = hn_i_four_points(hn_i_neighbourhood(place), place.fraction, seed, x, y, z, t);
  p.x = x;
  p.y = y;
  p.z = z;
  p.t = t;
  p.k = hn_i_vector(hn_i_waves(wave.x), hn_i_waves(wave.y), hn_i_waves(wave.z));
  p.angle = hn_i_angle(phase);
  return p;
}

// A sum of waves is at most 1024 / 674 (tools/make bounds).
HN_FN hn_i_num2 hn_i_scaled_waves3(hn_i_num2 n) { return hn_i_vector(hn_i_scaled(n.x, 674), hn_i_scaled(n.y, 674)); }

#endif
