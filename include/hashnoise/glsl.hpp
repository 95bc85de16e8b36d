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

// Without a branch and a comparison of floats, so that compilers make vectors of it.
template <>
constexpr int convert<int, float>(float value) {
  const uint bits = std::bit_cast<uint>(value);
  const uint magnitude = bits & 0x7FFFFFFFu;
  const bool fits = magnitude < 0x4F000000u;  // 2^31
  const int whole = static_cast<int>(std::bit_cast<float>(fits ? bits : 0u));
  const uint nearest = magnitude > 0x7F800000u ? 0u : 0x7FFFFFFFu + (bits >> 31u);
  return fits ? whole : static_cast<int>(nearest);
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
  friend bool operator==(Vector2, Vector2) = default;  // constexpr where that of T is
  friend constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector2 operator*(Vector2 a, Vector2 b) { return {a.x * b.x, a.y * b.y}; }
  friend constexpr Vector2 operator+(Vector2 a, T b) { return a + Vector2(b); }
  friend constexpr Vector2 operator-(Vector2 a, T b) { return a - Vector2(b); }
  friend constexpr Vector2 operator*(Vector2 a, T b) { return a * Vector2(b); }
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
  friend bool operator==(Vector3, Vector3) = default;  // constexpr where that of T is
  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator*(Vector3 a, Vector3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr Vector3 operator+(Vector3 a, T b) { return a + Vector3(b); }
  friend constexpr Vector3 operator-(Vector3 a, T b) { return a - Vector3(b); }
  friend constexpr Vector3 operator*(Vector3 a, T b) { return a * Vector3(b); }
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
  friend bool operator==(Vector4, Vector4) = default;  // constexpr where that of T is
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

// What the declarations of the library say; in GLSL ES these names carry the precision.
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
