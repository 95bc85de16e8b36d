// hashnoise: phasor noise and its derivatives in space.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR_D3D_GLSL
#define HN_PHASOR_D3D_GLSL

#include "detail/phasor_points3d.glsl"

// The waves around lattice points, weighted, and how they fall along each axis.
struct hn_i_waves3 {
  hn_i_num2 n;
  hn_i_num2 x;
  hn_i_num2 y;
  hn_i_num2 z;
};
HN_FN hn_i_waves3 hn_i_waves_at(hn_uint angle, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num t) {
  HN_I_NEW(hn_i_waves3, s);
  hn_i_num2 wave = hn_i_unit_wave(angle);
  hn_i_num2 fall = hn_i_weighted_wave(wave, hn_i_d_weight_wave(t, 2));
  s.n = hn_i_weighted_wave(wave, hn_i_weight_wave(t));
  s.x = hn_i_falling_wave(fall, x);
  s.y = hn_i_falling_wave(fall, y);
  s.z = hn_i_falling_wave(fall, z);
  return s;
}
HN_FN hn_i_waves3 hn_i_plus(hn_i_waves3 a, hn_i_waves3 b) {
  HN_I_NEW(hn_i_waves3, s);
  s.n = hn_i_plus(a.n, b.n);
  s.x = hn_i_plus(a.x, b.x);
  s.y = hn_i_plus(a.y, b.y);
  s.z = hn_i_plus(a.z, b.z);
  return s;
}
// These with a wave of the point, and how they turn along each axis.
struct hn_i_own_waves3 {
  hn_i_waves3 waves;
  hn_i_num2 x;
  hn_i_num2 y;
  hn_i_num2 z;
};
HN_FN hn_i_own_waves3 hn_i_own_waves_at(hn_uint angle, hn_i_num3 k, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num t) {
  HN_I_NEW(hn_i_own_waves3, s);
  s.waves = hn_i_waves_at(angle + hn_i_waves_from(k, x, y, z), x, y, z, t);
  s.x = hn_i_own_turning(s.waves.n, k.x);
  s.y = hn_i_own_turning(s.waves.n, k.y);
  s.z = hn_i_own_turning(s.waves.n, k.z);
  return s;
}
HN_FN hn_i_own_waves3 hn_i_plus(hn_i_own_waves3 a, hn_i_own_waves3 b) {
  HN_I_NEW(hn_i_own_waves3, s);
  s.waves = hn_i_plus(a.waves, b.waves);
  s.x = hn_i_plus(a.x, b.x);
  s.y = hn_i_plus(a.y, b.y);
  s.z = hn_i_plus(a.z, b.z);
  return s;
}
HN_FN hn_i_num2 hn_i_scaled_fall3(hn_i_num2 n) {
  hn_i_num2 fall = hn_i_scaled_waves3(n);
  return hn_i_vector(hn_i_of_fall(fall.x, 1), hn_i_of_fall(fall.y, 1));
}

// Phasor noise in space and its slopes: the value and the quadrature of hn_phasor with their derivatives.
//   (parameters as for hn_phasor in phasor3d.glsl)
//   example  hn_derivatives2x3 n = hn_phasor_d(vec3(uv * 8.0, 0.5), vec3(4.0, 0.0, 0.0), 0.25, 7u);
//   returns  value, and in dx, dy and dz the derivatives of both along x, y and z, per cell, at a constant wave and
//            phase: in [-100.5, 100.5] for the largest waves, once continuously differentiable (HN_FIXED: in steps of
//            2^-16)
//   error    hn_phasor's, and of a derivative at most 3.94e-3 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 5.23e-2. From a cell at most 2.90e-3
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes and sines of hn_phasor, which are most of its cost, and about twice the rest
//   source   the product rule on weight and wave; docs/reference/contract.md, section 23
HN_FN hn_derivatives2x3 hn_phasor_d(hn_place3 place, hn_vec3 wave, hn_float phase, hn_uint seed) {
  hn_i_wave_points3 p = hn_i_wave_points(place, wave, phase, seed);
  hn_i_waves3 s =
      hn_i_waves_at(p.h.x + p.angle + hn_i_waves_from(p.k, p.x.x, p.y.x, p.z.x), p.x.x, p.y.x, p.z.x, p.t.x);
  s = hn_i_plus(s,
                hn_i_waves_at(p.h.y + p.angle + hn_i_waves_from(p.k, p.x.y, p.y.y, p.z.y), p.x.y, p.y.y, p.z.y, p.t.y));
  s = hn_i_plus(s,
                hn_i_waves_at(p.h.z + p.angle + hn_i_waves_from(p.k, p.x.z, p.y.z, p.z.z), p.x.z, p.y.z, p.z.z, p.t.z));
  s = hn_i_plus(s,
                hn_i_waves_at(p.h.w + p.angle + hn_i_waves_from(p.k, p.x.w, p.y.w, p.z.w), p.x.w, p.y.w, p.z.w, p.t.w));
  hn_i_num2 n = hn_i_scaled_waves3(s.n);
  HN_I_NEW(hn_derivatives2x3, d);
  d.value = vec2(hn_i_value(n.x), hn_i_value(n.y));
  d.dx = hn_i_wave_slopes(n, hn_i_scaled_fall3(s.x), p.k.x);
  d.dy = hn_i_wave_slopes(n, hn_i_scaled_fall3(s.y), p.k.y);
  d.dz = hn_i_wave_slopes(n, hn_i_scaled_fall3(s.z), p.k.z);
  return d;
}
HN_FN hn_derivatives2x3 hn_phasor_d(hn_vec3 p, hn_vec3 wave, hn_float phase, hn_uint seed) {
  return hn_phasor_d(hn_place(p), wave, phase, seed);
}

// Phasor noise with a bandwidth in space and its slopes: the value and the quadrature of hn_phasor with their
// derivatives.
//   (other parameters as for hn_phasor in phasor3d.glsl)
//   bandwidth  how far the wave of each point is from the argument wave, in a direction of its own, in waves per cell.
//              Outside [0, 16] it counts as the nearer end
//   example  hn_derivatives2x3 n = hn_phasor_d(vec3(uv * 8.0, 0.5), vec3(4.0, 0.0, 0.0), 1.0, 0.25, 7u);
//   returns  value, and in dx, dy and dz the derivatives of both along x, y and z, per cell, at a constant wave,
//   bandwidth
//            and phase: in [-100.6, 100.6] for the largest waves, once continuously differentiable (HN_FIXED: in
//            steps of 2^-16)
//   error    hn_phasor's, and of a derivative at most 3.74e-3 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 6.80e-2. From a cell at most 3.30e-3
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes and sines of hn_phasor with a bandwidth, which are most of its cost, and about twice the rest
//   source   the product rule on weight and wave; docs/reference/contract.md, section 23
HN_FN hn_derivatives2x3 hn_phasor_d(hn_place3 place, hn_vec3 wave, hn_float bandwidth, hn_float phase, hn_uint seed) {
  hn_i_wave_points3 p = hn_i_wave_points(place, wave, phase, seed);
  hn_i_num b = hn_i_bandwidth(bandwidth);
  hn_i_own_waves3 s = hn_i_own_waves_at(p.h.x + p.angle, hn_i_own_waves(p.k, b, p.h.x), p.x.x, p.y.x, p.z.x, p.t.x);
  s = hn_i_plus(s, hn_i_own_waves_at(p.h.y + p.angle, hn_i_own_waves(p.k, b, p.h.y), p.x.y, p.y.y, p.z.y, p.t.y));
  s = hn_i_plus(s, hn_i_own_waves_at(p.h.z + p.angle, hn_i_own_waves(p.k, b, p.h.z), p.x.z, p.y.z, p.z.z, p.t.z));
  s = hn_i_plus(s, hn_i_own_waves_at(p.h.w + p.angle, hn_i_own_waves(p.k, b, p.h.w), p.x.w, p.y.w, p.z.w, p.t.w));
  hn_i_num2 n = hn_i_scaled_waves3(s.waves.n);
  HN_I_NEW(hn_derivatives2x3, d);
  d.value = vec2(hn_i_value(n.x), hn_i_value(n.y));
  d.dx = hn_i_own_wave_slopes(hn_i_scaled_fall3(s.waves.x), s.x, 674);
  d.dy = hn_i_own_wave_slopes(hn_i_scaled_fall3(s.waves.y), s.y, 674);
  d.dz = hn_i_own_wave_slopes(hn_i_scaled_fall3(s.waves.z), s.z, 674);
  return d;
}
HN_FN hn_derivatives2x3 hn_phasor_d(hn_vec3 p, hn_vec3 wave, hn_float bandwidth, hn_float phase, hn_uint seed) {
  return hn_phasor_d(hn_place(p), wave, bandwidth, phase, seed);
}

#endif
