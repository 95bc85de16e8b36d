// What the paper compares with: Perlin noise whose permutation and gradients are textures, once with float arithmetic
// and once with integers. The period is 256 cells. The textures are made and bound by bench/tables.cpp.
//
// Perlin/Float follows the arrangement of Green, "Implementing Improved Perlin Noise", GPU Gems 2, 2005, which the paper
// cites: tables made of tables, so that 2D takes 4 fetches and 3D takes 1 + 8. Perlin/Integer takes one step of the
// permutation at a time: 2 + 4 + 4 fetches in 2D, 2 + 4 + 8 + 8 in 3D, once the compiler has joined equal ones. Both are
// the same noise.

#ifndef HN_PAPER_TABLES_GLSL
#define HN_PAPER_TABLES_GLSL

#ifdef VULKAN
#define TABLE(n) layout(set = 0, binding = n) uniform
#else
#define TABLE(n) uniform
#endif

#if TABLE_ARITHMETIC == 1  // float

TABLE(0) sampler2D table_gradient2;     // 256 x 256: the gradient at (x, y)
TABLE(1) sampler2D table_permutation2;  // 256 x 256: P[P[x] + y] for (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)
TABLE(2) sampler2D table_gradient3;     // 256 x 1: the gradient of P[i]

float table_perlin(vec2 p) {
  // Texel centres; the wrap mode of the textures makes the period.
  vec2 cell = floor(p);
  vec2 f = p - cell;
  vec2 at = (cell + 0.5) * (1.0 / 256.0);
  vec2 next = at + 1.0 / 256.0;
  vec2 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float n00 = dot(texture(table_gradient2, at).xy, f);
  float n10 = dot(texture(table_gradient2, vec2(next.x, at.y)).xy, f - vec2(1.0, 0.0));
  float n01 = dot(texture(table_gradient2, vec2(at.x, next.y)).xy, f - vec2(0.0, 1.0));
  float n11 = dot(texture(table_gradient2, next).xy, f - vec2(1.0, 1.0));
  return mix(mix(n00, n10, t.x), mix(n01, n11, t.x), t.y);
}

float table_perlin(vec3 p) {
  vec3 cell = floor(p);
  vec3 f = p - cell;
  vec3 at = (cell + 0.5) * (1.0 / 256.0);
  vec3 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  // A texel holds an 8-bit number i as i / 255; the row of gradients is read at (i + z + 0.5) / 256.
  vec4 z0 = texture(table_permutation2, at.xy) * (255.0 / 256.0) + at.z;
  vec4 z1 = z0 + 1.0 / 256.0;
  float n000 = dot(texture(table_gradient3, vec2(z0.x, 0.5)).xyz, f);
  float n100 = dot(texture(table_gradient3, vec2(z0.y, 0.5)).xyz, f - vec3(1.0, 0.0, 0.0));
  float n010 = dot(texture(table_gradient3, vec2(z0.z, 0.5)).xyz, f - vec3(0.0, 1.0, 0.0));
  float n110 = dot(texture(table_gradient3, vec2(z0.w, 0.5)).xyz, f - vec3(1.0, 1.0, 0.0));
  float n001 = dot(texture(table_gradient3, vec2(z1.x, 0.5)).xyz, f - vec3(0.0, 0.0, 1.0));
  float n101 = dot(texture(table_gradient3, vec2(z1.y, 0.5)).xyz, f - vec3(1.0, 0.0, 1.0));
  float n011 = dot(texture(table_gradient3, vec2(z1.z, 0.5)).xyz, f - vec3(0.0, 1.0, 1.0));
  float n111 = dot(texture(table_gradient3, vec2(z1.w, 0.5)).xyz, f - vec3(1.0, 1.0, 1.0));
  return mix(mix(mix(n000, n100, t.x), mix(n010, n110, t.x), t.y), mix(mix(n001, n101, t.x), mix(n011, n111, t.x), t.y),
             t.z);
}

#elif TABLE_ARITHMETIC == 2  // integer

TABLE(0) usampler2D table_permutation;  // 256 x 1
TABLE(1) isampler2D table_gradients2;   // 8 x 1
TABLE(2) isampler2D table_gradients3;   // 16 x 1

int table_permute(int i) { return int(texelFetch(table_permutation, ivec2(i & 255, 0), 0).x); }

vec2 table_gradient(ivec2 cell) {
  int i = table_permute(table_permute(cell.x) + cell.y);
  return vec2(texelFetch(table_gradients2, ivec2(i & 7, 0), 0).xy);
}

vec3 table_gradient(ivec3 cell) {
  int i = table_permute(table_permute(table_permute(cell.x) + cell.y) + cell.z);
  return vec3(texelFetch(table_gradients3, ivec2(i & 15, 0), 0).xyz);
}

#define PERLIN_NAME table_perlin
#define PERLIN_GRADIENT(cell) table_gradient(cell)
#include "perlin.glsl"

#else
#error TABLE_ARITHMETIC is neither 1 (float) nor 2 (integer)
#endif

#endif
