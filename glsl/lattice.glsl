// hashnoise: the cell that a noise is in: its coordinates, wrapped by HN_PERIOD, and the words of its corners.
// SPDX-License-Identifier: MIT

#ifndef HN_LATTICE_GLSL
#define HN_LATTICE_GLSL

#include "arithmetic.glsl"
#include "hash.glsl"

// hn_i_wrap returns the coordinates of the near corner, and hn_i_next that of the far corner along one axis.
#if (HN_PERIOD) == 0
HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 cell) { return uvec2(cell); }
HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 cell) { return uvec3(cell); }
HN_FN hn_uint hn_i_next(hn_uint c) { return c + 1u; }
#else
#if ((HN_PERIOD) & ((HN_PERIOD) - 1)) == 0
HN_FN hn_uint hn_i_wrap(hn_int c) { return uint(c) & uint((HN_PERIOD) - 1); }
HN_FN hn_uint hn_i_next(hn_uint c) { return (c + 1u) & uint((HN_PERIOD) - 1); }
#else
// The remainder of floored division. GLSL leaves % of negative numbers undefined, so these count back from -1.
HN_FN hn_uint hn_i_wrap(hn_int c) {
  hn_uint rest = uint(hn_i_select(c < 0, -1 - c, c)) % uint(HN_PERIOD);
  return hn_i_select(c < 0, uint((HN_PERIOD) - 1) - rest, rest);
}
HN_FN hn_uint hn_i_next(hn_uint c) { return hn_i_select(c == uint((HN_PERIOD) - 1), 0u, c + 1u); }
#endif
HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 cell) { return uvec2(hn_i_wrap(cell.x), hn_i_wrap(cell.y)); }
HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 cell) { return uvec3(hn_i_wrap(cell.x), hn_i_wrap(cell.y), hn_i_wrap(cell.z)); }
#endif

// The spread coordinates of a cell's far corner, from those of its near one.
#if (HN_PERIOD) == 0
HN_FN hn_uvec2 hn_i_spread_next(hn_uvec2 spread, HN_I_UNUSED hn_uvec2 c) {
  return uvec2(spread.x + 0x9E3779B1u, spread.y + 0x85EBCA77u);
}
HN_FN hn_uvec3 hn_i_spread_next(hn_uvec3 spread, HN_I_UNUSED hn_uvec3 c) {
  return uvec3(spread.x + 0x9E3779B1u, spread.y + 0x85EBCA77u, spread.z + 0xC2B2AE3Du);
}
#else
HN_FN hn_uvec2 hn_i_spread_next(HN_I_UNUSED hn_uvec2 spread, hn_uvec2 c) {
  return hn_i_spread(uvec2(hn_i_next(c.x), hn_i_next(c.y)));
}
HN_FN hn_uvec3 hn_i_spread_next(HN_I_UNUSED hn_uvec3 spread, hn_uvec3 c) {
  return hn_i_spread(uvec3(hn_i_next(c.x), hn_i_next(c.y), hn_i_next(c.z)));
}
#endif

// The words of the corners 00, 10, 01, 11 of a square; c0 and c1 are the spread coordinates of the first and the last.
// z and the seed add `join` to the exclusive or, `sum` to the sum before it is made odd, and `more` to the odd number
// (`more` is even). Without a period `more` and the steps along x and y are constants, so they are added first.
HN_FN hn_uvec4 hn_i_corners(hn_uvec2 c0, hn_uvec2 c1, hn_uint join, hn_uint sum, hn_uint more) {
  hn_uvec2 a = hn_i_fold(c0);
  hn_uvec2 b = hn_i_fold(c1);
  a.x ^= join;
  b.x ^= join;
  hn_uint odd = hn_i_odd(c0.x + c0.y + sum);
  hn_uint x = (c1.x - c0.x) * 2u;
  hn_uint y = (c1.y - c0.y) * 2u;
  return uvec4(hn_i_word(a.x ^ a.y, odd + more), hn_i_word(b.x ^ a.y, odd + (x + more)),
               hn_i_word(a.x ^ b.y, odd + (y + more)), hn_i_word(b.x ^ b.y, odd + (x + y + more)));
}

// The same for the cell at c; in space for its front or back face.
HN_FN hn_uvec4 hn_i_corners(hn_uvec2 c, hn_uint seed) {
  hn_uvec2 c0 = hn_i_spread(c);
  hn_uint s = hn_i_mix(seed);
  return hn_i_corners(c0, hn_i_spread_next(c0, c), s, s, 0u);
}
HN_FN hn_uvec4 hn_i_corners(hn_uvec3 c, bool back, hn_uint seed) {
  hn_uvec3 c0 = hn_i_spread(c);
  hn_uvec3 c1 = hn_i_spread_next(c0, c);
  hn_uint s = hn_i_mix(seed);
  hn_uint join = hn_i_select(back, hn_i_fold(c1).z, hn_i_fold(c0).z) ^ s;
  hn_uint more = hn_i_select(back, (c1.z - c0.z) * 2u, 0u);
  return hn_i_corners(uvec2(c0.x, c0.y), uvec2(c1.x, c1.y), join, c0.z + s, more);
}

#endif
