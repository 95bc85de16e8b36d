// hashnoise: the cell on the plane that a noise is in: its corners, with or without a period, and their hashes.
// SPDX-License-Identifier: MIT

#ifndef HN_CELL2D_GLSL
#define HN_CELL2D_GLSL

#include "place2d.glsl"
#include "word.glsl"

// The upper corner of a cell, from its lower corner, both by their spread coordinates. Along an axis the upper one is a
// step further. Without a period a step adds a constant.
HN_FN hn_uint hn_i_upper(hn_uint lower) { return lower + HN_I_STEP_X; }
HN_FN hn_uvec2 hn_i_upper(hn_uvec2 lower) { return uvec2(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y); }

// A coordinate in [0, period); without a period (0, or less) the coordinate as it is. For a power of two it is a mask,
// and for no period, too. For others it is the remainder of floored division. GLSL leaves % of negative numbers
// undefined, so these count back from -1. If the period is a constant, then one of the two is left.
HN_FN hn_uint hn_i_wrap(hn_int c, hn_int period) {
  hn_uint size = uint(max(period, 0));
  hn_uint mask = size - 1u;
  hn_uint rest = uint(hn_i_select(c < 0, -1 - c, c)) % max(size, 1u);
  rest = hn_i_select(c < 0, mask - rest, rest);
  return hn_i_select((size & mask) == 0u, uint(c) & mask, rest);
}

// The spread coordinate of an upper corner. In the last cell of a period that is the spread coordinate of 0, which is
// `zero`; in any other it is `upper`.
HN_FN hn_uint hn_i_upper_at_seam(hn_uint upper, hn_uint c, hn_int period, hn_uint zero) {
  return hn_i_select(c + 1u == uint(max(period, 0)), zero, upper);
}

// The upper corner of a cell with a period. c has the wrapped coordinates of the cell, and hn_i_spread(c) is its lower
// corner.
HN_FN hn_uint hn_i_upper(hn_uint lower, hn_uint c, hn_int period) {
  return hn_i_upper_at_seam(hn_i_upper(lower), c, period, HN_I_ORIGIN_X);
}
HN_FN hn_uvec2 hn_i_upper(hn_uvec2 lower, hn_uvec2 c, hn_ivec2 period) {
  hn_uvec2 upper = hn_i_upper(lower);
  return uvec2(hn_i_upper(lower.x, c.x, period.x), hn_i_upper_at_seam(upper.y, c.y, period.y, 0u));
}

// The hashes of the corners 00, 10, 01, 11 of a square. c0 and c1 are the spread coordinates of its lower and upper
// corner. Other axes and the seed add `join` to the exclusive or, `sum` to the sum before it is made odd, and `more` to
// the odd number (`more` is even). Without a period `more` and the steps along x and y are constants, so they are added
// first.
HN_FN hn_uvec4 hn_i_corners(hn_uvec2 c0, hn_uvec2 c1, hn_uint join, hn_uint sum, hn_uint more) {
  hn_uvec2 a = hn_i_high(c0);
  hn_uvec2 b = hn_i_high(c1);
  a.x ^= join;
  b.x ^= join;
  hn_uint odd = hn_i_odd(hn_i_sum(c0) + sum);
  hn_uint x = hn_i_odd_step(c1.x - c0.x);
  hn_uint y = hn_i_odd_step((c1.y - c0.y) * HN_I_SUM_Y);
  return uvec4(hn_i_word(a.x ^ a.y, odd + more), hn_i_word(b.x ^ a.y, odd + (x + more)),
               hn_i_word(a.x ^ b.y, odd + (y + more)), hn_i_word(b.x ^ b.y, odd + (x + y + more)));
}

// The same in 3 and 4 dimensions: tools/make writes it of cell2d.glsl.

// The fade of a fraction along each axis.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_vec2 hn_i_fade(hn_vec2 f) {
  HN_I_AS_WRITTEN hn_vec2 d = f - 1.0f;
  HN_I_PRECISE hn_vec2 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}
#else
HN_FN hn_ivec2 hn_i_fade(hn_ivec2 f) { return ivec2(hn_i_fade(f.x), hn_i_fade(f.y)); }
#endif

HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 c, hn_ivec2 period) {
  return uvec2(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y));
}

// The same in 1, 3 and 4 dimensions: tools/make writes it of cell2d.glsl.

// A box has the spread coordinates of the lower and of the upper corner of a cell. With a period the corners are
// wrapped. All lattice noises are functions of a box and of the place in it.
struct hn_i_box2 {
  hn_uvec2 lower;
  hn_uvec2 upper;
};

HN_FN hn_i_box2 hn_i_box(hn_place2 place) {
  HN_I_NEW(hn_i_box2, box);
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    box.lower = hn_i_spread(c);
    box.upper = hn_i_upper(box.lower, c, place.period);
  } else {
    box.lower = hn_i_spread(uvec2(place.cell));
    box.upper = hn_i_upper(box.lower);
  }
  return box;
}

// By hand in each dimension.

// The same for a box.
HN_FN hn_uvec4 hn_i_corners(hn_i_box2 box, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  return hn_i_corners(box.lower, box.upper, hn_i_seed_join(s), s, 0u);
}

#endif
