// hashnoise for C++20: the functions of the GLSL library, from the same text. Header only, no dependencies.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/hashnoise.hpp>
//   float height = hashnoise::hn_perlin(hashnoise::vec2(3.25f, 7.5f));
//
// It includes glsl/ from its place in the source tree, ../../glsl. The installed copy of this file says glsl/ instead.
//
// Every function is forced inline, so that compilers can vectorize a loop over a noise. Clang does so with -O3
// -fno-math-errno, and GCC with -fno-trapping-math besides. Give either the -march of the machine. grid.hpp and
// field.hpp have such loops over grids and lists of points, for sums, too.
//
// HN_FIXED has the same bits under any compiler's flags. The floats of HN_PRECISE need -ffp-contract=off, and no
// fast-math.
//
// Knobs (config.glsl) are macros, to be defined before the include. HN_HASH, HN_GRADIENT and HN_ARITHMETIC name inline
// namespaces, so that translation units that differ in them may be linked together. HN_HASH_FN does not: its meaning
// must be the same in all translation units in which these three are the same.
//
// The macros of octave sums (HN_FBM2D(name, noise) and so on) stay defined. They belong inside of namespace hashnoise.

#pragma once

// clang-format off
#include "glsl.hpp"  // the first, since it refuses compilers before C++20
#include "../../glsl/config.glsl"
#include "../../glsl/again.h"
// clang-format on

#define HN_I_PASTE_TOKENS(a, b) a##b
#define HN_I_PASTE(a, b) HN_I_PASTE_TOKENS(a, b)

// clang-format off
namespace hashnoise {
inline namespace HN_I_PASTE(hash_, HN_HASH) {
inline namespace HN_I_PASTE(gradient_, HN_GRADIENT) {
inline namespace HN_I_PASTE(arithmetic_, HN_ARITHMETIC) {
#include "../../glsl/hashnoise.glsl"
}
}
}
}  // namespace hashnoise
// clang-format on

#undef HN_I_PASTE
#undef HN_I_PASTE_TOKENS
