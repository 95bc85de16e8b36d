// hashnoise for C++20: the functions of the GLSL library, from the same text. Header only, no dependencies.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/hashnoise.hpp>
//   float height = hashnoise::hn_perlin(hashnoise::vec2(3.25f, 7.5f));
//
// It includes glsl/ by its place in the source tree, ../../glsl; the installed copy of this file says glsl/ instead.
//
// Knobs (config.glsl) are macros, to be defined before the include. HN_HASH names an inline namespace, so that
// translation units with different hashes may be linked together. What other macros bring in (HN_HASH_FN,
// HN_FBM_NOISE2D, HN_FBM_NOISE3D) does not: it must be the same in all translation units that have the same HN_HASH.

#pragma once

#include "../../glsl/config.glsl"
#include "glsl.hpp"

#define HN_I_PASTE_TOKENS(a, b) a##b
#define HN_I_PASTE(a, b) HN_I_PASTE_TOKENS(a, b)
#define HN_I_NAMESPACE HN_I_PASTE(hash_, HN_HASH)

namespace hashnoise {
inline namespace HN_I_NAMESPACE {
#include "../../glsl/hashnoise.glsl"
}  // namespace HN_I_NAMESPACE
}  // namespace hashnoise

#undef HN_I_NAMESPACE
#undef HN_I_PASTE
#undef HN_I_PASTE_TOKENS
