// hashnoise: warp in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_WARP_GLSL
#define HN_WARP_GLSL

#include "warp2d.glsl"
#include "warp3d.glsl"

#endif
