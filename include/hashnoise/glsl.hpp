// What the types and built-in functions of GLSL that hashnoise uses mean in C++20. Only what the GLSL text needs.
// SPDX-License-Identifier: MIT
//
// Words wrap at 2^32. A float in a vector that does not fit an int becomes the nearest int that there is, and NaN
// becomes 0, where GLSL leaves the value undefined. So nothing has undefined behaviour, as long as coordinates are
// finite.

#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace hashnoise {

using uint = std::uint32_t;

namespace detail {

template <typename To, typename From>
constexpr To convert(From value) {
  return static_cast<To>(value);
}

template <>
constexpr int convert<int, float>(float value) {
  if (value >= 2147483648.0f) return std::numeric_limits<int>::max();
  if (value < -2147483648.0f) return std::numeric_limits<int>::min();
  return value == value ? static_cast<int>(value) : 0;
}

template <>
constexpr uint convert<uint, float>(float value) {
  if (value >= 4294967296.0f) return std::numeric_limits<uint>::max();
  return value > 0.0f ? static_cast<uint>(value) : 0u;
}

}  // namespace detail

template <typename T>
struct Vector2 {
  T x, y;
  constexpr Vector2() : x(), y() {}
  constexpr Vector2(T x_, T y_) : x(x_), y(y_) {}
  constexpr explicit Vector2(T s) : x(s), y(s) {}
  template <typename U>
  constexpr explicit Vector2(Vector2<U> v) : x(detail::convert<T>(v.x)), y(detail::convert<T>(v.y)) {}
  friend constexpr bool operator==(Vector2, Vector2) = default;
};

template <typename T>
struct Vector3 {
  T x, y, z;
  constexpr Vector3() : x(), y(), z() {}
  constexpr Vector3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  constexpr explicit Vector3(T s) : x(s), y(s), z(s) {}
  template <typename U>
  constexpr explicit Vector3(Vector3<U> v)
      : x(detail::convert<T>(v.x)), y(detail::convert<T>(v.y)), z(detail::convert<T>(v.z)) {}
  friend constexpr bool operator==(Vector3, Vector3) = default;
};

template <typename T>
struct Vector4 {
  T x, y, z, w;
  constexpr Vector4() : x(), y(), z(), w() {}
  constexpr Vector4(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
  constexpr explicit Vector4(T s) : x(s), y(s), z(s), w(s) {}
  template <typename U>
  constexpr explicit Vector4(Vector4<U> v)
      : x(detail::convert<T>(v.x)),
        y(detail::convert<T>(v.y)),
        z(detail::convert<T>(v.z)),
        w(detail::convert<T>(v.w)) {}
  friend constexpr bool operator==(Vector4, Vector4) = default;
};

using vec2 = Vector2<float>;
using vec3 = Vector3<float>;
using vec4 = Vector4<float>;
using ivec2 = Vector2<int>;
using ivec3 = Vector3<int>;
using ivec4 = Vector4<int>;
using uvec2 = Vector2<uint>;
using uvec3 = Vector3<uint>;
using uvec4 = Vector4<uint>;

// What declarations of the library say; in GLSL these carry the precision.
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

constexpr vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr vec2 operator*(vec2 a, vec2 b) { return {a.x * b.x, a.y * b.y}; }
constexpr vec2 operator+(vec2 a, float b) { return a + vec2(b); }
constexpr vec2 operator-(vec2 a, float b) { return a - vec2(b); }
constexpr vec2 operator*(vec2 a, float b) { return a * vec2(b); }

constexpr vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr vec3 operator+(vec3 a, float b) { return a + vec3(b); }
constexpr vec3 operator-(vec3 a, float b) { return a - vec3(b); }
constexpr vec3 operator*(vec3 a, float b) { return a * vec3(b); }

constexpr ivec2 operator-(ivec2 a, int b) { return {a.x - b, a.y - b}; }
constexpr ivec3 operator-(ivec3 a, int b) { return {a.x - b, a.y - b, a.z - b}; }

constexpr uvec2 operator+(uvec2 a, uvec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr uvec3 operator+(uvec3 a, uvec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr uvec2 operator+(uvec2 a, uint b) { return a + uvec2(b); }
constexpr uvec3 operator+(uvec3 a, uint b) { return a + uvec3(b); }

// In this namespace a call means these, never ::abs(int) or another function that happens to be declared.
inline float floor(float x) { return std::floor(x); }
inline vec2 floor(vec2 v) { return {std::floor(v.x), std::floor(v.y)}; }
inline vec3 floor(vec3 v) { return {std::floor(v.x), std::floor(v.y), std::floor(v.z)}; }
inline float trunc(float x) { return std::trunc(x); }
inline float abs(float x) { return std::fabs(x); }
constexpr float min(float x, float y) { return y < x ? y : x; }
constexpr float max(float x, float y) { return x < y ? y : x; }
constexpr int min(int x, int y) { return y < x ? y : x; }
constexpr int max(int x, int y) { return x < y ? y : x; }
constexpr uint min(uint x, uint y) { return y < x ? y : x; }
constexpr uint max(uint x, uint y) { return x < y ? y : x; }
constexpr float uintBitsToFloat(uint bits) { return std::bit_cast<float>(bits); }
constexpr uint floatBitsToUint(float value) { return std::bit_cast<uint>(value); }

}  // namespace hashnoise
