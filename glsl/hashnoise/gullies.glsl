// hashnoise: gullies in 2D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_GULLIES_GLSL
#define HN_GULLIES_GLSL

#include "gullies2d.glsl"

#endif
