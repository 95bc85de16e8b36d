// hashnoise: the steps of a cubic spline, and the four lattice points along each axis that it joins.
// SPDX-License-Identifier: MIT

#ifndef HN_CUBIC_SPLINE_GLSL
#define HN_CUBIC_SPLINE_GLSL

#include "cell.glsl"
#include "value.glsl"

//   hn_i_spline(f)     the weights of a uniform cubic B-spline at f, for the points -1, 0, 1 and 2
//   hn_i_blend(n, w)   the sum of four numbers, each times its weight

#if HN_ARITHMETIC != HN_FIXED

// The weights of the points 2 and 0 mirror those of -1 and 1. The sum of all is 1.
HN_FN hn_vec4 hn_i_spline(hn_float f) {
  HN_I_AS_WRITTEN hn_float g = 1.0f - f;
  HN_I_PRECISE hn_float first = g * g * g * (1.0f / 6.0f);
  HN_I_PRECISE hn_float last = f * f * f * (1.0f / 6.0f);
  HN_I_PRECISE hn_float second = last * 3.0f + (2.0f / 3.0f - f * f);
  HN_I_PRECISE hn_float third = first * 3.0f + (2.0f / 3.0f - g * g);
  return vec4(first, second, third, last);
}

HN_FN hn_float hn_i_blend(hn_vec4 n, hn_vec4 w) {
  HN_I_PRECISE hn_float sum = n.x * w.x + n.y * w.y + n.z * w.z + n.w * w.w;
  return sum;
}

#else

// A sixth of a cube, in units of 2^-30, of x in units of 2^-15: by the high and by the low bits of the square.
HN_FN hn_uint hn_i_sixth_of_cube(hn_uint x) {
  hn_uint square = x * x;
  return ((square >> 15u) * x + (((square & 32767u) * x) >> 15u)) / 6u;
}

// The weights are in units of 2^-18, and their sum is 2^18. 715829931 is 2/3 in units of 2^-30 and 2048 more, which
// rounds.
HN_FN hn_ivec4 hn_i_spline(hn_int f) {
  hn_uint x = uint(f + 16) >> 5u;
  hn_uint before = hn_i_sixth_of_cube(32768u - x);
  hn_uint after = hn_i_sixth_of_cube(x);
  hn_int first = int((before + 2048u) >> 12u);
  hn_int last = int((after + 2048u) >> 12u);
  hn_int second = int((715829931u + 3u * after - x * x) >> 12u);
  return ivec4(first, second, HN_I_UNITS_WEIGHT - first - second - last, last);
}

HN_FN hn_int hn_i_blend(hn_ivec4 n, hn_ivec4 w) {
  return hn_i_part(n.x, w.x) + hn_i_part(n.y, w.y) + hn_i_part(n.z, w.z) + hn_i_part(n.w, w.w);
}

#endif

// The spread coordinates of the points -1, 0, 1 and 2 along one axis of a place. The factor step spreads the axis,
// and zero is the spread coordinate of 0.
HN_FN hn_uvec4 hn_i_line(hn_int cell, hn_int period, bool tiled, hn_uint step, hn_uint zero) {
  hn_uint first = uint(cell) * step + zero;
  hn_uvec4 coordinates = uvec4(first - step, first, first + step, first + 2u * step);
  if (tiled) {
    hn_uint size = uint(max(period, 0));
    hn_uint c = hn_i_wrap(cell, period);
    hn_uint before = hn_i_select(c == 0u, size, c) - 1u;
    hn_uint after = hn_i_select(c + 1u == size, 0u, c + 1u);
    hn_uint last = hn_i_select(after + 1u == size, 0u, after + 1u);
    coordinates = uvec4(before * step + zero, c * step + zero, after * step + zero, last * step + zero);
  }
  return coordinates;
}

// The high bits of these coordinates, shifted as for the axis.
HN_FN hn_uvec4 hn_i_high_of_line(hn_uvec4 v, hn_uint shift) {
  return uvec4(v.x >> shift, v.y >> shift, v.z >> shift, v.w >> shift);
}

// The numbers of four points along x, blended with the weights w. The other axes and the seed add join to the
// exclusive or. The second point has the odd number odd.
HN_FN hn_i_num hn_i_cubic_row(hn_uvec4 x, hn_uint join, hn_uint odd, hn_i_num4 w) {
  hn_uvec4 a = hn_i_high_of_line(x, 12u);
  hn_uvec4 h =
      uvec4(hn_i_point_hash(a.x ^ join, hn_i_odd_x(hn_i_step_x(x.y, x.x), odd)), hn_i_point_hash(a.y ^ join, odd),
            hn_i_point_hash(a.z ^ join, hn_i_odd_x(hn_i_step_x(x.y, x.z), odd)),
            hn_i_point_hash(a.w ^ join, hn_i_odd_x(hn_i_step_x(x.y, x.w), odd)));
  return hn_i_blend(hn_i_numbers(h), w);
}

// Four rows along y. The second point of the second row has the odd number odd.
HN_FN hn_i_num hn_i_cubic_square(hn_uvec4 x, hn_uvec4 y, hn_uint join, hn_uint odd, hn_i_num4 wx, hn_i_num4 wy) {
  hn_uvec4 b = hn_i_high_of_line(y, 11u);
  hn_i_num4 rows =
      hn_i_vector(hn_i_cubic_row(x, b.x ^ join, hn_i_odd_y(y.x - y.y, odd), wx), hn_i_cubic_row(x, b.y ^ join, odd, wx),
                  hn_i_cubic_row(x, b.z ^ join, hn_i_odd_y(y.z - y.y, odd), wx),
                  hn_i_cubic_row(x, b.w ^ join, hn_i_odd_y(y.w - y.y, odd), wx));
  return hn_i_blend(rows, wy);
}

#endif
