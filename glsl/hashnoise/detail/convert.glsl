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

#endif
