// The paper's rivals: Perlin noise with its permutation P and its gradients G in textures, once in floats and once in
// integers. Both are the same noise, with a period of 256 cells. bench/tables.cpp makes and binds the textures.
//
// Perlin/Float follows Green, "Implementing Improved Perlin Noise", GPU Gems 2, 2005, which the paper cites: tables of
// tables, so that 2D takes 4 fetches and 3D takes 1 + 8. Perlin/Integer goes through the permutation axis by axis, as
// Perlin's own code does, in tables of 512 entries, so that sums need not be wrapped: 2 + 4 fetches in 2D, 2 + 4 + 8 in
// 3D.

#ifndef HN_PAPER_TABLES_GLSL
#define HN_PAPER_TABLES_GLSL

#include "perlin.glsl"

#ifdef VULKAN
#define TABLE(n) layout(set = 0, binding = n) uniform
#else
#define TABLE(n) uniform
#endif

#if TABLE_ARITHMETIC == 1  // float

TABLE(0) sampler2D table_gradient2;     // 256 x 256: G[P[P[x] + y]]
TABLE(1) sampler2D table_permutation2;  // 256 x 256: P[P[x] + y] for (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)
TABLE(2) sampler2D table_gradient3;     // 256 x 1: G[P[i]]

float table_perlin(vec2 p) {
  // Texel centres; the wrap mode of the textures makes the period.
  vec2 cell = floor(p);
  vec2 at = (cell + 0.5) * (1.0 / 256.0);
  vec2 next = at + 1.0 / 256.0;
  return perlin_sum(p - cell, texture(table_gradient2, at).xy, texture(table_gradient2, vec2(next.x, at.y)).xy,
                    texture(table_gradient2, vec2(at.x, next.y)).xy, texture(table_gradient2, next).xy);
}

vec3 table_gradient(float i) { return texture(table_gradient3, vec2(i, 0.5)).xyz; }

float table_perlin(vec3 p) {
  vec3 cell = floor(p);
  vec3 at = (cell + 0.5) * (1.0 / 256.0);
  // A texel holds an 8-bit number i as i / 255; the row of gradients is read at (i + z + 0.5) / 256.
  vec4 z0 = texture(table_permutation2, at.xy) * (255.0 / 256.0) + at.z;
  vec4 z1 = z0 + 1.0 / 256.0;
  return perlin_sum(p - cell, table_gradient(z0.x), table_gradient(z0.y), table_gradient(z0.z), table_gradient(z0.w),
                    table_gradient(z1.x), table_gradient(z1.y), table_gradient(z1.z), table_gradient(z1.w));
}

#elif TABLE_ARITHMETIC == 2  // integer

TABLE(0) usampler2D table_permutation;  // 512 x 1: P[i]
TABLE(1) isampler2D table_gradients2;   // 512 x 1: G[P[i]]
TABLE(2) isampler2D table_gradients3;   // 512 x 1: G[P[i]]

int table_permute(int i) { return int(texelFetch(table_permutation, ivec2(i, 0), 0).x); }
vec2 table_gradient2(int i) { return vec2(texelFetch(table_gradients2, ivec2(i, 0), 0).xy); }
vec3 table_gradient3(int i) { return vec3(texelFetch(table_gradients3, ivec2(i, 0), 0).xyz); }

float table_perlin(vec2 p) {
  vec2 cell = floor(p);
  ivec2 c = ivec2(cell) & 255;
  int i0 = table_permute(c.x) + c.y;
  int i1 = table_permute(c.x + 1) + c.y;
  return perlin_sum(p - cell, table_gradient2(i0), table_gradient2(i1), table_gradient2(i0 + 1),
                    table_gradient2(i1 + 1));
}

float table_perlin(vec3 p) {
  vec3 cell = floor(p);
  ivec3 c = ivec3(cell) & 255;
  int i0 = table_permute(c.x) + c.y;
  int i1 = table_permute(c.x + 1) + c.y;
  int i00 = table_permute(i0) + c.z;
  int i10 = table_permute(i1) + c.z;
  int i01 = table_permute(i0 + 1) + c.z;
  int i11 = table_permute(i1 + 1) + c.z;
  return perlin_sum(p - cell, table_gradient3(i00), table_gradient3(i10), table_gradient3(i01), table_gradient3(i11),
                    table_gradient3(i00 + 1), table_gradient3(i10 + 1), table_gradient3(i01 + 1),
                    table_gradient3(i11 + 1));
}

#else
#error TABLE_ARITHMETIC is neither 1 (float) nor 2 (integer)
#endif

#endif
