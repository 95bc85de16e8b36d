// hashnoise: all noise in 1D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE1D_GLSL
#define HN_NOISE1D_GLSL

#include "perlin1d.glsl"
#include "perlin_d1d.glsl"
#include "random1d.glsl"
#include "value1d.glsl"
#include "value_cubic1d.glsl"
#include "value_d1d.glsl"

#endif
