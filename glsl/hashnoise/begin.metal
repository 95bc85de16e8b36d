// hashnoise: the text of the library in Metal's shading language, from here to end.metal, in namespace hashnoise.
// SPDX-License-Identifier: MIT
//
//   #include <metal_stdlib>
//   #include "begin.metal"
//   #include "noise2d.glsl"     any files of glsl/hashnoise/
//   #include "end.metal"
//
// hashnoise.metal includes everything in this way. Knobs (config.glsl) are defined before. Includes may be repeated.
//
// The text has GLSL's names of vectors, and of two functions. end.metal undefines them, so none of them reaches your
// code. You call hashnoise::hn_perlin(float2), and behind end.metal hn_vec2 is float2 and so on.

#define HN_I_METAL
#include "detail/vectors_begin.h"
#define uintBitsToFloat hn_i_as_floats
#define floatBitsToUint hn_i_as_words

namespace hashnoise {
using namespace metal;

#ifndef HN_BEGIN_METAL
#define HN_BEGIN_METAL
inline float hn_i_as_floats(uint words) { return as_type<float>(words); }
inline float3 hn_i_as_floats(uint3 words) { return as_type<float3>(words); }
inline uint hn_i_as_words(float number) { return as_type<uint>(number); }
inline uint3 hn_i_as_words(float3 numbers) { return as_type<uint3>(numbers); }
#endif
