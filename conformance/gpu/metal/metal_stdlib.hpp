// Stands for Apple's <metal_stdlib>, which nobody has outside of macOS: as much of Metal's shading language as the
// library and the rows of the suite use, for a compiler of C++14. Sections are those of Apple's specification.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#define kernel extern "C"  // a function that a program starts for each point (section 5.1)
#define device             // the address spaces of buffers and of a function's variables (section 4)
#define thread

using uint = std::uint32_t;

namespace metal {
namespace detail {

template <typename T, int N>
struct Parts;
template <typename T>
struct Parts<T, 2> {
  T x, y;
};
template <typename T>
struct Parts<T, 3> {
  T x, y, z;
};
template <typename T>
struct Parts<T, 4> {
  T x, y, z, w;
};

template <typename T>
struct Same {
  using Type = T;
};

// A float that an int has no room for gives an int of some kind (section 2.15); in C++ it would be undefined.
template <typename To, typename From>
To converted(From value) {
  return static_cast<To>(value);
}
template <>
inline int converted<int, float>(float value) {
  return value >= -2147483648.0f && value < 2147483648.0f ? static_cast<int>(value) : INT32_MIN;
}

}  // namespace detail

// One scalar for all components, a vector of another type, or scalars and vectors with as many components together
// (section 2.2.3).
template <typename T, int N>
struct vec : detail::Parts<T, N> {
  vec() : detail::Parts<T, N>{} {}
  explicit vec(T scalar) {
    for (int i = 0; i < N; ++i) (*this)[i] = scalar;
  }
  template <typename U>
  explicit vec(vec<U, N> other) {
    for (int i = 0; i < N; ++i) (*this)[i] = detail::converted<T>(other[i]);
  }
  template <typename First, typename Second, typename... Rest>
  vec(First first, Second second, Rest... rest) {
    put<0>(first, second, rest...);
  }

  T& operator[](int i) { return reinterpret_cast<T*>(this)[i]; }
  const T& operator[](int i) const { return reinterpret_cast<const T*>(this)[i]; }

 private:
  template <int At>
  void put() {
    static_assert(At == N, "the arguments have as many components as the vector");
  }
  template <int At, typename U, int M, typename... Rest>
  void put(vec<U, M> part, Rest... rest) {
    for (int i = 0; i < M; ++i) (*this)[At + i] = detail::converted<T>(part[i]);
    put<At + M>(rest...);
  }
  template <int At, typename U, typename... Rest>
  void put(U part, Rest... rest) {
    (*this)[At] = detail::converted<T>(part);
    put<At + 1>(rest...);
  }
};

#define HN_OPERATOR(op)                                                  \
  template <typename T, int N>                                           \
  vec<T, N> operator op(vec<T, N> a, vec<T, N> b) {                      \
    for (int i = 0; i < N; ++i) a[i] = a[i] op b[i];                     \
    return a;                                                            \
  }                                                                      \
  template <typename T, int N>                                           \
  vec<T, N> operator op(vec<T, N> a, typename detail::Same<T>::Type b) { \
    return a op vec<T, N>(b);                                            \
  }                                                                      \
  template <typename T, int N>                                           \
  vec<T, N> operator op(typename detail::Same<T>::Type a, vec<T, N> b) { \
    return vec<T, N>(a) op b;                                            \
  }
HN_OPERATOR(+)
HN_OPERATOR(-)
HN_OPERATOR(*)
HN_OPERATOR(/)
HN_OPERATOR(%)
HN_OPERATOR(&)
HN_OPERATOR(|)
HN_OPERATOR(^)
HN_OPERATOR(<<)
HN_OPERATOR(>>)
#undef HN_OPERATOR

template <typename T, int N>
vec<T, N> operator-(vec<T, N> a) {
  return vec<T, N>(T(0)) - a;
}

using float2 = vec<float, 2>;
using float3 = vec<float, 3>;
using float4 = vec<float, 4>;
using int2 = vec<int, 2>;
using int3 = vec<int, 3>;
using int4 = vec<int, 4>;
using uint2 = vec<uint, 2>;
using uint3 = vec<uint, 3>;
using uint4 = vec<uint, 4>;

// Bits as another type (section 2.21).
template <typename To, typename From>
To as_type(From from) {
  static_assert(sizeof(To) == sizeof(From), "as many bits");
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

// Section 6.
#define HN_FUNCTION(name, one)                     \
  inline float name(float x) { return one(x); }    \
  template <int N>                                 \
  vec<float, N> name(vec<float, N> x) {            \
    for (int i = 0; i < N; ++i) x[i] = name(x[i]); \
    return x;                                      \
  }
HN_FUNCTION(floor, std::floor)
HN_FUNCTION(trunc, std::trunc)
HN_FUNCTION(sin, std::sin)
HN_FUNCTION(sqrt, std::sqrt)
HN_FUNCTION(abs, std::fabs)
#undef HN_FUNCTION
inline int abs(int x) { return x < 0 ? -x : x; }

#define HN_FUNCTION(name, op)                                    \
  inline float name(float a, float b) { return b op a ? b : a; } \
  inline int name(int a, int b) { return b op a ? b : a; }       \
  inline uint name(uint a, uint b) { return b op a ? b : a; }    \
  template <typename T, int N>                                   \
  vec<T, N> name(vec<T, N> a, vec<T, N> b) {                     \
    for (int i = 0; i < N; ++i) a[i] = name(a[i], b[i]);         \
    return a;                                                    \
  }
HN_FUNCTION(min, <)
HN_FUNCTION(max, >)
#undef HN_FUNCTION

}  // namespace metal
