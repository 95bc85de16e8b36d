// hashnoise: the positions of octaves on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_OCTAVES_PLANE_GLSL
#define HN_OCTAVES_PLANE_GLSL

#include "octaves.glsl"

// A whole position; each axis is one of octaves.glsl.
struct hn_i_whole2 {
  hn_ivec2 x;
  hn_ivec2 y;
  hn_ivec2 period;
  bool tiled;
};

HN_FN hn_i_whole2 hn_i_position(hn_place2 place) {
  HN_I_NEW(hn_i_whole2, q);
  q.x = hn_i_whole(place.cell.x, place.fraction.x, place.rest.x);
  q.y = hn_i_whole(place.cell.y, place.fraction.y, place.rest.y);
  q.period = place.period;
  q.tiled = place.tiled;
  return q;
}
HN_FN hn_place2 hn_i_place_of(hn_i_whole2 q) {
  hn_place2 place = hn_i_place(
      ivec2(q.x.x, q.y.x),
      hn_i_num(hn_i_whole_fraction(q.x), hn_i_whole_fraction(q.y)),
      ivec2(HN_I_REST(q.x.y & 15), HN_I_REST(q.y.y & 15)));
  place.period = q.period;
  place.tiled = q.tiled;
  return place;
}

HN_FN hn_ivec2 hn_i_next_period(hn_ivec2 period, hn_float lacunarity) {
  return ivec2(hn_i_next_period(period.x, lacunarity), hn_i_next_period(period.y, lacunarity));
}

// The next position. A tile must not turn.
HN_FN hn_i_whole2 hn_i_next(hn_i_whole2 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  hn_ivec2 x = hn_i_times_ratio(q.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(q.y, ratio);
  hn_i_whole2 next = q;
  if (q.tiled) {
    next.x = hn_i_shifted(x, HN_I_SHIFT_X);
    next.y = hn_i_shifted(y, HN_I_SHIFT_Y);
    next.period = hn_i_next_period(q.period, lacunarity);
  } else {
    next.x = hn_i_shifted(hn_i_rotated_axis(x, y, 25, -20), HN_I_SHIFT_X);
    next.y = hn_i_shifted(hn_i_rotated_axis(y, x, 25, 20), HN_I_SHIFT_Y);
  }
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_POSITION2 hn_i_whole2

HN_FN hn_i_whole2 hn_i_position(hn_vec2 p) { return hn_i_position(hn_place(p)); }

#else

#define HN_I_POSITION2 hn_vec2

HN_FN hn_vec2 hn_i_position(hn_vec2 p) { return hn_i_start(p); }
HN_FN hn_place2 hn_i_place_of(hn_vec2 q) { return hn_place(q); }

HN_FN hn_vec2 hn_i_next(hn_vec2 q, hn_float lacunarity) {
  hn_float a = hn_i_times(lacunarity, 25.0f / 32.0f);
  hn_float b = hn_i_times(lacunarity, 20.0f / 32.0f);
  HN_I_PRECISE hn_vec2 next = vec2(a * q.x - b * q.y + 11.0f / 32.0f, b * q.x + a * q.y + 19.0f / 32.0f);
  return next;
}

#endif

#define HN_I_TYPES2 hn_vec2, hn_place2, HN_I_POSITION2, hn_i_whole2

#endif
