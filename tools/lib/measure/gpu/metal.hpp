// Stands before a shader in Metal's language, as SPIRV-Cross prints it, to make it C++ for OpenCL. An operation becomes
// one of LLVM, so that a minimum stays a minimum, and no compiler contracts what is `precise`.
#define fragment static
#define thread
#define constant __constant
// A loop that always runs as often is written out, so that its steps are counted.
#define for _Pragma("clang loop unroll(full)") for

typedef unsigned int uint;
template <class T, int N>
using vec = T __attribute__((ext_vector_type(N)));
#define VECTORS(type, name)     \
  typedef vec<type, 2> name##2; \
  typedef vec<type, 3> name##3; \
  typedef vec<type, 4> name##4;
VECTORS(float, float)
VECTORS(int, int)
VECTORS(uint, uint)
VECTORS(int, bool)
template <int Columns, int Rows>
struct matrix {
  vec<float, Rows> columns[Columns];
};
typedef matrix<2, 2> float2x2;
typedef matrix<3, 3> float3x3;
typedef matrix<4, 4> float4x4;

// Constructors, for float3(a, b), float3(1.0) and uint2(int2(a)).
template <class T, class A>
struct Made {
  static T of(A a) { return (T)(a); }
};
template <class T, class A, int N>
struct Made<T, vec<A, N>> {
  static T of(vec<A, N> a) { return __builtin_convertvector(a, T); }
};
template <class T, class A>
T made(A a) {
  return Made<T, A>::of(a);
}
template <class T, class A, class... More>
T made(A a, More... more) {
  T found = {a, more...};
  return found;
}
template <class T, class A>
T as_type(A a) {
  return __builtin_astype(a, T);
}

// A function of numbers is one of vectors, component by component.
#define BY_COMPONENT(type, name, of)                                                              \
  static type##2 name PARAMETERS_##of(type##2) {                                                  \
    return made<type##2>(name ARGUMENTS_##of(x), name ARGUMENTS_##of(y));                         \
  }                                                                                               \
  static type##3 name PARAMETERS_##of(type##3) {                                                  \
    return made<type##3>(name ARGUMENTS_##of(x), name ARGUMENTS_##of(y), name ARGUMENTS_##of(z)); \
  }                                                                                               \
  static type##4 name PARAMETERS_##of(type##4) {                                                  \
    return made<type##4>(name ARGUMENTS_##of(x), name ARGUMENTS_##of(y), name ARGUMENTS_##of(z),  \
                         name ARGUMENTS_##of(w));                                                 \
  }
#define PARAMETERS_1(type) (type a)
#define PARAMETERS_2(type) (type a, type b)
#define PARAMETERS_3(type) (type a, type b, type c)
#define ARGUMENTS_1(part) (a.part)
#define ARGUMENTS_2(part) (a.part, b.part)
#define ARGUMENTS_3(part) (a.part, b.part, c.part)
#define FUNCTION(type, name, of, ...)                            \
  static type name PARAMETERS_##of(type) { return __VA_ARGS__; } \
  BY_COMPONENT(type, name, of)

#if defined(__NVPTX__)
#define INDEX __nvvm_read_ptx_sreg_tid_x()
#define NATIVE(name, of_ptx) __nvvm_##of_ptx##_approx_ftz_f
FUNCTION(float, spvFAdd, 2, __nvvm_add_rn_ftz_f(a, b))
FUNCTION(float, spvFMul, 2, __nvvm_mul_rn_ftz_f(a, b))
#else
#pragma clang fp contract(off)
FUNCTION(float, spvFAdd, 2, (a + b))
FUNCTION(float, spvFMul, 2, (a * b))
#pragma clang fp contract(fast)
#if defined(__SPIR__)
#define INDEX get_global_id(0)
unsigned long get_global_id(uint);
#define NATIVE(name, of_ptx) native_##name
float native_sqrt(float), native_rsqrt(float), native_sin(float), native_cos(float), native_exp2(float),
    native_log2(float);
#else  // this processor, for tests
#define INDEX 0
#define NATIVE(name, of_ptx) __builtin_##name##f
#define __builtin_rsqrtf(a) (1.0f / __builtin_sqrtf(a))
#endif
#endif
FUNCTION(float, sqrt, 1, NATIVE(sqrt, sqrt)(a))
FUNCTION(float, rsqrt, 1, NATIVE(rsqrt, rsqrt)(a))
FUNCTION(float, sin, 1, NATIVE(sin, sin)(a))
FUNCTION(float, cos, 1, NATIVE(cos, cos)(a))
FUNCTION(float, exp2, 1, NATIVE(exp2, ex2)(a))
FUNCTION(float, log2, 1, NATIVE(log2, lg2)(a))
FUNCTION(float, spvFSub, 2, spvFAdd(a, -b))
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
static float dot(float2 a, float2 b) { return a.x * b.x + a.y * b.y; }
static float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static float dot(float4 a, float4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
template <class T>
static float length(T a) {
  return sqrt(dot(a, a));
}
template <class T>
T normalize(T a) {
  return a * rsqrt(dot(a, a));
}
}  // namespace fast
template <int N>
static vec<float, N> operator*(matrix<N, N> m, vec<float, N> v) {
  vec<float, N> sum = m.columns[0] * v[0];
  for (int i = 1; i < N; ++i) sum += m.columns[i] * v[i];
  return sum;
}
template <int N>
static vec<float, N> operator*(vec<float, N> v, matrix<N, N> m) {
  vec<float, N> made;
  for (int i = 0; i < N; ++i) made[i] = fast::dot(v, m.columns[i]);
  return made;
}
using namespace fast;
template <class T>
T smoothstep(T low, T high, T a) {
  T t = clamp((a - low) / (high - low), made<T>(0.0f), made<T>(1.0f));
  return t * t * (3.0f - 2.0f * t);
}
template <class T, class Condition>
T select(T no, T yes, Condition condition) {
  return condition ? yes : no;
}
static bool any(bool2 a) { return a.x || a.y; }
static bool any(bool3 a) { return a.x || a.y || a.z; }
static bool any(bool4 a) { return a.x || a.y || a.z || a.w; }
static bool all(bool2 a) { return a.x && a.y; }
static bool all(bool3 a) { return a.x && a.y && a.z; }
static bool all(bool4 a) { return a.x && a.y && a.z && a.w; }

// The kernel of a shader, which reads its inputs from memory and writes its result there, component by component.
#define SHADER(name)                                                                                               \
  __attribute__((intel_reqd_sub_group_size(16))) kernel void name(global const float* __restrict memory,           \
                                                                  global float* __restrict results) {              \
    main0_in in;                                                                                                   \
    for (uint i = 0; i < sizeof in / sizeof(float); ++i) ((__private float*)&in)[i] = memory[INDEX + 1024 * i];    \
    main0_out out = main0(in);                                                                                     \
    for (uint i = 0; i < sizeof out / sizeof(float); ++i) results[INDEX + 1024 * i] = ((__private float*)&out)[i]; \
  }
