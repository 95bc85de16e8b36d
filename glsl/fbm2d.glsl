// hashnoise: octave sums over a noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM2D_GLSL
#define HN_FBM2D_GLSL

#include "octaves_plane.glsl"
#include "perlin2d.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Sums over other noises than hn_perlin. Each of these lines, outside of all functions and without a semicolon, defines
// the functions of a sum:
//
//   HN_FBM2D(my_sum, hn_simplex)           my_sum(p, octaves, lacunarity, gain [, seed]), and at a place
//   HN_FBM_LIMITED2D(my_lod, hn_simplex)   my_lod(p, detail, ...) and my_lod(p, footprint, octaves, ...)
//
// In place of FBM the others are TURBULENCE, CLOUDS, BILLOW, RIDGED, PING_PONG and WEIGHTED (these have no LIMITED).
// What they take and return is said below. The noise is called with a place and a seed, as any noise of the library can
// be. To sum your own float mine(vec2 p), write
//
//   float mine(hn_place2 place, uint seed) { return mine(hn_position(place)); }
#define HN_FBM2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_FBM)
#define HN_TURBULENCE2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_TURBULENCE)
#define HN_CLOUDS2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_CLOUDS)
#define HN_BILLOW2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_BILLOW)
#define HN_RIDGED2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_RIDGED)
#define HN_PING_PONG2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_PING_PONG)
#define HN_WEIGHTED2D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES2, HN_I_OF_WEIGHTED)
#define HN_FBM_LIMITED2D(name, noise) HN_I_LIMITED_OF(name, noise, HN_I_TYPES2)

// ---------------------------------------------------------------------------------------------------------------------
// Sums over hn_perlin. Each has three forms:
//
//   hn_fbm(p, octaves, lacunarity, gain)
//   hn_fbm(p, octaves, lacunarity, gain, seed)
//   hn_fbm(place, octaves, lacunarity, gain, seed)

// Fractional Brownian motion: octaves of noise, each finer by the lacunarity, weaker by the gain, and turned.
//   p           position, in cells of the first octave; (|p| + 1) * lacunarity^octaves < 2^23, for a lacunarity of 2
//               or more
//   place       a place in its stead, in cells of the first octave (place.glsl). The period of a tile times
//               lacunarity^octaves is below 2^31
//   octaves     how many; with fewer than 1 the sum is 0
//   lacunarity  ratio of frequencies, usually 2. In a tile it is a whole number from 1 to 255; others are rounded
//               down
//   gain        ratio of amplitudes, usually 0.5; not negative, and the sum of its powers below 2^126 (HN_PRECISE:
//               2^100)
//   seed        any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns     [-1, 1], mean 0
//   error       at a position it grows with |p| * lacunarity^octaves, since a float rounds the positions; at a place it
//               does not (docs/accuracy.md)
//   period      none that floats reach. In a tile octave i repeats after period * lacunarity^i of its cells, so the sum
//               repeats after the period, and no sooner. Octaves are not turned there, since they would not fit: a tile
//               shows the axes more than other sums do
//   cost        1 noise per octave
//   HN_FIXED    takes a gain above 1 as 1, a lacunarity outside [0, 255] as 0 or 255, and more than 32 octaves as 32.
//               The error does not grow with |p|
//   source      Musgrave, in "Texturing and Modeling: A Procedural Approach"
HN_FBM2D(hn_fbm, hn_perlin)

// The same without detail that a pixel cannot show: hn_fbm(p, detail, lacunarity, gain, seed) with a float, and
// hn_fbm(p, footprint, octaves, lacunarity, gain, seed).
//   detail      octaves, as a float: 3.5 is three octaves and half of the fourth. So octaves can come and go without a
//               jump
//   footprint   the size of a pixel at p, in cells of the first octave: in a fragment shader
//               max(length(dFdx(p)), length(dFdy(p))). An octave fades out as a pixel grows from 1/2 to 3/2 of
//               its cells, which comes nearest to the mean over the pixel. The others keep their contrast
//   (other parameters, error, period, HN_FIXED and source as for hn_fbm at a position)
//   returns     [-1, 1], mean 0
//   cost        1 noise per octave; octaves that have faded out cost none
HN_FBM_LIMITED2D(hn_fbm, hn_perlin)

// Turbulence: the mean of the octaves' absolute values, which have creases where the noise passes 0. Use it for marble
// and fire.
//   (parameters, error, period and cost as for hn_fbm)
//   returns  [0, 1]
//   source   Perlin, "An image synthesizer", 1985; Valdenegro-Toro and Pincheira, fig. 6
HN_TURBULENCE2D(hn_turbulence, hn_perlin)

// Billows: twice the turbulence less 1, so that heights are in the range of other noise. The round hills are the other
// side of ridges.
//   (parameters, period and cost as for hn_fbm)
//   returns  [-1, 1]
//   error    twice that of hn_turbulence
//   source   as for hn_turbulence
HN_BILLOW2D(hn_billow, hn_perlin)

// Clouds: the density of a sky, from an fBm.
//   (parameters, period and cost as for hn_fbm)
//   returns  [0, 1]: 0 is clear, 1 is dense; with fewer than 1 octave 5/32
//   error    3 times that of hn_fbm, plus 5.4e-7 (HN_FIXED 2.6e-5)
//   source   after the cloud images of Valdenegro-Toro and Pincheira, fig. 6; the paper has no formula for them
HN_CLOUDS2D(hn_clouds, hn_perlin)

// Ridges: sharp crests where the noise passes 0. Finer octaves show on the crests and leave the valleys smooth.
//   (parameters, period and cost as for hn_fbm)
//   returns  [0, 1]: 1 on a crest of every octave
//   error    grows with the octaves, since each is taken times the one before: docs/accuracy.md
//   source   Musgrave, as for hn_fbm: his ridged multifractal with the offset 1 and the gain 2, divided by the sum of
//            the weights
HN_RIDGED2D(hn_ridged, hn_perlin)

// Ping-pong: each octave is folded up and down between -1 and 1, which gives the rings of wood and of agate.
//   strength    how many times from one end to the other on the way from -1 to 1, times 1/2; usually 2, in [0, 64]
//   (other parameters, period and cost as for hn_fbm; the strength stands behind the gain)
//   returns  [-1, 1]
//   error    twice the strength times that of hn_fbm, and a little more; docs/accuracy.md
//   source   FastNoiseLite, FractalType_PingPong
HN_PING_PONG2D(hn_ping_pong, hn_perlin)

// Weighted fBm: where an octave is low, the finer ones count less, so that valleys are smoother than heights.
//   strength    how much less: 0 is hn_fbm, 1 leaves nothing of the finer octaves at -1; in [0, 1]
//   (other parameters, period and cost as for hn_fbm; the strength stands behind the gain)
//   returns  [-1, 1]
//   error    docs/accuracy.md
//   source   FastNoiseLite, SetFractalWeightedStrength
HN_WEIGHTED2D(hn_weighted, hn_perlin)

#endif
