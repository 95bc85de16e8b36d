// hashnoise: the positions of octaves on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_OCTAVES_PLANE_GLSL
#define HN_OCTAVES_PLANE_GLSL

#include "octaves.glsl"

// A whole position; each axis is one of octaves.glsl.
struct hn_i_whole2 {
  hn_ivec2 x;
  hn_ivec2 y;
};

HN_FN hn_ivec2 hn_i_cell_of(hn_i_whole2 q) { return ivec2(q.x.x, q.y.x); }
HN_FN hn_vec2 hn_i_place_of(hn_i_whole2 q) {
  return vec2(hn_i_whole_fraction(q.x), hn_i_whole_fraction(q.y));
}

HN_FN hn_i_whole2 hn_i_position(hn_ivec2 cell, hn_vec2 f) {
  HN_I_NEW(hn_i_whole2, q);
  q.x = hn_i_whole(cell.x, f.x);
  q.y = hn_i_whole(cell.y, f.y);
  return q;
}

// The next position of a tile, which must not turn. 5767168 and others are the shifts, in units of 2^-24.
HN_FN hn_i_whole2 hn_i_next_tile(hn_i_whole2 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  HN_I_NEW(hn_i_whole2, next);
  next.x = hn_i_shifted(hn_i_times_ratio(q.x, ratio), 5767168);
  next.y = hn_i_shifted(hn_i_times_ratio(q.y, ratio), 9961472);
  return next;
}

HN_FN hn_i_whole2 hn_i_next(hn_i_whole2 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  hn_ivec2 x = hn_i_times_ratio(q.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(q.y, ratio);
  HN_I_NEW(hn_i_whole2, next);
  next.x = hn_i_shifted(hn_i_turned_axis(x, y, 25, -20), 5767168);
  next.y = hn_i_shifted(hn_i_turned_axis(y, x, 25, 20), 9961472);
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_PLACE2 hn_i_whole2

HN_FN hn_i_whole2 hn_i_position(hn_vec2 p) {
  HN_I_NEW(hn_i_whole2, q);
  q.x = hn_i_whole(p.x);
  q.y = hn_i_whole(p.y);
  return q;
}

#else

#define HN_I_PLACE2 hn_vec2

HN_FN hn_vec2 hn_i_position(hn_vec2 p) { return hn_i_start(p); }
HN_FN hn_ivec2 hn_i_cell_of(hn_vec2 q) { return hn_i_cell(q); }
HN_FN hn_vec2 hn_i_place_of(hn_vec2 q) { return hn_i_fraction(q); }

HN_FN hn_vec2 hn_i_next(hn_vec2 q, hn_float lacunarity) {
  hn_float a = hn_i_times(lacunarity, 25.0f / 32.0f);
  hn_float b = hn_i_times(lacunarity, 20.0f / 32.0f);
  HN_I_PRECISE hn_vec2 next = vec2(a * q.x - b * q.y + 11.0f / 32.0f, b * q.x + a * q.y + 19.0f / 32.0f);
  return next;
}

HN_FN hn_vec2 hn_i_next_tile(hn_vec2 q, hn_float lacunarity) {
  return hn_i_times_plus(q, lacunarity, vec2(11.0f / 32.0f, 19.0f / 32.0f));
}

#endif

HN_FN hn_ivec2 hn_i_next_period(hn_ivec2 period, hn_float lacunarity) {
  return ivec2(hn_i_next_period(period.x, lacunarity), hn_i_next_period(period.y, lacunarity));
}

#define HN_I_TYPES2 hn_vec2, hn_ivec2, HN_I_PLACE2, hn_i_whole2

#endif
