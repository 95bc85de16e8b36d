// hashnoise for C++20: the functions of the GLSL library, from the same text. Header only, no dependencies.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/hashnoise.hpp>
//   float height = hashnoise::hn_perlin(hashnoise::vec2(3.25f, 7.5f));
//
// It includes the GLSL from its place in the source tree, ../../glsl/hashnoise. Installed, that lies beside this file.
//
// Every function is forced inline, so that compilers can vectorize a loop over a noise. Clang does so with -O3
// -fno-math-errno, and GCC with -fno-trapping-math besides. Give either the -march of the machine. grid.hpp and
// field.hpp have such loops over grids and lists of points, for sums, too.
//
// Kernels of CUDA and HIP may call the functions, too.
//
// HN_FIXED has the same bits under any compiler's flags. The floats of HN_PRECISE need -ffp-contract=off (nvcc
// -fmad=false), and no fast-math, and on 32-bit x86 -msse2 -mfpmath=sse.
//
// Knobs (config.glsl) are macros, to be defined before the include. HN_HASH, HN_GRADIENT and HN_ARITHMETIC name inline
// namespaces, so that translation units that differ in them may be linked together. HN_HASH_FN does not: its meaning
// must be the same in all translation units in which these three are the same. An inline function of yours that calls
// noise must have the same knobs in all of them, as it has one copy in a program.
//
// C++ converts numbers that GLSL does not: 2.5f would be 2 octaves, and the 16 of hn_perlin(x, 16) a seed. Such calls
// are errors of the compiler ("write 16u for a seed"). An argument has the type that the function names: 7u is a
// seed and 6 a number of octaves; a double such as 0.5 is a float, as it is in GLSL. HN_ONLY_TYPES_OF_GLSL(name) behind
// a function of your own does the same for it.

// clang-format off
#include "glsl.hpp"  // the first, since it refuses compilers before C++20
#include "../../glsl/hashnoise/detail/knobs.h"  // each time
// clang-format on

#ifndef HN_I_HASHNOISE_HPP
#define HN_I_HASHNOISE_HPP

// clang-format off
#include "../../glsl/hashnoise/detail/macros_begin.h"
#include "../../glsl/hashnoise/detail/undef_guards.h"
#include "detail/types_of_glsl.hpp"
// clang-format on

#define HN_I_PASTE_TOKENS(a, b) a##b
#define HN_I_PASTE(a, b) HN_I_PASTE_TOKENS(a, b)

// clang-format off
namespace hashnoise::inline HN_I_NAMESPACE {
inline namespace HN_I_PASTE(hash_, HN_HASH) {
inline namespace HN_I_PASTE(gradient_, HN_GRADIENT) {
inline namespace HN_I_PASTE(arithmetic_, HN_ARITHMETIC) {
#include "../../glsl/hashnoise/hashnoise.glsl"

#include "detail/functions_of_glsl.h"
}
}
}
}  // namespace hashnoise
#include "../../glsl/hashnoise/detail/macros_end.h"
// clang-format on

#undef HN_I_PASTE
#undef HN_I_PASTE_TOKENS

#endif
