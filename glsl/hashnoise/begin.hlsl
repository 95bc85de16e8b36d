// hashnoise: the text of the library as HLSL, from here to end.hlsl.
// SPDX-License-Identifier: MIT
//
//   #include "begin.hlsl"
//   #include "noise2d.glsl"     any files of glsl/hashnoise/
//   #include "end.hlsl"
//
// hashnoise.hlsl includes everything in this way. Knobs (config.glsl) are defined before. Includes may be repeated.
//
// The text has GLSL's names of vectors, and of two functions. end.hlsl undefines them, so none reaches your code. You
// call hn_perlin(float2), and behind end.hlsl hn_vec2 is float2 and so on.

#define HN_I_HLSL
#define HN_I_FXC
#include "detail/vectors_begin.h"
#define uintBitsToFloat asfloat
#define floatBitsToUint asuint
