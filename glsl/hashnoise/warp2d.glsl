// hashnoise: domain warping on the plane: displacements of positions by fractals.
// To read it in one piece: docs/reference/snippets/hn_warp2.md
// SPDX-License-Identifier: MIT

#ifndef HN_WARP2D_GLSL
#define HN_WARP2D_GLSL

// From here warp3d.glsl is generated from warp2d.glsl.

#include "detail/jacobian.glsl"
#include "octaves2d.glsl"
#include "value_vector2d.glsl"

// A sum of vectors, and the Jacobian of the octave.
// Its numbers are apart: in lavapipe of Mesa 22.3 a point that has left a loop computes a vector once more, while other
// points go on (bugs.vector_behind_loop of the conformance suite).
struct hn_shifts2 {
  hn_i_num x;
  hn_i_num y;
  hn_i_jacobian2 jacobian;
  hn_i_num growth;  // of the Jacobian, from octave to octave
  hn_i_num amplitude;
  hn_i_num rate;  // by which an octave of progressive displacements moves the next
};

// The position of an octave, moved by n of the octave's cells.
HN_FN void hn_i_move(HN_I_INOUT(hn_octaves2) o, hn_i_num2 n) {
#if HN_ARITHMETIC != HN_FIXED
  if (!o.is_fixed_point) {
    o.p = vec2(hn_i_plus(o.p.x, n.x), hn_i_plus(o.p.y, n.y));
  } else
#endif
  {
    o.x = hn_i_displaced(o.x, n.x);
    o.y = hn_i_displaced(o.y, n.y);
  }
}

// Displacements by any noise, yours or the library's, with a component along each axis:
//
//   hn_octaves2 o = hn_octaves(p, 6, 2.0, 0.5, 7u);
//   hn_shifts2 s = hn_shifts(o, 1.5);
//   do hn_add(o, s, hn_perlin_vector(o.place, o.seed)); while (hn_next(o));
//   vec2 shift = hn_mean(o, s);
//
// hn_add_progressive in place of hn_add moves the octaves that follow.
//   o          the octaves
//   s          the displacements, from hn_shifts(o, amplitude)
//   v          the noises at o.place, in [-1, 1]; values beyond are cut off
//   amplitude  the largest displacement along an axis, in cells, usually about 1, in [0, 64]
//   example    hn_shifts2 s = hn_shifts(o, 1.0);
//   returns    hn_shifts: displacements to begin with; hn_mean: the displacement along each axis, as hn_warp
//   error      docs/measured/accuracy.md
//   cost       8 multiplications for the Jacobian of progressive displacements
//   source     docs/reference/contract.md, section 7
HN_FN hn_shifts2 hn_shifts(hn_octaves2 o, hn_float amplitude) {
  HN_I_NEW(hn_shifts2, s);
  s.x = HN_I_NO_WEIGHT;
  s.y = HN_I_NO_WEIGHT;
  s.jacobian = hn_i_identity2();
  s.growth = hn_i_growth(o.sum.gain, o.lacunarity);
  s.amplitude = hn_i_setting(amplitude, 64.0f);
  s.rate = hn_i_mean(s.amplitude, hn_i_total(o.sum));
  return s;
}
HN_FN void hn_add(hn_octaves2 o, HN_I_INOUT(hn_shifts2) s, hn_vec2 v) {
  s.x = hn_i_summed(s.x, hn_i_bounded_octave(v.x), o.sum.weight);
  s.y = hn_i_summed(s.y, hn_i_bounded_octave(v.y), o.sum.weight);
}
HN_FN void hn_add_progressive(HN_I_INOUT(hn_octaves2) o, HN_I_INOUT(hn_shifts2) s, hn_vec2 v) {
  hn_add(o, s, v);
  hn_i_num2 n = hn_i_vector(hn_i_bounded_octave(v.x), hn_i_bounded_octave(v.y));
  hn_i_move(o, hn_i_displacements(hn_i_jacobian_times(s.jacobian, n), s.rate));
  s.jacobian = hn_i_next_jacobian(s.jacobian, s.growth, o.place.tiled);
}
HN_FN hn_vec2 hn_mean(hn_octaves2 o, hn_shifts2 s) {
  hn_i_num total = hn_i_total(o.sum);
  return vec2(hn_i_mean_displacement(o.sum, s.x, total, s.amplitude),
              hn_i_mean_displacement(o.sum, s.y, total, s.amplitude));
}

HN_FN hn_vec2 hn_i_warp(hn_octaves2 o, hn_float amplitude) {
  hn_shifts2 s = hn_shifts(o, amplitude);
  do hn_add(o, s, hn_value_vector(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o, s);
}
HN_FN hn_vec2 hn_i_warp_progressive(hn_octaves2 o, hn_float amplitude) {
  hn_shifts2 s = hn_shifts(o, amplitude);
  do hn_add_progressive(o, s, hn_value_vector(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o, s);
}

// ---------------------------------------------------------------------------------------------------------------------
// Displacements by hn_value_vector, in the forms of hn_fbm with a seed.

// Domain warping: a displacement for a position. Evaluate another noise at p + hn_warp(p, ...). Far from the origin
// evaluate it at hn_place(cell, f + hn_warp(hn_place(cell, f), ...)), with the whole part of the sum added to the cell.
//   p           position, in cells of the first octave: a coordinate times a frequency, so that a cell is as large as
//               the largest hills. Less than 2^23 / lacunarity^octaves - 1 along each axis, for a lacunarity of 2 or
//               more: larger floats have no fraction
//   place       in place of p, in cells of the first octave: hn_place(cell, f) far from the origin, or
//               hn_tile(p, period) (place.glsl)
//   octaves     how many, usually 4 to 8; more than 32 count as 32, and with fewer than 1 the displacement is 0
//   lacunarity  ratio of frequencies from octave to octave, usually 2. In a tile it is a whole number from 1 to 255;
//               others are rounded down
//   gain        ratio of amplitudes (persistence), usually 0.5; not negative
//   amplitude   the largest displacement along an axis, in cells, usually about 1, in [0, 64]
//   seed        any uint: 7u, not 7; different seeds give independent displacements
//   example     vec2 n = hn_warp(uv * 8.0, 6, 2.0, 0.5, 1.0, 7u);
//   returns     the displacement along x and y, each in [-amplitude, amplitude]
//   error       docs/measured/accuracy.md
//   period      none that floats reach, or the tile's
//   cost        hn_value_vector per octave
//   source      Quilez, "Domain warping", 2002
HN_FN hn_vec2 hn_warp(hn_place2 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float amplitude,
                      hn_uint seed) {
  return hn_i_warp(hn_octaves(place, octaves, lacunarity, gain, seed), amplitude);
}
HN_FN hn_vec2 hn_warp(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float amplitude, hn_uint seed) {
  return hn_i_warp(hn_octaves(p, octaves, lacunarity, gain, seed), amplitude);
}

// A warp in which the octaves before an octave displace it, too. It draws strands and eddies.
//   (parameters, period and source as for hn_warp)
//   example     vec2 n = hn_warp_progressive(uv * 8.0, 6, 2.0, 0.5, 1.0, 7u);
//   returns     the displacement along x and y, each in [-amplitude, amplitude]
//   error       grows with the amplitude and with each octave, since its place has an error already:
//               docs/measured/accuracy.md
//   cost        hn_value_vector per octave, and 8 multiplications for the Jacobian
HN_FN hn_vec2 hn_warp_progressive(hn_place2 place, hn_int octaves, hn_float lacunarity, hn_float gain,
                                  hn_float amplitude, hn_uint seed) {
  return hn_i_warp_progressive(hn_octaves(place, octaves, lacunarity, gain, seed), amplitude);
}
HN_FN hn_vec2 hn_warp_progressive(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float amplitude,
                                  hn_uint seed) {
  return hn_i_warp_progressive(hn_octaves(p, octaves, lacunarity, gain, seed), amplitude);
}

// To here warp3d.glsl is generated from warp2d.glsl.

#endif
