// hashnoise: octave sums over a noise on the plane.
// SPDX-License-Identifier: MIT
//
// The noise is hn_perlin unless you name another: define HN_FBM_NOISE2D(q, seed) before the first include. It must be
// in [-1, 1] for the ranges below to hold.

#ifndef HN_FBM2D_GLSL
#define HN_FBM2D_GLSL

#include "octaves.glsl"
#include "perlin2d.glsl"

#if HN_ARITHMETIC == HN_FIXED

// The noise of an octave, in units of 2^-21.
#ifdef HN_FBM_NOISE2D
HN_FN hn_int hn_i_octave(hn_uvec2 x, hn_uvec2 y, hn_uint seed) {
  hn_float n = HN_FBM_NOISE2D(vec2(hn_i_short(x), hn_i_short(y)), seed);
  return int(min(max(n, -1.0f), 1.0f) * 2097152.0f);
}
#else
HN_FN hn_int hn_i_octave(hn_uvec2 x, hn_uvec2 y, hn_uint seed) {
  return hn_i_perlin(ivec2(int(x.x), int(y.x)), ivec2(int(x.y >> 12u), int(y.y >> 12u)), seed);
}
#endif

HN_FN hn_int hn_i_tiled_octave(hn_uvec2 x, hn_uvec2 y, hn_ivec2 period, hn_uint seed) {
  hn_ivec2 cell = ivec2(int(x.x), int(y.x));
  return hn_i_perlin(cell, ivec2(int(x.y >> 12u), int(y.y >> 12u)), period, seed);
}

// The sum in integers. 0x58000000 and 0x98000000 are 11/32 and 19/32 of a cell, as below.
HN_FN hn_int hn_i_octaves(hn_vec2 p, hn_ivec2 period, bool tiled, hn_int octaves, hn_float lacunarity, hn_float gain,
                          hn_uint seed, bool absolute) {
  hn_uvec2 x = hn_i_long(p.x);
  hn_uvec2 y = hn_i_long(p.y);
  hn_uint ratio = hn_i_lacunarity(lacunarity);
  if (tiled) ratio &= 0xFF800000u;  // a whole number
  hn_int fall = hn_i_gain(gain);
  hn_int sum = 0;
  hn_int total = 0;
  hn_int weight = 262144;
  for (hn_int i = 0; i < min(octaves, 32); ++i) {
    hn_int n;
    if (tiled) {
      n = hn_i_tiled_octave(x, y, period, seed);
      period = ivec2(uvec2(period) * (ratio >> 23u));
    } else {
      n = hn_i_octave(x, y, seed);
    }
    sum += hn_i_weighted(hn_i_select(absolute, max(n, -n), n), weight);
    total += weight;
    weight = hn_i_next_weight(weight, fall);
    x = hn_i_next_octave(x, ratio, 0x58000000u);
    y = hn_i_next_octave(y, ratio, 0x98000000u);
    seed += 0x9E3779B9u;
  }
  return octaves < 1 ? 0 : hn_i_mean(sum, total);
}

#endif

// Behind the include another noise would change nothing. As this one stays defined, a compiler says so: it is a second
// definition. (HN_FIXED has no other use for it.)
#ifndef HN_FBM_NOISE2D
#define HN_FBM_NOISE2D(q, seed) hn_perlin(q, seed)  // yours: define it before the include
#endif

#if HN_ARITHMETIC != HN_FIXED

// The sum that octaves.glsl describes.
HN_FN hn_float hn_i_octaves(hn_vec2 p, hn_ivec2 period, bool tiled, hn_int octaves, hn_float lacunarity, hn_float gain,
                            hn_uint seed, bool absolute) {
  hn_vec2 q = hn_i_start(p);
  hn_float ratio = lacunarity;
  if (tiled) ratio = hn_i_whole(lacunarity);
  hn_float sum = 0.0f;
  hn_float total = 0.0f;
  hn_float weight = 1.0f;
  for (hn_int i = 0; i < octaves; ++i) {
    hn_float n;
    if (tiled) {
      n = hn_perlin(q, period, seed);
      period = ivec2(uvec2(period) * uint(ratio));
    } else {
      n = HN_FBM_NOISE2D(q, seed);
    }
    sum = hn_i_times_plus(weight, hn_i_select(absolute, abs(n), n), sum);
    total = hn_i_times_plus(gain, total, 1.0f);
    weight = hn_i_times(weight, gain);
    q = hn_i_times_plus(q, ratio, vec2(11.0f / 32.0f, 19.0f / 32.0f));
    seed += 0x9E3779B9u;
  }
  return octaves < 1 ? 0.0f : hn_i_quotient(sum, total);
}

#endif

// Fractional Brownian motion: octaves of noise, each finer by the lacunarity and weaker by the gain.
//   p           position, in cells of the first octave; (|p| + 1) * lacunarity^octaves < 2^23, for a lacunarity of 2
//               or more
//   octaves     how many; with fewer than 1 the sum is 0
//   lacunarity  ratio of frequencies, usually 2
//   gain        ratio of amplitudes, usually 0.5; not negative, and the sum of its powers below 2^126 (HN_PRECISE:
//               2^100)
//   seed        any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns     [-1, 1], mean 0
//   error       grows with |p| * lacunarity^octaves, since a float rounds the positions (docs/accuracy.md)
//   period      none that floats reach. HN_FIXED repeats after 2^32 cells of any octave
//   cost        1 noise per octave
//   HN_FIXED    takes a gain above 1 as 1, a lacunarity outside [0, 255] as 0 or 255, and more than 32 octaves as 32.
//               The error does not grow with |p|
//   source      Musgrave, in "Texturing and Modeling: A Procedural Approach"
HN_FN hn_float hn_fbm(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, ivec2(0), false, octaves, lacunarity, gain, seed, false));
}

HN_FN hn_float hn_fbm(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_fbm(p, octaves, lacunarity, gain, 0u);
}

// The same with a period: octave i repeats after period * lacunarity^i of its cells, so the sum repeats after the
// period, and no sooner. The octaves are hn_perlin, whatever HN_FBM_NOISE2D names.
//   period      cells of the first octave along each axis, any ivec2; 0 for none along that axis;
//               period * lacunarity^octaves < 2^31
//   lacunarity  a whole number from 1 to 255; others are rounded down
//   error       that of hn_perlin at positions that a float rounds; HN_FIXED as above
//   cost        1 noise with a period per octave
HN_FN hn_float hn_fbm(hn_vec2 p, hn_ivec2 period, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, period, true, octaves, lacunarity, gain, seed, false));
}

// Turbulence: the mean of the octaves' absolute values, which have creases where the noise passes 0. Use it for marble,
// fire and billows.
//   (parameters, error, period and cost as for hn_fbm)
//   returns  [0, 1]
//   source   Perlin, "An image synthesizer", 1985; Valdenegro-Toro and Pincheira, fig. 6
HN_FN hn_float hn_turbulence(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, ivec2(0), false, octaves, lacunarity, gain, seed, true));
}

HN_FN hn_float hn_turbulence(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_turbulence(p, octaves, lacunarity, gain, 0u);
}

HN_FN hn_float hn_turbulence(hn_vec2 p, hn_ivec2 period, hn_int octaves, hn_float lacunarity, hn_float gain,
                             hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, period, true, octaves, lacunarity, gain, seed, true));
}

// Clouds: the density of a sky, from an fBm.
//   (parameters, period and cost as for hn_fbm)
//   returns  [0, 1]: 0 is clear, 1 is dense; with fewer than 1 octave 5/32
//   error    3 times that of hn_fbm, plus 5.4e-7 (HN_FIXED 2.6e-5)
//   source   after the cloud images of Valdenegro-Toro and Pincheira, fig. 6; the paper has no formula for them
HN_FN hn_float hn_clouds(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_cloud_density(hn_i_octaves(p, ivec2(0), false, octaves, lacunarity, gain, seed, false)));
}

HN_FN hn_float hn_clouds(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_clouds(p, octaves, lacunarity, gain, 0u);
}

HN_FN hn_float hn_clouds(hn_vec2 p, hn_ivec2 period, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_cloud_density(hn_i_octaves(p, period, true, octaves, lacunarity, gain, seed, false)));
}

#endif
