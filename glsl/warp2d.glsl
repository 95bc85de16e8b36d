// hashnoise: shifts of positions on the plane, as sums of octaves.
// SPDX-License-Identifier: MIT

#ifndef HN_WARP2D_GLSL
#define HN_WARP2D_GLSL

#include "frame.glsl"
#include "octaves_plane.glsl"
#include "value2d.glsl"

// A vector of noises, in the numbers of HN_ARITHMETIC, and the sum with it.
HN_FN hn_num2 hn_i_vector(hn_float x, hn_float y) {
  return hn_i_num(hn_i_bounded_octave(x), hn_i_bounded_octave(y));
}
HN_FN void hn_i_add_vector(HN_I_INOUT(hn_num2) sum, hn_num2 v, hn_num weight) {
  sum.x = hn_i_summed(sum.x, v.x, weight);
  sum.y = hn_i_summed(sum.y, v.y, weight);
}

HN_FN hn_vec2 hn_i_shifts(hn_num2 sum, hn_num total, hn_num amplitude) {
  return vec2(hn_i_shift(sum.x, total, amplitude), hn_i_shift(sum.y, total, amplitude));
}

// The place to which a shift of the first octave's cells moves that of an octave, whose frame is k.
HN_FN hn_i_whole2 hn_i_moved(hn_i_whole2 q, hn_num2 k, hn_num2 v, hn_num rate) {
  hn_num2 n = hn_i_strides(hn_i_to_frame(k, v), rate);
  hn_i_whole2 moved = q;
  moved.x = hn_i_moved(q.x, n.x);
  moved.y = hn_i_moved(q.y, n.y);
  return moved;
}
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_vec2 hn_i_moved(hn_vec2 q, hn_num2 k, hn_num2 v, hn_num rate) {
  hn_num2 n = hn_i_strides(hn_i_to_frame(k, v), rate);
  return vec2(hn_i_plus(q.x, n.x), hn_i_plus(q.y, n.y));
}
#endif

#define HN_I_BEGIN_WARP2 hn_num2 sum = hn_i_num(HN_I_NO_WEIGHT, HN_I_NO_WEIGHT);
#define HN_I_VECTOR2(noise, call) hn_i_vector(call(noise, s.seed), call(noise, hn_i_other_seed(s.seed)))
#define HN_I_EACH_WARP2(noise, call) hn_i_add_vector(sum, HN_I_VECTOR2(noise, call), s.weight);
#define HN_I_END_WARP return hn_i_shifts(sum, HN_I_TOTAL, s.option);
#define HN_I_OF_WARP2 HN_I_SWAYED, hn_i_setting(amplitude, 64.0f), HN_I_BEGIN_WARP2, HN_I_EACH_WARP2, HN_I_ONWARD, HN_I_END_WARP
#define HN_I_BEGIN_PROGRESSIVE2 HN_I_BEGIN_WARP2 hn_num2 k = hn_i_first_frame2(); hn_num growth = hn_i_growth(s.gain, s.lacunarity); hn_num total = HN_I_TOTAL; hn_num rate = hn_i_mean(s.option, total);
#define HN_I_EACH_PROGRESSIVE2(noise, call) hn_num2 v = HN_I_VECTOR2(noise, call); hn_i_add_vector(sum, v, s.weight);
#define HN_I_END_PROGRESSIVE return hn_i_shifts(sum, total, s.option);
#define HN_I_OF_PROGRESSIVE2 HN_I_SWAYED, hn_i_setting(amplitude, 64.0f), HN_I_BEGIN_PROGRESSIVE2, HN_I_EACH_PROGRESSIVE2, HN_I_ONWARD_MOVED, HN_I_END_PROGRESSIVE

// ---------------------------------------------------------------------------------------------------------------------
// Shifts by other noises than hn_value, as in fbm2d.glsl: outside of all functions and without a semicolon. Each
// component is the noise with a seed of its own.
//
//   HN_WARP2D(my_warp, hn_simplex)        my_warp(p, octaves, lacunarity, gain, amplitude [, seed]), and at a place
//   HN_WARP_PROGRESSIVE2D(...)           the same, progressive
#define HN_WARP2D(name, noise) HN_I_FRAMED_OF(name, noise, hn_vec2, HN_I_TYPES2, HN_I_OF_WARP2)
#define HN_WARP_PROGRESSIVE2D(name, noise) HN_I_FRAMED_OF(name, noise, hn_vec2, HN_I_TYPES2, HN_I_OF_PROGRESSIVE2)

// ---------------------------------------------------------------------------------------------------------------------
// Shifts by hn_value, in the forms of hn_fbm.

// How far a position is moved: another noise is taken at p + hn_warp(p, ...). Far out it is taken at
// hn_place(cell, f + hn_warp(hn_place(cell, f), ...)), of which the whole part belongs to the cell.
//   p           position, in cells of the first octave; (|p| + 1) * lacunarity^octaves < 2^23, for a lacunarity of 2
//               or more
//   place       a place in its stead, in cells of the first octave (place.glsl)
//   octaves     how many; with fewer than 1 the shift is 0
//   lacunarity  ratio of frequencies, usually 2. In a tile it is a whole number from 1 to 255; others are rounded
//               down
//   gain        ratio of amplitudes, usually 0.5; not negative
//   amplitude   the largest shift along an axis, in cells, in [0, 64]
//   seed        any uint: 7u, not 7; 0 if left out
//   returns     the shift along x and y, each in [-amplitude, amplitude]
//   error       docs/accuracy.md
//   period      none that floats reach, or that of the tile
//   cost        2 noises per octave, which share the cell and its fades
//   source      Quilez, "Domain warping", 2002
HN_WARP2D(hn_warp, hn_value)

// The same, where each octave is taken at the place to which those before it have moved. It draws strands and eddies.
//   (parameters, period and source as for hn_warp)
//   returns     the shift along x and y, each in [-amplitude, amplitude]
//   error       grows with the amplitude and with each octave, which is taken at a place that has an error:
//               docs/accuracy.md
//   cost        2 noises per octave, and 8 multiplications for the frame
HN_WARP_PROGRESSIVE2D(hn_warp_progressive, hn_value)

#endif
