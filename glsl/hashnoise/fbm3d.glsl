// hashnoise: fractals over a noise in space.
// To read it in one piece: docs/reference/snippets/hn_fbm3.md
// SPDX-License-Identifier: MIT
//
// Made from fbm2d.glsl by tools/make. tools/lib/translate/dimensions/numbers.py has its numbers.

#ifndef HN_FBM3D_GLSL
#define HN_FBM3D_GLSL

// From here fbm1d.glsl, fbm3d.glsl and fbm4d.glsl are generated from fbm2d.glsl.

#include "octaves3d.glsl"
#include "perlin3d.glsl"

// Fractals over hn_perlin. Over another noise, or over your own, write the same loop (octaves3d.glsl).
// tools/make catalog: loops
HN_FN hn_float hn_i_fbm(hn_octaves3 o) {
  do hn_add(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o);
}
HN_FN hn_float hn_i_turbulence(hn_octaves3 o) {
  do hn_add_turbulence(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o);
}
HN_FN hn_float hn_i_clouds(hn_octaves3 o) {
  do hn_add(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_density(o);
}
HN_FN hn_float hn_i_billow(hn_octaves3 o) {
  do o.sum = hn_i_add_billow(o.sum, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_i_value(hn_i_billows(hn_i_mean(o.sum)));
}
HN_FN hn_float hn_i_ridged(hn_octaves3 o) {
  do hn_add_ridged(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_i_value(hn_i_bounded(hn_i_mean(o.sum)));
}
HN_FN hn_float hn_i_hybrid(hn_octaves3 o) {
  do hn_add_hybrid(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_i_value(hn_i_bounded(hn_i_mean(o.sum)));
}
HN_FN hn_float hn_i_ping_pong(hn_octaves3 o, hn_float strength) {
  do hn_add_ping_pong(o, hn_perlin(o.place, o.seed), strength);
  while (hn_next(o));
  return hn_i_value(hn_i_bounded(hn_i_mean(o.sum)));
}
HN_FN hn_float hn_i_weighted(hn_octaves3 o, hn_float strength) {
  do hn_add_weighted(o, hn_perlin(o.place, o.seed), strength);
  while (hn_next(o));
  return hn_i_value(hn_i_bounded(hn_i_mean(o.sum)));
}
// tools/make catalog: end

// Each fractal has three forms, and one with a strength has the last two:
//
//   hn_fbm(p, octaves, lacunarity, gain)
//   hn_fbm(p, octaves, lacunarity, gain, seed)
//   hn_fbm(place, octaves, lacunarity, gain, seed)

// Fractional Brownian motion (fBm), the usual fractal noise: octaves of hn_perlin, each finer by the lacunarity, weaker
// by the gain, and rotated.
//   p           position, in cells of the first octave: a coordinate times a frequency, so that a cell is as large as
//               the largest hills. Less than 2^23 / lacunarity^octaves - 1 along each axis, for a lacunarity of 2 or
//               more: larger floats have no fraction
//   place       in place of p, in cells of the first octave: hn_place(cell, f) far from the origin, or
//               hn_tile(p, period) (place.glsl). The period of a tile times lacunarity^octaves is below 2^31
//   octaves     how many, usually 4 to 8; more than 32 count as 32, and with fewer than 1 the sum is 0
//   lacunarity  ratio of frequencies from octave to octave, usually 2. In a tile it is a whole number from 1 to 255;
//               others are rounded down
//   gain        ratio of amplitudes (persistence), usually 0.5; not negative, and the sum of its powers below 2^126
//               (HN_PRECISE: 2^100)
//   seed        any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example     float n = hn_fbm(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [-1, 1], mean 0; with HN_GRADIENT_SINE, which is not scaled, [-3/2, 3/2]
//   error       at a position it grows with |p| * lacunarity^octaves, since a float rounds the positions; at a place it
//               does not (docs/measured/accuracy.md)
//   period      none that floats reach. In a tile octave i repeats after period * lacunarity^i of its cells, so the
//               fractal repeats after the period, and no sooner. Octaves are not rotated there, since they would not
//               fit: a tile shows the axes more than other fractals do
//   cost        1 noise per octave
//   HN_FIXED    takes a gain above 1 as 1, and a lacunarity outside [0, 255] as 0 or 255. The error does not grow
//               with |p|
//   source      Musgrave, in "Texturing and Modeling: A Procedural Approach"
HN_FN hn_float hn_fbm(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_fbm(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_fbm(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_fbm(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_fbm(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_fbm(p, octaves, lacunarity, gain, 0u);
}

// hn_fbm without detail that a pixel cannot show: hn_fbm(p, detail, lacunarity, gain, seed) with a float, and
// hn_fbm(p, footprint, octaves, lacunarity, gain, seed).
//   detail      octaves, as a float: 3.5 is three octaves and half of the fourth. So octaves from the second on come
//               and go without a jump. Up to 1 it is the whole first octave, below 2^-32 none, and
//               above 32 it counts as 32
//   footprint   the size of a pixel at p, in cells of the first octave: in a fragment shader max(length(dFdx(p)),
//               length(dFdy(p))). An octave fades out as a pixel grows from 1/2 to 3/2 of its cells, which comes
//               nearest to the mean over the pixel. The others keep their contrast
//   (other parameters, error, period, HN_FIXED and source as for hn_fbm at a position)
//   example     float n = hn_fbm(vec3(uv * 8.0, 0.5), 3.5, 2.0, 0.5, 7u);
//   returns     [-1, 1], mean 0; with HN_GRADIENT_SINE, which is not scaled, [-3/2, 3/2]
//   cost        1 noise per octave; octaves that have faded out cost none
HN_FN hn_float hn_fbm(hn_vec3 p, hn_float detail, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_octaves3 o = hn_octaves(p, detail, lacunarity, gain, seed);
  do hn_add_detail(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o);
}
HN_FN hn_float hn_fbm(hn_vec3 p, hn_float footprint, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_octaves3 o = hn_octaves(p, footprint, octaves, lacunarity, gain, seed);
  do hn_add_footprint(o, hn_perlin(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o);
}

// tools/make catalog: forms

// Turbulence: the mean of the octaves' absolute values. Use it for marble and fire.
//   (parameters, period and cost as for hn_fbm)
//   example     float n = hn_turbulence(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [0, 1], with creases where the noise passes 0; with HN_GRADIENT_SINE, which is not scaled, [0, 3/2]
//   error       hn_fbm's
//   source      Perlin, "An image synthesizer", 1985; Valdenegro-Toro and Pincheira, fig. 6
HN_FN hn_float hn_turbulence(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_turbulence(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_turbulence(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_turbulence(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_turbulence(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_turbulence(p, octaves, lacunarity, gain, 0u);
}

// Clouds: the density of a sky, from an fBm.
//   (parameters, period and cost as for hn_fbm)
//   example     float n = hn_clouds(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [0, 1]: 0 is clear, 1 is dense; with fewer than 1 octave 5/32
//   error       3 times hn_fbm's, plus 5.4e-7 (HN_FIXED 2.6e-5)
//   source      after the cloud images of Valdenegro-Toro and Pincheira, fig. 6; the paper has no formula for them
HN_FN hn_float hn_clouds(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_clouds(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_clouds(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_clouds(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_clouds(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_clouds(p, octaves, lacunarity, gain, 0u);
}

// Billows: twice the turbulence less 1. The round hills are the other side of ridges.
//   (parameters, period and cost as for hn_fbm)
//   example     float n = hn_billow(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [-1, 1]; with fewer than 1 octave -1
//   error       twice hn_turbulence's, and a little more
//   source      as of hn_turbulence
HN_FN hn_float hn_billow(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_billow(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_billow(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_billow(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_billow(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_billow(p, octaves, lacunarity, gain, 0u);
}

// Ridges: sharp crests where the noise passes 0, with detail on them and smooth valleys between.
//   (parameters, period and cost as for hn_fbm)
//   example     float n = hn_ridged(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [0, 1]: 1 on a crest of every octave
//   error       grows with the octaves, since each is multiplied by the one before: docs/measured/accuracy.md
//   source      Musgrave, in "Texturing and Modeling: A Procedural Approach": his ridged multifractal with the offset 1
//               and the gain 2, divided by the sum of the weights
HN_FN hn_float hn_ridged(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_ridged(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_ridged(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_ridged(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_ridged(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_ridged(p, octaves, lacunarity, gain, 0u);
}

// Hybrid terrain: plains are flat and heights are rough. An octave counts as far as the one before it is high; in full
// from the middle on.
//   (parameters, period and cost as for hn_fbm)
//   example     float n = hn_hybrid(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [0, 1]
//   error       grows with the octaves, since each is multiplied by the one before: docs/measured/accuracy.md
//   source      Musgrave, in "Texturing and Modeling: A Procedural Approach": after his hybrid multifractal with the
//               offset 1, of octaves in [0, 1], divided by the sum of the weights
HN_FN hn_float hn_hybrid(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_hybrid(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_hybrid(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_hybrid(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_float hn_hybrid(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_hybrid(p, octaves, lacunarity, gain, 0u);
}

// Ping-pong: each octave is folded up and down, which gives the rings of wood and of agate.
//   strength    how often it folds: half the number of passes from one end to the other while the noise goes from -1 to
//               1; usually 2, in [0, 64]
//   (other parameters, period and cost as for hn_fbm; the strength stands behind the gain, and the seed cannot be
//   left out)
//   example     float n = hn_ping_pong(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 2.0, 7u);
//   returns     [-1, 1]
//   error       twice the strength times hn_fbm's, and a little more; docs/measured/accuracy.md
//   source      FastNoiseLite, FractalType_PingPong
HN_FN hn_float hn_ping_pong(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float strength,
                            hn_uint seed) {
  return hn_i_ping_pong(hn_octaves(place, octaves, lacunarity, gain, seed), strength);
}
HN_FN hn_float hn_ping_pong(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float strength,
                            hn_uint seed) {
  return hn_i_ping_pong(hn_octaves(p, octaves, lacunarity, gain, seed), strength);
}

// Weighted fBm: where an octave is low, the finer ones count less. Valleys are smoother than heights.
//   strength    how much less: 0 is hn_fbm, 1 leaves nothing of the finer octaves at -1; usually 1, in [0, 1]
//   (other parameters, period and cost as for hn_fbm; the strength stands behind the gain, and the seed cannot be
//   left out)
//   example     float n = hn_weighted(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 1.0, 7u);
//   returns     [-1, 1]
//   error       docs/measured/accuracy.md
//   source      FastNoiseLite, SetFractalWeightedStrength
HN_FN hn_float hn_weighted(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float strength,
                           hn_uint seed) {
  return hn_i_weighted(hn_octaves(place, octaves, lacunarity, gain, seed), strength);
}
HN_FN hn_float hn_weighted(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float strength,
                           hn_uint seed) {
  return hn_i_weighted(hn_octaves(p, octaves, lacunarity, gain, seed), strength);
}
// tools/make catalog: end

// To here fbm1d.glsl, fbm3d.glsl and fbm4d.glsl are generated from fbm2d.glsl.

#endif
