// hashnoise: the whole library. Made by tools/make.
// SPDX-License-Identifier: MIT

#ifndef HN_HASHNOISE_GLSL
#define HN_HASHNOISE_GLSL

#include "noise1d.glsl"
#include "noise2d.glsl"
#include "noise3d.glsl"
#include "noise4d.glsl"
#include "curl.glsl"
#include "curl_fbm.glsl"
#include "curl_phase.glsl"
#include "fbm.glsl"
#include "fbm_d.glsl"
#include "gradient.glsl"
#include "gullies.glsl"
#include "octaves.glsl"
#include "perlin_vector_d.glsl"
#include "perlin_worley.glsl"
#include "scatter.glsl"
#include "self_check.glsl"
#include "uniform.glsl"
#include "value_vector_d.glsl"
#include "warp.glsl"

#endif
