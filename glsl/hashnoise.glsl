// hashnoise: the whole library. Made by tools/umbrella.
// SPDX-License-Identifier: MIT

#ifndef HN_HASHNOISE_GLSL
#define HN_HASHNOISE_GLSL

#include "fbm.glsl"
#include "noise2d.glsl"
#include "noise3d.glsl"

#endif
