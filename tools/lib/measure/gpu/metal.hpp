// Stands before a shader in Metal's language, as SPIRV-Cross prints it, to make it CUDA for nvcc, C++ for OpenCL for
// Clang, and C++ for this processor. A minimum stays a minimum, and no compiler contracts what is `precise`.
#if defined(__CUDACC__)
#define INLINE __device__ __forceinline__
#define KERNEL(name) extern "C" __global__ void name(const float* __restrict__ memory, float* __restrict__ results)
#define INDEX threadIdx.x
#define NATIVE(name) name##f  // -use_fast_math
#define ROUNDED(operation, intrinsic) intrinsic
#define constant static __constant__ const
#else
#define INLINE inline
#define ROUNDED(operation, intrinsic) operation
#define constant static const
#if defined(__SPIR__)
#define KERNEL(name)                                                                                     \
  __attribute__((intel_reqd_sub_group_size(16))) kernel void name(global const float* __restrict memory, \
                                                                  global float* __restrict results)
#define INDEX get_global_id(0)
#define NATIVE(name) native_##name
unsigned long get_global_id(unsigned);
float native_sqrt(float), native_rsqrt(float), native_sin(float), native_cos(float), native_exp2(float),
    native_log2(float);
#else  // this processor, for tests
#define KERNEL(name) extern "C" void name(const float* __restrict memory, float* __restrict results)
#define INDEX 0
#define NATIVE(name) __builtin_##name##f
#define __builtin_rsqrtf(a) (1.0f / __builtin_sqrtf(a))
#endif
#endif
#define fragment static INLINE
#define thread
// A loop that always runs as often is written out, so that its steps are counted.
#define for _Pragma("unroll") for

namespace metal {
typedef unsigned int uint;
template <class T, int N>
struct vec {
  vec() = default;
  template <class A>
  INLINE constexpr explicit vec(A all) : parts() {
    for (int i = 0; i < N; ++i) parts[i] = T(all);
  }
  template <class A>
  INLINE constexpr explicit vec(vec<A, N> other) : parts() {
    for (int i = 0; i < N; ++i) parts[i] = T(other[i]);
  }
  template <class A, class B, class... More>
  INLINE constexpr vec(A a, B b, More... more) : parts() {
    int i = 0;
    put(i, a), put(i, b), (put(i, more), ...);
  }
  INLINE constexpr T& operator[](int i) { return parts[i]; }
  INLINE constexpr const T& operator[](int i) const { return parts[i]; }
  template <int... I>
  INLINE constexpr vec<T, sizeof...(I)> at() const {
    return vec<T, sizeof...(I)>(parts[I]...);
  }

 private:
  INLINE constexpr void put(int& i, T a) { parts[i++] = a; }
  template <int M>
  INLINE constexpr void put(int& i, vec<T, M> a) {
    for (int j = 0; j < M; ++j) parts[i++] = a[j];
  }
  T parts[N];
};
#define VECTORS(type, name)     \
  typedef vec<type, 2> name##2; \
  typedef vec<type, 3> name##3; \
  typedef vec<type, 4> name##4;
VECTORS(float, float)
VECTORS(int, int)
VECTORS(uint, uint)
VECTORS(bool, bool)
typedef vec<float2, 2> float2x2;
typedef vec<float3, 3> float3x3;
typedef vec<float4, 4> float4x4;

// An operator or a function of numbers is one of vectors, component by component.
#define OPERATOR(op)                                    \
  template <class T, class U, int N>                    \
  INLINE auto operator op(vec<T, N> a, vec<U, N> b) {   \
    vec<decltype(a[0] op b[0]), N> made;                \
    for (int i = 0; i < N; ++i) made[i] = a[i] op b[i]; \
    return made;                                        \
  }                                                     \
  template <class T, int N>                             \
  INLINE auto operator op(vec<T, N> a, T b) {           \
    return a op vec<T, N>(b);                           \
  }                                                     \
  template <class T, int N>                             \
  INLINE auto operator op(T a, vec<T, N> b) {           \
    return vec<T, N>(a) op b;                           \
  }
#define ASSIGNING_OPERATOR(op)                    \
  OPERATOR(op)                                    \
  template <class T, int N, class U>              \
  INLINE void operator op##=(vec<T, N>& a, U b) { \
    a = a op b;                                   \
  }
#define PARAMETERS_1(...) __VA_ARGS__ a
#define PARAMETERS_2(...) __VA_ARGS__ a, __VA_ARGS__ b
#define PARAMETERS_3(...) __VA_ARGS__ a, __VA_ARGS__ b, __VA_ARGS__ c
#define COMPONENTS_1 a[i]
#define COMPONENTS_2 a[i], b[i]
#define COMPONENTS_3 a[i], b[i], c[i]
#define FUNCTION(type, name, of, ...)                             \
  INLINE type name(PARAMETERS_##of(type)) { return __VA_ARGS__; } \
  template <int N>                                                \
  INLINE vec<type, N> name(PARAMETERS_##of(vec<type, N>)) {       \
    for (int i = 0; i < N; ++i) a[i] = name(COMPONENTS_##of);     \
    return a;                                                     \
  }
ASSIGNING_OPERATOR(+)
ASSIGNING_OPERATOR(-)
ASSIGNING_OPERATOR(*)
ASSIGNING_OPERATOR(/)
ASSIGNING_OPERATOR(%)
ASSIGNING_OPERATOR(&)
ASSIGNING_OPERATOR(|)
ASSIGNING_OPERATOR(^)
ASSIGNING_OPERATOR(<<)
ASSIGNING_OPERATOR(>>)
OPERATOR(<)
OPERATOR(>)
OPERATOR(<=)
OPERATOR(>=)
OPERATOR(==)
OPERATOR(!=)
#define UNARY_OPERATOR(op)                      \
  template <class T, int N>                     \
  INLINE vec<T, N> operator op(vec<T, N> a) {   \
    for (int i = 0; i < N; ++i) a[i] = op a[i]; \
    return a;                                   \
  }
UNARY_OPERATOR(-)
UNARY_OPERATOR(~)
UNARY_OPERATOR(!)
#ifdef __clang__
#pragma clang fp contract(off)
#endif
FUNCTION(float, spvFAdd, 2, ROUNDED(a + b, __fadd_rn(a, b)))
FUNCTION(float, spvFMul, 2, ROUNDED(a* b, __fmul_rn(a, b)))
#ifdef __clang__
#pragma clang fp contract(fast)
#endif
FUNCTION(float, spvFSub, 2, spvFAdd(a, -b))
FUNCTION(float, sqrt, 1, NATIVE(sqrt)(a))
FUNCTION(float, rsqrt, 1, NATIVE(rsqrt)(a))
FUNCTION(float, sin, 1, NATIVE(sin)(a))
FUNCTION(float, cos, 1, NATIVE(cos)(a))
FUNCTION(float, exp2, 1, NATIVE(exp2)(a))
FUNCTION(float, log2, 1, NATIVE(log2)(a))
FUNCTION(float, floor, 1, __builtin_floorf(a))
FUNCTION(float, ceil, 1, __builtin_ceilf(a))
FUNCTION(float, trunc, 1, __builtin_truncf(a))
FUNCTION(float, rint, 1, __builtin_rintf(a))
FUNCTION(float, round, 1, __builtin_rintf(a))
FUNCTION(float, abs, 1, __builtin_fabsf(a))
FUNCTION(float, fma, 3, __builtin_fmaf(a, b, c))
FUNCTION(float, fract, 1, a - floor(a))
FUNCTION(float, sign, 1, float(a > 0.0f) - float(a < 0.0f))
FUNCTION(float, step, 2, b < a ? 0.0f : 1.0f)
FUNCTION(float, mix, 3, (b - a) * c + a)
FUNCTION(float, exp, 1, exp2(a * 1.44269504f))
FUNCTION(float, log, 1, log2(a) * 0.693147181f)
FUNCTION(float, pow, 2, exp2(log2(a) * b))
FUNCTION(float, powr, 2, exp2(log2(a) * b))
FUNCTION(int, abs, 1, a < 0 ? -a : a)
FUNCTION(int, min, 2, a < b ? a : b)
FUNCTION(int, max, 2, a > b ? a : b)
FUNCTION(int, clamp, 3, min(max(a, b), c))
FUNCTION(uint, min, 2, a < b ? a : b)
FUNCTION(uint, max, 2, a > b ? a : b)
FUNCTION(uint, clamp, 3, min(max(a, b), c))
namespace fast {
FUNCTION(float, min, 2, __builtin_fminf(a, b))
FUNCTION(float, max, 2, __builtin_fmaxf(a, b))
FUNCTION(float, clamp, 3, min(max(a, b), c))
template <int N>
INLINE float dot(vec<float, N> a, vec<float, N> b) {
  float sum = a[0] * b[0];
  for (int i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}
template <int N>
INLINE float length(vec<float, N> a) {
  return sqrt(dot(a, a));
}
template <int N>
INLINE vec<float, N> normalize(vec<float, N> a) {
  return a * rsqrt(dot(a, a));
}
}  // namespace fast
using namespace fast;
template <int N>
INLINE vec<float, N> operator*(vec<vec<float, N>, N> m, vec<float, N> v) {
  vec<float, N> sum = m[0] * v[0];
  for (int i = 1; i < N; ++i) sum += m[i] * v[i];
  return sum;
}
template <int N>
INLINE vec<float, N> operator*(vec<float, N> v, vec<vec<float, N>, N> m) {
  vec<float, N> made;
  for (int i = 0; i < N; ++i) made[i] = dot(v, m[i]);
  return made;
}
template <class T>
INLINE T smoothstep(T low, T high, T a) {
  T t = clamp((a - low) / (high - low), T(0.0f), T(1.0f));
  return t * t * (3.0f - 2.0f * t);
}
template <class T>
INLINE T select(T no, T yes, bool condition) {
  return condition ? yes : no;
}
template <class T, int N>
INLINE vec<T, N> select(vec<T, N> no, vec<T, N> yes, vec<bool, N> condition) {
  for (int i = 0; i < N; ++i) no[i] = select(no[i], yes[i], condition[i]);
  return no;
}
template <int N>
INLINE bool all(vec<bool, N> a) {
  bool found = a[0];
  for (int i = 1; i < N; ++i) found = found && a[i];
  return found;
}
template <int N>
INLINE bool any(vec<bool, N> a) {
  return !all(!a);
}
template <class T, class A>
INLINE T as_type(A a) {
  return __builtin_bit_cast(T, a);
}
}  // namespace metal

// The kernel of a shader, which reads its inputs from memory and writes its result there, component by component.
#define SHADER(name)                                                                                         \
  KERNEL(name) {                                                                                             \
    main0_in in;                                                                                             \
    for (unsigned i = 0; i < sizeof in / sizeof(float); ++i) ((float*)&in)[i] = memory[INDEX + 1024 * i];    \
    main0_out out = main0(in);                                                                               \
    for (unsigned i = 0; i < sizeof out / sizeof(float); ++i) results[INDEX + 1024 * i] = ((float*)&out)[i]; \
  }
