// The types and built-in functions of GLSL in C++20: those that the GLSL text of hashnoise uses, and GLSL's
// constructors of vectors.
// SPDX-License-Identifier: MIT
//
// Words wrap at 2^32. If a float in a vector does not fit an int, it becomes the nearest int. NaN becomes 0. (GLSL
// leaves these values undefined.) So nothing has undefined behaviour, as long as all floats that you pass are finite,
// and fractions, which are to be in [0, 1], are below 2^64 in size.

#pragma once

// MSVC has its own macro for the version.
#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error hashnoise needs C++20: compile with -std=c++20, or with /std:c++20
#endif

// The first include of each header: the standard headers, too, are read without the macros of others.
// clang-format off
#include "../../glsl/hashnoise/detail/macros_begin.h"
// clang-format on
#include <cmath>
#include <concepts>
#include <cstdint>

// Before each function: vectors of lanes (lanes.hpp) are fast only if none is called, and a linker may take the copy of
// a called one from another translation unit, which was compiled for another processor. In CUDA and HIP a kernel may
// call it, too. Behind the parameters of a lambda stands HN_I_INLINED, for which MSVC has no word.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define HN_I_DEVICE __host__ __device__
#else
#define HN_I_DEVICE
#endif
#ifdef _MSC_VER
#define HN_I_INLINE HN_I_DEVICE __forceinline
#else
#define HN_I_INLINE [[gnu::always_inline]] HN_I_DEVICE inline
#endif
#if defined(__GNUC__) || defined(__clang__)
#define HN_I_INLINED __attribute__((always_inline))
#else
#define HN_I_INLINED
#endif

// Namespaces that users need not name, and that linkers see. A program may have two versions, of a plugin and its host:
// the first namespace has the major and the minor version, so that none of them gets the functions of the other. The
// second has the major version, and holds what hashnoise::grid offers: its later minor versions serve a program, too.
#define HN_I_NAMESPACE v1_1
#define HN_I_LIBRARY v1

namespace hashnoise::inline HN_I_NAMESPACE {

using uint = std::uint32_t;

template <typename T>
struct Vector2;
template <typename T>
struct Vector3;
template <typename T>
struct Vector4;

namespace detail {

template <typename>
concept Never = false;  // of a pack, which is empty then

template <typename T>
concept Number = std::same_as<T, float> || std::same_as<T, int> || std::same_as<T, uint>;

template <typename To, typename From>
HN_I_INLINE constexpr To convert(From value) {
  return static_cast<To>(value);
}

// There is no branch and no comparison of floats, so that compilers can vectorize it. Compilers have the built-in for
// longer than all libraries have std::bit_cast.
template <>
HN_I_INLINE constexpr int convert<int, float>(float value) {
  const uint bits = __builtin_bit_cast(uint, value);
  const uint magnitude = bits & 0x7FFFFFFFu;
  const bool fits = magnitude < 0x4F000000u;  // 2^31
  const int whole = static_cast<int>(__builtin_bit_cast(float, fits ? bits : 0u));
  const uint nearest = magnitude > 0x7F800000u ? 0u : 0x7FFFFFFFu + (bits >> 31u);
  return fits ? whole : static_cast<int>(nearest);
}

template <>
HN_I_INLINE constexpr uint convert<uint, float>(float value) {
  if (value >= 4294967296.0f) return 0xFFFFFFFFu;
  return value > 0.0f ? static_cast<uint>(value) : 0u;
}

// How many components an argument of a constructor has.
template <typename Argument>
constexpr int kComponents = 1;
template <typename T>
constexpr int kComponents<Vector2<T>> = 2;
template <typename T>
constexpr int kComponents<Vector3<T>> = 3;
template <typename T>
constexpr int kComponents<Vector4<T>> = 4;

// Whether the arguments fill a vector of `Count` components. The last argument may have more components than are
// needed, but every argument must be used.
template <int Count, typename... Arguments>
HN_I_INLINE constexpr bool fill() {
  int found = 0;
  bool all_used = true;
  ((all_used = all_used && found < Count, found += kComponents<Arguments>), ...);
  return all_used && found >= Count;
}

template <int Index, typename First, typename... Rest>
HN_I_INLINE constexpr auto component([[maybe_unused]] const First& first, [[maybe_unused]] const Rest&... rest) {
  constexpr int count = kComponents<First>;
  if constexpr (Index >= count) {
    return component<Index - count>(rest...);
  } else if constexpr (count == 1) {
    return first;
  } else if constexpr (Index == 0) {
    return first.x;
  } else if constexpr (Index == 1) {
    return first.y;
  } else if constexpr (Index == 2) {
    return first.z;
  } else {
    return first.w;
  }
}

}  // namespace detail

// As in GLSL, a constructor takes scalars and vectors of any type in any order, as long as they have enough components.
template <typename T>
struct Vector2 {
  T x, y;
  HN_I_INLINE constexpr Vector2() : x(), y() {}
  HN_I_INLINE constexpr Vector2(T x_, T y_) : x(x_), y(y_) {}
  template <typename Scalar>
  requires(detail::kComponents<Scalar> == 1) HN_I_INLINE constexpr explicit Vector2(Scalar s)
      : Vector2(detail::convert<T>(s), detail::convert<T>(s)) {}
  template <typename U>
  HN_I_INLINE constexpr explicit Vector2(Vector2<U> v) : x(detail::convert<T>(v.x)), y(detail::convert<T>(v.y)) {}
  template <typename... Arguments>
  requires(detail::fill<2, Arguments...>()) HN_I_INLINE constexpr explicit(sizeof...(Arguments) != 2)
      Vector2(const Arguments&... arguments)
      : x(detail::convert<T>(detail::component<0>(arguments...))),
        y(detail::convert<T>(detail::component<1>(arguments...))) {}
  friend bool operator==(Vector2, Vector2) = default;  // constexpr where that of T is
  HN_I_INLINE friend constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
  HN_I_INLINE friend constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
  HN_I_INLINE friend constexpr Vector2 operator*(Vector2 a, Vector2 b) { return {a.x * b.x, a.y * b.y}; }
  HN_I_INLINE friend constexpr Vector2 operator+(Vector2 a, T b) { return a + Vector2(b); }
  HN_I_INLINE friend constexpr Vector2 operator-(Vector2 a, T b) { return a - Vector2(b); }
  HN_I_INLINE friend constexpr Vector2 operator*(Vector2 a, T b) { return a * Vector2(b); }
  HN_I_INLINE friend constexpr Vector2 operator*(T a, Vector2 b) { return Vector2(a) * b; }
  HN_I_INLINE friend constexpr Vector2 operator/(Vector2 a, Vector2 b) { return {a.x / b.x, a.y / b.y}; }
  HN_I_INLINE friend constexpr Vector2 operator/(Vector2 a, T b) { return a / Vector2(b); }
  HN_I_INLINE friend constexpr Vector2 operator+(T a, Vector2 b) { return Vector2(a) + b; }
  HN_I_INLINE friend constexpr Vector2 operator-(T a, Vector2 b) { return Vector2(a) - b; }
  HN_I_INLINE friend constexpr Vector2 operator/(T a, Vector2 b) { return Vector2(a) / b; }
  HN_I_INLINE friend constexpr Vector2 operator-(Vector2 a) { return {-a.x, -a.y}; }
};

template <typename T>
struct Vector3 {
  T x, y, z;
  HN_I_INLINE constexpr Vector3() : x(), y(), z() {}
  HN_I_INLINE constexpr Vector3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  template <typename Scalar>
  requires(detail::kComponents<Scalar> == 1) HN_I_INLINE constexpr explicit Vector3(Scalar s)
      : Vector3(detail::convert<T>(s), detail::convert<T>(s), detail::convert<T>(s)) {}
  template <typename U>
  HN_I_INLINE constexpr explicit Vector3(Vector3<U> v)
      : x(detail::convert<T>(v.x)), y(detail::convert<T>(v.y)), z(detail::convert<T>(v.z)) {}
  template <typename... Arguments>
  requires(detail::fill<3, Arguments...>()) HN_I_INLINE constexpr explicit(sizeof...(Arguments) != 3)
      Vector3(const Arguments&... arguments)
      : x(detail::convert<T>(detail::component<0>(arguments...))),
        y(detail::convert<T>(detail::component<1>(arguments...))),
        z(detail::convert<T>(detail::component<2>(arguments...))) {}
  friend bool operator==(Vector3, Vector3) = default;  // constexpr where that of T is
  HN_I_INLINE friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  HN_I_INLINE friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  HN_I_INLINE friend constexpr Vector3 operator*(Vector3 a, Vector3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  HN_I_INLINE friend constexpr Vector3 operator+(Vector3 a, T b) { return a + Vector3(b); }
  HN_I_INLINE friend constexpr Vector3 operator-(Vector3 a, T b) { return a - Vector3(b); }
  HN_I_INLINE friend constexpr Vector3 operator*(Vector3 a, T b) { return a * Vector3(b); }
  HN_I_INLINE friend constexpr Vector3 operator*(T a, Vector3 b) { return Vector3(a) * b; }
  HN_I_INLINE friend constexpr Vector3 operator/(Vector3 a, Vector3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
  HN_I_INLINE friend constexpr Vector3 operator/(Vector3 a, T b) { return a / Vector3(b); }
  HN_I_INLINE friend constexpr Vector3 operator+(T a, Vector3 b) { return Vector3(a) + b; }
  HN_I_INLINE friend constexpr Vector3 operator-(T a, Vector3 b) { return Vector3(a) - b; }
  HN_I_INLINE friend constexpr Vector3 operator/(T a, Vector3 b) { return Vector3(a) / b; }
  HN_I_INLINE friend constexpr Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
  // For integers.
  HN_I_INLINE friend constexpr Vector3 operator&(Vector3 a, Vector3 b) { return {a.x & b.x, a.y & b.y, a.z & b.z}; }
  HN_I_INLINE friend constexpr Vector3 operator&(Vector3 a, T b) { return {a.x & b, a.y & b, a.z & b}; }
  HN_I_INLINE friend constexpr Vector3 operator|(Vector3 a, T b) { return {a.x | b, a.y | b, a.z | b}; }
  HN_I_INLINE friend constexpr Vector3 operator|(Vector3 a, Vector3 b) { return {a.x | b.x, a.y | b.y, a.z | b.z}; }
  HN_I_INLINE friend constexpr Vector3 operator^(Vector3 a, T b) { return {a.x ^ b, a.y ^ b, a.z ^ b}; }
  HN_I_INLINE friend constexpr Vector3 operator^(Vector3 a, Vector3 b) { return {a.x ^ b.x, a.y ^ b.y, a.z ^ b.z}; }
  template <typename Count>
  HN_I_INLINE friend constexpr Vector3 operator<<(Vector3 a, Count b) {
    return {a.x << T(b), a.y << T(b), a.z << T(b)};
  }
  template <typename Count>
  HN_I_INLINE friend constexpr Vector3 operator>>(Vector3 a, Count b) {
    return {a.x >> T(b), a.y >> T(b), a.z >> T(b)};
  }
};

template <typename T>
struct Vector4 {
  T x, y, z, w;
  HN_I_INLINE constexpr Vector4() : x(), y(), z(), w() {}
  HN_I_INLINE constexpr Vector4(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
  template <typename Scalar>
  requires(detail::kComponents<Scalar> == 1) HN_I_INLINE constexpr explicit Vector4(Scalar s)
      : Vector4(detail::convert<T>(s), detail::convert<T>(s), detail::convert<T>(s), detail::convert<T>(s)) {}
  template <typename U>
  HN_I_INLINE constexpr explicit Vector4(Vector4<U> v)
      : x(detail::convert<T>(v.x)),
        y(detail::convert<T>(v.y)),
        z(detail::convert<T>(v.z)),
        w(detail::convert<T>(v.w)) {}
  template <typename... Arguments>
  requires(detail::fill<4, Arguments...>()) HN_I_INLINE constexpr explicit(sizeof...(Arguments) != 4)
      Vector4(const Arguments&... arguments)
      : x(detail::convert<T>(detail::component<0>(arguments...))),
        y(detail::convert<T>(detail::component<1>(arguments...))),
        z(detail::convert<T>(detail::component<2>(arguments...))),
        w(detail::convert<T>(detail::component<3>(arguments...))) {}
  friend bool operator==(Vector4, Vector4) = default;  // constexpr where that of T is
  HN_I_INLINE friend constexpr Vector4 operator+(Vector4 a, Vector4 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
  }
  HN_I_INLINE friend constexpr Vector4 operator-(Vector4 a, Vector4 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
  }
  HN_I_INLINE friend constexpr Vector4 operator*(Vector4 a, Vector4 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w};
  }
  HN_I_INLINE friend constexpr Vector4 operator+(Vector4 a, T b) { return a + Vector4(b); }
  HN_I_INLINE friend constexpr Vector4 operator-(Vector4 a, T b) { return a - Vector4(b); }
  HN_I_INLINE friend constexpr Vector4 operator*(Vector4 a, T b) { return a * Vector4(b); }
  HN_I_INLINE friend constexpr Vector4 operator*(T a, Vector4 b) { return Vector4(a) * b; }
  HN_I_INLINE friend constexpr Vector4 operator/(Vector4 a, Vector4 b) {
    return {a.x / b.x, a.y / b.y, a.z / b.z, a.w / b.w};
  }
  HN_I_INLINE friend constexpr Vector4 operator/(Vector4 a, T b) { return a / Vector4(b); }
  HN_I_INLINE friend constexpr Vector4 operator+(T a, Vector4 b) { return Vector4(a) + b; }
  HN_I_INLINE friend constexpr Vector4 operator-(T a, Vector4 b) { return Vector4(a) - b; }
  HN_I_INLINE friend constexpr Vector4 operator/(T a, Vector4 b) { return Vector4(a) / b; }
  HN_I_INLINE friend constexpr Vector4 operator-(Vector4 a) { return {-a.x, -a.y, -a.z, -a.w}; }
  template <typename Count>
  HN_I_INLINE friend constexpr Vector4 operator>>(Vector4 a, Count b) {
    return {a.x >> T(b), a.y >> T(b), a.z >> T(b), a.w >> T(b)};
  }
};

template <typename V, typename B>
requires(detail::kComponents<V> > 1) HN_I_INLINE constexpr V& operator+=(V& a, const B& b) { return a = a + b; }
template <typename V, typename B>
requires(detail::kComponents<V> > 1) HN_I_INLINE constexpr V& operator-=(V& a, const B& b) { return a = a - b; }
template <typename V, typename B>
requires(detail::kComponents<V> > 1) HN_I_INLINE constexpr V& operator*=(V& a, const B& b) { return a = a * b; }
template <typename V, typename B>
requires(detail::kComponents<V> > 1) HN_I_INLINE constexpr V& operator/=(V& a, const B& b) { return a = a / b; }

using vec2 = Vector2<float>;
using vec3 = Vector3<float>;
using vec4 = Vector4<float>;
using ivec2 = Vector2<int>;
using ivec3 = Vector3<int>;
using ivec4 = Vector4<int>;
using uvec2 = Vector2<uint>;
using uvec3 = Vector3<uint>;
using uvec4 = Vector4<uint>;

// The declarations of the library use these names. In GLSL ES they carry the precision.
using hn_float = float;
using hn_vec2 = vec2;
using hn_vec3 = vec3;
using hn_vec4 = vec4;
using hn_int = int;
using hn_ivec2 = ivec2;
using hn_ivec3 = ivec3;
using hn_ivec4 = ivec4;
using hn_uint = uint;
using hn_uvec2 = uvec2;
using hn_uvec3 = uvec3;
using hn_uvec4 = uvec4;

// In this namespace a call means one of these, never ::abs(int) or another function that happens to be declared. In a
// namespace of users that uses this one, a function of theirs or of the standard library that fits as well comes first:
// a compiler chooses a template behind other functions, and one with a pack behind other templates.
template <std::same_as<float> T, detail::Never... None>
HN_I_INLINE T floor(T x, None...) {
  return std::floor(x);
}
template <std::same_as<float> T, detail::Never... None>
HN_I_INLINE T trunc(T x, None...) {
  return std::trunc(x);
}
template <std::same_as<float> T, detail::Never... None>
HN_I_INLINE T sqrt(T x, None...) {
  return std::sqrt(x);
}
template <std::same_as<float> T, detail::Never... None>
HN_I_INLINE T abs(T x, None...) {
  return std::fabs(x);
}
template <detail::Number T, detail::Never... None>
HN_I_INLINE constexpr T min(T x, T y, None...) {
  return y < x ? y : x;
}
template <detail::Number T, detail::Never... None>
HN_I_INLINE constexpr T max(T x, T y, None...) {
  return x < y ? y : x;
}
HN_I_INLINE vec2 floor(vec2 v) { return {std::floor(v.x), std::floor(v.y)}; }
HN_I_INLINE vec3 floor(vec3 v) { return {std::floor(v.x), std::floor(v.y), std::floor(v.z)}; }
HN_I_INLINE vec4 floor(vec4 v) { return {std::floor(v.x), std::floor(v.y), std::floor(v.z), std::floor(v.w)}; }
template <typename T>
HN_I_INLINE constexpr Vector3<T> min(Vector3<T> a, Vector3<T> b) {
  return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
template <typename T>
HN_I_INLINE constexpr Vector3<T> max(Vector3<T> a, Vector3<T> b) {
  return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
}
template <typename T>
HN_I_INLINE constexpr Vector3<T> abs(Vector3<T> v) {
  return {abs(v.x), abs(v.y), abs(v.z)};
}
template <std::same_as<uint> T, detail::Never... None>
HN_I_INLINE constexpr float uintBitsToFloat(T bits, None...) {
  return __builtin_bit_cast(float, bits);
}
template <std::same_as<float> T, detail::Never... None>
HN_I_INLINE constexpr uint floatBitsToUint(T value, None...) {
  return __builtin_bit_cast(uint, value);
}
template <typename T>
HN_I_INLINE constexpr auto uintBitsToFloat(Vector3<T> v) {
  return Vector3<decltype(uintBitsToFloat(v.x))>(uintBitsToFloat(v.x), uintBitsToFloat(v.y), uintBitsToFloat(v.z));
}
template <typename T>
HN_I_INLINE constexpr auto floatBitsToUint(Vector3<T> v) {
  return Vector3<decltype(floatBitsToUint(v.x))>(floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z));
}

}  // namespace hashnoise

#include "../../glsl/hashnoise/detail/macros_end.h"
