// hashnoise: the octaves of a sum in space.
// SPDX-License-Identifier: MIT

#ifndef HN_OCTAVES3D_GLSL
#define HN_OCTAVES3D_GLSL

#include "octave.glsl"

// The octaves of a sum, one after another, over any noise:
//
//   hn_octaves3 o = hn_octaves(p, 6, 2.0, 0.5, 7u);
//   do hn_add(o, hn_simplex(o.place, o.seed)); while (hn_next(o));
//   float height = hn_mean(o);
//
// It asks behind an octave, since drivers unroll such a loop, and run it faster than one that asks first. In place of
// hn_add there are hn_add_size, hn_add_ridge, hn_add_wave and hn_add_bent; and hn_add_part and hn_add_resolved for
// octaves without detail that a pixel cannot show. The sums of the library are made so (fbm3d.glsl). To sum a noise of
// your own, which takes a position, ask for it at hn_position(o.place).
//
//   place    where the noise of the octave is asked
//   seed     its seed
//   (the rest belongs to the library)
struct hn_octaves3 {
  hn_place3 place;
  hn_uint seed;
  hn_i_octave_sum sum;
  hn_float lacunarity;
  hn_ivec2 x;  // whole positions, along each axis (octave.glsl)
  hn_ivec2 y;
  hn_ivec2 z;
#if HN_ARITHMETIC != HN_FIXED
  hn_vec3 p;  // or a position in floats
  bool is_whole;
#endif
};

// Puts the place where the whole position is. Neither this nor hn_next touches what a period is made of where there is
// none: compilers could no longer see that there is none.
HN_FN void hn_i_put(HN_I_INOUT(hn_octaves3) o) {
  o.place.cell = ivec3(o.x.x, o.y.x, o.z.x);
  o.place.fraction = hn_i_num(hn_i_whole_fraction(o.x), hn_i_whole_fraction(o.y), hn_i_whole_fraction(o.z));
  o.place.rest = ivec3(HN_I_REST(o.x.y & 15), HN_I_REST(o.y.y & 15), HN_I_REST(o.z.y & 15));
}

HN_FN hn_octaves3 hn_i_octaves(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  HN_I_NEW(hn_octaves3, o);
  o.place = place;
  o.seed = seed;
  o.sum = hn_i_no_octave(octaves, gain);
  o.lacunarity = lacunarity;
  o.x = hn_i_whole(place.cell.x, place.fraction.x, place.rest.x);
  o.y = hn_i_whole(place.cell.y, place.fraction.y, place.rest.y);
  o.z = hn_i_whole(place.cell.z, place.fraction.z, place.rest.z);
#if HN_ARITHMETIC != HN_FIXED
  o.p = vec3(0.0f, 0.0f, 0.0f);
  o.is_whole = true;
#endif
  return o;
}

// The octaves of a sum, at the first. octaves2d.glsl says more.
//   p, place    as on the plane
//   octaves     how many; with fewer than 1 the mean is 0
//   lacunarity  ratio of frequencies, usually 2. In a tile it is a whole number from 1 to 255
//   gain        ratio of amplitudes, usually 0.5; not negative
//   seed        any uint: 7u, not 7
//   returns     the octaves
//   error, cost, source    as on the plane
HN_FN hn_octaves3 hn_octaves(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_float ratio = hn_i_lacunarity(min(max(lacunarity, 0.0f), 255.0f), place.tiled);
  hn_octaves3 o = hn_i_octaves(place, octaves, ratio, gain, seed);
  hn_i_put(o);
  return o;
}
#if HN_ARITHMETIC == HN_FIXED
HN_FN hn_octaves3 hn_octaves(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_octaves(hn_place(p), octaves, lacunarity, gain, seed);
}
#else
HN_FN hn_octaves3 hn_octaves(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_vec3 start = hn_i_start(p);
  hn_octaves3 o = hn_i_octaves(hn_place(start), octaves, lacunarity, gain, seed);
  o.p = start;
  o.is_whole = false;
  return o;
}

// The next position.
HN_FN hn_vec3 hn_i_next(hn_vec3 q, hn_float lacunarity) {
  hn_float a = hn_i_times(lacunarity, 25.0f / 32.0f);
  hn_float b = hn_i_times(lacunarity, 20.0f / 32.0f);
  HN_I_PRECISE hn_float turned = b * q.x + a * q.y;
  hn_float c = hn_i_times(lacunarity, 29.0f / 32.0f);
  hn_float d = hn_i_times(lacunarity, 13.0f / 32.0f);
  HN_I_PRECISE hn_vec3 next =
      vec3(a * q.x - b * q.y + 11.0f / 32.0f, 29.0f / 32.0f * turned - d * q.z + 19.0f / 32.0f,
           13.0f / 32.0f * turned + c * q.z + 23.0f / 32.0f);
  return next;
}
#endif

// With a number of octaves that is no whole number, or a footprint.
//   (parameters, error, cost and source as on the plane)
//   returns     the octaves
HN_FN hn_octaves3 hn_octaves(hn_vec3 p, hn_float detail, hn_float lacunarity, hn_float gain, hn_uint seed) {
  hn_int octaves = hn_i_whole_octaves(detail);
  hn_octaves3 o = hn_octaves(p, octaves, lacunarity, gain, seed);
  o.sum.part = hn_i_last_part(detail, octaves);
  return o;
}
HN_FN hn_octaves3 hn_octaves(hn_vec3 p, hn_float footprint, hn_int octaves, hn_float lacunarity, hn_float gain,
                             hn_uint seed) {
  hn_octaves3 o = hn_octaves(p, octaves, lacunarity, gain, seed);
  o.sum.footprint = hn_i_footprint(footprint);
  return o;
}

// The next whole position. A tile must not rotate, as it would not fit itself.
HN_FN void hn_i_go_on(HN_I_INOUT(hn_octaves3) o) {
  hn_uint ratio = hn_i_ratio(o.lacunarity);
  hn_ivec2 x = hn_i_times_ratio(o.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(o.y, ratio);
  hn_ivec2 z = hn_i_times_ratio(o.z, ratio);
  if (o.place.tiled) {
    o.x = hn_i_shifted(x, HN_I_SHIFT_X);
    o.y = hn_i_shifted(y, HN_I_SHIFT_Y);
    o.z = hn_i_shifted(z, HN_I_SHIFT_Z);
    o.place.period.x = hn_i_next_period(o.place.period.x, o.lacunarity);
    o.place.period.y = hn_i_next_period(o.place.period.y, o.lacunarity);
    o.place.period.z = hn_i_next_period(o.place.period.z, o.lacunarity);
  } else {
    hn_ivec2 rotated = hn_i_rotated_axis(y, x, 25, 20);  // in the plane of x and y, and then in that of y and z
    o.x = hn_i_shifted(hn_i_rotated_axis(x, y, 25, -20), HN_I_SHIFT_X);
    o.y = hn_i_shifted(hn_i_rotated_axis(rotated, z, 29, -13), HN_I_SHIFT_Y);
    o.z = hn_i_shifted(hn_i_rotated_axis(z, rotated, 29, 13), HN_I_SHIFT_Z);
  }
  hn_i_put(o);
}

// Goes on to the next octave.
//   o        the octaves
//   returns  whether there is one
//   (error, cost and source as on the plane)
HN_FN bool hn_next(HN_I_INOUT(hn_octaves3) o) {
  o.sum.at += 1;
  bool more = hn_i_truth(o.sum.at < o.sum.octaves);
#ifdef __cplusplus
  if (!more) return false;  // behind the last octave a position may not fit an int; a GPU asks for no branch
#endif
  o.seed += 0x9E3779B9u;
  o.sum.weight = hn_i_weighed(o.sum.weight, o.sum.gain);
#if HN_ARITHMETIC == HN_FIXED
  hn_i_go_on(o);
#else
  if (o.is_whole) {
    hn_i_go_on(o);
  } else {
    o.p = hn_i_next(o.p, o.lacunarity);
    o.place.cell = hn_i_cell(o.p);
    o.place.fraction = hn_i_fraction(o.p);
  }
#endif
  return more;
}

// Add the noise of an octave.
//   (parameters, error, cost and source as on the plane)
//   returns     nothing: the octaves have the sum
HN_FN void hn_add(HN_I_INOUT(hn_octaves3) o, hn_float n) { o.sum = hn_i_with_noise(o.sum, n); }
HN_FN void hn_add_size(HN_I_INOUT(hn_octaves3) o, hn_float n) { o.sum = hn_i_with_size(o.sum, n); }
HN_FN void hn_add_ridge(HN_I_INOUT(hn_octaves3) o, hn_float n) { o.sum = hn_i_with_ridge(o.sum, n); }
HN_FN void hn_add_wave(HN_I_INOUT(hn_octaves3) o, hn_float n, hn_float strength) {
  o.sum = hn_i_with_wave(o.sum, n, strength);
}
HN_FN void hn_add_bent(HN_I_INOUT(hn_octaves3) o, hn_float n, hn_float strength) {
  o.sum = hn_i_with_bent(o.sum, n, strength);
}
HN_FN void hn_add_part(HN_I_INOUT(hn_octaves3) o, hn_float n) { o.sum = hn_i_with_part(o.sum, n); }
HN_FN void hn_add_resolved(HN_I_INOUT(hn_octaves3) o, hn_float n) {
  o.sum = hn_i_with_resolved(o.sum, n, o.lacunarity);
}

// The mean of the octaves by their weights.
//   (parameters, error, cost and source as on the plane)
//   returns  [-1, 1]; of hn_add_size and hn_add_ridge [0, 1]
HN_FN hn_float hn_mean(hn_octaves3 o) { return hn_i_value(hn_i_mean(o.sum)); }

// The density of a sky, from the mean of hn_add.
//   (parameters, error, cost and source as on the plane)
//   returns  [0, 1]
HN_FN hn_float hn_density(hn_octaves3 o) { return hn_i_value(hn_i_density(hn_i_mean(o.sum))); }

#endif
