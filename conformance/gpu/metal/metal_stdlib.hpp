// Stands for Apple's <metal_stdlib>, which nobody has outside of macOS: as much of Metal's shading language as the
// library, the rows of the suite and the kernels of translators use, for clang as C++14. It includes nothing, so that
// no name is there twice. Sections are those of Apple's specification.
#pragma once

#define kernel    // a function that a program starts for each point (section 5.1)
#define constant  // the address spaces of buffers and of a function's variables (section 4)
#define device
#define thread
#define threadgroup

using size_t = decltype(sizeof 0);
using uint = unsigned int;

namespace metal {
namespace detail {

// C++14 leaves some operations on ints undefined, and Metal's compiler makes use of that. Clang calls the functions at
// the end of this file for them. The first one is kept for the evaluator.
struct Place {
  const char* file;
  unsigned line, column;
};
static char undefined[256];
static uint point;                  // that is evaluated
static Place operand = {"", 0, 0};  // of an operation on vectors: the checked one is in this file

inline void keep(const Place* place, const char* operation) {
  if (undefined[0] != 0) return;
  if (__builtin_strcmp(place->file, __FILE__) == 0) place = &operand;
  __builtin_snprintf(undefined, sizeof undefined, "%s:%u: %s is undefined (point %u)", place->file, place->line,
                     operation, point);
}

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

// A float that an int has no room for gives an int of some kind (section 2.15); in C++ it would be undefined.
template <typename To, typename From>
To converted(From value) {
  return static_cast<To>(value);
}
template <>
inline int converted<int, float>(float value) {
  return value >= -2147483648.0f && value < 2147483648.0f ? static_cast<int>(value) : -2147483647 - 1;
}

}  // namespace detail

// One scalar for all components, a vector of another type, or scalars and vectors with as many components together
// (section 2.2.3).
template <typename T, int N>
struct vec : detail::Parts<T, N> {
  vec() : detail::Parts<T, N>{} {}
  vec(T scalar) {
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

  // v.yx is v.part<'y', 'x'>() here, and on the left of = it is v.place<'y', 'x'>().
  template <char... C>
  vec<T, sizeof...(C)> part() const {
    return {(*this)[C == 'w' ? 3 : C - 'x']...};
  }
  template <char... C>
  struct Components {
    vec& whole;
    void operator=(vec<T, sizeof...(C)> by) {
      const char names[] = {C...};
      for (int i = 0; i < int(sizeof...(C)); ++i) whole[names[i] == 'w' ? 3 : names[i] - 'x'] = by[i];
    }
  };
  template <char... C>
  Components<C...> place() {
    return {*this};
  }

  // The right operand, and where it is in the text.
  struct Operand {
    vec value;
    detail::Place place;
    Operand(vec v, const char* file = __builtin_FILE(), unsigned line = __builtin_LINE())
        : value(v), place{file, line, 0} {}
    Operand(T s, const char* file = __builtin_FILE(), unsigned line = __builtin_LINE())
        : value(s), place{file, line, 0} {}
  };
  // The count of a shift, of any type.
  struct Count : Operand {
    template <typename U>
    Count(vec<U, N> v, const char* file = __builtin_FILE(), unsigned line = __builtin_LINE())
        : Operand(vec(v), file, line) {}
    Count(T s, const char* file = __builtin_FILE(), unsigned line = __builtin_LINE()) : Operand(s, file, line) {}
  };

#define HN_OPERATOR(op, Result, Right)                          \
  friend vec<Result, N> operator op(vec a, Right b) {           \
    detail::operand = b.place;                                  \
    vec<Result, N> result;                                      \
    for (int i = 0; i < N; ++i) result[i] = a[i] op b.value[i]; \
    return result;                                              \
  }                                                             \
  friend vec<Result, N> operator op(T a, Right b) { return vec(a) op b; }
#define HN_ARITHMETIC_OPERATOR(op, Right) \
  HN_OPERATOR(op, T, Right)               \
  friend vec& operator op##=(vec& a, Right b) { return a = a op b; }
  HN_ARITHMETIC_OPERATOR(+, Operand)
  HN_ARITHMETIC_OPERATOR(-, Operand)
  HN_ARITHMETIC_OPERATOR(*, Operand)
  HN_ARITHMETIC_OPERATOR(/, Operand)
  HN_ARITHMETIC_OPERATOR(%, Operand)
  HN_ARITHMETIC_OPERATOR(&, Operand)
  HN_ARITHMETIC_OPERATOR(|, Operand)
  HN_ARITHMETIC_OPERATOR(^, Operand)
  HN_ARITHMETIC_OPERATOR(<<, Count)
  HN_ARITHMETIC_OPERATOR(>>, Count)
  HN_OPERATOR(==, bool, Operand)
  HN_OPERATOR(!=, bool, Operand)
  HN_OPERATOR(<, bool, Operand)
  HN_OPERATOR(<=, bool, Operand)
  HN_OPERATOR(>, bool, Operand)
  HN_OPERATOR(>=, bool, Operand)
  HN_OPERATOR(&&, bool, Operand)
  HN_OPERATOR(||, bool, Operand)
#undef HN_ARITHMETIC_OPERATOR
#undef HN_OPERATOR
#define HN_OPERATOR(op)                                     \
  friend vec operator op(Operand a) {                       \
    detail::operand = a.place;                              \
    for (int i = 0; i < N; ++i) a.value[i] = op a.value[i]; \
    return a.value;                                         \
  }
  HN_OPERATOR(-)
  HN_OPERATOR(~)
  HN_OPERATOR(!)
#undef HN_OPERATOR

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

#define HN_TYPES(type)              \
  using type##2 = vec<type, 2>;     \
  using type##3 = vec<type, 3>;     \
  using packed_##type##3 = type##3; \
  using type##4 = vec<type, 4>;
HN_TYPES(bool)
HN_TYPES(float)
HN_TYPES(int)
HN_TYPES(uint)
#undef HN_TYPES
using ::uint;

template <typename T, size_t N>
struct array {
  T elements[N];
  T& operator[](size_t i) { return elements[i]; }
  const T& operator[](size_t i) const { return elements[i]; }
};

// Bits as another type (section 2.21).
template <typename To, typename From>
To as_type(From from) {
  static_assert(sizeof(To) == sizeof(From), "as many bits");
  To to;
  __builtin_memcpy(&to, &from, sizeof to);
  return to;
}

namespace detail {
template <typename T, int N>
T at(vec<T, N> v, int i) {
  return v[i];
}
template <typename T>
T at(T scalar, int) {
  return scalar;
}
}  // namespace detail

// Section 6: functions of scalars, and of vectors by their components.
#define HN_COMPONENTS(name)                                                       \
  template <typename T, int N, typename... Others>                                \
  auto name(vec<T, N> a, Others... others) {                                      \
    vec<decltype(name(a[0], detail::at(others, 0)...)), N> result;                \
    for (int i = 0; i < N; ++i) result[i] = name(a[i], detail::at(others, i)...); \
    return result;                                                                \
  }
#define HN_FUNCTION(name, parameters, value)     \
  inline float name parameters { return value; } \
  HN_COMPONENTS(name)
HN_FUNCTION(floor, (float x), __builtin_floorf(x))
HN_FUNCTION(ceil, (float x), __builtin_ceilf(x))
HN_FUNCTION(trunc, (float x), __builtin_truncf(x))
HN_FUNCTION(round, (float x), __builtin_roundf(x))
HN_FUNCTION(rint, (float x), __builtin_rintf(x))
HN_FUNCTION(sin, (float x), __builtin_sinf(x))
HN_FUNCTION(cos, (float x), __builtin_cosf(x))
HN_FUNCTION(tan, (float x), __builtin_tanf(x))
HN_FUNCTION(acos, (float x), __builtin_acosf(x))
HN_FUNCTION(atan, (float x), __builtin_atanf(x))
HN_FUNCTION(exp, (float x), __builtin_expf(x))
HN_FUNCTION(exp2, (float x), __builtin_exp2f(x))
HN_FUNCTION(log, (float x), __builtin_logf(x))
HN_FUNCTION(log2, (float x), __builtin_log2f(x))
HN_FUNCTION(sqrt, (float x), __builtin_sqrtf(x))
HN_FUNCTION(rsqrt, (float x), 1.0f / __builtin_sqrtf(x))
HN_FUNCTION(fract, (float x), __builtin_fminf(x - __builtin_floorf(x), 0x1.fffffep-1f))
HN_FUNCTION(sign, (float x), x > 0 ? 1.0f : x < 0 ? -1.0f : 0.0f)
HN_FUNCTION(pow, (float x, float y), __builtin_powf(x, y))
HN_FUNCTION(fmod, (float x, float y), __builtin_fmodf(x, y))
HN_FUNCTION(atan2, (float y, float x), __builtin_atan2f(y, x))
HN_FUNCTION(step, (float edge, float x), x < edge ? 0.0f : 1.0f)
HN_FUNCTION(fma, (float a, float b, float c), __builtin_fmaf(a, b, c))
HN_FUNCTION(mix, (float a, float b, float t), a + (b - a) * t)
HN_FUNCTION(abs, (float x), __builtin_fabsf(x))
#undef HN_FUNCTION

// Functions of bits take ints alone (section 6.4).
#define HN_FUNCTIONS(T)                                                     \
  inline T min(T a, T b) { return b < a ? b : a; }                          \
  inline T max(T a, T b) { return b > a ? b : a; }                          \
  inline T clamp(T x, T least, T most) { return min(max(x, least), most); } \
  inline T select(T a, T b, bool second) { return second ? b : a; }
#define HN_BITS(T, Long)                                                       \
  HN_FUNCTIONS(T)                                                              \
  inline T popcount(T x) { return T(__builtin_popcount(uint(x))); }            \
  inline T clz(T x) { return x == 0 ? T(32) : T(__builtin_clz(uint(x))); }     \
  inline T ctz(T x) { return x == 0 ? T(32) : T(__builtin_ctz(uint(x))); }     \
  inline T reverse_bits(T x) { return T(__builtin_bitreverse32(uint(x))); }    \
  inline T mulhi(T a, T b) { return T((static_cast<Long>(a) * b) >> 32); }     \
  inline T extract_bits(T x, uint from, uint bits) {                           \
    return bits == 0 ? T(0) : T(uint(x) << (32 - from - bits)) >> (32 - bits); \
  }                                                                            \
  inline T insert_bits(T x, T by, uint from, uint bits) {                      \
    const uint mask = uint(((1ull << bits) - 1) << from);                      \
    return T((uint(x) & ~mask) | ((uint(by) << (from & 31)) & mask));          \
  }
HN_FUNCTIONS(bool)
HN_FUNCTIONS(float)
HN_BITS(int, long long)
HN_BITS(uint, unsigned long long)
inline int abs(int x) { return x < 0 ? -x : x; }
inline float smoothstep(float from, float to, float x) {
  const float t = clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}
inline bool isnan(float x) { return x != x; }
inline bool isinf(float x) { return __builtin_isinf(x); }
HN_COMPONENTS(min)
HN_COMPONENTS(max)
HN_COMPONENTS(clamp)
HN_COMPONENTS(select)
HN_COMPONENTS(popcount)
HN_COMPONENTS(clz)
HN_COMPONENTS(ctz)
HN_COMPONENTS(reverse_bits)
HN_COMPONENTS(mulhi)
HN_COMPONENTS(extract_bits)
HN_COMPONENTS(insert_bits)
HN_COMPONENTS(smoothstep)
HN_COMPONENTS(isnan)
HN_COMPONENTS(isinf)
#undef HN_BITS
#undef HN_FUNCTIONS
#undef HN_COMPONENTS

template <int N>
bool any(vec<bool, N> b) {
  bool found = false;
  for (int i = 0; i < N; ++i) found = found || b[i];
  return found;
}
template <int N>
bool all(vec<bool, N> b) {
  return !any(!b);
}
template <int N>
float dot(vec<float, N> a, vec<float, N> b) {
  float sum = a[0] * b[0];
  for (int i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}
template <int N>
float length(vec<float, N> v) {
  return sqrt(dot(v, v));
}
template <int N>
vec<float, N> normalize(vec<float, N> v) {
  return v / length(v);
}

template <int N>
float distance(vec<float, N> a, vec<float, N> b) {
  return length(a - b);
}
inline float3 cross(float3 a, float3 b) {
  return float3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// By its columns (section 2.3).
template <typename T, int C, int R>
struct matrix {
  vec<T, R> columns[C];

  matrix() = default;
  template <typename... Others>
  explicit matrix(vec<T, R> first, Others... others) : columns{first, others...} {}
  vec<T, R>& operator[](int i) { return columns[i]; }
  const vec<T, R>& operator[](int i) const { return columns[i]; }
  vec<T, R> operator*(vec<T, C> v) const {
    vec<T, R> sum;
    for (int i = 0; i < C; ++i) sum += columns[i] * v[i];
    return sum;
  }
  template <int D>
  matrix<T, D, R> operator*(const matrix<T, D, C>& by) const {
    matrix<T, D, R> product;
    for (int i = 0; i < D; ++i) product[i] = *this * by[i];
    return product;
  }
  friend vec<T, C> operator*(vec<T, R> v, const matrix& m) {
    vec<T, C> result;
    for (int i = 0; i < C; ++i) result[i] = dot(v, m[i]);
    return result;
  }
  friend vec<T, C>& operator*=(vec<T, C>& v, const matrix& m) { return v = v * m; }
};
using float2x2 = matrix<float, 2, 2>;
using float3x3 = matrix<float, 3, 3>;
using float4x4 = matrix<float, 4, 4>;

namespace fast {
using namespace metal;
}
namespace precise {
using namespace metal;
}

namespace detail {

// Arguments of a kernel: a buffer, as a pointer or a reference to what the kernel takes it for, and a point's number.
struct Buffer {
  void* words;
  template <typename T>
  operator T*() const {
    return static_cast<T*>(words);
  }
  template <typename T>
  operator T&() const {
    return *static_cast<T*>(words);
  }
};
struct Position {
  operator uint() const { return point; }
  operator uint3() const { return uint3(point, 0u, 0u); }
};

}  // namespace detail
}  // namespace metal

// naga has these without metal::, too.
using metal::as_type;
using metal::uint2;

#define HN_UNDEFINED(name, operation)                                                       \
  extern "C" __attribute__((used, visibility("hidden"))) inline void __ubsan_handle_##name( \
      const metal::detail::Place* place, unsigned long, unsigned long) {                    \
    metal::detail::keep(place, operation);                                                  \
  }
HN_UNDEFINED(add_overflow, "a sum of ints that overflows")
HN_UNDEFINED(sub_overflow, "a difference of ints that overflows")
HN_UNDEFINED(mul_overflow, "a product of ints that overflows")
HN_UNDEFINED(divrem_overflow, "a quotient of ints that overflows")
HN_UNDEFINED(negate_overflow, "the negation of the least int")
HN_UNDEFINED(shift_out_of_bounds, "a shift to the left of an int that is negative or gets too large")
#undef HN_UNDEFINED
