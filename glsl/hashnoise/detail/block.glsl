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

// A block has the spread coordinates of a cell, of the previous one along each axis, and of the following one: all that
// simplex noise and cellular noise visit.
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

// To here block.glsl is generated from block2d.glsl, in 3 and 4 dimensions.

HN_FN hn_uvec3 hn_i_coordinates_x(hn_i_block3 block) {
  return uvec3(block.previous.x, block.cell.x, block.following.x);
}
HN_FN hn_uvec3 hn_i_coordinates_y(hn_i_block3 block) {
  return uvec3(block.previous.y, block.cell.y, block.following.y);
}
HN_FN hn_uvec3 hn_i_coordinates_z(hn_i_block3 block) {
  return uvec3(block.previous.z, block.cell.z, block.following.z);
}

#endif
