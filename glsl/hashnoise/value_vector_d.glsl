// hashnoise: value_vector_d in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_VECTOR_D_GLSL
#define HN_VALUE_VECTOR_D_GLSL

#include "value_vector_d2d.glsl"
#include "value_vector_d3d.glsl"

#endif
