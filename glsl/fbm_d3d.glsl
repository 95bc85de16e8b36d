// hashnoise: octave sums over a noise with derivatives, in space.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM_D3D_GLSL
#define HN_FBM_D3D_GLSL

#include "frame.glsl"
#include "octaves_space.glsl"
#include "perlin_d3d.glsl"

// The derivatives of an octave, n, in its frame k.
HN_FN void hn_i_add_slopes(HN_I_INOUT(hn_num3) d, hn_i_frame3 k, hn_vec4 n) {
  hn_num3 g = hn_i_from_frame(k, hn_i_num(hn_i_octave_slope(n.y), hn_i_octave_slope(n.z), hn_i_octave_slope(n.w)));
  d.x = hn_i_joined(d.x, g.x);
  d.y = hn_i_joined(d.y, g.y);
  d.z = hn_i_joined(d.z, g.z);
}

// What the slopes so far, e, leave of an octave.
HN_FN void hn_i_add_eroded(HN_I_INOUT(hn_i_octave_sum) s, HN_I_INOUT(hn_num3) e, hn_vec4 n) {
  e.x = hn_i_steeper(e.x, n.y);
  e.y = hn_i_steeper(e.y, n.z);
  e.z = hn_i_steeper(e.z, n.w);
  HN_I_PRECISE hn_i_square_of_slope square = hn_i_square(e.x) + hn_i_square(e.y) + hn_i_square(e.z);
  s.sum = hn_i_summed(s.sum, hn_i_octave(n.x), hn_i_weighed(s.weight, hn_i_eroding(square, s.option)));
}

HN_FN hn_vec4 hn_i_with_slopes(hn_num sum, hn_num3 d, hn_num total) {
  return vec4(hn_i_value(hn_i_mean(sum, total)), hn_i_derivative(hn_i_coarse(hn_i_mean(d.x, total))),
              hn_i_derivative(hn_i_coarse(hn_i_mean(d.y, total))),
              hn_i_derivative(hn_i_coarse(hn_i_mean(d.z, total))));
}

#define HN_I_BEGIN_SLOPES3 hn_num3 d = hn_i_num(HN_I_NO_WEIGHT, HN_I_NO_WEIGHT, HN_I_NO_WEIGHT); hn_i_frame3 k = hn_i_first_frame3(); hn_num growth = hn_i_growth(s.gain, s.lacunarity);
#define HN_I_EACH_SLOPES3(noise, call) hn_vec4 n = call(noise, s.seed); hn_i_add(s, n.x); hn_i_add_slopes(d, k, n);
#define HN_I_END_SLOPES3 return hn_i_with_slopes(s.sum, d, HN_I_TOTAL);
#define HN_I_OF_FBM_D3 HN_I_PLAIN, HN_I_WEIGHT_ONE, HN_I_BEGIN_SLOPES3, HN_I_EACH_SLOPES3, HN_I_ONWARD_FRAME, HN_I_END_SLOPES3
#define HN_I_BEGIN_ERODED3 hn_num3 e = hn_i_num(HN_I_NO_WEIGHT, HN_I_NO_WEIGHT, HN_I_NO_WEIGHT);
#define HN_I_EACH_ERODED3(noise, call) hn_i_add_eroded(s, e, call(noise, s.seed));
#define HN_I_END_ERODED return hn_i_value(hn_i_mean(s.sum, HN_I_TOTAL));
#define HN_I_OF_ERODED3 HN_I_STRONG, hn_i_setting(strength, 16.0f), HN_I_BEGIN_ERODED3, HN_I_EACH_ERODED3, HN_I_ONWARD_SLOPE, HN_I_END_ERODED

// ---------------------------------------------------------------------------------------------------------------------
// Sums over other noises than hn_perlin_d, as in fbm3d.glsl: outside of all functions and without a semicolon. The
// noise returns its value and its derivatives along x, y and z.
//
//   HN_FBM_D3D(my_sum, hn_simplex_d)   my_sum(p, octaves, lacunarity, gain [, seed]), and at a place
//   HN_ERODED3D(...)                  the same, with a strength behind the gain
#define HN_FBM_D3D(name, noise) HN_I_FRAMED_OF(name, noise, hn_vec4, HN_I_TYPES3, HN_I_OF_FBM_D3)
#define HN_ERODED3D(name, noise) HN_I_FRAMED_OF(name, noise, hn_float, HN_I_TYPES3, HN_I_OF_ERODED3)

// ---------------------------------------------------------------------------------------------------------------------
// Sums over hn_perlin_d, in the forms of hn_fbm.

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Fractional Brownian motion and how steep it is. The value is that of hn_fbm.
//   (parameters, period and source as for hn_fbm)
//   returns   the value and its derivatives along x, y and z, per cell of the first octave. A derivative is at most
//             3.75 times the sum of (1.001 * gain * lacunarity)^i, divided by the sum of gain^i
//   error     docs/accuracy.md; for HN_FIXED while the sum of (gain * lacunarity)^i is at most 64
//   cost      1 noise with derivatives per octave, and 9 multiplications for the frame
HN_FBM_D3D(hn_fbm_d, hn_perlin_d)

// Eroded fBm: an octave counts less where those before it and itself are steep, so that slopes are smooth and detail
// gathers in valleys and on summits.
//   strength  how much less: 0 is hn_fbm, and usually 1; in [0, 16]. A slope of 1 cell in 1 leaves 1 / (1 + strength)
//   (other parameters, period and source as for hn_fbm; the strength stands behind the gain)
//   returns   [-1, 1]
//   error     docs/accuracy.md
//   cost      1 noise with derivatives per octave, and a division
//   source    Quilez, "More noise", 2008: his slopes are not turned with the octaves
HN_ERODED3D(hn_eroded, hn_perlin_d)

#endif
#endif
