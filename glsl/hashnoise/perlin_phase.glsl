// hashnoise: perlin_phase in 2D and 3D. Made by tools/umbrella.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_PHASE_GLSL
#define HN_PERLIN_PHASE_GLSL

#include "perlin_phase2d.glsl"
#include "perlin_phase3d.glsl"

#endif
