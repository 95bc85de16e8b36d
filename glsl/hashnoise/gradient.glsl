// hashnoise: the gradient of a hash, and the gradient of a lattice point.
// SPDX-License-Identifier: MIT

#ifndef HN_GRADIENT_GLSL
#define HN_GRADIENT_GLSL

#include "detail/direction3d.glsl"
#include "detail/direction4d.glsl"
#include "hash.glsl"
#if HN_GRADIENT == HN_GRADIENT_SINE
#include "detail/sine_gradient.glsl"
#endif

// A gradient on the line, from bits 14 to 22 of a hash.
//   h        any uint
//   example  float g = hn_gradient1(hn_lattice(ivec2(3, -5), 7u));
//   returns  an odd multiple of 2^-9 in (-1, 1)
//   error    none
//   cost     no multiplication (GLSL before 3.30: 1 of floats)
//   source   docs/reference/contract.md, section 4
HN_FN hn_float hn_gradient1(hn_uint h) {
#if HN_ARITHMETIC != HN_FIXED
  return hn_i_gradient1(h);
#else
  return hn_i_float(hn_i_gradient1(h)) * (1.0f / 134217728.0f);
#endif
}

// A gradient in the plane, from bits 21, 22 and 31 of a hash.
//   h        any uint
//   example  vec2 g = hn_gradient2(hn_lattice(ivec2(3, -5), 7u));
//   returns  one of 8 vectors: one component is 3/4 or -3/4, and the other 1/4 or -1/4
//   error    none
//   cost     no multiplication (GLSL before 3.30: 1 of floats)
//   source   docs/reference/contract.md, section 4
HN_FN hn_vec2 hn_gradient2(hn_uint h) { return hn_i_direction2(h); }

// A gradient in space, from the size of a hash and its bits 21 and 22.
//   h        any uint
//   example  vec3 g = hn_gradient3(hn_lattice(ivec2(3, -5), 7u));
//   returns  one of 12 vectors: two components are 1 or -1, and one is 0
//   error    none
//   cost     no multiplication
//   source   Perlin, "Improving noise", 2002, for the vectors; docs/reference/contract.md, section 4
HN_FN hn_vec3 hn_gradient3(hn_uint h) { return hn_i_direction3(h, false); }

// A gradient in four dimensions, from the size of a hash and its bits 20 to 22.
//   h        any uint
//   example  vec4 g = hn_gradient4(hn_lattice(ivec2(3, -5), 7u));
//   returns  two components that are 1 or -1, and two that are 0
//   error    none
//   cost     no multiplication
//   source   docs/reference/contract.md, section 4
HN_FN hn_vec4 hn_gradient4(hn_uint h) { return hn_i_direction4(h); }

// The gradient of the noise at a lattice point.
//   cell     the point: int, ivec2, ivec3 or ivec4
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec2 g = hn_gradient(ivec2(3, -5), 7u);
//   returns  a vector of hn_gradient1, hn_gradient2, hn_gradient3 or hn_gradient4; with HN_GRADIENT_SINE, in 2D and 3D,
//            a point of the square or cube [-1, 1]^n
//   error    none; with HN_GRADIENT_SINE less than 2^-19 (HN_FIXED: 3.7e-5)
//   period   2^32 along each axis
//   cost     1 hash (none with HN_HASH_LATTICE), 1 multiplication per axis and 1 more, 2 more for a seed that is not
//            constant, and the cost of hn_gradient1 to hn_gradient4; with HN_GRADIENT_SINE 1 hash per axis and a sine
//            of 10 multiplications, 6 of them of floats, per component
//   source   docs/reference/contract.md, section 4; for the sine: Valdenegro-Toro and Pincheira, sec. 5
HN_FN hn_float hn_gradient(hn_int cell, hn_uint seed) { return hn_gradient1(hn_i_point(uint(cell), seed)); }

HN_FN hn_vec2 hn_gradient(hn_ivec2 cell, hn_uint seed) {
  hn_uvec2 c = uvec2(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient2(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_scramble(seed);
  return hn_i_components(hn_i_gradient(hn_i_column_key(c.x, s), c.y));
#endif
}

HN_FN hn_vec3 hn_gradient(hn_ivec3 cell, hn_uint seed) {
  hn_uvec3 c = uvec3(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient3(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_scramble(seed);
  hn_uint column = hn_i_column_key(c.x, s);
  return hn_i_components(hn_i_gradient(column, hn_i_row_key(column, c.y), c.z));
#endif
}

HN_FN hn_vec4 hn_gradient(hn_ivec4 cell, hn_uint seed) { return hn_gradient4(hn_i_point(uvec4(cell), seed)); }

HN_FN hn_vec2 hn_gradient(hn_ivec2 cell) { return hn_gradient(cell, 0u); }
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_float hn_gradient(hn_int cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec3 hn_gradient(hn_ivec3 cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec4 hn_gradient(hn_ivec4 cell) { return hn_gradient(cell, 0u); }

#endif
