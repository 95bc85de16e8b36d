// hashnoise: the cell that a noise is in, in every dimension. cell2d.glsl has it on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_CELL_GLSL
#define HN_CELL_GLSL

#include "../place.glsl"
#include "cell2d.glsl"

HN_FN hn_uvec3 hn_i_upper(hn_uvec3 lower) {
  return uvec3(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y, lower.z + HN_I_STEP_Z);
}
HN_FN hn_uvec4 hn_i_upper(hn_uvec4 lower) {
  return uvec4(hn_i_upper(lower.x), lower.y + HN_I_STEP_Y, lower.z + HN_I_STEP_Z, lower.w + HN_I_STEP_W);
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

// From here cell.glsl is generated from cell2d.glsl, in 3 and 4 dimensions.

// The fade of a fraction along each axis.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_vec3 hn_i_fade(hn_vec3 f) {
  HN_I_AS_WRITTEN hn_vec3 d = f - 1.0f;
  HN_I_PRECISE hn_vec3 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}
HN_FN hn_vec4 hn_i_fade(hn_vec4 f) {
  HN_I_AS_WRITTEN hn_vec4 d = f - 1.0f;
  HN_I_PRECISE hn_vec4 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}
#else
HN_FN hn_ivec3 hn_i_fade(hn_ivec3 f) { return ivec3(hn_i_fade(f.x), hn_i_fade(f.y), hn_i_fade(f.z)); }
HN_FN hn_ivec4 hn_i_fade(hn_ivec4 f) { return ivec4(hn_i_fade(f.x), hn_i_fade(f.y), hn_i_fade(f.z), hn_i_fade(f.w)); }
#endif

HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 c, hn_ivec3 period) {
  return uvec3(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y), hn_i_wrap(c.z, period.z));
}
HN_FN hn_uvec4 hn_i_wrap(hn_ivec4 c, hn_ivec4 period) {
  return uvec4(hn_i_wrap(c.x, period.x), hn_i_wrap(c.y, period.y), hn_i_wrap(c.z, period.z), hn_i_wrap(c.w, period.w));
}

// To here cell.glsl is generated from cell2d.glsl, in 3 and 4 dimensions.

// From here cell.glsl is generated from cell2d.glsl, in 1, 3 and 4 dimensions.

// The spread coordinates of the lower and the upper corner of a cell, wrapped where it has a period. All lattice noises
// are functions of the corners and of the place between them.
struct hn_i_cell_corners1 {
  hn_uint lower;
  hn_uint upper;
};
struct hn_i_cell_corners3 {
  hn_uvec3 lower;
  hn_uvec3 upper;
};
struct hn_i_cell_corners4 {
  hn_uvec4 lower;
  hn_uvec4 upper;
};

HN_FN hn_i_cell_corners1 hn_i_cell_corners(hn_place1 place) {
  HN_I_NEW(hn_i_cell_corners1, corners);
  if (place.tiled) {
    hn_uint c = hn_i_wrap(place.cell, place.period);
    corners.lower = hn_i_spread(c);
    corners.upper = hn_i_upper(corners.lower, c, place.period);
  } else {
    corners.lower = hn_i_spread(uint(place.cell));
    corners.upper = hn_i_upper(corners.lower);
  }
  return corners;
}
HN_FN hn_i_cell_corners3 hn_i_cell_corners(hn_place3 place) {
  HN_I_NEW(hn_i_cell_corners3, corners);
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    corners.lower = hn_i_spread(c);
    corners.upper = hn_i_upper(corners.lower, c, place.period);
  } else {
    corners.lower = hn_i_spread(uvec3(place.cell));
    corners.upper = hn_i_upper(corners.lower);
  }
  return corners;
}
HN_FN hn_i_cell_corners4 hn_i_cell_corners(hn_place4 place) {
  HN_I_NEW(hn_i_cell_corners4, corners);
  if (place.tiled) {
    hn_uvec4 c = hn_i_wrap(place.cell, place.period);
    corners.lower = hn_i_spread(c);
    corners.upper = hn_i_upper(corners.lower, c, place.period);
  } else {
    corners.lower = hn_i_spread(uvec4(place.cell));
    corners.upper = hn_i_upper(corners.lower);
  }
  return corners;
}

// To here cell.glsl is generated from cell2d.glsl, in 1, 3 and 4 dimensions.

// The hashes of the corners of a cell: of both ends of a line, of the front or back face of a cube along z, and in four
// dimensions of the square that z and w choose.
HN_FN hn_uvec2 hn_i_corner_hashes(hn_i_cell_corners1 corners, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uint join = hn_i_seed_join(s);
  hn_uint odd = hn_i_odd(corners.lower, s);
  return uvec2(
      hn_i_point_hash(hn_i_high(corners.lower) ^ join, odd),
      hn_i_point_hash(hn_i_high(corners.upper) ^ join, hn_i_odd_x(hn_i_step_x(corners.lower, corners.upper), odd)));
}
HN_FN hn_uvec4 hn_i_corner_hashes(hn_i_cell_corners3 corners, bool back, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uvec3 lower = corners.lower;
  hn_uvec3 upper = corners.upper;
  hn_uint join = hn_i_select(back, hn_i_high(upper).z, hn_i_high(lower).z) ^ hn_i_seed_join(s);
  hn_uint more = hn_i_select(back, hn_i_odd_z(upper.z - lower.z, 0u), 0u);
  return hn_i_corner_hashes(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), join, hn_i_odd(lower, s), more);
}
HN_FN hn_uvec4 hn_i_corner_hashes(hn_i_cell_corners4 corners, bool far_z, bool far_w, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uvec4 lower = corners.lower;
  hn_uvec4 upper = corners.upper;
  hn_uvec4 a = hn_i_high(lower);
  hn_uvec4 b = hn_i_high(upper);
  hn_uint join = hn_i_select(far_z, b.z, a.z) ^ hn_i_select(far_w, b.w, a.w) ^ hn_i_seed_join(s);
  hn_uint more = hn_i_select(far_z, hn_i_odd_z(upper.z - lower.z, 0u), 0u) +
                 hn_i_select(far_w, hn_i_odd_w(upper.w - lower.w, 0u), 0u);
  return hn_i_corner_hashes(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), join, hn_i_odd(lower, s), more);
}

#endif
