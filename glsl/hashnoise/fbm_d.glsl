// hashnoise: fbm_d in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM_D_GLSL
#define HN_FBM_D_GLSL

#include "fbm_d2d.glsl"
#include "fbm_d3d.glsl"

#endif
