// The operations of SPIR-V, by their names without the types of operands, on the numbers of lanes.cpp or of
// rounded.cpp: both include this in their namespace. spirv.py writes the functions of a user so that they call these. A
// condition is a bool: where lanes decide otherwise, each goes its own way.

// --- Vectors ---

template <typename V>
constexpr std::int32_t kSize = ::hashnoise::detail::kComponents<V>;

template <typename T, std::int32_t size>
auto vector_type() {
  if constexpr (size == 2) {
    return ::hashnoise::Vector2<T>{};
  } else if constexpr (size == 3) {
    return ::hashnoise::Vector3<T>{};
  } else {
    return ::hashnoise::Vector4<T>{};
  }
}
template <typename T, std::int32_t size>
using VectorType = decltype(vector_type<T, size>());
template <typename T, std::int32_t size>
struct Array {  // or a matrix, of columns
  T element[static_cast<std::size_t>(size)]{};
};

template <typename V>
auto& component(V& v, std::int32_t i) {
  constexpr std::int32_t size = kSize<std::remove_const_t<V>>;
  if constexpr (size == 1) {
    return v;
  } else {
    if (i == 0) return v.x;
    if constexpr (size > 2) {
      if (i == 2) return v.z;
    }
    if constexpr (size > 3) {
      if (i == 3) return v.w;
    }
    return v.y;
  }
}
// f of the components of each.
template <typename F, typename A, typename... B>
auto each(const F& f, const A& a, const B&... b) {
  if constexpr (kSize<A> == 1) {
    return f(a, b...);
  } else {
    VectorType<decltype(f(a.x, b.x...)), kSize<A>> made;
    for (std::int32_t i = 0; i < kSize<A>; ++i) component(made, i) = f(component(a, i), component(b, i)...);
    return made;
  }
}
template <typename V>
using Part = std::remove_cvref_t<decltype(component(std::declval<V&>(), 0))>;

// A component, an element or a column, by an index of the leader's lane. One beyond the ends counts as the end.
template <typename V, typename I>
auto& at(V& v, const I& i) {
  if constexpr (requires { v.element; }) {
    return v.element[std::clamp<std::int32_t>(whole(i), 0, static_cast<std::int32_t>(std::size(v.element)) - 1)];
  } else {
    return component(v, std::clamp<std::int32_t>(whole(i), 0, kSize<std::remove_const_t<V>> - 1));
  }
}
template <std::int32_t... i, typename A, typename B>
auto shuffled(const A& a, const B& b) {
  const auto of = [&](std::int32_t n) { return n < kSize<A> ? component(a, n) : component(b, n - kSize<A>); };
  return VectorType<Part<A>, sizeof...(i)>(of(i)...);
}

// --- Operations ---

#define OPERATION_1(Name, code)                         \
  template <typename A>                                 \
  auto Name(const A& a) {                               \
    return each([](const auto& x) { return code; }, a); \
  }
#define OPERATION_2(Name, code)                                           \
  template <typename A, typename B>                                       \
  auto Name(const A& a, const B& b) {                                     \
    return each([](const auto& x, const auto& y) { return code; }, a, b); \
  }
#define OPERATION_3(Name, code)                                                             \
  template <typename A, typename B, typename C>                                             \
  auto Name(const A& a, const B& b, const C& c) {                                           \
    return each([](const auto& x, const auto& y, const auto& z) { return code; }, a, b, c); \
  }
template <typename X>
X whole_below(const X& x) {
  tie_of_whole(x);
  return floor(x);
}
template <typename X>
constexpr bool kIsFloat = std::is_same_v<X, Float>;
template <typename X>
X divided(const X& x, const X& y) {
  if constexpr (kIsFloat<X>) {
    return x / y;
  } else {
    return quotient(x, y, false);
  }
}
template <typename X>
X rest(const X& x, const X& y) {
  if constexpr (kIsFloat<X>) {
    return x - y * whole_below(x / y);
  } else {
    return quotient(x, y, true);  // GLSL leaves that of a number below 0 open
  }
}
// Where both are the same it jumps.
template <typename X>
const X& tied(const X& x, const X& y) {
  if constexpr (kIsFloat<X>) tie(x - y);
  return x;
}
OPERATION_2(Add, x + y)
OPERATION_2(Sub, x - y)
OPERATION_2(Mul, x* y)
OPERATION_2(Div, divided(x, y))
OPERATION_2(Mod, rest(x, y))
OPERATION_1(Negate, -x)
OPERATION_1(Not, ~x)
OPERATION_2(BitwiseAnd, x& y)
OPERATION_2(BitwiseOr, x | y)
OPERATION_2(BitwiseXor, x ^ y)
OPERATION_2(ShiftLeftLogical, x << std::remove_cvref_t<decltype(x)>(y))
OPERATION_2(ShiftRightLogical, x >> std::remove_cvref_t<decltype(x)>(y))
OPERATION_2(ShiftRightArithmetic, x >> std::remove_cvref_t<decltype(x)>(y))
OPERATION_2(LogicalAnd, x&& y)
OPERATION_2(LogicalOr, x || y)
OPERATION_1(LogicalNot, !x)
OPERATION_2(LogicalEqual, x == y)
OPERATION_2(LogicalNotEqual, x != y)
OPERATION_2(Equal, decided(tied(x, y) == y))
OPERATION_2(NotEqual, decided(tied(x, y) != y))
OPERATION_2(LessThan, decided(tied(x, y) < y))
OPERATION_2(LessThanEqual, decided(tied(x, y) <= y))
OPERATION_2(GreaterThan, decided(tied(x, y) > y))
OPERATION_2(GreaterThanEqual, decided(tied(x, y) >= y))
template <typename C, typename A>
A Select(const C& c, const A& a, const A& b) {
  if constexpr (kSize<C> == 1) {
    return c ? a : b;
  } else {
    return each([](bool which, const auto& x, const auto& y) { return which ? x : y; }, c, a, b);
  }
}
template <typename V>
bool All(const V& v) {
  bool all = true;
  for (std::int32_t i = 0; i < kSize<V>; ++i) all = all && component(v, i);
  return all;
}
template <typename V>
bool Any(const V& v) {
  return !All(LogicalNot(v));
}

// --- Conversions ---

template <typename To, typename X>
To converted_number(const X& x) {
  if constexpr (std::is_same_v<To, X> || std::is_same_v<To, Float>) {
    return To(x);
  } else {
    if constexpr (std::is_same_v<X, Float>) tie_of_whole(x);
    if constexpr (std::is_same_v<To, Int>) {
      return to_int(x);
    } else {
      return to_uint(x);
    }
  }
}
template <typename To, typename A>
To converted(const A& a) {
  if constexpr (std::is_same_v<To, A>) {
    return a;
  } else {
    return each([](const auto& x) { return converted_number<Part<To>>(x); }, a);
  }
}
template <typename To, typename X>
To bits_of_number(const X& x) {
  if constexpr (std::is_same_v<To, Float>) {
    return of_bits(Uint(x));
  } else if constexpr (std::is_same_v<X, Float>) {
    return To(bits_as_uint(x));
  } else {
    return To(x);
  }
}
template <typename To, typename A>
To bits(const A& a) {
  return each([](const auto& x) { return bits_of_number<Part<To>>(x); }, a);
}

// --- Functions of numbers ---

template <typename X>
X sign_of(const X& x) {
  if constexpr (kIsFloat<X>) tie(x);
  return X(x > X{}) - X(x < X{});
}
inline Float at_edge(const Float& e, const Float& x) {
  tie(x - e);
  return Float(x >= e);
}
// GLSL leaves the direction of a half open.
inline Float rounded_number(const Float& x) {
  const Float below = floor(x), half = 0.5_f;
  return below + at_edge(half, x - below);
}
inline Float smooth_step(const Float& e, const Float& f, const Float& x) {
  const Float zero = 0.0_f, one = 1.0_f, two = 2.0_f, three = 3.0_f;
  const Float t = min(max((x - e) / (f - e), zero), one);
  return t * t * (three - two * t);
}
OPERATION_1(Floor, whole_below(x))
OPERATION_1(Ceil, -whole_below(-x))
OPERATION_1(Trunc, (tie_of_whole(x), trunc(x)))
OPERATION_1(Round, rounded_number(x))
OPERATION_1(RoundEven, rounded_number(x))
OPERATION_1(Fract, x - whole_below(x))
OPERATION_1(Abs, max(x, -x))
OPERATION_1(Sign, sign_of(x))
OPERATION_1(Radians, x* Float(0.017453292519943295_f))
OPERATION_1(Degrees, x* Float(57.29577951308232_f))
OPERATION_1(Sqrt, sqrt(x))
OPERATION_1(InverseSqrt, inverse_root(x))
OPERATION_2(Min, min(x, y))
OPERATION_2(Max, max(x, y))
OPERATION_3(Clamp, min(max(x, y), z))
OPERATION_3(Mix, x*(Float(1.0_f) - z) + y * z)
OPERATION_3(Fma, x* y + z)
OPERATION_2(Step, at_edge(x, y))
OPERATION_3(SmoothStep, smooth_step(x, y, z))

// --- Vectors and matrices ---

template <typename V>
Float Dot(const V& a, const V& b) {
  Float sum = component(a, 0) * component(b, 0);
  for (std::int32_t i = 1; i < kSize<V>; ++i) sum += component(a, i) * component(b, i);
  return sum;
}
template <typename V>
V VectorTimesScalar(const V& v, const Float& s) {
  return each([&](const Float& x) { return x * s; }, v);
}
template <typename V>
Float Length(const V& v) {
  if constexpr (kSize<V> == 1) {
    return abs(v);
  } else {
    return sqrt(Dot(v, v));
  }
}
template <typename V>
Float Distance(const V& a, const V& b) {
  return Length(Sub(a, b));
}
template <typename V>
V Normalize(const V& v) {
  const Float length = Length(v);
  return each([&](const Float& x) { return x / length; }, v);
}
template <typename V>
V Cross(const V& a, const V& b) {
  return V(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
}
template <typename V>
V Reflect(const V& a, const V& n) {
  return Sub(a, VectorTimesScalar(n, Float(2.0_f) * Dot(n, a)));
}
template <typename V>
V FaceForward(const V& n, const V& a, const V& by) {
  const Float zero = 0.0_f;
  return LessThan(Dot(by, a), zero) ? n : Negate(n);
}
template <typename F, typename V, std::int32_t size>
auto of_columns(const F& f, const Array<V, size>& m) {
  Array<decltype(f(m.element[0])), size> made;
  for (std::int32_t i = 0; i < size; ++i) made.element[i] = f(m.element[i]);
  return made;
}
template <typename V, std::int32_t size>
auto MatrixTimesScalar(const Array<V, size>& m, const Float& s) {
  return of_columns([&](const V& column) { return VectorTimesScalar(column, s); }, m);
}
template <typename V, std::int32_t size, typename U>
V MatrixTimesVector(const Array<V, size>& m, const U& v) {
  V sum = VectorTimesScalar(m.element[0], component(v, 0));
  for (std::int32_t i = 1; i < size; ++i) sum = Add(sum, VectorTimesScalar(m.element[i], component(v, i)));
  return sum;
}
template <typename V, std::int32_t size>
auto VectorTimesMatrix(const V& v, const Array<V, size>& m) {
  VectorType<Float, size> made;
  for (std::int32_t i = 0; i < size; ++i) component(made, i) = Dot(v, m.element[i]);
  return made;
}
template <typename M, typename V, std::int32_t size>
auto MatrixTimesMatrix(const M& m, const Array<V, size>& other) {
  return of_columns([&](const V& column) { return MatrixTimesVector(m, column); }, other);
}
template <typename V, std::int32_t size>
auto Transpose(const Array<V, size>& m) {
  Array<VectorType<Float, size>, kSize<V>> made;
  for (std::int32_t i = 0; i < kSize<V>; ++i) {
    for (std::int32_t k = 0; k < size; ++k) component(made.element[i], k) = component(m.element[k], i);
  }
  return made;
}
template <typename V, typename U>
auto OuterProduct(const V& a, const U& b) {
  Array<V, kSize<U>> made;
  for (std::int32_t i = 0; i < kSize<U>; ++i) made.element[i] = VectorTimesScalar(a, component(b, i));
  return made;
}

// --- The text ---

// Loops count their rounds: a program that does not end would be of no use.
constexpr std::uint32_t kRounds = 100000;
inline std::uint32_t rounds = 0;
inline void another() {
  if (++rounds > kRounds) std::_Exit(3);  // program.py knows it
}

struct File {
#include "own.inc"
};
