// The parts of GLSL that the library's own text does not use, for the expressions of users: built-in functions,
// operators and swizzles. hn-bake includes it in the program for an expression (program.cpp); it is no part of
// hashnoise.
#pragma once

#include <hashnoise/hashnoise.hpp>

// In this namespace, so that they are found beside those of glsl.hpp.
namespace hashnoise {

// GLSL's numbers stand before vectors, too, and may be whole: 1 - v.
template <typename T>
struct SameHelper {
  using Type = T;
};
template <typename T>
using Same = typename SameHelper<T>::Type;  // from which no type is deduced

template <typename T>
constexpr Vector2<T> operator-(Vector2<T> v) {
  return {-v.x, -v.y};
}
template <typename T>
constexpr Vector3<T> operator-(Vector3<T> v) {
  return {-v.x, -v.y, -v.z};
}
template <typename T>
constexpr Vector4<T> operator-(Vector4<T> v) {
  return {-v.x, -v.y, -v.z, -v.w};
}

#define HN_BAKE_OPERATORS(Vector)                          \
  template <typename T>                                    \
  constexpr Vector<T> operator+(Same<T> a, Vector<T> b) {  \
    return Vector<T>(a) + b;                               \
  }                                                        \
  template <typename T>                                    \
  constexpr Vector<T> operator-(Same<T> a, Vector<T> b) {  \
    return Vector<T>(a) - b;                               \
  }                                                        \
  template <typename T>                                    \
  constexpr Vector<T> operator/(Same<T> a, Vector<T> b) {  \
    return Vector<T>(a) / b;                               \
  }                                                        \
  template <typename T, typename Other>                    \
  constexpr Vector<T>& operator+=(Vector<T>& a, Other b) { \
    return a = a + b;                                      \
  }                                                        \
  template <typename T, typename Other>                    \
  constexpr Vector<T>& operator-=(Vector<T>& a, Other b) { \
    return a = a - b;                                      \
  }                                                        \
  template <typename T, typename Other>                    \
  constexpr Vector<T>& operator*=(Vector<T>& a, Other b) { \
    return a = a * b;                                      \
  }                                                        \
  template <typename T, typename Other>                    \
  constexpr Vector<T>& operator/=(Vector<T>& a, Other b) { \
    return a = a / b;                                      \
  }
HN_BAKE_OPERATORS(Vector2)
HN_BAKE_OPERATORS(Vector3)
HN_BAKE_OPERATORS(Vector4)
#undef HN_BAKE_OPERATORS

// v.yx is swizzled<21>(v), with a digit for each component: hn-bake writes it so. The result is constant, because an
// assignment to it would change nothing.
template <int Digit, typename Vector>
constexpr auto component_of(const Vector& v) {
  static_assert(Digit <= detail::kComponents<Vector>, "hn-bake: the vector has not so many components");
  return detail::component<Digit - 1>(v);
}
template <int Digits, typename Vector>
constexpr const auto swizzled(const Vector& v) {
  if constexpr (Digits < 100) {
    return Vector2<decltype(v.x)>(component_of<Digits / 10>(v), component_of<Digits % 10>(v));
  } else if constexpr (Digits < 1000) {
    return Vector3<decltype(v.x)>(swizzled<Digits / 10>(v), component_of<Digits % 10>(v));
  } else {
    return Vector4<decltype(v.x)>(swizzled<Digits / 10>(v), component_of<Digits % 10>(v));
  }
}

// A function of floats, of each component; `HN_BAKE_EACH_VECTOR` where glsl.hpp has that of a float.
#define HN_BAKE_EACH_VECTOR(name)                                        \
  inline vec2 name(vec2 v) { return {name(v.x), name(v.y)}; }            \
  inline vec3 name(vec3 v) { return {name(v.x), name(v.y), name(v.z)}; } \
  inline vec4 name(vec4 v) { return {name(v.x), name(v.y), name(v.z), name(v.w)}; }
#define HN_BAKE_EACH(name, value)              \
  inline float name(float x) { return value; } \
  HN_BAKE_EACH_VECTOR(name)
HN_BAKE_EACH(radians, x * 0.017453292519943295f)
HN_BAKE_EACH(degrees, x * 57.29577951308232f)
HN_BAKE_EACH(sin, std::sin(x))
HN_BAKE_EACH(cos, std::cos(x))
HN_BAKE_EACH(tan, std::tan(x))
HN_BAKE_EACH(asin, std::asin(x))
HN_BAKE_EACH(acos, std::acos(x))
HN_BAKE_EACH(atan, std::atan(x))
HN_BAKE_EACH(sinh, std::sinh(x))
HN_BAKE_EACH(cosh, std::cosh(x))
HN_BAKE_EACH(tanh, std::tanh(x))
HN_BAKE_EACH(asinh, std::asinh(x))
HN_BAKE_EACH(acosh, std::acosh(x))
HN_BAKE_EACH(atanh, std::atanh(x))
HN_BAKE_EACH(exp, std::exp(x))
HN_BAKE_EACH(log, std::log(x))
HN_BAKE_EACH(exp2, std::exp2(x))
HN_BAKE_EACH(log2, std::log2(x))
HN_BAKE_EACH(inversesqrt, 1.0f / std::sqrt(x))
HN_BAKE_EACH(sign, static_cast<float>(x > 0.0f) - static_cast<float>(x < 0.0f))
HN_BAKE_EACH(round, std::rint(x))
HN_BAKE_EACH(roundEven, std::rint(x))
HN_BAKE_EACH(ceil, std::ceil(x))
HN_BAKE_EACH(fract, x - std::floor(x))
HN_BAKE_EACH_VECTOR(trunc)
HN_BAKE_EACH_VECTOR(sqrt)
inline vec2 abs(vec2 v) { return {abs(v.x), abs(v.y)}; }
inline vec4 abs(vec4 v) { return {abs(v.x), abs(v.y), abs(v.z), abs(v.w)}; }
inline int abs(int x) { return x < 0 ? -x : x; }
inline bool isnan(float x) { return x != x; }
inline bool isinf(float x) { return std::fabs(x) > std::numeric_limits<float>::max(); }
#undef HN_BAKE_EACH

// Functions of two arguments; the second may be a float for all components.
#define HN_BAKE_PAIRS(name)                                                                                     \
  inline vec2 name(vec2 a, vec2 b) { return {name(a.x, b.x), name(a.y, b.y)}; }                                 \
  inline vec4 name(vec4 a, vec4 b) { return {name(a.x, b.x), name(a.y, b.y), name(a.z, b.z), name(a.w, b.w)}; } \
  inline vec2 name(vec2 a, float b) { return name(a, vec2(b)); }                                                \
  inline vec3 name(vec3 a, float b) { return name(a, vec3(b)); }                                                \
  inline vec4 name(vec4 a, float b) { return name(a, vec4(b)); }
#define HN_BAKE_PAIRS_IN_SPACE(name) \
  inline vec3 name(vec3 a, vec3 b) { return {name(a.x, b.x), name(a.y, b.y), name(a.z, b.z)}; }
inline float mod(float x, float y) { return x - y * std::floor(x / y); }
inline float pow(float x, float y) { return std::pow(x, y); }
inline float atan(float y, float x) { return std::atan2(y, x); }
HN_BAKE_PAIRS_IN_SPACE(mod)
HN_BAKE_PAIRS_IN_SPACE(pow)
HN_BAKE_PAIRS_IN_SPACE(atan)
HN_BAKE_PAIRS(mod)
HN_BAKE_PAIRS(pow)
HN_BAKE_PAIRS(atan)
HN_BAKE_PAIRS(min)
HN_BAKE_PAIRS(max)
#undef HN_BAKE_PAIRS
#undef HN_BAKE_PAIRS_IN_SPACE

inline float step(float edge, float x) { return x < edge ? 0.0f : 1.0f; }
inline float clamp(float x, float least, float most) { return min(max(x, least), most); }
inline int clamp(int x, int least, int most) { return min(max(x, least), most); }
inline float mix(float a, float b, float t) { return a * (1.0f - t) + b * t; }
inline float smoothstep(float first, float last, float x) {
  const float t = clamp((x - first) / (last - first), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}
inline float dot(float a, float b) { return a * b; }
inline float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float dot(vec4 a, vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
inline vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y}; }
inline float length(float v) { return std::fabs(v); }

#define HN_BAKE_OF_A_VECTOR(Vector)                                                                                  \
  inline Vector step(Vector edge, Vector x) { return 1.0f - each_less(x, edge); }                                    \
  inline Vector step(float edge, Vector x) { return step(Vector(edge), x); }                                         \
  inline Vector clamp(Vector x, Vector least, Vector most) { return min(max(x, least), most); }                      \
  inline Vector clamp(Vector x, float least, float most) { return clamp(x, Vector(least), Vector(most)); }           \
  inline Vector mix(Vector a, Vector b, Vector t) { return a * (1.0f - t) + b * t; }                                 \
  inline Vector mix(Vector a, Vector b, float t) { return mix(a, b, Vector(t)); }                                    \
  inline Vector smoothstep(Vector first, Vector last, Vector x) {                                                    \
    const Vector t = clamp((x - first) / (last - first), 0.0f, 1.0f);                                                \
    return t * t * (3.0f - 2.0f * t);                                                                                \
  }                                                                                                                  \
  inline Vector smoothstep(float first, float last, Vector x) { return smoothstep(Vector(first), Vector(last), x); } \
  inline float length(Vector v) { return std::sqrt(dot(v, v)); }                                                     \
  inline float distance(Vector a, Vector b) { return length(a - b); }                                                \
  inline Vector normalize(Vector v) { return v / length(v); }                                                        \
  inline Vector reflect(Vector i, Vector n) { return i - 2.0f * dot(n, i) * n; }                                     \
  inline Vector faceforward(Vector n, Vector i, Vector reference) { return dot(reference, i) < 0.0f ? n : -n; }      \
  inline Vector refract(Vector i, Vector n, float eta) {                                                             \
    const float k = 1.0f - eta * eta * (1.0f - dot(n, i) * dot(n, i));                                               \
    return k < 0.0f ? Vector(0.0f) : eta * i - (eta * dot(n, i) + std::sqrt(k)) * n;                                 \
  }
inline vec2 each_less(vec2 a, vec2 b) { return vec2(a.x < b.x, a.y < b.y); }
inline vec3 each_less(vec3 a, vec3 b) { return vec3(a.x < b.x, a.y < b.y, a.z < b.z); }
inline vec4 each_less(vec4 a, vec4 b) { return vec4(a.x < b.x, a.y < b.y, a.z < b.z, a.w < b.w); }
HN_BAKE_OF_A_VECTOR(vec2)
HN_BAKE_OF_A_VECTOR(vec3)
HN_BAKE_OF_A_VECTOR(vec4)
#undef HN_BAKE_OF_A_VECTOR
#undef HN_BAKE_EACH_VECTOR

}  // namespace hashnoise
