// hashnoise: all noise in 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE3D_GLSL
#define HN_NOISE3D_GLSL

#include "cell_border3d.glsl"
#include "cellular3d.glsl"
#include "cellular_d3d.glsl"
#include "cellular_phase3d.glsl"
#include "cellular_smooth3d.glsl"
#include "cellular_three3d.glsl"
#include "perlin3d.glsl"
#include "perlin_d3d.glsl"
#include "perlin_phase3d.glsl"
#include "perlin_vector3d.glsl"
#include "phasor3d.glsl"
#include "phasor_d3d.glsl"
#include "random3d.glsl"
#include "simplex3d.glsl"
#include "simplex_d3d.glsl"
#include "simplex_phase3d.glsl"
#include "simplex_smooth3d.glsl"
#include "value3d.glsl"
#include "value_cubic3d.glsl"
#include "value_d3d.glsl"
#include "value_vector3d.glsl"

#endif
