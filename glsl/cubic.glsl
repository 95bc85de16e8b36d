// hashnoise: the four lattice points along each axis that a cubic spline joins.
// SPDX-License-Identifier: MIT

#ifndef HN_CUBIC_GLSL
#define HN_CUBIC_GLSL

#include "lattice.glsl"

// The spread coordinates of the points -1, 0, 1 and 2 along one axis, from that of point 0. `step` is the factor that
// spreads the axis.
HN_FN hn_uvec4 hn_i_line(hn_uint c, hn_uint step) { return uvec4(c - step, c, c + step, c + 2u * step); }

// The same with a period. `zero` is the spread coordinate of 0.
HN_FN hn_uvec4 hn_i_line(hn_int cell, hn_int period, hn_uint step, hn_uint zero) {
  hn_uint size = uint(max(period, 0));
  hn_uint c = hn_i_wrap(cell, period);
  hn_uint before = hn_i_select(c == 0u, size, c) - 1u;
  hn_uint after = hn_i_select(c + 1u == size, 0u, c + 1u);
  hn_uint last = hn_i_select(after + 1u == size, 0u, after + 1u);
  return uvec4(before * step + zero, c * step + zero, after * step + zero, last * step + zero);
}

HN_FN hn_uvec4 hn_i_folded(hn_uvec4 v, hn_uint shift) {
  return uvec4(v.x ^ (v.x >> shift), v.y ^ (v.y >> shift), v.z ^ (v.z >> shift), v.w ^ (v.w >> shift));
}

// The numbers of four points along x, blended with the weights w. The other axes and the seed add `join` to the
// exclusive or, and `sum` to the sum before it is made odd.
HN_FN hn_num hn_i_cubic_row(hn_uvec4 x, hn_uint join, hn_uint sum, hn_num4 w) {
  hn_uvec4 a = hn_i_folded(x, 18u);
  hn_uvec4 h = uvec4(hn_i_word(a.x ^ join, hn_i_odd(x.x + sum)), hn_i_word(a.y ^ join, hn_i_odd(x.y + sum)),
                     hn_i_word(a.z ^ join, hn_i_odd(x.z + sum)), hn_i_word(a.w ^ join, hn_i_odd(x.w + sum)));
  return hn_i_blend(hn_i_numbers(h), w);
}

// The same for four rows along y.
HN_FN hn_num hn_i_cubic_square(hn_uvec4 x, hn_uvec4 y, hn_uint join, hn_uint sum, hn_num4 wx, hn_num4 wy) {
  hn_uvec4 b = hn_i_folded(y, 17u);
  hn_num4 rows = hn_i_num(hn_i_cubic_row(x, b.x ^ join, y.x + sum, wx), hn_i_cubic_row(x, b.y ^ join, y.y + sum, wx),
                          hn_i_cubic_row(x, b.z ^ join, y.z + sum, wx), hn_i_cubic_row(x, b.w ^ join, y.w + sum, wx));
  return hn_i_blend(rows, wy);
}

#endif
