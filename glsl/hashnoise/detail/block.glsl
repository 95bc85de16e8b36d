// hashnoise: the cell that a noise is in, with the cells beside it, in space and in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_BLOCK_GLSL
#define HN_BLOCK_GLSL

#include "block2d.glsl"
#include "cell.glsl"

HN_FN hn_uvec3 hn_i_previous(hn_uvec3 lower) {
  return uvec3(hn_i_previous(uvec2(lower.x, lower.y)), lower.z - HN_I_STEP_Z);
}
HN_FN hn_uvec4 hn_i_previous(hn_uvec4 lower) {
  return uvec4(hn_i_previous(uvec3(lower.x, lower.y, lower.z)), lower.w - HN_I_STEP_W);
}

// From here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

HN_FN hn_uvec3 hn_i_previous(hn_uvec3 c, hn_ivec3 period) {
  return uvec3(hn_i_previous(c.x, period.x), hn_i_previous(c.y, period.y), hn_i_previous(c.z, period.z));
}
HN_FN hn_uvec4 hn_i_previous(hn_uvec4 c, hn_ivec4 period) {
  return uvec4(hn_i_previous(c.x, period.x), hn_i_previous(c.y, period.y), hn_i_previous(c.z, period.z),
               hn_i_previous(c.w, period.w));
}

// To here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

// From here block.glsl is generated from block2d.glsl, in 3 dimensions.

HN_FN hn_uvec3 hn_i_following(hn_uvec3 c, hn_ivec3 period) {
  return uvec3(hn_i_following(c.x, period.x), hn_i_following(c.y, period.y), hn_i_following(c.z, period.z));
}

// To here block.glsl is generated from block2d.glsl, in 3 dimensions.

// From here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

// The spread coordinates of a cell, of the previous one along each axis, and of the following one: all that simplex
// noise and cellular noise visit.
struct hn_i_neighbourhood3 {
  hn_uvec3 previous;
  hn_uvec3 cell;
  hn_uvec3 following;
};
struct hn_i_neighbourhood4 {
  hn_uvec4 previous;
  hn_uvec4 cell;
  hn_uvec4 following;
};

HN_FN hn_i_neighbourhood3 hn_i_neighbourhood(hn_place3 place) {
  HN_I_NEW(hn_i_neighbourhood3, cells);
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    cells.cell = hn_i_spread(c);
    cells.previous = hn_i_spread(hn_i_previous(c, place.period));
    cells.following = hn_i_upper(cells.cell, c, place.period);
  } else {
    cells.cell = hn_i_spread(uvec3(place.cell));
    cells.previous = hn_i_previous(cells.cell);
    cells.following = hn_i_upper(cells.cell);
  }
  return cells;
}
HN_FN hn_i_neighbourhood4 hn_i_neighbourhood(hn_place4 place) {
  HN_I_NEW(hn_i_neighbourhood4, cells);
  if (place.tiled) {
    hn_uvec4 c = hn_i_wrap(place.cell, place.period);
    cells.cell = hn_i_spread(c);
    cells.previous = hn_i_spread(hn_i_previous(c, place.period));
    cells.following = hn_i_upper(cells.cell, c, place.period);
  } else {
    cells.cell = hn_i_spread(uvec4(place.cell));
    cells.previous = hn_i_previous(cells.cell);
    cells.following = hn_i_upper(cells.cell);
  }
  return cells;
}

// To here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

HN_FN hn_uvec3 hn_i_coordinates_x(hn_i_neighbourhood3 cells) {
  return uvec3(cells.previous.x, cells.cell.x, cells.following.x);
}
HN_FN hn_uvec3 hn_i_coordinates_y(hn_i_neighbourhood3 cells) {
  return uvec3(cells.previous.y, cells.cell.y, cells.following.y);
}
HN_FN hn_uvec3 hn_i_coordinates_z(hn_i_neighbourhood3 cells) {
  return uvec3(cells.previous.z, cells.cell.z, cells.following.z);
}

#endif
