// hashnoise: the cell on the plane that a noise is in, with the cells beside it.
// SPDX-License-Identifier: MIT

#ifndef HN_BLOCK2D_GLSL
#define HN_BLOCK2D_GLSL

#include "cell2d.glsl"

// The lower corner of the previous cell along each axis.
HN_FN hn_uvec2 hn_i_previous(hn_uvec2 lower) { return uvec2(lower.x - HN_I_STEP_X, lower.y - HN_I_STEP_Y); }

// The wrapped coordinates before another one and after it. Without a period the one before 0 is -1.
HN_FN hn_uint hn_i_previous(hn_uint c, hn_int period) { return hn_i_select(c == 0u, uint(max(period, 0)), c) - 1u; }
HN_FN hn_uint hn_i_following(hn_uint c, hn_int period) {
  return hn_i_select(c + 1u == uint(max(period, 0)), 0u, c + 1u);
}

// From here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

HN_FN hn_uvec2 hn_i_previous(hn_uvec2 c, hn_ivec2 period) {
  return uvec2(hn_i_previous(c.x, period.x), hn_i_previous(c.y, period.y));
}

// To here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

// From here block.glsl is generated from block2d.glsl, in 3 dimensions.

HN_FN hn_uvec2 hn_i_following(hn_uvec2 c, hn_ivec2 period) {
  return uvec2(hn_i_following(c.x, period.x), hn_i_following(c.y, period.y));
}

// To here block.glsl is generated from block2d.glsl, in 3 dimensions.

// From here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

// The spread coordinates of a cell, of the previous one along each axis, and of the following one: all that simplex
// noise and cellular noise visit.
struct hn_i_neighbourhood2 {
  hn_uvec2 previous;
  hn_uvec2 cell;
  hn_uvec2 following;
};

HN_FN hn_i_neighbourhood2 hn_i_neighbourhood(hn_place2 place) {
  HN_I_NEW(hn_i_neighbourhood2, cells);
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    cells.cell = hn_i_spread(c);
    cells.previous = hn_i_spread(hn_i_previous(c, place.period));
    cells.following = hn_i_upper(cells.cell, c, place.period);
  } else {
    cells.cell = hn_i_spread(uvec2(place.cell));
    cells.previous = hn_i_previous(cells.cell);
    cells.following = hn_i_upper(cells.cell);
  }
  return cells;
}

// To here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

// The spread coordinates of these cells along an axis. hn_i_triple_at chooses the first, the second or the third, for
// an n of -1, 0 or 1.
HN_FN hn_uvec3 hn_i_coordinates_x(hn_i_neighbourhood2 cells) {
  return uvec3(cells.previous.x, cells.cell.x, cells.following.x);
}
HN_FN hn_uvec3 hn_i_coordinates_y(hn_i_neighbourhood2 cells) {
  return uvec3(cells.previous.y, cells.cell.y, cells.following.y);
}
HN_FN hn_uint hn_i_triple_at(hn_uvec3 v, hn_int n) { return hn_i_select(n < 0, v.x, hn_i_select(n > 0, v.z, v.y)); }

#endif
