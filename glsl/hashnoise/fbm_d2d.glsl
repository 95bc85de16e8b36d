// hashnoise: fractals over a noise with derivatives, on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM_D2D_GLSL
#define HN_FBM_D2D_GLSL

// From here fbm_d3d.glsl is generated from fbm_d2d.glsl.

#include "detail/jacobian.glsl"
#include "octaves2d.glsl"
#include "perlin_d2d.glsl"

// A sum of derivatives, beside the sum of values, and the Jacobian of the octave.
// Its numbers are apart: in lavapipe of Mesa 22.3 a point that has left a loop computes a vector once more, while other
// points go on (bugs.vector_behind_loop of the conformance suite).
struct hn_slopes2 {
  hn_i_num x;
  hn_i_num y;
  hn_i_jacobian2 jacobian;
  hn_i_num growth;  // of the Jacobian, from octave to octave
};

// A fractal over a noise with derivatives, yours or the library's:
//
//   hn_octaves2 o = hn_octaves(p, 6, 2.0, 0.5, 7u);
//   hn_slopes2 s = hn_slopes(o);
//   do hn_add(o, s, hn_simplex_d(o.place, o.seed)); while (hn_next(o));
//   vec3 height = hn_mean(o, s);
//
// With hn_add_eroded in place of hn_add, hn_mean(o) is the value.
//   o         the octaves
//   s         the slopes, from hn_slopes(o)
//   n         the value of the noise, and its derivatives along x and y. HN_FIXED cuts off a value beyond [-3/2, 3/2]
//             and a derivative beyond [-128, 128], which no noise of the library is. Floats cut off neither
//   strength  of erosion, usually 1, in [0, 16]
//   example   hn_slopes2 s = hn_slopes(o);
//   returns   hn_slopes: slopes to begin with; hn_mean: the value and its derivatives, as hn_fbm_d
//   error     docs/measured/accuracy.md
//   cost      4 multiplications for the Jacobian, or a division
//   source    docs/reference/contract.md, section 7
HN_FN hn_slopes2 hn_slopes(hn_octaves2 o) {
  HN_I_NEW(hn_slopes2, s);
  s.x = HN_I_NO_WEIGHT;
  s.y = HN_I_NO_WEIGHT;
  s.jacobian = hn_i_identity2();
  s.growth = hn_i_growth(o.sum.gain, o.lacunarity);
  return s;
}
HN_FN void hn_add(HN_I_INOUT(hn_octaves2) o, HN_I_INOUT(hn_slopes2) s, hn_vec3 n) {
  hn_i_num2 g = hn_i_vector(hn_i_octave_slope(n.y), hn_i_octave_slope(n.z));
  g = hn_i_transposed_times(s.jacobian, g);
  o.sum = hn_i_add_noise(o.sum, n.x);
  s.x = hn_i_wide_plus(s.x, g.x);
  s.y = hn_i_wide_plus(s.y, g.y);
  s.jacobian = hn_i_next_jacobian(s.jacobian, s.growth, o.place.tiled);
}
HN_FN void hn_add_eroded(HN_I_INOUT(hn_octaves2) o, HN_I_INOUT(hn_slopes2) s, hn_vec3 n, hn_float strength) {
  hn_i_num2 e = hn_i_vector(hn_i_summed_slope(s.x, n.y), hn_i_summed_slope(s.y, n.z));
  HN_I_PRECISE hn_i_square_of_slope steep = hn_i_squared_slope(e.x) + hn_i_squared_slope(e.y);
  hn_i_num left = hn_i_erosion_weight(steep, hn_i_setting(strength, 16.0f));
  o.sum = hn_i_add_octave(o.sum, hn_i_octave(n.x), hn_i_weight_times(o.sum.weight, left));
  e = hn_i_next_slope(e, o.place.tiled);
  s.x = e.x;
  s.y = e.y;
}
HN_FN hn_vec3 hn_mean(hn_octaves2 o, hn_slopes2 s) {
  hn_i_num total = hn_i_total(o.sum);
  return vec3(hn_i_value(hn_i_mean(o.sum, o.sum.value, total)),
              hn_i_derivative(hn_i_coarse(hn_i_mean(o.sum, s.x, total))),
              hn_i_derivative(hn_i_coarse(hn_i_mean(o.sum, s.y, total))));
}

// ---------------------------------------------------------------------------------------------------------------------
// Fractals over hn_perlin_d, in the forms of hn_fbm.

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

HN_FN hn_vec3 hn_i_fbm_d(hn_octaves2 o) {
  hn_slopes2 s = hn_slopes(o);
  do hn_add(o, s, hn_perlin_d(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o, s);
}
HN_FN hn_float hn_i_eroded(hn_octaves2 o, hn_float strength) {
  hn_slopes2 s = hn_slopes(o);
  do hn_add_eroded(o, s, hn_perlin_d(o.place, o.seed), strength);
  while (hn_next(o));
  return hn_mean(o);
}

// Fractional Brownian motion (fBm) and its slope: the value of hn_fbm with its derivatives.
//   (parameters, period and source as for hn_fbm)
//   example   vec3 n = hn_fbm_d(uv * 8.0, 6, 2.0, 0.5, 7u);
//   returns   the value and its derivatives along x and y, per cell of the first octave. A derivative is at most
//             2.95 times the sum of (1.001 * gain * lacunarity)^i, divided by the sum of gain^i
//   error     docs/measured/accuracy.md; for HN_FIXED while the sum of (gain * lacunarity)^i is at most 64
//   cost      1 noise with derivatives per octave, and 4 multiplications for the Jacobian
HN_FN hn_vec3 hn_fbm_d(hn_place2 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_fbm_d(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_vec3 hn_fbm_d(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_fbm_d(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_vec3 hn_fbm_d(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_fbm_d(p, octaves, lacunarity, gain, 0u);
}

// Eroded fBm: smooth slopes, with detail in valleys and on summits. An octave counts less where it and those before it
// are steep.
//   strength  how much less: 0 is hn_fbm, and usually 1; in [0, 16]. A slope of 1 cell in 1 leaves 1 / (1 + strength)
//   (other parameters, period and source as for hn_fbm; the strength stands behind the gain, and the seed cannot be
//   left out)
//   example   float n = hn_eroded(uv * 8.0, 6, 2.0, 0.5, 1.0, 7u);
//   returns   [-1, 1]
//   error     docs/measured/accuracy.md
//   cost      1 noise with derivatives per octave, and a division
//   source    Quilez, "More noise", 2008: his slopes are not rotated with the octaves
HN_FN hn_float hn_eroded(hn_place2 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float strength,
                         hn_uint seed) {
  return hn_i_eroded(hn_octaves(place, octaves, lacunarity, gain, seed), strength);
}
HN_FN hn_float hn_eroded(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float strength,
                         hn_uint seed) {
  return hn_i_eroded(hn_octaves(p, octaves, lacunarity, gain, seed), strength);
}

#endif

// To here fbm_d3d.glsl is generated from fbm_d2d.glsl.

#endif
