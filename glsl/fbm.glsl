// hashnoise: octave sums over a noise.
// SPDX-License-Identifier: MIT
//
// The noise is hn_perlin unless you name another. To name one, define HN_FBM_NOISE2D(q, seed) for the functions of a
// vec2 or HN_FBM_NOISE3D(q, seed) for those of a vec3, before the first include. The ranges below hold if it returns
// values in [-1, 1].

#ifndef HN_FBM_GLSL
#define HN_FBM_GLSL

#include "fbm_fixed.glsl"
#include "noise2d.glsl"
#include "noise3d.glsl"

// After the include another noise would have no effect. These macros stay defined, so a compiler reports it as a second
// definition. (With HN_FIXED this is their only use.)
#ifndef HN_FBM_NOISE2D
#define HN_FBM_NOISE2D(q, seed) hn_perlin(q, seed)  // yours: define it before the include
#endif
#ifndef HN_FBM_NOISE3D
#define HN_FBM_NOISE3D(q, seed) hn_perlin(q, seed)  // yours: define it before the include
#endif

#if HN_ARITHMETIC != HN_FIXED

// The mean of the octaves, or of their absolute values, weighted by gain^i. Each octave has its own seed: the step is
// 2^32 divided by the golden ratio, so that the octaves of nearby seeds do not coincide either. The noise is 0 at the
// lattice points of an octave, and the shift keeps those of all octaves from meeting at the origin.
HN_FN hn_float hn_i_octaves(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed,
                            bool absolute) {
  hn_vec2 q = hn_i_start(p);
  hn_float sum = 0.0f;
  hn_float total = 0.0f;
  hn_float weight = 1.0f;
  for (hn_int i = 0; i < octaves; ++i) {
    hn_float n = HN_FBM_NOISE2D(q, seed);
    sum = hn_i_times_plus(weight, hn_i_select(absolute, abs(n), n), sum);
    total = hn_i_times_plus(gain, total, 1.0f);
    weight = hn_i_times(weight, gain);
    q = hn_i_times_plus(q, lacunarity, vec2(11.0f / 32.0f, 19.0f / 32.0f));
    seed += 0x9E3779B9u;
  }
  return octaves < 1 ? 0.0f : hn_i_quotient(sum, total);
}

HN_FN hn_float hn_i_octaves(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed,
                            bool absolute) {
  hn_vec3 q = hn_i_start(p);
  hn_float sum = 0.0f;
  hn_float total = 0.0f;
  hn_float weight = 1.0f;
  for (hn_int i = 0; i < octaves; ++i) {
    hn_float n = HN_FBM_NOISE3D(q, seed);
    sum = hn_i_times_plus(weight, hn_i_select(absolute, abs(n), n), sum);
    total = hn_i_times_plus(gain, total, 1.0f);
    weight = hn_i_times(weight, gain);
    q = hn_i_times_plus(q, lacunarity, vec3(11.0f / 32.0f, 19.0f / 32.0f, 23.0f / 32.0f));
    seed += 0x9E3779B9u;
  }
  return octaves < 1 ? 0.0f : hn_i_quotient(sum, total);
}

// Makes a sky from an fBm: it is clear below -1/8 and dense above 3/8, with a smooth step between.
HN_FN hn_float hn_i_cloud_density(hn_float fbm) {
  return hn_i_smooth(min(max(hn_i_times_plus(2.0f, fbm, 0.25f), 0.0f), 1.0f));
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
//   returns     [-1, 1], mean 0; with HN_GRADIENT_SINE in space [-3/2, 3/2]
//   error       grows with |p| * lacunarity^octaves, since a float rounds the positions (docs/accuracy.md)
//   period      HN_PERIOD, with a whole lacunarity (HN_FIXED: with a period that is not a power of two, only up to
//               2^31 cells of the last octave). Without HN_PERIOD, HN_FIXED repeats after 2^32 cells of any octave, and
//               floats do not reach so far
//   cost        1 noise per octave
//   HN_FIXED    takes a gain above 1 as 1, a lacunarity outside [0, 255] as 0 or 255, and more than 32 octaves as 32.
//               The error does not grow with |p|
//   source      Musgrave, in "Texturing and Modeling: A Procedural Approach"
HN_FN hn_float hn_fbm(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, octaves, lacunarity, gain, seed, false));
}

HN_FN hn_float hn_fbm(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, octaves, lacunarity, gain, seed, false));
}

HN_FN hn_float hn_fbm(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_fbm(p, octaves, lacunarity, gain, 0u);
}

HN_FN hn_float hn_fbm(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_fbm(p, octaves, lacunarity, gain, 0u);
}

// Turbulence: the mean of the octaves' absolute values, which have creases where the noise passes 0. Use it for marble,
// fire and billows.
//   (parameters, error, period and cost as for hn_fbm)
//   returns  [0, 1]; with HN_GRADIENT_SINE in space [0, 3/2]
//   source   Perlin, "An image synthesizer", 1985; Valdenegro-Toro and Pincheira, fig. 6
HN_FN hn_float hn_turbulence(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, octaves, lacunarity, gain, seed, true));
}

HN_FN hn_float hn_turbulence(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_octaves(p, octaves, lacunarity, gain, seed, true));
}

HN_FN hn_float hn_turbulence(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_turbulence(p, octaves, lacunarity, gain, 0u);
}

HN_FN hn_float hn_turbulence(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_turbulence(p, octaves, lacunarity, gain, 0u);
}

// Clouds: the density of a sky, from an fBm.
//   (parameters, period and cost as for hn_fbm)
//   returns  [0, 1]: 0 is clear, 1 is dense; with fewer than 1 octave 5/32
//   error    3 times that of hn_fbm, plus 5.4e-7 (HN_FIXED 2.6e-5)
//   source   after the cloud images of Valdenegro-Toro and Pincheira, fig. 6; the paper has no formula for them
HN_FN hn_float hn_clouds(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_cloud_density(hn_i_octaves(p, octaves, lacunarity, gain, seed, false)));
}

HN_FN hn_float hn_clouds(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_value(hn_i_cloud_density(hn_i_octaves(p, octaves, lacunarity, gain, seed, false)));
}

HN_FN hn_float hn_clouds(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_clouds(p, octaves, lacunarity, gain, 0u);
}

HN_FN hn_float hn_clouds(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_clouds(p, octaves, lacunarity, gain, 0u);
}

#endif
