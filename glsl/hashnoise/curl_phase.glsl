// hashnoise: curl_phase in 2D and 3D. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL_PHASE_GLSL
#define HN_CURL_PHASE_GLSL

#include "curl_phase2d.glsl"
#include "curl_phase3d.glsl"

#endif
