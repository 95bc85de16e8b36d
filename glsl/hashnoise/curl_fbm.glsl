// hashnoise: curl_fbm in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL_FBM_GLSL
#define HN_CURL_FBM_GLSL

#include "curl_fbm2d.glsl"
#include "curl_fbm3d.glsl"

#endif
