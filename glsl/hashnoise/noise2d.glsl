// hashnoise: all noise in 2D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE2D_GLSL
#define HN_NOISE2D_GLSL

#include "cell_border2d.glsl"
#include "cellular2d.glsl"
#include "cellular_d2d.glsl"
#include "cellular_phase2d.glsl"
#include "cellular_smooth2d.glsl"
#include "cellular_three2d.glsl"
#include "hex_tiling2d.glsl"
#include "perlin2d.glsl"
#include "perlin_d2d.glsl"
#include "perlin_phase2d.glsl"
#include "perlin_vector2d.glsl"
#include "phasor2d.glsl"
#include "phasor_d2d.glsl"
#include "random2d.glsl"
#include "simplex2d.glsl"
#include "simplex_d2d.glsl"
#include "simplex_phase2d.glsl"
#include "simplex_smooth2d.glsl"
#include "value2d.glsl"
#include "value_cubic2d.glsl"
#include "value_d2d.glsl"
#include "value_vector2d.glsl"

#endif
