// hashnoise: feature points that circle with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_POINTS_MOVING_GLSL
#define HN_FEATURE_POINTS_MOVING_GLSL

#include "direction_turning.glsl"
#include "feature_points.glsl"

// All points circle the centres of their cells alike. So the place is rotated instead, backwards, once for all points.
// Distances stay as they are, but only the Euclidean ones do.
//
// A point on its way leaves the square or octahedron on which it lies at a phase of 0, but not the circle or sphere
// around that. So it must be nearer to the centre of its cell than without a phase: or else a cell and its neighbours
// would not always have the two nearest points.
//
//   hn_i_jitter(j, n)            n / 32 of the jitter
//   hn_i_projected(d, b)         an offset times a cosine or a sine
//   hn_i_turned_offset(d, b, n)  the offset from the centre of the n-th cell after a cell, along an axis that rotates
//                                to b. d is the offset from the centre of that cell, rotated
//   hn_i_row(d, b)               that for n from -1 to 1

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_jitter(hn_float jitter, hn_int n) {
  return hn_i_times(hn_i_times(hn_i_jitter(jitter), hn_i_float(n)), 1.0f / 32.0f);
}
HN_FN hn_float hn_i_projected(hn_float d, hn_float b) { return hn_i_times(d, b); }
HN_FN hn_float hn_i_turned_offset(hn_float d, hn_float b, hn_int n) {
  return hn_i_minus(d, hn_i_times(hn_i_float(n * 2), b));
}

#else

HN_FN hn_int hn_i_jitter(hn_float jitter, hn_int n) { return (hn_i_jitter(jitter) * n) >> 5; }

// A cosine is in units of 2^-18, and an offset that is rotated has up to 21 bits. A product with its high bits has 31.
HN_FN hn_int hn_i_projected(hn_int d, hn_int b) { return (((d >> 8) * b) >> 10) + (((d & 255) * b) >> 18); }
HN_FN hn_int hn_i_turned_offset(hn_int d, hn_int b, hn_int n) { return d - n * 4 * b; }

#endif

HN_FN hn_i_num3 hn_i_row(hn_i_num d, hn_i_num b) {
  return hn_i_triple(hn_i_turned_offset(d, b, -1), d, hn_i_turned_offset(d, b, 1));
}

#endif
