// hashnoise: directions in the plane and in space from words. They are exact, in units of 2^-16.
// SPDX-License-Identifier: MIT

#ifndef HN_SPHERE_GLSL
#define HN_SPHERE_GLSL

#include "sine.glsl"
#include "square_root.glsl"

// The direction of an angle of h turns.
HN_FN hn_ivec2 hn_i_on_circle(hn_uint h) { return ivec2(hn_i_whole_wave(h + 0x40000000u, 0u), hn_i_whole_wave(h, 0u)); }

// Each strip of a sphere between two heights has an area that follows from the difference of the heights alone, so the
// height is uniform. It is odd, so the square of the radius there is at least 1.
HN_FN hn_ivec3 hn_i_on_sphere(hn_uint h, hn_uint height) {
  hn_ivec2 direction = hn_i_on_circle(h);
  hn_int z = int((height >> 16u) << 1u) - 65535;
  hn_uint square = 0u - uint(z) * uint(z);  // 2^32 less the square of the height
  hn_int radius = int(hn_i_root(square >> 4u) >> 3u);
  return ivec3((direction.x * radius) >> 15, (direction.y * radius) >> 15, z);
}

#endif
