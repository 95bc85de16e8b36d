// hashnoise: how the cells of an octave lie in those of the first, for sums with slopes and with shifts.
// SPDX-License-Identifier: MIT
//
// The frame of an octave is the matrix that takes a small step of the position to one of the octave's position, times
// the octave's weight. On the plane the matrix has the rows (x, -y) and (y, x), for a frame (x, y). In space it is three
// rows. From one octave to the next it grows by gain * lacunarity and turns, as positions do.

#ifndef HN_JACOBIAN_GLSL
#define HN_JACOBIAN_GLSL

#include "octave.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Steps of numbers. With HN_FIXED those of a frame are in units of 2^-18, as weights are.
//
//   hn_i_framed(a, b)       the product of a number and one of a frame, in the units of the number
//   hn_i_joined, hn_i_parted    the sum and the difference; integers wrap
//   hn_i_rotated_by(a, b, along, across)    (along * a + across * b) / 32
//   hn_i_growth             gain * lacunarity
//   hn_i_octave_slope       a derivative of an octave's noise
//   hn_i_coarse             a result that a float holds
//   hn_i_eroding(square, strength)    1 / (1 + strength * square), in the units of weights

#if HN_ARITHMETIC == HN_FIXED

HN_FN hn_int hn_i_framed(hn_int a, hn_int b) {
  hn_uint high = hn_i_multiply_high(uint(a), uint(b));
  high -= hn_i_select(a < 0, uint(b), 0u) + hn_i_select(b < 0, uint(a), 0u);
  return int((high << 14u) | ((uint(a) * uint(b)) >> 18u));
}

HN_FN hn_int hn_i_joined(hn_int a, hn_int b) { return int(uint(a) + uint(b)); }
HN_FN hn_int hn_i_parted(hn_int a, hn_int b) { return int(uint(a) - uint(b)); }

HN_FN hn_int hn_i_rotated_by(hn_int a, hn_int b, hn_int along, hn_int across) {
  return int(uint(along) * uint(a) + uint(across) * uint(b)) >> 5;
}

// A gain has 18 bits, and a lacunarity in units of 2^-23 has 31.
HN_FN hn_int hn_i_growth(hn_int gain, hn_float lacunarity) {
  return int(hn_i_multiply_high(uint(gain) << 9u, hn_i_ratio(lacunarity)));
}

// In units of 2^-19. The noises of the library stay below 4.
HN_FN hn_int hn_i_octave_slope(hn_float g) { return int(min(max(g, -4.0f), 4.0f) * 524288.0f); }

// A float has 24 bits, and the others are dropped, towards 0.
HN_FN hn_int hn_i_coarse(hn_int n) {
  hn_int size = hn_i_size(n);
  hn_int rounded = hn_i_select(size < 16777216, size, size & -128);
  return hn_i_select(n < 0, -rounded, rounded);
}

// What slopes have summed to is in units of 2^-12, and at most 8.
HN_FN hn_int hn_i_steeper(hn_int slope, hn_float g) {
  return min(max(slope + (hn_i_octave_slope(g) >> 7), -32768), 32768);
}
HN_FN hn_uint hn_i_square(hn_int slope) { return uint(slope * slope); }

// The square is in units of 2^-24, and the divisor, up to 2^28, in units of 2^-16. 2^34 / divisor is 2^31 / divisor and
// three bits more.
HN_FN hn_int hn_i_eroding(hn_uint square, hn_int strength) {
  hn_uint s = uint(strength);
  hn_uint divisor = 65536u + ((hn_i_multiply_high(square, s) << 6u) | ((square * s) >> 26u));
  hn_uint quotient = 0x80000000u / divisor;
  hn_uint rest = 0x80000000u - quotient * divisor;
  return int((quotient << 3u) | ((rest << 3u) / divisor));
}

// Moves a coordinate, by a number in units of 2^-21.
HN_FN hn_ivec2 hn_i_moved(hn_ivec2 x, hn_int n) {
  hn_int rest = x.y + ((n & 2097151) << 3);
  return ivec2(int(uint(x.x) + uint(n >> 21) + uint(rest >> 24)), rest & 16777215);
}
HN_FN hn_int hn_i_stride(hn_int n, hn_int rate) { return hn_i_framed(n, rate); }

#define hn_i_square_of_slope hn_uint

#else

HN_FN hn_float hn_i_framed(hn_float a, hn_float b) { return hn_i_times(a, b); }
HN_FN hn_float hn_i_joined(hn_float a, hn_float b) { return hn_i_plus(a, b); }
HN_FN hn_float hn_i_parted(hn_float a, hn_float b) { return hn_i_minus(a, b); }

HN_FN hn_float hn_i_rotated_by(hn_float a, hn_float b, hn_int along, hn_int across) {
  HN_I_PRECISE hn_float n = hn_i_float(along) * (1.0f / 32.0f) * a + hn_i_float(across) * (1.0f / 32.0f) * b;
  return n;
}

HN_FN hn_float hn_i_growth(hn_float gain, hn_float lacunarity) { return hn_i_times(gain, lacunarity); }
HN_FN hn_float hn_i_octave_slope(hn_float g) { return g; }
HN_FN hn_float hn_i_coarse(hn_float n) { return n; }
HN_FN hn_float hn_i_steeper(hn_float slope, hn_float g) { return min(max(hn_i_plus(slope, g), -8.0f), 8.0f); }
HN_FN hn_float hn_i_square(hn_float slope) { return hn_i_times(slope, slope); }

HN_FN hn_float hn_i_eroding(hn_float square, hn_float strength) {
  return hn_i_quotient(1.0f, hn_i_times_plus(square, strength, 1.0f));
}

// In a whole position. Beyond the domain the number may not fit an int, which C++ leaves undefined.
HN_FN hn_ivec2 hn_i_moved(hn_ivec2 x, hn_float n) {
  hn_float cells = floor(min(max(-1073741824.0f, n), 1073741824.0f));
  hn_int rest = x.y + int(min(max(0.0f, hn_i_minus(n, cells)), 1.0f) * 16777216.0f);
  return ivec2(int(uint(x.x) + uint(int(cells)) + uint(rest >> 24)), rest & 16777215);
}
HN_FN hn_float hn_i_stride(hn_float n, hn_float rate) { return hn_i_settled(hn_i_times(n, rate)); }

#define hn_i_square_of_slope hn_float

#endif

// A component of a shift.
HN_FN hn_float hn_i_shift(hn_i_octave_sum s, hn_num sum, hn_num total, hn_num amplitude) {
  return hn_i_value(hn_i_coarse(hn_i_framed(hn_i_bounded(hn_i_mean(s, sum, total)), amplitude)));
}

HN_FN hn_num2 hn_i_framed(hn_num2 a, hn_num b) { return hn_i_num(hn_i_framed(a.x, b), hn_i_framed(a.y, b)); }
HN_FN hn_num2 hn_i_strides(hn_num2 n, hn_num rate) { return hn_i_num(hn_i_stride(n.x, rate), hn_i_stride(n.y, rate)); }
HN_FN hn_num3 hn_i_strides(hn_num3 n, hn_num rate) {
  return hn_i_num(hn_i_stride(n.x, rate), hn_i_stride(n.y, rate), hn_i_stride(n.z, rate));
}
HN_FN hn_num3 hn_i_framed(hn_num3 a, hn_num b) {
  return hn_i_num(hn_i_framed(a.x, b), hn_i_framed(a.y, b), hn_i_framed(a.z, b));
}
HN_FN hn_num3 hn_i_joined(hn_num3 a, hn_num3 b) {
  return hn_i_num(hn_i_joined(a.x, b.x), hn_i_joined(a.y, b.y), hn_i_joined(a.z, b.z));
}
HN_FN hn_num3 hn_i_rotated_by(hn_num3 a, hn_num3 b, hn_int along, hn_int across) {
  return hn_i_num(hn_i_rotated_by(a.x, b.x, along, across), hn_i_rotated_by(a.y, b.y, along, across),
                  hn_i_rotated_by(a.z, b.z, along, across));
}

// ---------------------------------------------------------------------------------------------------------------------
// Turns, on the plane and in space: of frames, and of the slopes that an erosion sums. A tile must not turn.

HN_FN hn_num2 hn_i_rotated(hn_num2 v) {
  return hn_i_num(hn_i_rotated_by(v.x, v.y, 25, -20), hn_i_rotated_by(v.y, v.x, 25, 20));
}
HN_FN hn_num3 hn_i_rotated(hn_num3 v) {
  hn_num y = hn_i_rotated_by(v.y, v.x, 25, 20);
  return hn_i_num(hn_i_rotated_by(v.x, v.y, 25, -20), hn_i_rotated_by(y, v.z, 29, -13),
                  hn_i_rotated_by(v.z, y, 29, 13));
}
HN_FN hn_num2 hn_i_next_slope(hn_num2 e, bool tiled) {
  hn_num2 next = e;
  if (!tiled) next = hn_i_rotated(e);
  return next;
}
HN_FN hn_num3 hn_i_next_slope(hn_num3 e, bool tiled) {
  hn_num3 next = e;
  if (!tiled) next = hn_i_rotated(e);
  return next;
}

struct hn_i_frame3 {
  hn_num3 x;
  hn_num3 y;
  hn_num3 z;
};

HN_FN hn_num2 hn_i_first_frame2() { return hn_i_num(HN_I_WEIGHT_ONE, HN_I_NO_WEIGHT); }
HN_FN hn_i_frame3 hn_i_first_frame3() {
  HN_I_NEW(hn_i_frame3, k);
  k.x = hn_i_num(HN_I_WEIGHT_ONE, HN_I_NO_WEIGHT, HN_I_NO_WEIGHT);
  k.y = hn_i_num(HN_I_NO_WEIGHT, HN_I_WEIGHT_ONE, HN_I_NO_WEIGHT);
  k.z = hn_i_num(HN_I_NO_WEIGHT, HN_I_NO_WEIGHT, HN_I_WEIGHT_ONE);
  return k;
}

HN_FN hn_num2 hn_i_next_frame(hn_num2 k, hn_num growth, bool tiled) {
  hn_num2 next = hn_i_framed(k, growth);
  if (!tiled) next = hn_i_rotated(next);
  return next;
}

HN_FN hn_i_frame3 hn_i_next_frame(hn_i_frame3 k, hn_num growth, bool tiled) {
  HN_I_NEW(hn_i_frame3, next);
  next.x = hn_i_framed(k.x, growth);
  next.y = hn_i_framed(k.y, growth);
  next.z = hn_i_framed(k.z, growth);
  if (!tiled) {
    hn_num3 x = next.x;
    hn_num3 y = hn_i_rotated_by(next.y, x, 25, 20);
    hn_num3 z = next.z;
    next.x = hn_i_rotated_by(x, next.y, 25, -20);
    next.y = hn_i_rotated_by(y, z, 29, -13);
    next.z = hn_i_rotated_by(z, y, 29, 13);
  }
  return next;
}

// A vector of an octave, taken to the first one, times the transposed matrix; and one of the first, taken to the octave.
HN_FN hn_num2 hn_i_from_frame(hn_num2 k, hn_num2 g) {
  return hn_i_num(hn_i_joined(hn_i_framed(k.x, g.x), hn_i_framed(k.y, g.y)),
                  hn_i_parted(hn_i_framed(k.x, g.y), hn_i_framed(k.y, g.x)));
}
HN_FN hn_num2 hn_i_to_frame(hn_num2 k, hn_num2 v) {
  return hn_i_num(hn_i_parted(hn_i_framed(k.x, v.x), hn_i_framed(k.y, v.y)),
                  hn_i_joined(hn_i_framed(k.y, v.x), hn_i_framed(k.x, v.y)));
}
HN_FN hn_num3 hn_i_from_frame(hn_i_frame3 k, hn_num3 g) {
  return hn_i_joined(hn_i_joined(hn_i_framed(k.x, g.x), hn_i_framed(k.y, g.y)), hn_i_framed(k.z, g.z));
}
HN_FN hn_num hn_i_on_row(hn_num3 row, hn_num3 v) {
  return hn_i_joined(hn_i_joined(hn_i_framed(row.x, v.x), hn_i_framed(row.y, v.y)), hn_i_framed(row.z, v.z));
}
HN_FN hn_num3 hn_i_to_frame(hn_i_frame3 k, hn_num3 v) {
  return hn_i_num(hn_i_on_row(k.x, v), hn_i_on_row(k.y, v), hn_i_on_row(k.z, v));
}

#endif
