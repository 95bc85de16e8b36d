// hashnoise: integers as floats.
// SPDX-License-Identifier: MIT

#ifndef HN_CONVERT_GLSL
#define HN_CONVERT_GLSL

#include "../config.glsl"

// In GLSL ES a constructor has the precision of its argument. NVIDIA's driver takes the default of the scope instead:
// where that is mediump, float(100000) is infinite. So integers become floats here alone, in scopes of their own.
HN_FN hn_float hn_i_float(hn_int n) {
  HN_I_HIGHP_HERE hn_float x = float(n);
  return x;
}
HN_FN hn_float hn_i_float(hn_uint n) {
  HN_I_HIGHP_HERE hn_float x = float(n);
  return x;
}

// Microsoft's FXC takes a whole number times a constant below 2^-19 for a whole number, and leaves out the floor() of
// it, also where users write it. It does not see what this does, which others leave out.
#ifdef HN_I_FXC
#define HN_I_NOT_WHOLE(x) uintBitsToFloat(floatBitsToUint(x) ^ 0u)
#else
#define HN_I_NOT_WHOLE(x) (x)
#endif

#endif
