// Refuses calls with numbers that C++ would convert and GLSL does not. SPDX-License-Identifier: MIT
#ifndef HN_I_TYPES_OF_GLSL_HPP
#define HN_I_TYPES_OF_GLSL_HPP

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

#endif
