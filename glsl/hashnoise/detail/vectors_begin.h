// hashnoise: GLSL's vectors in the languages that call them float2, int2 and uint2. For begin.hlsl and begin.metal.
// SPDX-License-Identifier: MIT

// For the text of the library, as far as vectors_end.h.
#define vec2 float2
#define vec3 float3
#define vec4 float4
#define ivec2 int2
#define ivec3 int3
#define ivec4 int4
#define uvec2 uint2
#define uvec3 uint3
#define uvec4 uint4

// The types in declarations, as config.glsl has them for GLSL, where they stay, too.
#define hn_float float
#define hn_vec2 float2
#define hn_vec3 float3
#define hn_vec4 float4
#define hn_int int
#define hn_ivec2 int2
#define hn_ivec3 int3
#define hn_ivec4 int4
#define hn_uint uint
#define hn_uvec2 uint2
#define hn_uvec3 uint3
#define hn_uvec4 uint4
