// hashnoise: fbm in 2D and 3D. Made by tools/umbrella.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM_GLSL
#define HN_FBM_GLSL

#include "fbm2d.glsl"
#include "fbm3d.glsl"

#endif
