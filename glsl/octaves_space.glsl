// hashnoise: the positions of octaves in space.
// SPDX-License-Identifier: MIT

#ifndef HN_OCTAVES_SPACE_GLSL
#define HN_OCTAVES_SPACE_GLSL

#include "octaves.glsl"

// A whole position; each axis is one of octaves.glsl.
struct hn_i_whole3 {
  hn_ivec2 x;
  hn_ivec2 y;
  hn_ivec2 z;
};

HN_FN hn_ivec3 hn_i_cell_of(hn_i_whole3 q) { return ivec3(q.x.x, q.y.x, q.z.x); }
HN_FN hn_vec3 hn_i_place_of(hn_i_whole3 q) {
  return vec3(hn_i_whole_fraction(q.x), hn_i_whole_fraction(q.y), hn_i_whole_fraction(q.z));
}

HN_FN hn_i_whole3 hn_i_position(hn_ivec3 cell, hn_vec3 f) {
  HN_I_NEW(hn_i_whole3, q);
  q.x = hn_i_whole(cell.x, f.x);
  q.y = hn_i_whole(cell.y, f.y);
  q.z = hn_i_whole(cell.z, f.z);
  return q;
}

// The next position of a tile, which must not turn. 5767168 and others are the shifts, in units of 2^-24.
HN_FN hn_i_whole3 hn_i_next_tile(hn_i_whole3 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  HN_I_NEW(hn_i_whole3, next);
  next.x = hn_i_shifted(hn_i_times_ratio(q.x, ratio), 5767168);
  next.y = hn_i_shifted(hn_i_times_ratio(q.y, ratio), 9961472);
  next.z = hn_i_shifted(hn_i_times_ratio(q.z, ratio), 12058624);
  return next;
}

// The turn is one in the plane of x and y, and then one in that of y and z.
HN_FN hn_i_whole3 hn_i_next(hn_i_whole3 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  hn_ivec2 x = hn_i_times_ratio(q.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(q.y, ratio);
  hn_ivec2 z = hn_i_times_ratio(q.z, ratio);
  HN_I_NEW(hn_i_whole3, next);
  hn_ivec2 turned = hn_i_turned_axis(y, x, 25, 20);
  next.x = hn_i_shifted(hn_i_turned_axis(x, y, 25, -20), 5767168);
  next.y = hn_i_shifted(hn_i_turned_axis(turned, z, 29, -13), 9961472);
  next.z = hn_i_shifted(hn_i_turned_axis(z, turned, 29, 13), 12058624);
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_PLACE3 hn_i_whole3

HN_FN hn_i_whole3 hn_i_position(hn_vec3 p) {
  HN_I_NEW(hn_i_whole3, q);
  q.x = hn_i_whole(p.x);
  q.y = hn_i_whole(p.y);
  q.z = hn_i_whole(p.z);
  return q;
}

#else

#define HN_I_PLACE3 hn_vec3

HN_FN hn_vec3 hn_i_position(hn_vec3 p) { return hn_i_start(p); }
HN_FN hn_ivec3 hn_i_cell_of(hn_vec3 q) { return hn_i_cell(q); }
HN_FN hn_vec3 hn_i_place_of(hn_vec3 q) { return hn_i_fraction(q); }

HN_FN hn_vec3 hn_i_next(hn_vec3 q, hn_float lacunarity) {
  hn_float a = hn_i_times(lacunarity, 25.0f / 32.0f);
  hn_float b = hn_i_times(lacunarity, 20.0f / 32.0f);
  HN_I_PRECISE hn_float turned = b * q.x + a * q.y;
  hn_float c = hn_i_times(lacunarity, 29.0f / 32.0f);
  hn_float d = hn_i_times(lacunarity, 13.0f / 32.0f);
  HN_I_PRECISE hn_vec3 next =
      vec3(a * q.x - b * q.y + 11.0f / 32.0f, 29.0f / 32.0f * turned - d * q.z + 19.0f / 32.0f,
           13.0f / 32.0f * turned + c * q.z + 23.0f / 32.0f);
  return next;
}

HN_FN hn_vec3 hn_i_next_tile(hn_vec3 q, hn_float lacunarity) {
  return hn_i_times_plus(q, lacunarity, vec3(11.0f / 32.0f, 19.0f / 32.0f, 23.0f / 32.0f));
}

#endif

HN_FN hn_ivec3 hn_i_next_period(hn_ivec3 period, hn_float lacunarity) {
  return ivec3(hn_i_next_period(period.x, lacunarity), hn_i_next_period(period.y, lacunarity),
               hn_i_next_period(period.z, lacunarity));
}

#define HN_I_TYPES3 hn_vec3, hn_ivec3, HN_I_PLACE3, hn_i_whole3

#endif
