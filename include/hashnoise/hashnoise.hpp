// hashnoise for C++20: the functions of the GLSL library, from the same text. Header only, no dependencies.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/hashnoise.hpp>
//   float height = hashnoise::hn_perlin(hashnoise::vec2(3.25f, 7.5f));
//
// Knobs (glsl/config.glsl) are macros, to be defined before the include. HN_HASH names an inline namespace, so that
// translation units with different hashes may be linked together. Code that a macro brings in (HN_HASH_FN,
// HN_FBM_NOISE2D, HN_FBM_NOISE3D) does not: let it be the same wherever the HN_HASH is.

#pragma once

#include "glsl.hpp"

// In the source tree the GLSL lies beside include/; installed, below this header.
#if __has_include("../../glsl/hashnoise.glsl")
#include "../../glsl/config.glsl"
#else
#include "glsl/config.glsl"
#endif

#define HN_I_PASTE(a, b) a##b
#define HN_I_NAMESPACE(hash) HN_I_PASTE(hash_, hash)

namespace hashnoise {
inline namespace HN_I_NAMESPACE(HN_HASH) {
#if __has_include("../../glsl/hashnoise.glsl")
#include "../../glsl/hashnoise.glsl"
#else
#include "glsl/hashnoise.glsl"
#endif
}  // namespace )
}  // namespace hashnoise

#undef HN_I_NAMESPACE
#undef HN_I_PASTE
