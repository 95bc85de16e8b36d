// hashnoise: simplex_phase in 2D and 3D. Made by tools/umbrella.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_PHASE_GLSL
#define HN_SIMPLEX_PHASE_GLSL

#include "simplex_phase2d.glsl"
#include "simplex_phase3d.glsl"

#endif
