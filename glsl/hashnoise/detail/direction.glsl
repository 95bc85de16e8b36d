// hashnoise: the direction of a gradient on the plane and in space, and what it adds at an offset.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION_GLSL
#define HN_DIRECTION_GLSL

#include "arithmetic.glsl"

// Gradients are made of fields: bits of a hash as odd multiples of 2^-9 for the plane, and of 2^-8 for space, in
// (-1, 1). They are symmetric about 0 and never 0. The highest bit is a sign. For the plane the field is where the
// fraction of a float begins, from bit 22 down: that saves a shift. For space the two fields are from bit 30 down. No
// bit is used twice. Bits behind an exponent make a float without a conversion from integer.
#if HN_I_BITCAST
HN_FN hn_float hn_i_field2(hn_uint h) {
  return hn_i_minus(uintBitsToFloat((h & 0x007FC000u) | 0x40000000u), 3.0f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3p(hn_uint h) {
  return hn_i_minus(uintBitsToFloat(((h >> 8u) & 0x007F8000u) | 0x40000000u), 3.0f - 1.0f / 256.0f);
}
HN_FN hn_float hn_i_field3q(hn_uint h) {
  return hn_i_minus(uintBitsToFloat((h & 0x007F8000u) | 0x40000000u), 3.0f - 1.0f / 256.0f);
}

// The fields of three words at once.
HN_FN hn_vec3 hn_i_of_field_bits(hn_uvec3 bits, hn_float offset) {
  HN_I_PRECISE hn_vec3 x = uintBitsToFloat(hn_i_or(bits, 0x40000000u)) - offset;
  return x;
}
HN_FN hn_vec3 hn_i_fields2(hn_uvec3 h) { return hn_i_of_field_bits(hn_i_and(h, 0x007FC000u), 3.0f - 1.0f / 512.0f); }
HN_FN hn_vec3 hn_i_fields3p(hn_uvec3 h) {
  return hn_i_of_field_bits(hn_i_and(h >> 8u, 0x007F8000u), 3.0f - 1.0f / 256.0f);
}
HN_FN hn_vec3 hn_i_fields3q(hn_uvec3 h) { return hn_i_of_field_bits(hn_i_and(h, 0x007F8000u), 3.0f - 1.0f / 256.0f); }
#else
HN_FN hn_float hn_i_field2(hn_uint h) {
  return hn_i_minus(hn_i_float((h >> 14u) & 511u) * (1.0f / 256.0f), 1.0f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3p(hn_uint h) {
  return hn_i_minus(hn_i_float((h >> 23u) & 255u) * (1.0f / 128.0f), 1.0f - 1.0f / 256.0f);
}
HN_FN hn_float hn_i_field3q(hn_uint h) {
  return hn_i_minus(hn_i_float((h >> 15u) & 255u) * (1.0f / 128.0f), 1.0f - 1.0f / 256.0f);
}
HN_FN hn_vec3 hn_i_fields2(hn_uvec3 h) { return vec3(hn_i_field2(h.x), hn_i_field2(h.y), hn_i_field2(h.z)); }
HN_FN hn_vec3 hn_i_fields3p(hn_uvec3 h) { return vec3(hn_i_field3p(h.x), hn_i_field3p(h.y), hn_i_field3p(h.z)); }
HN_FN hn_vec3 hn_i_fields3q(hn_uvec3 h) { return vec3(hn_i_field3q(h.x), hn_i_field3q(h.y), hn_i_field3q(h.z)); }
#endif

// A direction is a point of the square or octahedron |x| + |y| (+ |z|) = 1, and `more`: 1 less its largest component.
// The gradient is the point times 1 + more. That brings its length near 1 in every direction, since noise made of the
// points themselves would show the axes (docs/quality.md). Ramps are lengthened in place of gradients: it is cheaper.
#if HN_ARITHMETIC != HN_FIXED

// On the plane a direction is x, y, more.
HN_FN hn_vec3 hn_i_direction2(hn_uint h) {
  hn_float x = hn_i_field2(h);
  hn_float m = hn_i_minus(1.0f, abs(x));
  return vec3(x, hn_i_signed(m, h), min(abs(x), m));
}

// In space a direction is p, q, z, more. Seen along z the octahedron is a square with corners on the axes. p and q run
// along its sides: x = (p + q) / 2 and y = (p - q) / 2. The height above a point of the square is 1 minus the larger of
// |p| and |q|.
HN_FN hn_vec4 hn_i_direction3(hn_uint h) {
  hn_float p = hn_i_field3p(h);
  hn_float q = hn_i_field3q(h);
  hn_float larger = max(abs(p), abs(q));
  hn_float more = min(hn_i_times_plus(-0.5f, hn_i_plus(abs(p), abs(q)), 1.0f), larger);
  return vec4(p, q, hn_i_signed(hn_i_minus(1.0f, larger), h), more);
}

HN_FN hn_float hn_i_gradient1(hn_uint h) { return hn_i_field2(h); }
HN_FN hn_vec2 hn_i_gradient(hn_vec3 d) { return vec2(hn_i_times_one_plus(d.x, d.z), hn_i_times_one_plus(d.y, d.z)); }
HN_FN hn_vec3 hn_i_gradient(hn_vec4 d) {
  hn_float half_length = hn_i_times_plus(0.5f, d.w, 0.5f);
  return vec3(hn_i_times(hn_i_plus(d.x, d.y), half_length), hn_i_times(hn_i_minus(d.x, d.y), half_length),
              hn_i_times_one_plus(d.z, d.w));
}

// A direction times an offset. In space u = (x + y) / 2, v = (x - y) / 2, and w = z.
HN_FN hn_float hn_i_dot_direction(hn_vec3 d, hn_float x, hn_float y) { return hn_i_dot(vec2(d.x, d.y), x, y); }
HN_FN hn_float hn_i_dot_direction(hn_vec4 d, hn_float u, hn_float v, hn_float w) {
  return hn_i_dot(vec3(d.x, d.y, d.z), u, v, w);
}
HN_FN hn_float hn_i_ramp(hn_float g, hn_float x) { return hn_i_times(g, x); }

// a x - b y
HN_FN hn_float hn_i_cross(hn_float a, hn_float x, hn_float b, hn_float y) {
  HN_I_PRECISE hn_float n = a * x - b * y;
  return n;
}

// Ramps in space take offsets in this form: u and v are made of halves.
HN_FN hn_float hn_i_octahedral(hn_float x) { return hn_i_times(x, 0.5f); }
HN_FN hn_float hn_i_octahedral_z(hn_float z) { return z; }

#else

// The same in units of 2^-9, but p, q and z in units of 2^-8. They are computed as floats, since on GPUs the absolute
// value of a float costs nothing, and that of an integer does. No step rounds: the floats are whole numbers of few
// bits.
#if HN_I_BITCAST
HN_FN hn_float hn_i_whole2(hn_uint h) { return uintBitsToFloat((h & 0x007FC000u) | 0x44800000u) - 1535.0f; }
HN_FN hn_float hn_i_whole3(hn_uint h) { return uintBitsToFloat((h & 0x007F8000u) | 0x44000000u) - 767.0f; }

// The fields of three words at once.
HN_FN hn_vec3 hn_i_wholes2(hn_uvec3 h) {
  return uintBitsToFloat(hn_i_or(hn_i_and(h, 0x007FC000u), 0x44800000u)) - 1535.0f;
}
#else
HN_FN hn_float hn_i_whole2(hn_uint h) { return hn_i_float((h >> 13u) & 1022u) - 511.0f; }
HN_FN hn_float hn_i_whole3(hn_uint h) { return hn_i_float((h >> 14u) & 510u) - 255.0f; }
HN_FN hn_vec3 hn_i_wholes2(hn_uvec3 h) { return vec3(hn_i_whole2(h.x), hn_i_whole2(h.y), hn_i_whole2(h.z)); }
#endif
HN_FN hn_ivec3 hn_i_direction2(hn_uint h) {
  hn_float x = hn_i_whole2(h);
  hn_float m = 512.0f - abs(x);
  return ivec3(vec3(x, hn_i_signed(m, h), min(abs(x), m)));
}
HN_FN hn_ivec4 hn_i_direction3(hn_uint h) {
  hn_float p = hn_i_whole3(h >> 8u);
  hn_float q = hn_i_whole3(h);
  hn_float larger = max(abs(p), abs(q));
  hn_float more = min(512.0f - (abs(p) + abs(q)), larger + larger);
  return ivec4(vec4(p, q, hn_i_signed(256.0f - larger, h), more));
}

// Gradients are in units of 2^-29, as ramps are.
HN_FN hn_int hn_i_gradient1(hn_uint h) { return (int((h >> 13u) & 1022u) - 511) << 20; }
HN_FN hn_ivec2 hn_i_gradient(hn_ivec3 d) {
  hn_int s = (512 + d.z) << 11;
  return ivec2(d.x * s, d.y * s);
}
HN_FN hn_ivec3 hn_i_gradient(hn_ivec4 d) {
  hn_int s = (512 + d.w) << 11;
  return ivec3((d.x + d.y) * s, (d.x - d.y) * s, (d.z + d.z) * s);
}

HN_FN hn_int hn_i_dot_direction(hn_ivec3 d, hn_int x, hn_int y) { return d.x * x + d.y * y; }
HN_FN hn_int hn_i_dot_direction(hn_ivec4 d, hn_int u, hn_int v, hn_int w) { return d.x * u + d.y * v + d.z * w; }
HN_FN hn_int hn_i_ramp(hn_int g, hn_int x) { return (g >> 20) * x; }
HN_FN hn_int hn_i_cross(hn_int a, hn_int x, hn_int b, hn_int y) { return a * x - b * y; }

// In space p, q and z have units twice as large, so u = x + y, v = x - y and w = 2 z.
HN_FN hn_int hn_i_octahedral(hn_int x) { return x; }
HN_FN hn_int hn_i_octahedral_z(hn_int z) { return z + z; }

#endif

// The ramp of a corner.
HN_FN hn_i_num hn_i_ramp(hn_i_num3 d, hn_i_num x, hn_i_num y) {
  return hn_i_times_one_plus(hn_i_dot_direction(d, x, y), d.z);
}
HN_FN hn_i_num hn_i_ramp(hn_i_num4 d, hn_i_num u, hn_i_num v, hn_i_num w) {
  return hn_i_times_one_plus(hn_i_dot_direction(d, u, v, w), d.w);
}

#endif
