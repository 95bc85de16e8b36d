// hashnoise: phasor noise and its derivatives on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR_D2D_GLSL
#define HN_PHASOR_D2D_GLSL

#include "detail/phasor_points2d.glsl"

// The waves around lattice points, weighted, and how they fall along each axis.
struct hn_i_waves2 {
  hn_i_num2 n;
  hn_i_num2 x;
  hn_i_num2 y;
};
HN_FN hn_i_waves2 hn_i_waves_at(hn_uint angle, hn_i_num x, hn_i_num y, hn_i_num t) {
  HN_I_NEW(hn_i_waves2, s);
  hn_i_num2 wave = hn_i_unit_wave(angle);
  hn_i_num2 fall = hn_i_weighted_wave(wave, hn_i_d_weight_wave(t, 1));
  s.n = hn_i_weighted_wave(wave, hn_i_weight_wave(t));
  s.x = hn_i_falling_wave(fall, x);
  s.y = hn_i_falling_wave(fall, y);
  return s;
}
HN_FN hn_i_waves2 hn_i_plus(hn_i_waves2 a, hn_i_waves2 b) {
  HN_I_NEW(hn_i_waves2, s);
  s.n = hn_i_plus(a.n, b.n);
  s.x = hn_i_plus(a.x, b.x);
  s.y = hn_i_plus(a.y, b.y);
  return s;
}
// These with a wave of the point, and how they turn along each axis.
struct hn_i_own_waves2 {
  hn_i_waves2 waves;
  hn_i_num2 x;
  hn_i_num2 y;
};
HN_FN hn_i_own_waves2 hn_i_own_waves_at(hn_uint angle, hn_i_num2 k, hn_i_num x, hn_i_num y, hn_i_num t) {
  HN_I_NEW(hn_i_own_waves2, s);
  s.waves = hn_i_waves_at(angle + hn_i_waves_from(k, x, y), x, y, t);
  s.x = hn_i_own_turning(s.waves.n, k.x);
  s.y = hn_i_own_turning(s.waves.n, k.y);
  return s;
}
HN_FN hn_i_own_waves2 hn_i_plus(hn_i_own_waves2 a, hn_i_own_waves2 b) {
  HN_I_NEW(hn_i_own_waves2, s);
  s.waves = hn_i_plus(a.waves, b.waves);
  s.x = hn_i_plus(a.x, b.x);
  s.y = hn_i_plus(a.y, b.y);
  return s;
}
HN_FN hn_i_num2 hn_i_scaled_fall2(hn_i_num2 n) {
  hn_i_num2 fall = hn_i_scaled_waves2(n);
  return hn_i_vector(hn_i_of_fall(fall.x, 2), hn_i_of_fall(fall.y, 2));
}

// Phasor noise on the plane and its slopes: the value and the quadrature of hn_phasor with their derivatives.
//   (parameters as for hn_phasor in phasor2d.glsl)
//   example  hn_derivatives2x2 n = hn_phasor_d(uv * 8.0, vec2(4.0, 0.0), 0.25, 7u);
//   returns  value, and in dx and dy the derivatives of both along x and y, per cell, at a constant wave and phase: in
//            [-100.6, 100.6] for the largest waves, once continuously differentiable (HN_FIXED: in steps of 2^-16)
//   error    hn_phasor's, and of a derivative at most 4.43e-3 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 3.81e-2. From a cell at most 3.22e-3
//   period   2^31 cells per axis, or the tile's
//   cost     the hashes and sines of hn_phasor, which are most of its cost, and about twice the rest
//   source   the product rule on weight and wave; docs/reference/contract.md, section 23
HN_FN hn_derivatives2x2 hn_phasor_d(hn_place2 place, hn_vec2 wave, hn_float phase, hn_uint seed) {
  hn_i_wave_points2 p = hn_i_wave_points(place, wave, phase, seed);
  hn_i_waves2 s = hn_i_waves_at(p.h.x + p.angle + hn_i_waves_from(p.k, p.x.x, p.y.x), p.x.x, p.y.x, p.t.x);
  s = hn_i_plus(s, hn_i_waves_at(p.h.y + p.angle + hn_i_waves_from(p.k, p.x.y, p.y.y), p.x.y, p.y.y, p.t.y));
  s = hn_i_plus(s, hn_i_waves_at(p.h.z + p.angle + hn_i_waves_from(p.k, p.x.z, p.y.z), p.x.z, p.y.z, p.t.z));
  hn_i_num2 n = hn_i_scaled_waves2(s.n);
  HN_I_NEW(hn_derivatives2x2, d);
  d.value = vec2(hn_i_value(n.x), hn_i_value(n.y));
  d.dx = hn_i_wave_slopes(n, hn_i_scaled_fall2(s.x), p.k.x);
  d.dy = hn_i_wave_slopes(n, hn_i_scaled_fall2(s.y), p.k.y);
  return d;
}
HN_FN hn_derivatives2x2 hn_phasor_d(hn_vec2 p, hn_vec2 wave, hn_float phase, hn_uint seed) {
  return hn_phasor_d(hn_place(p), wave, phase, seed);
}

// Phasor noise with a bandwidth and its slopes: the value and the quadrature of hn_phasor with their derivatives.
//   (other parameters as for hn_phasor in phasor2d.glsl)
//   bandwidth  how far the wave of each point is from the argument wave, in a direction of its own, in waves per cell.
//              Outside [0, 16] it counts as the nearer end
//   example  hn_derivatives2x2 n = hn_phasor_d(uv * 8.0, vec2(4.0, 0.0), 1.0, 0.25, 7u);
//   returns  value, and in dx and dy the derivatives of both along x and y, per cell, at a constant wave, bandwidth
//            and phase: in [-100.6, 100.6] for the largest waves, once continuously differentiable (HN_FIXED: in
//            steps of 2^-16)
//   error    hn_phasor's, and of a derivative at most 4.82e-3 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 4.67e-2. From a cell at most 3.48e-3
//   period   2^31 cells per axis, or the tile's
//   cost     the hashes and sines of hn_phasor with a bandwidth, which are most of its cost, and about twice the rest
//   source   the product rule on weight and wave; docs/reference/contract.md, section 23
HN_FN hn_derivatives2x2 hn_phasor_d(hn_place2 place, hn_vec2 wave, hn_float bandwidth, hn_float phase, hn_uint seed) {
  hn_i_wave_points2 p = hn_i_wave_points(place, wave, phase, seed);
  hn_i_num b = hn_i_bandwidth(bandwidth);
  hn_i_own_waves2 s = hn_i_own_waves_at(p.h.x + p.angle, hn_i_own_waves(p.k, b, p.h.x), p.x.x, p.y.x, p.t.x);
  s = hn_i_plus(s, hn_i_own_waves_at(p.h.y + p.angle, hn_i_own_waves(p.k, b, p.h.y), p.x.y, p.y.y, p.t.y));
  s = hn_i_plus(s, hn_i_own_waves_at(p.h.z + p.angle, hn_i_own_waves(p.k, b, p.h.z), p.x.z, p.y.z, p.t.z));
  hn_i_num2 n = hn_i_scaled_waves2(s.waves.n);
  HN_I_NEW(hn_derivatives2x2, d);
  d.value = vec2(hn_i_value(n.x), hn_i_value(n.y));
  d.dx = hn_i_own_wave_slopes(hn_i_scaled_fall2(s.waves.x), s.x, 762);
  d.dy = hn_i_own_wave_slopes(hn_i_scaled_fall2(s.waves.y), s.y, 762);
  return d;
}
HN_FN hn_derivatives2x2 hn_phasor_d(hn_vec2 p, hn_vec2 wave, hn_float bandwidth, hn_float phase, hn_uint seed) {
  return hn_phasor_d(hn_place(p), wave, bandwidth, phase, seed);
}

#endif
