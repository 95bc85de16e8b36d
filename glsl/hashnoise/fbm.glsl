// hashnoise: fbm in 1D and 2D and 3D and 4D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM_GLSL
#define HN_FBM_GLSL

#include "fbm1d.glsl"
#include "fbm2d.glsl"
#include "fbm3d.glsl"
#include "fbm4d.glsl"

#endif
