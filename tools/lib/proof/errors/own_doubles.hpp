// The doubles beneath own.hpp (rounded.cpp includes it in their namespace).

using Float = Rounded;
using Int = int;
using Uint = uint;

inline bool decided(bool answer) { return answer; }
inline std::int32_t whole(std::int64_t n) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(n, INT32_MIN, INT32_MAX));
}
// The text jumps where this is 0, or where that is whole: the search walks there.
inline void tie(Rounded x) { singular.push_back(x.value); }
inline void tie_of_whole(Rounded x) { singular.push_back(x.value - std::nearbyint(x.value)); }

inline Rounded inverse_root(Rounded x) { return Rounded(1.0f) / sqrt(x); }
inline int to_int(Rounded x) { return static_cast<int>(x); }
inline int to_int(uint n) { return static_cast<int>(n); }
inline uint to_uint(Rounded x) { return static_cast<uint>(x); }
inline uint to_uint(int n) { return static_cast<uint>(n); }
inline int bits_as_int(Rounded x) { return std::bit_cast<int>(static_cast<float>(x.value)); }
inline uint bits_as_uint(Rounded x) { return std::bit_cast<uint>(static_cast<float>(x.value)); }
inline Rounded of_bits(uint bits) { return exactly(static_cast<double>(std::bit_cast<float>(bits))); }

// GLSL leaves quotients by 0 open. They must not stop the program.
template <typename Integer>
struct Divisor {
  Integer n;
  friend Integer operator/(Integer a, Divisor b) { return static_cast<Integer>(std::int64_t{a} / b.n); }
  friend Integer operator%(Integer a, Divisor b) { return static_cast<Integer>(std::int64_t{a} % b.n); }
  friend Rounded operator/(Rounded a, Divisor b) { return a / Rounded(b.n); }
  template <typename Vector>
  requires(::hashnoise::detail::kComponents<Vector> > 1) friend Vector operator/(Vector a, Divisor b) {
    return a / Vector(b.n);
  }
  template <typename Vector>
  requires(::hashnoise::detail::kComponents<Vector> > 1) friend Vector operator%(Vector a, Divisor b) {
    constexpr auto size = ::hashnoise::detail::kComponents<Vector>;
    a.x = a.x % b, a.y = a.y % b;
    if constexpr (size > 2) a.z = a.z % b;
    if constexpr (size > 3) a.w = a.w % b;
    return a;
  }
};
inline int one_for_zero(int n) { return n == 0 ? 1 : n; }
inline uint one_for_zero(uint n) { return n == 0u ? 1u : n; }
template <typename T>
Vector2<T> one_for_zero(Vector2<T> v) {
  return {one_for_zero(v.x), one_for_zero(v.y)};
}
template <typename T>
Vector3<T> one_for_zero(Vector3<T> v) {
  return {one_for_zero(v.x), one_for_zero(v.y), one_for_zero(v.z)};
}
template <typename T>
Vector4<T> one_for_zero(Vector4<T> v) {
  return {one_for_zero(v.x), one_for_zero(v.y), one_for_zero(v.z), one_for_zero(v.w)};
}
template <typename T>
T divisor(T x) {
  if constexpr (::hashnoise::detail::kComponents < T >> 1) {
    if constexpr (std::is_integral_v<decltype(x.x)>) return one_for_zero(x);
  }
  return x;
}
inline Divisor<int> divisor(int n) { return {one_for_zero(n)}; }
inline Divisor<uint> divisor(uint n) { return {one_for_zero(n)}; }
template <typename T, typename Integer>
T& operator/=(T& a, Divisor<Integer> b) {
  return a = a / b;
}
template <typename T, typename Integer>
T& operator%=(T& a, Divisor<Integer> b) {
  return a = a % b;
}
