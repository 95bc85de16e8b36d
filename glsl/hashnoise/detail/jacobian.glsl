// hashnoise: the Jacobians of octaves, for fractals with derivatives and with displacements.
// SPDX-License-Identifier: MIT
//
// The Jacobian of an octave is the matrix of derivatives of its position by the position of the fractal, times the
// octave's weight. On the plane a vector (x, y) stands for the matrix with the rows (x, -y) and (y, x). In space there
// are three rows. From one octave to the next the Jacobian grows by gain * lacunarity, and it is rotated as positions
// are.

#ifndef HN_JACOBIAN_GLSL
#define HN_JACOBIAN_GLSL

#include "octave.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Steps of numbers. With HN_FIXED a Jacobian is in units of 2^-18, as weights are.
//
//   hn_i_wide_times(a, b)  the product of a number and one of a Jacobian, in the units of the number
//   hn_i_wide_plus(a, b), hn_i_wide_minus(a, b)  the sum and the difference; integers wrap
//   hn_i_rotated_by(a, b, along, across)  (along * a + across * b) / 32
//   hn_i_growth            gain * lacunarity
//   hn_i_stretched_area(cosine, sine)  by which a rotation by 32nds stretches areas of its plane
//   hn_i_octave_slope      a derivative of an octave's noise
//   hn_i_coarse            a result that a float holds
//   hn_i_erosion_weight(square, strength)  1 / (1 + strength * square), in the units of weights

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_wide_times(hn_float a, hn_float b) { return hn_i_times(a, b); }
HN_FN hn_float hn_i_wide_plus(hn_float a, hn_float b) { return hn_i_plus(a, b); }
HN_FN hn_float hn_i_wide_minus(hn_float a, hn_float b) { return hn_i_minus(a, b); }

HN_FN hn_float hn_i_rotated_by(hn_float a, hn_float b, hn_int along, hn_int across) {
  HN_I_PRECISE hn_float n = hn_i_float(along) * (1.0f / 32.0f) * a + hn_i_float(across) * (1.0f / 32.0f) * b;
  return n;
}

HN_FN hn_float hn_i_growth(hn_float gain, hn_float lacunarity) { return hn_i_times(gain, lacunarity); }
HN_FN hn_float hn_i_stretched_area(hn_int cosine, hn_int sine) {
  return hn_i_float(cosine * cosine + sine * sine) * (1.0f / 1024.0f);
}
HN_FN hn_float hn_i_octave_slope(hn_float g) { return g; }
HN_FN hn_float hn_i_coarse(hn_float n) { return n; }
HN_FN hn_float hn_i_summed_slope(hn_float slope, hn_float g) { return min(max(-8.0f, hn_i_plus(slope, g)), 8.0f); }
HN_FN hn_float hn_i_squared_slope(hn_float slope) { return hn_i_times(slope, slope); }

HN_FN hn_float hn_i_erosion_weight(hn_float square, hn_float strength) {
  return hn_i_quotient(1.0f, hn_i_multiply_add(square, strength, 1.0f));
}

// Moves a coordinate of a fixed-point position. Beyond the domain the number may not fit an int, which C++ leaves
// undefined.
HN_FN hn_ivec2 hn_i_displaced(hn_ivec2 x, hn_float n) {
  hn_float cells = floor(min(max(-1073741824.0f, n), 1073741824.0f));
  hn_int rest = x.y + int(min(max(0.0f, hn_i_minus(n, cells)), 1.0f) * HN_I_FLOAT_UNITS_POSITION);
  return ivec2(int(uint(x.x) + uint(int(cells)) + uint(rest >> 24)), rest & (HN_I_UNITS_POSITION - 1));
}
HN_FN hn_float hn_i_displacement(hn_float n, hn_float rate) { return hn_i_flushed(hn_i_times(n, rate)); }

#define hn_i_square_of_slope hn_float

#else

HN_FN hn_int hn_i_wide_times(hn_int a, hn_int b) {
  hn_uint high = hn_i_multiply_high(uint(a), uint(b));
  high -= hn_i_select(a < 0, uint(b), 0u) + hn_i_select(b < 0, uint(a), 0u);
  return int((high << 14u) | ((uint(a) * uint(b)) >> 18u));
}

HN_FN hn_int hn_i_wide_plus(hn_int a, hn_int b) { return int(uint(a) + uint(b)); }
HN_FN hn_int hn_i_wide_minus(hn_int a, hn_int b) { return int(uint(a) - uint(b)); }

HN_FN hn_int hn_i_rotated_by(hn_int a, hn_int b, hn_int along, hn_int across) {
  return int(uint(along) * uint(a) + uint(across) * uint(b)) >> 5;
}

// A gain has 18 bits, and a lacunarity in units of 2^-23 has 31.
HN_FN hn_int hn_i_growth(hn_int gain, hn_float lacunarity) {
  return int(hn_i_multiply_high(uint(gain) << 9u, hn_i_ratio(lacunarity)));
}

HN_FN hn_int hn_i_stretched_area(hn_int cosine, hn_int sine) {
  return (cosine * cosine + sine * sine) * (HN_I_UNITS_WEIGHT / 1024);
}

// The result is in units of 2^-19. The derivatives of all noises of the library stay below 128, and those that fit
// hn_add below 9.
HN_FN hn_int hn_i_octave_slope(hn_float g) { return int(min(max(-128.0f, g), 128.0f) * HN_I_FLOAT_UNITS_SLOPE); }

// A float has 24 bits, and the others are dropped, towards 0.
HN_FN hn_int hn_i_coarse(hn_int n) {
  hn_int size = hn_i_magnitude(n);
  hn_int rounded = hn_i_select(size < 16777216, size, size & -128);
  return hn_i_select(n < 0, -rounded, rounded);
}

// The sum of slopes is in units of 2^-12, and at most 8.
HN_FN hn_int hn_i_summed_slope(hn_int slope, hn_float g) {
  return min(max(slope + (hn_i_octave_slope(g) >> 7), -32768), 32768);
}
HN_FN hn_uint hn_i_squared_slope(hn_int slope) { return uint(slope * slope); }

// The square is in units of 2^-24, and the divisor, up to 2^28, in units of 2^-16. 2^34 / divisor is 2^31 / divisor and
// three bits more.
HN_FN hn_int hn_i_erosion_weight(hn_uint square, hn_int strength) {
  hn_uint s = uint(strength);
  hn_uint divisor = 65536u + ((hn_i_multiply_high(square, s) << 6u) | ((square * s) >> 26u));
  hn_uint quotient = 0x80000000u / divisor;
  hn_uint rest = 0x80000000u - quotient * divisor;
  return int((quotient << 3u) | ((rest << 3u) / divisor));
}

// The number is in units of 2^-21.
HN_FN hn_ivec2 hn_i_displaced(hn_ivec2 x, hn_int n) {
  hn_int rest = x.y + ((n & (HN_I_UNITS_VALUE - 1)) << 3);
  return ivec2(int(uint(x.x) + uint(n >> 21) + uint(rest >> 24)), rest & (HN_I_UNITS_POSITION - 1));
}
HN_FN hn_int hn_i_displacement(hn_int n, hn_int rate) { return hn_i_wide_times(n, rate); }

#define hn_i_square_of_slope hn_uint

#endif

// A component of a displacement.
HN_FN hn_float hn_i_mean_displacement(hn_i_octave_sum s, hn_i_num sum, hn_i_num total, hn_i_num amplitude) {
  return hn_i_value(hn_i_coarse(hn_i_wide_times(hn_i_bounded(hn_i_mean(s, sum, total)), amplitude)));
}

HN_FN hn_i_num2 hn_i_wide_times(hn_i_num2 a, hn_i_num b) {
  return hn_i_vector(hn_i_wide_times(a.x, b), hn_i_wide_times(a.y, b));
}
HN_FN hn_i_num2 hn_i_displacements(hn_i_num2 n, hn_i_num rate) {
  return hn_i_vector(hn_i_displacement(n.x, rate), hn_i_displacement(n.y, rate));
}
HN_FN hn_i_num3 hn_i_wide_plus(hn_i_num3 a, hn_i_num3 b) {
  return hn_i_vector(hn_i_wide_plus(a.x, b.x), hn_i_wide_plus(a.y, b.y), hn_i_wide_plus(a.z, b.z));
}
HN_FN hn_i_num3 hn_i_rotated_by(hn_i_num3 a, hn_i_num3 b, hn_int along, hn_int across) {
  return hn_i_vector(hn_i_rotated_by(a.x, b.x, along, across), hn_i_rotated_by(a.y, b.y, along, across),
                     hn_i_rotated_by(a.z, b.z, along, across));
}
// Generated for 3 dimensions from the lines above.
HN_FN hn_i_num3 hn_i_wide_times(hn_i_num3 a, hn_i_num b) {
  return hn_i_vector(hn_i_wide_times(a.x, b), hn_i_wide_times(a.y, b), hn_i_wide_times(a.z, b));
}
HN_FN hn_i_num3 hn_i_displacements(hn_i_num3 n, hn_i_num rate) {
  return hn_i_vector(hn_i_displacement(n.x, rate), hn_i_displacement(n.y, rate), hn_i_displacement(n.z, rate));
}

// ---------------------------------------------------------------------------------------------------------------------
// These rotate Jacobians, and the slopes that an erosion sums, on the plane and in space. A tile must not rotate.

HN_FN hn_i_num2 hn_i_rotated(hn_i_num2 v) {
  return hn_i_vector(hn_i_rotated_by(v.x, v.y, HN_I_COS_XY, -HN_I_SIN_XY),
                     hn_i_rotated_by(v.y, v.x, HN_I_COS_XY, HN_I_SIN_XY));
}
HN_FN hn_i_num3 hn_i_rotated(hn_i_num3 v) {
  hn_i_num y = hn_i_rotated_by(v.y, v.x, HN_I_COS_XY, HN_I_SIN_XY);
  return hn_i_vector(hn_i_rotated_by(v.x, v.y, HN_I_COS_XY, -HN_I_SIN_XY),
                     hn_i_rotated_by(y, v.z, HN_I_COS_YZ, -HN_I_SIN_YZ),
                     hn_i_rotated_by(v.z, y, HN_I_COS_YZ, HN_I_SIN_YZ));
}

HN_FN hn_i_num2 hn_i_next_slope(hn_i_num2 e, bool tiled) {
  hn_i_num2 next = e;
  if (!tiled) next = hn_i_rotated(e);
  return next;
}
// Generated for 3 dimensions from the lines above.
HN_FN hn_i_num3 hn_i_next_slope(hn_i_num3 e, bool tiled) {
  hn_i_num3 next = e;
  if (!tiled) next = hn_i_rotated(e);
  return next;
}

#define hn_i_jacobian2 hn_i_num2
struct hn_i_jacobian3 {
  hn_i_num3 x;
  hn_i_num3 y;
  hn_i_num3 z;
};

HN_FN hn_i_num2 hn_i_identity2() { return hn_i_vector(HN_I_WEIGHT_ONE, HN_I_NO_WEIGHT); }
HN_FN hn_i_jacobian3 hn_i_identity3() {
  HN_I_NEW(hn_i_jacobian3, k);
  k.x = hn_i_vector(HN_I_WEIGHT_ONE, HN_I_NO_WEIGHT, HN_I_NO_WEIGHT);
  k.y = hn_i_vector(HN_I_NO_WEIGHT, HN_I_WEIGHT_ONE, HN_I_NO_WEIGHT);
  k.z = hn_i_vector(HN_I_NO_WEIGHT, HN_I_NO_WEIGHT, HN_I_WEIGHT_ONE);
  return k;
}

HN_FN hn_i_num2 hn_i_next_jacobian(hn_i_num2 k, hn_i_num growth, bool tiled) {
  hn_i_num2 next = hn_i_wide_times(k, growth);
  if (!tiled) next = hn_i_rotated(next);
  return next;
}

HN_FN hn_i_jacobian3 hn_i_next_jacobian(hn_i_jacobian3 k, hn_i_num growth, bool tiled) {
  HN_I_NEW(hn_i_jacobian3, next);
  next.x = hn_i_wide_times(k.x, growth);
  next.y = hn_i_wide_times(k.y, growth);
  next.z = hn_i_wide_times(k.z, growth);
  if (!tiled) {
    hn_i_num3 x = next.x;
    hn_i_num3 y = hn_i_rotated_by(next.y, x, HN_I_COS_XY, HN_I_SIN_XY);
    hn_i_num3 z = next.z;
    next.x = hn_i_rotated_by(x, next.y, HN_I_COS_XY, -HN_I_SIN_XY);
    next.y = hn_i_rotated_by(y, z, HN_I_COS_YZ, -HN_I_SIN_YZ);
    next.z = hn_i_rotated_by(z, y, HN_I_COS_YZ, HN_I_SIN_YZ);
  }
  return next;
}

// The transpose of this matrix rotates a velocity of the octave back. It is what remains of the Jacobian without the
// lacunarity: so it grows by the gain alone. Where a rotation stretches its plane by the root of a number, it has to
// stretch the axis beside the plane by the number itself, or velocities would have a divergence.
HN_FN hn_i_jacobian2 hn_i_next_cofactors(hn_i_jacobian2 k, hn_i_num gain, bool tiled) {
  return hn_i_next_jacobian(k, gain, tiled);
}
HN_FN hn_i_jacobian3 hn_i_next_cofactors(hn_i_jacobian3 k, hn_i_num gain, bool tiled) {
  hn_i_jacobian3 next = k;
  if (!tiled) next.z = hn_i_wide_times(next.z, hn_i_stretched_area(HN_I_COS_XY, HN_I_SIN_XY));
  next = hn_i_next_jacobian(next, gain, tiled);
  if (!tiled) next.x = hn_i_wide_times(next.x, hn_i_stretched_area(HN_I_COS_YZ, HN_I_SIN_YZ));
  return next;
}

// The transposed Jacobian times a gradient of the octave is the gradient by the position of the fractal. The Jacobian
// times a displacement of that position is the displacement in the octave.
HN_FN hn_i_num2 hn_i_transposed_times(hn_i_num2 k, hn_i_num2 g) {
  return hn_i_vector(hn_i_wide_plus(hn_i_wide_times(k.x, g.x), hn_i_wide_times(k.y, g.y)),
                     hn_i_wide_minus(hn_i_wide_times(k.x, g.y), hn_i_wide_times(k.y, g.x)));
}
HN_FN hn_i_num2 hn_i_jacobian_times(hn_i_num2 k, hn_i_num2 v) {
  return hn_i_vector(hn_i_wide_minus(hn_i_wide_times(k.x, v.x), hn_i_wide_times(k.y, v.y)),
                     hn_i_wide_plus(hn_i_wide_times(k.y, v.x), hn_i_wide_times(k.x, v.y)));
}
HN_FN hn_i_num3 hn_i_transposed_times(hn_i_jacobian3 k, hn_i_num3 g) {
  return hn_i_wide_plus(hn_i_wide_plus(hn_i_wide_times(k.x, g.x), hn_i_wide_times(k.y, g.y)),
                        hn_i_wide_times(k.z, g.z));
}
HN_FN hn_i_num hn_i_dot_row(hn_i_num3 row, hn_i_num3 v) {
  return hn_i_wide_plus(hn_i_wide_plus(hn_i_wide_times(row.x, v.x), hn_i_wide_times(row.y, v.y)),
                        hn_i_wide_times(row.z, v.z));
}
HN_FN hn_i_num3 hn_i_jacobian_times(hn_i_jacobian3 k, hn_i_num3 v) {
  return hn_i_vector(hn_i_dot_row(k.x, v), hn_i_dot_row(k.y, v), hn_i_dot_row(k.z, v));
}

#endif
