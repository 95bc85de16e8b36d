// hashnoise: phasor noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR2D_GLSL
#define HN_PHASOR2D_GLSL

#include "detail/phasor_points2d.glsl"

// The sum of the waves around points, each with a wave of its own.
HN_FN hn_vec2 hn_i_phasor(hn_i_wave_points2 p, hn_i_num2 first, hn_i_num2 middle, hn_i_num2 last) {
  hn_i_num2 n = hn_i_wave_at(p.h.x + p.angle + hn_i_waves_from(first, p.x.x, p.y.x), hn_i_weight_wave(p.t.x));
  n = hn_i_plus(n, hn_i_wave_at(p.h.y + p.angle + hn_i_waves_from(middle, p.x.y, p.y.y), hn_i_weight_wave(p.t.y)));
  n = hn_i_plus(n, hn_i_wave_at(p.h.z + p.angle + hn_i_waves_from(last, p.x.z, p.y.z), hn_i_weight_wave(p.t.z)));
  n = hn_i_scaled_waves2(n);
  return vec2(hn_i_value(n.x), hn_i_value(n.y));
}

// Phasor noise on the plane: stripes in a direction and with a wavelength of your choice, which may change from place
// to place. They bend where the random phases of the lattice do not agree. The value by itself looks as Gabor noise
// does. The angle of value and quadrature, atan(n.y, n.x), grows across the stripes: any profile may be made of it. So
// n.x / length(n) is stripes of one height. length(n) is how well the stripes agree.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   wave     the direction across the stripes, times the number of waves per cell: usually 2 to 8, which show as
//            stripes. Each component outside [-16, 16] counts as the nearer end
//   phase    in turns, any float: phase + 1 has the same bits. The stripes move along the wave as the phase falls, and
//            loop after one turn. A float far from 0 has few bits left for the turn: pass fract(phase)
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  vec2 n = hn_phasor(uv * 8.0, vec2(4.0, 0.0), 0.25, 7u);
//   returns  a value and its quadrature, the value a quarter of a turn of the phase earlier, each in [-1, 1] (proven
//            bound 0.99933), mean 0, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 4.24e-5 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            3.56e-4. From a cell at most 3.04e-5
//   period   2^31 cells per axis, or the tile's
//   cost     3 hashes (none with HN_HASH_LATTICE), 6 sines of 6 multiplications each, and 15 multiplications; 2 more to
//            spread the coordinates, and 2 more for a seed that is not constant
//   source   Tricard et al., "Procedural phasor noise", 2019; Lagae et al., "Procedural noise using sparse Gabor
//            convolution", 2009; docs/reference/contract.md, section 23
HN_FN hn_vec2 hn_phasor(hn_place2 place, hn_vec2 wave, hn_float phase, hn_uint seed) {
  hn_i_wave_points2 p = hn_i_wave_points(place, wave, phase, seed);
  return hn_i_phasor(p, p.k, p.k, p.k);
}
HN_FN hn_vec2 hn_phasor(hn_vec2 p, hn_vec2 wave, hn_float phase, hn_uint seed) {
  return hn_phasor(hn_place(p), wave, phase, seed);
}

// Phasor noise whose waves differ from point to point of the lattice, as in Gabor noise. With a wave the stripes
// bend, fork and end more, the larger the bandwidth. Without one, at vec2(0.0), the stripes have all
// directions, and the bandwidth is the number of waves per cell.
//   (other parameters as for hn_phasor above)
//   bandwidth  how far the wave of each point is from the argument wave, in a direction of its own, in waves per cell:
//              usually up to the length of the wave. Outside [0, 16] it counts as the nearer end. With 0 it has the
//              bits of hn_phasor without one
//   example  vec2 n = hn_phasor(uv * 8.0, vec2(4.0, 0.0), 1.0, 0.25, 7u);
//   returns  a value and its quadrature, the value a quarter of a turn of the phase earlier, each in [-1, 1] (proven
//            bound 0.99933), mean 0, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 4.69e-5 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            4.30e-4. From a cell at most 3.38e-5
//   period   2^31 cells per axis, or the tile's
//   cost     hn_phasor without a bandwidth, and for each of 3 points 11 multiplications of integers and 4 of floats
//   source   as of hn_phasor without a bandwidth; docs/reference/contract.md, section 23
HN_FN hn_vec2 hn_phasor(hn_place2 place, hn_vec2 wave, hn_float bandwidth, hn_float phase, hn_uint seed) {
  hn_i_wave_points2 p = hn_i_wave_points(place, wave, phase, seed);
  hn_i_num b = hn_i_bandwidth(bandwidth);
  return hn_i_phasor(p, hn_i_own_waves(p.k, b, p.h.x), hn_i_own_waves(p.k, b, p.h.y), hn_i_own_waves(p.k, b, p.h.z));
}
HN_FN hn_vec2 hn_phasor(hn_vec2 p, hn_vec2 wave, hn_float bandwidth, hn_float phase, hn_uint seed) {
  return hn_phasor(hn_place(p), wave, bandwidth, phase, seed);
}

#endif
