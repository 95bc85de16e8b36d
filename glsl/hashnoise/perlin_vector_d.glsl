// hashnoise: perlin_vector_d in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_VECTOR_D_GLSL
#define HN_PERLIN_VECTOR_D_GLSL

#include "perlin_vector_d2d.glsl"
#include "perlin_vector_d3d.glsl"

#endif
