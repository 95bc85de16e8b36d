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
  hn_ivec3 period;
  bool tiled;
};

HN_FN hn_i_whole3 hn_i_position(hn_place3 place) {
  HN_I_NEW(hn_i_whole3, q);
  q.x = hn_i_whole(place.cell.x, place.fraction.x, place.rest.x);
  q.y = hn_i_whole(place.cell.y, place.fraction.y, place.rest.y);
  q.z = hn_i_whole(place.cell.z, place.fraction.z, place.rest.z);
  q.period = place.period;
  q.tiled = place.tiled;
  return q;
}
HN_FN hn_place3 hn_i_place_of(hn_i_whole3 q) {
  hn_place3 place = hn_i_place(
      ivec3(q.x.x, q.y.x, q.z.x),
      hn_i_num(hn_i_whole_fraction(q.x), hn_i_whole_fraction(q.y), hn_i_whole_fraction(q.z)),
      ivec3(HN_I_REST(q.x.y & 15), HN_I_REST(q.y.y & 15), HN_I_REST(q.z.y & 15)));
  place.period = q.period;
  place.tiled = q.tiled;
  return place;
}

HN_FN hn_ivec3 hn_i_next_period(hn_ivec3 period, hn_float lacunarity) {
  return ivec3(hn_i_next_period(period.x, lacunarity), hn_i_next_period(period.y, lacunarity),
               hn_i_next_period(period.z, lacunarity));
}

// The next position. A tile must not turn.
// The turn is one in the plane of x and y, and then one in that of y and z.
HN_FN hn_i_whole3 hn_i_next(hn_i_whole3 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  hn_ivec2 x = hn_i_times_ratio(q.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(q.y, ratio);
  hn_ivec2 z = hn_i_times_ratio(q.z, ratio);
  hn_i_whole3 next = q;
  if (q.tiled) {
    next.x = hn_i_shifted(x, HN_I_SHIFT_X);
    next.y = hn_i_shifted(y, HN_I_SHIFT_Y);
    next.z = hn_i_shifted(z, HN_I_SHIFT_Z);
    next.period = hn_i_next_period(q.period, lacunarity);
  } else {
    hn_ivec2 turned = hn_i_rotated_axis(y, x, 25, 20);
    next.x = hn_i_shifted(hn_i_rotated_axis(x, y, 25, -20), HN_I_SHIFT_X);
    next.y = hn_i_shifted(hn_i_rotated_axis(turned, z, 29, -13), HN_I_SHIFT_Y);
    next.z = hn_i_shifted(hn_i_rotated_axis(z, turned, 29, 13), HN_I_SHIFT_Z);
  }
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_POSITION3 hn_i_whole3

HN_FN hn_i_whole3 hn_i_position(hn_vec3 p) { return hn_i_position(hn_place(p)); }

#else

#define HN_I_POSITION3 hn_vec3

HN_FN hn_vec3 hn_i_position(hn_vec3 p) { return hn_i_start(p); }
HN_FN hn_place3 hn_i_place_of(hn_vec3 q) { return hn_place(q); }

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

#endif

#define HN_I_TYPES3 hn_vec3, hn_place3, HN_I_POSITION3, hn_i_whole3

#endif
