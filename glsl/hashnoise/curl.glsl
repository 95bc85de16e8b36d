// hashnoise: curl in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL_GLSL
#define HN_CURL_GLSL

#include "curl2d.glsl"
#include "curl3d.glsl"

#endif
