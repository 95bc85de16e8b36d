// hashnoise: octaves in 1D and 2D and 3D and 4D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_OCTAVES_GLSL
#define HN_OCTAVES_GLSL

#include "octaves1d.glsl"
#include "octaves2d.glsl"
#include "octaves3d.glsl"
#include "octaves4d.glsl"

#endif
