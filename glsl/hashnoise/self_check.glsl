// hashnoise: a number that is wrong if a driver, a compiler or a port computes wrong bits.
// SPDX-License-Identifier: MIT

#ifndef HN_SELF_CHECK_GLSL
#define HN_SELF_CHECK_GLSL

#include "numbers.glsl"
#include "position.glsl"

// Multiplies a float by a power of two that makes a whole number of it, and returns that as a uint.
HN_FN hn_uint hn_i_in_units(hn_float x, hn_float units) { return uint(int(x * units)); }

HN_FN hn_uint hn_i_checked(hn_uint w, hn_uint n) { return hn_i_scramble(w + n); }
HN_FN hn_uint hn_i_checked(hn_uint w, hn_vec2 v, hn_float units) {
  return hn_i_checked(hn_i_checked(w, hn_i_in_units(v.x, units)), hn_i_in_units(v.y, units));
}
HN_FN hn_uint hn_i_checked(hn_uint w, hn_vec3 v, hn_float units) {
  return hn_i_checked(hn_i_checked(w, vec2(v.x, v.y), units), hn_i_in_units(v.z, units));
}

// A check of your driver, compiler or port: one number, equal everywhere, made of 16 points each of hashes, random
// numbers, directions, orders and whole positions. They use every operation on integers that noises use with HN_FIXED.
// docs/guide/same-bits.md has advice if yours differs.
//   zero     0u, from a uniform or an argument: so the compiler cannot compute the result itself
//   example  uint h = hn_self_check(0u);
//   returns  0x1BB1728B with the default hash, and another number with each HN_HASH
//   error    none
//   cost     16 hashes (none with HN_HASH_LATTICE) and 3400 multiplications: call it once, not in each pixel
//   source   docs/reference/contract.md, section 18
HN_FN hn_uint hn_self_check(hn_uint zero) {
  hn_uint w = zero;
  for (hn_int i = 0; i < 16; ++i) {
    hn_uint seed = w;
    hn_uint h = hn_lattice(ivec3(int(seed), i - 8, int(seed >> 9u) - 4194304), seed);
    w = hn_i_checked(w, h);
    w = hn_i_checked(w, hn_unorm_three(h), 16777216.0f);
    w = hn_i_checked(w, hn_sphere(h), 65536.0f);
    w = hn_i_checked(w, hn_disk(h), 65536.0f);
    w = hn_i_checked(w, hn_i_in_units(hn_gaussian(h), 8192.0f));
    w = hn_i_checked(w, hn_shuffle(h, uint(i + 1000), seed));
    w = hn_i_checked(w, hn_sobol(h, seed), 16777216.0f);
    w = hn_i_checked(w, uint(hn_cell(int(h), i + 1, 7)));
    w = hn_i_checked(w, hn_i_in_units(hn_fraction(int(h), i + 1, 7), 16777216.0f));
  }
  return w;
}

#endif
