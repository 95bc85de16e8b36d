// hashnoise: the octaves of a fractal on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_OCTAVES1D_GLSL
#define HN_OCTAVES1D_GLSL

#include "detail/octave.glsl"
#include "place.glsl"

// The octaves of a fractal, one after another, over any noise:
//
//   hn_octaves1 o = hn_octaves(p, 6, 2.0, 0.5, 7u);
//   do hn_add(o, hn_value(o.place, o.seed)); while (hn_next(o));
//   float height = hn_mean(o);
//
// The condition stands behind the octave: drivers unroll such a loop, and run it faster than one that begins with it.
// In place of hn_add there are hn_add_turbulence, hn_add_ridged, hn_add_hybrid, hn_add_ping_pong and hn_add_weighted,
// as in the fractals of these names, and hn_add_detail and hn_add_footprint for octaves without detail that a pixel
// cannot show. The fractals of the library are made so (fbm1d.glsl). Evaluate your own noise, if it takes a position,
// at hn_position(o.place).
//
//   place    where to evaluate the noise of the octave
//   seed     its seed
//   (the rest belongs to the library)
struct hn_octaves1 {
  hn_place1 place;
  hn_uint seed;
  hn_i_octave_sum sum;
  hn_float lacunarity;
  hn_ivec2 x;  // fixed-point positions, along each axis (octave.glsl)
#if HN_ARITHMETIC != HN_FIXED
  hn_float p;  // or a position in floats
  bool is_fixed_point;
#endif
};

// Puts the place where the fixed-point position is. Neither this nor hn_next touches what a period is made of where
// there is none: compilers could no longer see that there is none.
HN_FN void hn_i_update_place(HN_I_INOUT(hn_octaves1) o) {
  o.place.cell = o.x.x;
  o.place.fraction = hn_i_fixed_fraction(o.x);
  o.place.rest = HN_I_REST(o.x.y & 15);
}

HN_FN hn_octaves1 hn_i_octaves(hn_place1 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  HN_I_NEW(hn_octaves1, o);
  o.place = place;
  o.seed = seed;
  o.sum = hn_i_empty_sum(octaves, gain);
  o.lacunarity = lacunarity;
  o.x = hn_i_fixed_position(place.cell, place.fraction, place.rest);
#if HN_ARITHMETIC != HN_FIXED
  o.p = 0.0f;
  o.is_fixed_point = true;
#endif
  return o;
}

#if HN_ARITHMETIC != HN_FIXED
// The position of the next octave.
HN_FN hn_float hn_i_next(hn_float q, hn_float lacunarity) { return hn_i_multiply_add(q, lacunarity, 11.0f / 32.0f); }
#endif

// Advances to the fixed-point position of the next octave. A tile must not rotate, as it would not fit itself.
HN_FN void hn_i_advance(HN_I_INOUT(hn_octaves1) o) {
  hn_uint ratio = hn_i_ratio(o.lacunarity);
  o.x = hn_i_shifted(hn_i_times_ratio(o.x, ratio), HN_I_SHIFT_X);
  if (o.place.tiled) o.place.period = hn_i_next_period(o.place.period, o.lacunarity);
  hn_i_update_place(o);
}

// ---------------------------------------------------------------------------------------------------------------------
// From here octaves1d.glsl, octaves3d.glsl and octaves4d.glsl are generated from octaves2d.glsl.

// The octaves of a fractal over your own noise, with the place and the seed of the first one.
//   p           position, in cells of the first octave: a coordinate times a frequency, so that a cell is as large as
//               the largest hills. Less than 2^23 / lacunarity^octaves - 1 along each axis, for a lacunarity of 2 or
//               more: larger floats have no fraction
//   place       in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl).
//               The period of a tile times lacunarity^octaves is below 2^31
//   octaves     how many, usually 4 to 8; more than 32 count as 32, and with fewer than 1 the mean is 0
//   lacunarity  ratio of frequencies from octave to octave, usually 2. In a tile it is a whole number from 1 to 255;
//               others are rounded down
//   gain        ratio of amplitudes (persistence), usually 0.5; not negative
//   seed        any uint: 7u, not 7; different seeds give independent fields
//   example     hn_octaves1 o = hn_octaves(uv.x * 8.0, 6, 2.0, 0.5, 7u);
//   returns     the octaves
//   error       at a position it grows with |p| * lacunarity^octaves, since a float rounds the positions; at a place it
//               does not
//   cost        none: hn_next places each octave
//   HN_FIXED    takes a gain above 1 as 1, and a lacunarity outside [0, 255] as 0 or 255
//   source      docs/reference/contract.md, section 7
HN_FN hn_octaves1 hn_octaves(hn_place1 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_float ratio = hn_i_lacunarity(min(max(0.0f, lacunarity), 255.0f), place.tiled);
  hn_octaves1 o = hn_i_octaves(place, octaves, ratio, gain, seed);
  hn_i_update_place(o);
  return o;
}
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_octaves1 hn_octaves(hn_float p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_float start = hn_i_flushed_position(p);
  hn_octaves1 o = hn_i_octaves(hn_place(start), octaves, lacunarity, gain, seed);
  o.p = start;
  o.is_fixed_point = false;
  return o;
}
#else
HN_FN hn_octaves1 hn_octaves(hn_float p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_octaves(hn_place(p), octaves, lacunarity, gain, seed);
}
#endif

// The octaves that a pixel can show: with a fractional number of octaves, for hn_add_detail, or with a footprint, for
// hn_add_footprint.
//   detail      octaves, as a float: 3.5 is three octaves and half of the fourth. So octaves from the second on come
//               and go without a jump. Up to 1 it is the whole first octave, below 2^-32 none, and
//               above 32 it counts as 32
//   footprint   the size of a pixel at p, in cells of the first octave: in a fragment shader max(length(dFdx(p)),
//               length(dFdy(p))). An octave fades out as a pixel grows from 1/2 to 3/2 of its cells, which comes
//               nearest to the mean over the pixel. The others keep their contrast
//   (other parameters, error, cost and source as above)
//   example     hn_octaves1 o = hn_octaves(uv.x * 8.0, 3.5, 2.0, 0.5, 7u);
//   returns     the octaves
HN_FN hn_octaves1 hn_octaves(hn_float p, hn_float detail, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_int octaves = hn_i_whole_octaves(detail);
  hn_octaves1 o = hn_octaves(p, octaves, lacunarity, gain, seed);
  o.sum.part = hn_i_last_part(detail, octaves);
  return o;
}
HN_FN hn_octaves1 hn_octaves(hn_float p, hn_float footprint, hn_int octaves, hn_float lacunarity, hn_float gain,
                             hn_uint seed) {
  hn_octaves1 o = hn_octaves(p, octaves, lacunarity, gain, seed);
  o.sum.footprint = hn_i_footprint(footprint);
  return o;
}

// Moves on to the next octave.
//   o        the octaves
//   example  do hn_add(o, hn_perlin(o.place, o.seed)); while (hn_next(o));
//   returns  whether there is one
//   error    as of hn_octaves
//   cost     about 10 operations; in HN_FIXED, and at a place, some products of integers
//   source   as of hn_octaves
HN_FN bool hn_next(HN_I_INOUT(hn_octaves1) o) {
  o.sum.at += 1;
  bool more = hn_i_to_bool(o.sum.at < o.sum.octaves);
#ifdef __cplusplus
  if (!more) return false;  // behind the last octave a position may not fit an int; a GPU needs no branch
#endif
  o.seed += HN_I_SEED_STEP;
  o.sum.weight = hn_i_weight_times(o.sum.weight, o.sum.gain);
#if HN_ARITHMETIC != HN_FIXED
  if (o.is_fixed_point) {
    hn_i_advance(o);
  } else {
    o.p = hn_i_next(o.p, o.lacunarity);
    o.place.cell = hn_i_cell(o.p);
    o.place.fraction = hn_i_fraction(o.p);
  }
#else
  hn_i_advance(o);
#endif
  return more;
}

// tools/make catalog: steps

// Add the noise of an octave: as it is (hn_fbm, hn_clouds); its absolute value (hn_turbulence); a crest where it is 0
// (hn_ridged); its height above -1, as far as the octave before lets it (hn_hybrid); folded up and down between -1 and
// 1 (hn_ping_pong); so that finer octaves count less where it is low (hn_weighted).
//   o         the octaves
//   n         the noise at o.place with o.seed, in [-1, 1]. hn_add and hn_add_turbulence take values beyond (HN_FIXED
//             up to 3/2), others cut them off. hn_add takes whole octaves: of hn_octaves(p, 4.5, ...) it adds 5, and
//             hn_add_detail half of the last
//   strength  of hn_ping_pong, usually 2, in [0, 64]; of hn_weighted, usually 1, in [0, 1]
//   example   do hn_add(o, hn_value(o.place, o.seed)); while (hn_next(o));
//   returns   nothing: the octaves hold the result so far
//   error     as of the fractals in fbm1d.glsl
//   cost      1 to 10 operations
//   source    docs/reference/contract.md, section 7
HN_FN void hn_add(HN_I_INOUT(hn_octaves1) o, hn_float n) { o.sum = hn_i_add_noise(o.sum, n); }
HN_FN void hn_add_turbulence(HN_I_INOUT(hn_octaves1) o, hn_float n) { o.sum = hn_i_add_turbulence(o.sum, n); }
HN_FN void hn_add_ridged(HN_I_INOUT(hn_octaves1) o, hn_float n) { o.sum = hn_i_add_ridged(o.sum, n); }
HN_FN void hn_add_hybrid(HN_I_INOUT(hn_octaves1) o, hn_float n) { o.sum = hn_i_add_hybrid(o.sum, n); }
HN_FN void hn_add_ping_pong(HN_I_INOUT(hn_octaves1) o, hn_float n, hn_float strength) {
  o.sum = hn_i_add_ping_pong(o.sum, n, strength);
}
HN_FN void hn_add_weighted(HN_I_INOUT(hn_octaves1) o, hn_float n, hn_float strength) {
  o.sum = hn_i_add_weighted(o.sum, n, strength);
}
// tools/make catalog: end

// Add the noise of an octave as it is, and as much of it as a detail or a footprint leaves.
//   n         the noise. hn_add_detail and hn_add_footprint take values beyond [-1, 1], as hn_add does
//   (other parameters, error, cost and source as above)
//   example   do hn_add_detail(o, hn_value(o.place, o.seed)); while (hn_next(o));
//   returns   nothing: the octaves hold the result so far
HN_FN void hn_add_detail(HN_I_INOUT(hn_octaves1) o, hn_float n) { o.sum = hn_i_add_detail(o.sum, n); }
HN_FN void hn_add_footprint(HN_I_INOUT(hn_octaves1) o, hn_float n) {
  o.sum = hn_i_add_footprint(o.sum, n, o.lacunarity);
}

// The mean of the octaves by their weights.
//   o        the octaves, after the last
//   example  float n = hn_mean(o);
//   returns  [-1, 1]; of hn_add_turbulence, hn_add_ridged and hn_add_hybrid [0, 1]. Roundings may take floats
//            beyond by 1e-6
//   error    as of the fractals in fbm1d.glsl
//   cost     a division; with a number of octaves that is no constant some operations for each
//   source   docs/reference/contract.md, section 7
HN_FN hn_float hn_mean(hn_octaves1 o) { return hn_i_value(hn_i_mean(o.sum)); }

// The density of a sky, from the mean of hn_add: clear below -1/8 and dense above 3/8, with a smooth step between.
//   o        the octaves, after the last
//   example  float n = hn_density(o);
//   returns  [0, 1]
//   error    as of hn_clouds in fbm1d.glsl
//   cost     hn_mean's, and some operations
//   source   as of hn_clouds
HN_FN hn_float hn_density(hn_octaves1 o) { return hn_i_value(hn_i_density(hn_i_mean(o.sum))); }

// To here octaves1d.glsl, octaves3d.glsl and octaves4d.glsl are generated from octaves2d.glsl.

#endif
