// The listings of "Implementing Noise with Hash functions for Graphics Processing Units" as printed (Valdenegro-Toro
// and Pincheira, sec. 5 to 7), for measuring what they do today: int arithmetic, arithmetic shifts, sin of whatever
// integer comes. Nobody should use them: GLSL leaves open what sin makes of a large argument, and drivers differ.
//
// PAPER_HASH, to be defined before the include: one of the numbers below.
// PAPER_FNV1_MASK3: the mask of the highest byte in FNV1. The paper prints -2130706432, which is 0x81000000 and takes 2
// of the byte's 8 bits; -16777216, 0xFF000000, was meant, and stands in its Jenkins hash.

#ifndef HN_PAPER_PUBLISHED_GLSL
#define HN_PAPER_PUBLISHED_GLSL

#include "perlin.glsl"

#define PAPER_FNV1 1
#define PAPER_PARTIAL_FNV1 2
#define PAPER_JENKINS 3
#define PAPER_PARTIAL_JENKINS 4
#define PAPER_MURMUR 5

#ifndef PAPER_FNV1_MASK3
#define PAPER_FNV1_MASK3 -2130706432
#endif

#if PAPER_HASH == PAPER_FNV1
int paper_hash(int key) {  // fig. 1
  int ret = -2128831035;
  int b0 = (key & 255);
  int b1 = (key & 65280) >> 8;
  int b2 = (key & 16711680) >> 16;
  int b3 = (key & PAPER_FNV1_MASK3) >> 24;
  ret *= 16777619;
  ret ^= b0;
  ret *= 16777619;
  ret ^= b1;
  ret *= 16777619;
  ret ^= b2;
  ret *= 16777619;
  ret ^= b3;
  return ret;
}
#elif PAPER_HASH == PAPER_PARTIAL_FNV1
int paper_hash(int key) {  // fig. 4
  int ret = -2128831035;
  ret *= 16777619;
  ret ^= key;
  ret *= 16777619;
  ret ^= key;
  return ret;
}
#elif PAPER_HASH == PAPER_JENKINS
int paper_hash(int key) {  // fig. 2
  int hash = 0;
  int b0 = (key & 255);
  int b1 = (key & 65280) >> 8;
  int b2 = (key & 16711680) >> 16;
  int b3 = (key & -16777216) >> 24;
  hash += b0;
  hash += (hash << 10);
  hash ^= (hash >> 6);
  hash += b1;
  hash += (hash << 10);
  hash ^= (hash >> 6);
  hash += b2;
  hash += (hash << 10);
  hash ^= (hash >> 6);
  hash += b3;
  hash += (hash << 10);
  hash ^= (hash >> 6);
  hash += (hash << 3);
  hash ^= (hash >> 11);
  hash += (hash << 15);
  return hash;
}
#elif PAPER_HASH == PAPER_PARTIAL_JENKINS
int paper_hash(int key) {  // fig. 5
  int hash = 0;
  hash += key;
  hash += (hash << 10);
  hash ^= (hash >> 6);
  hash += (hash << 3);
  hash ^= (hash >> 11);
  hash += (hash << 15);
  return hash;
}
#elif PAPER_HASH == PAPER_MURMUR
int paper_hash(int k) {  // fig. 3
  int h = 10;
  k *= 1540483477;
  k ^= k >> 24;
  k *= 1540483477;
  h *= 1540483477;
  h ^= k;
  return h;
}
#else
#error PAPER_HASH is none of PAPER_FNV1, PAPER_PARTIAL_FNV1, PAPER_JENKINS, PAPER_PARTIAL_JENKINS, PAPER_MURMUR
#endif

vec2 paper_gradient(ivec2 p) {  // sec. 5
  int x = paper_hash(p.x);
  int y = paper_hash(x + p.y);
  return sin(vec2(x + y, y + y));
}

vec3 paper_gradient(ivec3 p) {  // sec. 5
  int x = paper_hash(p.x);
  int y = paper_hash(x + p.y);
  int z = paper_hash(y + p.z);
  return sin(vec3(z + x, z + y, z + z));
}

// The paper prints no more than these. The rest is Perlin's algorithm, with the period of 2^20 cells from sec. 8. Each
// corner is on its own: the paper's instruction counts mean that no hash is shared between corners.
#define PAPER_CORNER(offset) paper_gradient((cell + offset) & 1048575)

float paper_perlin(vec2 p) {
  ivec2 cell = ivec2(floor(p));
  return perlin_sum(p - floor(p), PAPER_CORNER(ivec2(0, 0)), PAPER_CORNER(ivec2(1, 0)), PAPER_CORNER(ivec2(0, 1)),
                    PAPER_CORNER(ivec2(1, 1)));
}

float paper_perlin(vec3 p) {
  ivec3 cell = ivec3(floor(p));
  return perlin_sum(p - floor(p), PAPER_CORNER(ivec3(0, 0, 0)), PAPER_CORNER(ivec3(1, 0, 0)),
                    PAPER_CORNER(ivec3(0, 1, 0)), PAPER_CORNER(ivec3(1, 1, 0)), PAPER_CORNER(ivec3(0, 0, 1)),
                    PAPER_CORNER(ivec3(1, 0, 1)), PAPER_CORNER(ivec3(0, 1, 1)), PAPER_CORNER(ivec3(1, 1, 1)));
}

#endif
