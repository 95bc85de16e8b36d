// hashnoise: the cell that a noise is in: where its corners are, with or without a period, and their words.
// SPDX-License-Identifier: MIT

#ifndef HN_CELL_GLSL
#define HN_CELL_GLSL

#include "arithmetic.glsl"
#include "../hash.glsl"
#include "../place.glsl"

// A cell is known by the spread coordinates of its first corner and of its last, the opposite one. Along an axis the
// last is one step further. Without a period a step adds a constant.
HN_FN hn_uint hn_i_last(hn_uint first) { return first + HN_I_STEP_X; }
HN_FN hn_uvec2 hn_i_last(hn_uvec2 first) { return uvec2(hn_i_last(first.x), first.y + HN_I_STEP_Y); }
HN_FN hn_uvec3 hn_i_last(hn_uvec3 first) {
  return uvec3(hn_i_last(first.x), first.y + HN_I_STEP_Y, first.z + HN_I_STEP_Z);
}
HN_FN hn_uvec4 hn_i_last(hn_uvec4 first) {
  return uvec4(hn_i_last(first.x), first.y + HN_I_STEP_Y, first.z + HN_I_STEP_Z, first.w + HN_I_STEP_W);
}

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
HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 c, hn_ivec2 period) {
  return uvec2(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y));
}
HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 c, hn_ivec3 period) {
  return uvec3(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y), hn_i_wrap(c.z, period.z));
}
HN_FN hn_uvec4 hn_i_wrap(hn_ivec4 c, hn_ivec4 period) {
  return uvec4(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y), hn_i_wrap(c.z, period.z), hn_i_wrap(c.w, period.w));
}

// The spread coordinate of a last corner, given that without a period: behind the seam it is that of 0, which is
// `zero`.
HN_FN hn_uint hn_i_behind(hn_uint last, hn_uint c, hn_int period, hn_uint zero) {
  return hn_i_select(c + 1u == uint(max(period, 0)), zero, last);
}

// The first corner of a cell with a period, from its wrapped coordinates, is hn_i_spread(c). This is its last.
HN_FN hn_uint hn_i_last(hn_uint first, hn_uint c, hn_int period) {
  return hn_i_behind(hn_i_last(first), c, period, HN_I_ORIGIN_X);
}
HN_FN hn_uvec2 hn_i_last(hn_uvec2 first, hn_uvec2 c, hn_ivec2 period) {
  hn_uvec2 last = hn_i_last(first);
  return uvec2(hn_i_last(first.x, c.x, period.x), hn_i_behind(last.y, c.y, period.y, 0u));
}
HN_FN hn_uvec3 hn_i_last(hn_uvec3 first, hn_uvec3 c, hn_ivec3 period) {
  hn_uvec3 last = hn_i_last(first);
  return uvec3(hn_i_last(first.x, c.x, period.x), hn_i_behind(last.y, c.y, period.y, 0u),
               hn_i_behind(last.z, c.z, period.z, 0u));
}
HN_FN hn_uvec4 hn_i_last(hn_uvec4 first, hn_uvec4 c, hn_ivec4 period) {
  hn_uvec4 last = hn_i_last(first);
  return uvec4(hn_i_last(first.x, c.x, period.x), hn_i_behind(last.y, c.y, period.y, 0u),
               hn_i_behind(last.z, c.z, period.z, 0u), hn_i_behind(last.w, c.w, period.w, 0u));
}

// A box has the spread coordinates of two opposite corners of a cell: those of the first and of the last. With a period
// the corners are wrapped. All lattice noises are functions of a box and of the place in it.
struct hn_i_box1 {
  hn_uint first;
  hn_uint last;
};
struct hn_i_box2 {
  hn_uvec2 first;
  hn_uvec2 last;
};
struct hn_i_box3 {
  hn_uvec3 first;
  hn_uvec3 last;
};
struct hn_i_box4 {
  hn_uvec4 first;
  hn_uvec4 last;
};

HN_FN hn_i_box1 hn_i_box(hn_place1 place) {
  HN_I_NEW(hn_i_box1, box);
  if (place.tiled) {
    hn_uint c = hn_i_wrap(place.cell, place.period);
    box.first = hn_i_spread(c);
    box.last = hn_i_last(box.first, c, place.period);
  } else {
    box.first = hn_i_spread(uint(place.cell));
    box.last = hn_i_last(box.first);
  }
  return box;
}
HN_FN hn_i_box2 hn_i_box(hn_place2 place) {
  HN_I_NEW(hn_i_box2, box);
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    box.first = hn_i_spread(c);
    box.last = hn_i_last(box.first, c, place.period);
  } else {
    box.first = hn_i_spread(uvec2(place.cell));
    box.last = hn_i_last(box.first);
  }
  return box;
}
HN_FN hn_i_box3 hn_i_box(hn_place3 place) {
  HN_I_NEW(hn_i_box3, box);
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    box.first = hn_i_spread(c);
    box.last = hn_i_last(box.first, c, place.period);
  } else {
    box.first = hn_i_spread(uvec3(place.cell));
    box.last = hn_i_last(box.first);
  }
  return box;
}
HN_FN hn_i_box4 hn_i_box(hn_place4 place) {
  HN_I_NEW(hn_i_box4, box);
  if (place.tiled) {
    hn_uvec4 c = hn_i_wrap(place.cell, place.period);
    box.first = hn_i_spread(c);
    box.last = hn_i_last(box.first, c, place.period);
  } else {
    box.first = hn_i_spread(uvec4(place.cell));
    box.last = hn_i_last(box.first);
  }
  return box;
}

// The first corner of the cell before, given the first corner of a cell.
HN_FN hn_uvec2 hn_i_before(hn_uvec2 first) { return uvec2(first.x - HN_I_STEP_X, first.y - HN_I_STEP_Y); }
HN_FN hn_uvec3 hn_i_before(hn_uvec3 first) {
  return uvec3(hn_i_before(uvec2(first.x, first.y)), first.z - HN_I_STEP_Z);
}
HN_FN hn_uvec4 hn_i_before(hn_uvec4 first) {
  return uvec4(hn_i_before(uvec3(first.x, first.y, first.z)), first.w - HN_I_STEP_W);
}

// The wrapped coordinate before another with a period, and the one after it. Without a period the one before 0 is -1.
HN_FN hn_uint hn_i_before(hn_uint c, hn_int period) { return hn_i_select(c == 0u, uint(max(period, 0)), c) - 1u; }
HN_FN hn_uint hn_i_after(hn_uint c, hn_int period) { return hn_i_select(c + 1u == uint(max(period, 0)), 0u, c + 1u); }
HN_FN hn_uvec2 hn_i_before(hn_uvec2 c, hn_ivec2 period) {
  return uvec2(hn_i_before(c.x, period.x), hn_i_before(c.y, period.y));
}
HN_FN hn_uvec2 hn_i_after(hn_uvec2 c, hn_ivec2 period) {
  return uvec2(hn_i_after(c.x, period.x), hn_i_after(c.y, period.y));
}
HN_FN hn_uvec3 hn_i_before(hn_uvec3 c, hn_ivec3 period) {
  return uvec3(hn_i_before(c.x, period.x), hn_i_before(c.y, period.y), hn_i_before(c.z, period.z));
}
HN_FN hn_uvec3 hn_i_after(hn_uvec3 c, hn_ivec3 period) {
  return uvec3(hn_i_after(c.x, period.x), hn_i_after(c.y, period.y), hn_i_after(c.z, period.z));
}
HN_FN hn_uvec4 hn_i_before(hn_uvec4 c, hn_ivec4 period) {
  return uvec4(hn_i_before(c.x, period.x), hn_i_before(c.y, period.y), hn_i_before(c.z, period.z),
               hn_i_before(c.w, period.w));
}

// A block has the spread coordinates of a cell, of the one before it along each axis, and of the one after it: all that
// simplex noise and cellular noise visit.
struct hn_i_block2 {
  hn_uvec2 before;
  hn_uvec2 cell;
  hn_uvec2 after;
};
struct hn_i_block3 {
  hn_uvec3 before;
  hn_uvec3 cell;
  hn_uvec3 after;
};
struct hn_i_block4 {
  hn_uvec4 before;
  hn_uvec4 cell;
  hn_uvec4 after;
};

HN_FN hn_i_block2 hn_i_block(hn_place2 place) {
  HN_I_NEW(hn_i_block2, block);
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    block.cell = hn_i_spread(c);
    block.before = hn_i_spread(hn_i_before(c, place.period));
    block.after = hn_i_last(block.cell, c, place.period);
  } else {
    block.cell = hn_i_spread(uvec2(place.cell));
    block.before = hn_i_before(block.cell);
    block.after = hn_i_last(block.cell);
  }
  return block;
}
HN_FN hn_i_block3 hn_i_block(hn_place3 place) {
  HN_I_NEW(hn_i_block3, block);
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    block.cell = hn_i_spread(c);
    block.before = hn_i_spread(hn_i_before(c, place.period));
    block.after = hn_i_last(block.cell, c, place.period);
  } else {
    block.cell = hn_i_spread(uvec3(place.cell));
    block.before = hn_i_before(block.cell);
    block.after = hn_i_last(block.cell);
  }
  return block;
}
HN_FN hn_i_block4 hn_i_block(hn_place4 place) {
  HN_I_NEW(hn_i_block4, block);
  if (place.tiled) {
    hn_uvec4 c = hn_i_wrap(place.cell, place.period);
    block.cell = hn_i_spread(c);
    block.before = hn_i_spread(hn_i_before(c, place.period));
    block.after = hn_i_last(block.cell, c, place.period);
  } else {
    block.cell = hn_i_spread(uvec4(place.cell));
    block.before = hn_i_before(block.cell);
    block.after = hn_i_last(block.cell);
  }
  return block;
}

// The words of the corners 00, 10, 01, 11 of a square; c0 and c1 are the spread coordinates of the first and the last.
// Other axes and the seed add `join` to the exclusive or, `sum` to the sum before it is made odd, and `more` to the odd
// number (`more` is even). Without a period `more` and the steps along x and y are constants, so they are added first.
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

// The same for a box: both ends of a line, a square, the front or back face of a cube along z, and in four dimensions
// the square that z and w choose.
HN_FN hn_uvec2 hn_i_corners(hn_i_box1 box, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uint odd = hn_i_odd(box.first + s);
  return uvec2(hn_i_word(hn_i_fold(box.first) ^ s, odd),
               hn_i_word(hn_i_fold(box.last) ^ s, odd + (box.last - box.first) * 2u));
}
HN_FN hn_uvec4 hn_i_corners(hn_i_box2 box, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  return hn_i_corners(box.first, box.last, s, s, 0u);
}
HN_FN hn_uvec4 hn_i_corners(hn_i_box3 box, bool back, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec3 first = box.first;
  hn_uvec3 last = box.last;
  hn_uint join = hn_i_select(back, hn_i_fold(last).z, hn_i_fold(first).z) ^ s;
  hn_uint more = hn_i_select(back, (last.z - first.z) * 2u, 0u);
  return hn_i_corners(uvec2(first.x, first.y), uvec2(last.x, last.y), join, first.z + s, more);
}
HN_FN hn_uvec4 hn_i_corners(hn_i_box4 box, bool far_z, bool far_w, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec4 first = box.first;
  hn_uvec4 last = box.last;
  hn_uvec4 a = hn_i_fold(first);
  hn_uvec4 b = hn_i_fold(last);
  hn_uint join = hn_i_select(far_z, b.z, a.z) ^ hn_i_select(far_w, b.w, a.w) ^ s;
  hn_uint more = hn_i_select(far_z, (last.z - first.z) * 2u, 0u) + hn_i_select(far_w, (last.w - first.w) * 2u, 0u);
  return hn_i_corners(uvec2(first.x, first.y), uvec2(last.x, last.y), join, first.z + first.w + s, more);
}

#endif
