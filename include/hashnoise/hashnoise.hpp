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
// HN_FIXED has the same bits under any compiler's flags. The floats of HN_PRECISE need -ffp-contract=off, and no
// fast-math, and on 32-bit x86 -msse2 -mfpmath=sse.
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
// clang-format on

#include <cstddef>
#include <type_traits>

namespace hashnoise::inline HN_I_NAMESPACE::detail {

// C++ would convert one of these types to another. Vectors of lanes and types of others are not among them: what they
// convert to is their own affair.
template <typename T>
constexpr bool kIsOfGlsl = std::is_arithmetic_v<T> || requires(T place) {
  place.tiled;
};
template <typename T>
constexpr bool kIsOfGlsl<Vector2<T>> = std::is_arithmetic_v<T>;
template <typename T>
constexpr bool kIsOfGlsl<Vector3<T>> = std::is_arithmetic_v<T>;
template <typename T>
constexpr bool kIsOfGlsl<Vector4<T>> = std::is_arithmetic_v<T>;

template <typename... T>
constexpr bool kAreOfGlsl = (kIsOfGlsl<T> && ...);

// The result type of a deleted function: compilers print its name.
template <std::size_t Count>
struct Hint {
  char text[Count];
  constexpr Hint(const char (&hint)[Count]) : text() {
    for (std::size_t i = 0; i < Count; ++i) text[i] = hint[i];
  }
};
template <Hint>
struct Refused {};  // MSVC may want it whole, as Clang does with -fdelayed-template-parsing

// GLSL's 0.5 is a float.
template <typename T>
constexpr bool kIsDouble = std::is_floating_point_v<T> && !std::is_same_v<T, float>;
template <typename... T>
constexpr bool kHaveDouble = (kIsDouble<T> || ...);
template <typename T>
HN_I_INLINE constexpr auto as_in_glsl(T argument) {
  if constexpr (kIsDouble<T>) {
    return static_cast<float>(argument);
  } else {
    return argument;
  }
}

}  // namespace hashnoise::detail

// Deletes the calls of a function, whose overloads are all declared above, with arguments of types that it does not
// have. A template with the very types of a call is chosen before a function that would convert one, and after one that
// converts none. Doubles are converted: the second template is for calls that are wrong even so. (Clang lets what is
// unavailable call what is, so the question stands outside of it.)
//
// The hint is in the first line of the error: GCC writes there the type that a deleted function returns, and Clang only
// what an attribute of it has.
#define HN_I_HINT \
  "write 16u for a seed, 6 for octaves, 2.0f for other numbers, an ivec2 for cells; or an argument is missing"
#ifdef __clang__
#define HN_I_REFUSED(signature) [[clang::unavailable(HN_I_HINT)]] float signature
#else
#define HN_I_REFUSED(signature) ::hashnoise::detail::Refused<HN_I_HINT> signature = delete
#endif
// clang-format off
#define HN_ONLY_TYPES_OF_GLSL(name)                                                                              \
  template <typename... TypesInCall>                                                                             \
  requires(::hashnoise::detail::kAreOfGlsl<TypesInCall...> && !::hashnoise::detail::kHaveDouble<TypesInCall...>) \
  HN_I_REFUSED(name(TypesInCall...));                                                                            \
  template <typename... TypesInCall>                                                                             \
  constexpr bool hn_i_takes_##name = requires(TypesInCall... call) {                                             \
    name(::hashnoise::detail::as_in_glsl(call)...);                                                              \
  };                                                                                                             \
  template <typename... TypesInCall>                                                                             \
  requires(::hashnoise::detail::kAreOfGlsl<TypesInCall...> && ::hashnoise::detail::kHaveDouble<TypesInCall...> && \
           !hn_i_takes_##name<TypesInCall...>)                                                                   \
  HN_I_REFUSED(name(TypesInCall...));
// clang-format on

#define HN_I_PASTE_TOKENS(a, b) a##b
#define HN_I_PASTE(a, b) HN_I_PASTE_TOKENS(a, b)

// clang-format off
namespace hashnoise::inline HN_I_NAMESPACE {
inline namespace HN_I_PASTE(hash_, HN_HASH) {
inline namespace HN_I_PASTE(gradient_, HN_GRADIENT) {
inline namespace HN_I_PASTE(arithmetic_, HN_ARITHMETIC) {
#include "../../glsl/hashnoise/hashnoise.glsl"

HN_ONLY_TYPES_OF_GLSL(hn_hash_fnv1)
HN_ONLY_TYPES_OF_GLSL(hn_hash_partial_fnv1)
HN_ONLY_TYPES_OF_GLSL(hn_hash_jenkins)
HN_ONLY_TYPES_OF_GLSL(hn_hash_partial_jenkins)
HN_ONLY_TYPES_OF_GLSL(hn_hash_murmur)
HN_ONLY_TYPES_OF_GLSL(hn_hash_pcg)
HN_ONLY_TYPES_OF_GLSL(hn_hash_xxhash32)
HN_ONLY_TYPES_OF_GLSL(hn_hash_lowbias32)
HN_ONLY_TYPES_OF_GLSL(hn_hash_pcg2d)
HN_ONLY_TYPES_OF_GLSL(hn_hash_pcg3d)
HN_ONLY_TYPES_OF_GLSL(hn_hash_pcg4d)
HN_ONLY_TYPES_OF_GLSL(hn_hash)
HN_ONLY_TYPES_OF_GLSL(hn_lattice)
HN_ONLY_TYPES_OF_GLSL(hn_unorm)
HN_ONLY_TYPES_OF_GLSL(hn_snorm)
HN_ONLY_TYPES_OF_GLSL(hn_rehash)
HN_ONLY_TYPES_OF_GLSL(hn_unorm_two)
HN_ONLY_TYPES_OF_GLSL(hn_unorm_three)
HN_ONLY_TYPES_OF_GLSL(hn_unorm_four)
HN_ONLY_TYPES_OF_GLSL(hn_gaussian)
HN_ONLY_TYPES_OF_GLSL(hn_circle)
HN_ONLY_TYPES_OF_GLSL(hn_disk)
HN_ONLY_TYPES_OF_GLSL(hn_sphere)
HN_ONLY_TYPES_OF_GLSL(hn_ball)
HN_ONLY_TYPES_OF_GLSL(hn_shuffle)
HN_ONLY_TYPES_OF_GLSL(hn_sobol)
HN_ONLY_TYPES_OF_GLSL(hn_scatter_point)
HN_ONLY_TYPES_OF_GLSL(hn_scattered)
HN_ONLY_TYPES_OF_GLSL(hn_hex_tiling)
HN_ONLY_TYPES_OF_GLSL(hn_phasor_d)
HN_ONLY_TYPES_OF_GLSL(hn_value_vector_d)
HN_ONLY_TYPES_OF_GLSL(hn_perlin_vector_d)
HN_ONLY_TYPES_OF_GLSL(hn_gullies)
HN_ONLY_TYPES_OF_GLSL(hn_self_check)
HN_ONLY_TYPES_OF_GLSL(hn_gradient)
HN_ONLY_TYPES_OF_GLSL(hn_gradient1)
HN_ONLY_TYPES_OF_GLSL(hn_gradient2)
HN_ONLY_TYPES_OF_GLSL(hn_gradient3)
HN_ONLY_TYPES_OF_GLSL(hn_gradient4)
HN_ONLY_TYPES_OF_GLSL(hn_place)
HN_ONLY_TYPES_OF_GLSL(hn_tile)
HN_ONLY_TYPES_OF_GLSL(hn_position)
HN_ONLY_TYPES_OF_GLSL(hn_cell)
HN_ONLY_TYPES_OF_GLSL(hn_fraction)
HN_ONLY_TYPES_OF_GLSL(hn_octaves)
HN_ONLY_TYPES_OF_GLSL(hn_next)
HN_ONLY_TYPES_OF_GLSL(hn_add_detail)
HN_ONLY_TYPES_OF_GLSL(hn_add_footprint)
HN_ONLY_TYPES_OF_GLSL(hn_add_progressive)
HN_ONLY_TYPES_OF_GLSL(hn_slopes)
HN_ONLY_TYPES_OF_GLSL(hn_shifts)
HN_ONLY_TYPES_OF_GLSL(hn_mean)
HN_ONLY_TYPES_OF_GLSL(hn_distribution)
HN_ONLY_TYPES_OF_GLSL(hn_distribution_fbm)
HN_ONLY_TYPES_OF_GLSL(hn_uniform)
HN_ONLY_TYPES_OF_GLSL(hn_uniform_d)
HN_ONLY_TYPES_OF_GLSL(hn_density)
// tools/make catalog: noises and sums
HN_ONLY_TYPES_OF_GLSL(hn_add)
HN_ONLY_TYPES_OF_GLSL(hn_add_turbulence)
HN_ONLY_TYPES_OF_GLSL(hn_add_ridged)
HN_ONLY_TYPES_OF_GLSL(hn_add_hybrid)
HN_ONLY_TYPES_OF_GLSL(hn_add_ping_pong)
HN_ONLY_TYPES_OF_GLSL(hn_add_weighted)
HN_ONLY_TYPES_OF_GLSL(hn_add_eroded)
HN_ONLY_TYPES_OF_GLSL(hn_perlin)
HN_ONLY_TYPES_OF_GLSL(hn_value)
HN_ONLY_TYPES_OF_GLSL(hn_value_d)
HN_ONLY_TYPES_OF_GLSL(hn_value_cubic)
HN_ONLY_TYPES_OF_GLSL(hn_simplex)
HN_ONLY_TYPES_OF_GLSL(hn_simplex_d)
HN_ONLY_TYPES_OF_GLSL(hn_simplex_smooth)
HN_ONLY_TYPES_OF_GLSL(hn_cellular)
HN_ONLY_TYPES_OF_GLSL(hn_cellular_phase)
HN_ONLY_TYPES_OF_GLSL(hn_cellular_three)
HN_ONLY_TYPES_OF_GLSL(hn_cellular_d)
HN_ONLY_TYPES_OF_GLSL(hn_cellular_smooth)
HN_ONLY_TYPES_OF_GLSL(hn_cell_border)
HN_ONLY_TYPES_OF_GLSL(hn_curl)
HN_ONLY_TYPES_OF_GLSL(hn_value_vector)
HN_ONLY_TYPES_OF_GLSL(hn_perlin_vector)
HN_ONLY_TYPES_OF_GLSL(hn_phasor)
HN_ONLY_TYPES_OF_GLSL(hn_random)
HN_ONLY_TYPES_OF_GLSL(hn_fbm)
HN_ONLY_TYPES_OF_GLSL(hn_turbulence)
HN_ONLY_TYPES_OF_GLSL(hn_clouds)
HN_ONLY_TYPES_OF_GLSL(hn_billow)
HN_ONLY_TYPES_OF_GLSL(hn_ridged)
HN_ONLY_TYPES_OF_GLSL(hn_hybrid)
HN_ONLY_TYPES_OF_GLSL(hn_ping_pong)
HN_ONLY_TYPES_OF_GLSL(hn_weighted)
HN_ONLY_TYPES_OF_GLSL(hn_warp)
HN_ONLY_TYPES_OF_GLSL(hn_warp_progressive)
HN_ONLY_TYPES_OF_GLSL(hn_perlin_worley)
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
HN_ONLY_TYPES_OF_GLSL(hn_perlin_d)
HN_ONLY_TYPES_OF_GLSL(hn_fbm_d)
HN_ONLY_TYPES_OF_GLSL(hn_eroded)
#endif
// tools/make catalog: end
}
}
}
}  // namespace hashnoise
#include "../../glsl/hashnoise/detail/macros_end.h"
// clang-format on

#undef HN_I_PASTE
#undef HN_I_PASTE_TOKENS

#endif
