// hashnoise: all noise in 4D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE4D_GLSL
#define HN_NOISE4D_GLSL

#include "perlin4d.glsl"
#include "perlin_d4d.glsl"
#include "random4d.glsl"
#include "simplex4d.glsl"
#include "simplex_d4d.glsl"
#include "value4d.glsl"
#include "value_d4d.glsl"

#endif
