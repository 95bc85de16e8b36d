// hashnoise: perlin_worley in 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_WORLEY_GLSL
#define HN_PERLIN_WORLEY_GLSL

#include "perlin_worley3d.glsl"

#endif
