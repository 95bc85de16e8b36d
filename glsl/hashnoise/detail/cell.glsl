// hashnoise: the cell that a noise is in: its corners, with or without a period, and their hashes.
// SPDX-License-Identifier: MIT

#ifndef HN_CELL_GLSL
#define HN_CELL_GLSL

#include "arithmetic.glsl"
#include "../hash.glsl"
#include "../place.glsl"

// The upper corner of a cell, from its lower corner, both by their spread coordinates. Along an axis the upper one is a
// step further. Without a period a step adds a constant.
HN_FN hn_uint hn_i_upper(hn_uint lower) { return lower + HN_I_STEP_X; }
HN_FN hn_uvec2 hn_i_upper(hn_uvec2 lower) { return uvec2(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y); }
HN_FN hn_uvec3 hn_i_upper(hn_uvec3 lower) {
  return uvec3(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y, lower.z + HN_I_STEP_Z);
}
HN_FN hn_uvec4 hn_i_upper(hn_uvec4 lower) {
  return uvec4(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y, lower.z + HN_I_STEP_Z, lower.w + HN_I_STEP_W);
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
// The same in 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 c, hn_ivec3 period) {
  return uvec3(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y), hn_i_wrap(c.z, period.z));
}
HN_FN hn_uvec4 hn_i_wrap(hn_ivec4 c, hn_ivec4 period) {
  return uvec4(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y), hn_i_wrap(c.z, period.z), hn_i_wrap(c.w, period.w));
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
HN_FN hn_uvec3 hn_i_upper(hn_uvec3 lower, hn_uvec3 c, hn_ivec3 period) {
  hn_uvec3 upper = hn_i_upper(lower);
  return uvec3(hn_i_upper(lower.x, c.x, period.x), hn_i_upper_at_seam(upper.y, c.y, period.y, 0u),
               hn_i_upper_at_seam(upper.z, c.z, period.z, 0u));
}
HN_FN hn_uvec4 hn_i_upper(hn_uvec4 lower, hn_uvec4 c, hn_ivec4 period) {
  hn_uvec4 upper = hn_i_upper(lower);
  return uvec4(hn_i_upper(lower.x, c.x, period.x), hn_i_upper_at_seam(upper.y, c.y, period.y, 0u),
               hn_i_upper_at_seam(upper.z, c.z, period.z, 0u), hn_i_upper_at_seam(upper.w, c.w, period.w, 0u));
}

// A box has the spread coordinates of the lower and of the upper corner of a cell. With a period the corners are
// wrapped. All lattice noises are functions of a box and of the place in it.
struct hn_i_box2 {
  hn_uvec2 lower;
  hn_uvec2 upper;
};
// The same in 1, 3 and 4 dimensions: tools/make writes it.
struct hn_i_box1 {
  hn_uint lower;
  hn_uint upper;
};
struct hn_i_box3 {
  hn_uvec3 lower;
  hn_uvec3 upper;
};
struct hn_i_box4 {
  hn_uvec4 lower;
  hn_uvec4 upper;
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
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_i_box1 hn_i_box(hn_place1 place) {
  HN_I_NEW(hn_i_box1, box);
  if (place.tiled) {
    hn_uint c = hn_i_wrap(place.cell, place.period);
    box.lower = hn_i_spread(c);
    box.upper = hn_i_upper(box.lower, c, place.period);
  } else {
    box.lower = hn_i_spread(uint(place.cell));
    box.upper = hn_i_upper(box.lower);
  }
  return box;
}
HN_FN hn_i_box3 hn_i_box(hn_place3 place) {
  HN_I_NEW(hn_i_box3, box);
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    box.lower = hn_i_spread(c);
    box.upper = hn_i_upper(box.lower, c, place.period);
  } else {
    box.lower = hn_i_spread(uvec3(place.cell));
    box.upper = hn_i_upper(box.lower);
  }
  return box;
}
HN_FN hn_i_box4 hn_i_box(hn_place4 place) {
  HN_I_NEW(hn_i_box4, box);
  if (place.tiled) {
    hn_uvec4 c = hn_i_wrap(place.cell, place.period);
    box.lower = hn_i_spread(c);
    box.upper = hn_i_upper(box.lower, c, place.period);
  } else {
    box.lower = hn_i_spread(uvec4(place.cell));
    box.upper = hn_i_upper(box.lower);
  }
  return box;
}

// The lower corner of the previous cell along each axis.
HN_FN hn_uvec2 hn_i_previous(hn_uvec2 lower) { return uvec2(lower.x - HN_I_STEP_X, lower.y - HN_I_STEP_Y); }
HN_FN hn_uvec3 hn_i_previous(hn_uvec3 lower) {
  return uvec3(hn_i_previous(uvec2(lower.x, lower.y)), lower.z - HN_I_STEP_Z);
}
HN_FN hn_uvec4 hn_i_previous(hn_uvec4 lower) {
  return uvec4(hn_i_previous(uvec3(lower.x, lower.y, lower.z)), lower.w - HN_I_STEP_W);
}

// The wrapped coordinates before another one and after it. Without a period the one before 0 is -1.
HN_FN hn_uint hn_i_previous(hn_uint c, hn_int period) { return hn_i_select(c == 0u, uint(max(period, 0)), c) - 1u; }
HN_FN hn_uint hn_i_following(hn_uint c, hn_int period) {
  return hn_i_select(c + 1u == uint(max(period, 0)), 0u, c + 1u);
}
HN_FN hn_uvec2 hn_i_previous(hn_uvec2 c, hn_ivec2 period) {
  return uvec2(hn_i_previous(c.x, period.x), hn_i_previous(c.y, period.y));
}
// The same in 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uvec3 hn_i_previous(hn_uvec3 c, hn_ivec3 period) {
  return uvec3(hn_i_previous(c.x, period.x), hn_i_previous(c.y, period.y), hn_i_previous(c.z, period.z));
}
HN_FN hn_uvec4 hn_i_previous(hn_uvec4 c, hn_ivec4 period) {
  return uvec4(hn_i_previous(c.x, period.x), hn_i_previous(c.y, period.y), hn_i_previous(c.z, period.z),
               hn_i_previous(c.w, period.w));
}

HN_FN hn_uvec2 hn_i_following(hn_uvec2 c, hn_ivec2 period) {
  return uvec2(hn_i_following(c.x, period.x), hn_i_following(c.y, period.y));
}
// The same in 3 dimensions: tools/make writes it.
HN_FN hn_uvec3 hn_i_following(hn_uvec3 c, hn_ivec3 period) {
  return uvec3(hn_i_following(c.x, period.x), hn_i_following(c.y, period.y), hn_i_following(c.z, period.z));
}

// A block has the spread coordinates of a cell, of the previous one along each axis, and of the following one: all that
// simplex noise and cellular noise visit.
struct hn_i_block2 {
  hn_uvec2 previous;
  hn_uvec2 cell;
  hn_uvec2 following;
};
// The same in 3 and 4 dimensions: tools/make writes it.
struct hn_i_block3 {
  hn_uvec3 previous;
  hn_uvec3 cell;
  hn_uvec3 following;
};
struct hn_i_block4 {
  hn_uvec4 previous;
  hn_uvec4 cell;
  hn_uvec4 following;
};

HN_FN hn_i_block2 hn_i_block(hn_place2 place) {
  HN_I_NEW(hn_i_block2, block);
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    block.cell = hn_i_spread(c);
    block.previous = hn_i_spread(hn_i_previous(c, place.period));
    block.following = hn_i_upper(block.cell, c, place.period);
  } else {
    block.cell = hn_i_spread(uvec2(place.cell));
    block.previous = hn_i_previous(block.cell);
    block.following = hn_i_upper(block.cell);
  }
  return block;
}
// The same in 3 and 4 dimensions: tools/make writes it.
HN_FN hn_i_block3 hn_i_block(hn_place3 place) {
  HN_I_NEW(hn_i_block3, block);
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    block.cell = hn_i_spread(c);
    block.previous = hn_i_spread(hn_i_previous(c, place.period));
    block.following = hn_i_upper(block.cell, c, place.period);
  } else {
    block.cell = hn_i_spread(uvec3(place.cell));
    block.previous = hn_i_previous(block.cell);
    block.following = hn_i_upper(block.cell);
  }
  return block;
}
HN_FN hn_i_block4 hn_i_block(hn_place4 place) {
  HN_I_NEW(hn_i_block4, block);
  if (place.tiled) {
    hn_uvec4 c = hn_i_wrap(place.cell, place.period);
    block.cell = hn_i_spread(c);
    block.previous = hn_i_spread(hn_i_previous(c, place.period));
    block.following = hn_i_upper(block.cell, c, place.period);
  } else {
    block.cell = hn_i_spread(uvec4(place.cell));
    block.previous = hn_i_previous(block.cell);
    block.following = hn_i_upper(block.cell);
  }
  return block;
}

// The spread coordinates of a block along an axis. Of such three hn_i_triple_at chooses the first, the second or the
// third, for an n of -1, 0 or 1.
HN_FN hn_uvec3 hn_i_coordinates_x(hn_i_block2 block) {
  return uvec3(block.previous.x, block.cell.x, block.following.x);
}
HN_FN hn_uvec3 hn_i_coordinates_y(hn_i_block2 block) {
  return uvec3(block.previous.y, block.cell.y, block.following.y);
}
HN_FN hn_uvec3 hn_i_coordinates_x(hn_i_block3 block) {
  return uvec3(block.previous.x, block.cell.x, block.following.x);
}
HN_FN hn_uvec3 hn_i_coordinates_y(hn_i_block3 block) {
  return uvec3(block.previous.y, block.cell.y, block.following.y);
}
HN_FN hn_uvec3 hn_i_coordinates_z(hn_i_block3 block) {
  return uvec3(block.previous.z, block.cell.z, block.following.z);
}
HN_FN hn_uint hn_i_triple_at(hn_uvec3 v, hn_int n) { return hn_i_select(n < 0, v.x, hn_i_select(n > 0, v.z, v.y)); }

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

// The same for a box: both ends of a line, a square, the front or back face of a cube along z, and in four dimensions
// the square that z and w choose.
HN_FN hn_uvec2 hn_i_corners(hn_i_box1 box, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uint join = hn_i_seed_join(s);
  hn_uint odd = hn_i_odd(box.lower + s);
  return uvec2(hn_i_word(hn_i_high(box.lower) ^ join, odd),
               hn_i_word(hn_i_high(box.upper) ^ join, odd + hn_i_odd_step(box.upper - box.lower)));
}
HN_FN hn_uvec4 hn_i_corners(hn_i_box2 box, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  return hn_i_corners(box.lower, box.upper, hn_i_seed_join(s), s, 0u);
}
HN_FN hn_uvec4 hn_i_corners(hn_i_box3 box, bool back, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec3 lower = box.lower;
  hn_uvec3 upper = box.upper;
  hn_uint join = hn_i_select(back, hn_i_high(upper).z, hn_i_high(lower).z) ^ hn_i_seed_join(s);
  hn_uint more = hn_i_select(back, hn_i_odd_step((upper.z - lower.z) * HN_I_SUM_Z), 0u);
  return hn_i_corners(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), join, hn_i_sum_z(lower.z) + s, more);
}
HN_FN hn_uvec4 hn_i_corners(hn_i_box4 box, bool far_z, bool far_w, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec4 lower = box.lower;
  hn_uvec4 upper = box.upper;
  hn_uvec4 a = hn_i_high(lower);
  hn_uvec4 b = hn_i_high(upper);
  hn_uint join = hn_i_select(far_z, b.z, a.z) ^ hn_i_select(far_w, b.w, a.w) ^ hn_i_seed_join(s);
  hn_uint more = hn_i_select(far_z, hn_i_odd_step((upper.z - lower.z) * HN_I_SUM_Z), 0u) +
                 hn_i_select(far_w, hn_i_odd_step((upper.w - lower.w) * HN_I_SUM_W), 0u);
  return hn_i_corners(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), join,
                      hn_i_sum_z(lower.z) + hn_i_sum_w(lower.w) + s, more);
}

#endif
