// hashnoise: the whole library. Made by tools/umbrella.
// SPDX-License-Identifier: MIT

#ifndef HN_HASHNOISE_GLSL
#define HN_HASHNOISE_GLSL

#include "noise2d.glsl"
#include "noise3d.glsl"
#include "fbm.glsl"

#endif
