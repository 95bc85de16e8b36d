// The doubles beneath own.hpp (rounded.cpp includes it in their namespace).

using Float = Rounded;
using Int = int;
using Uint = uint;

inline bool decided(bool answer) { return answer; }
inline std::int32_t whole(std::int64_t n) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(n, INT32_MIN, INT32_MAX));
}
inline std::int64_t selector(std::int64_t n) { return n; }
// The text jumps where this is 0, or where that is whole: the search walks there.
inline void tie(Rounded x) { singular.push_back(x.value); }
inline void tie_of_whole(Rounded x) { singular.push_back(x.value - std::nearbyint(x.value)); }

inline Rounded inverse_root(Rounded x) { return Rounded(1.0f) / sqrt(x); }
template <typename X>
int to_int(X x) {
  return static_cast<int>(x);
}
template <typename X>
uint to_uint(X x) {
  return static_cast<uint>(x);
}
inline uint bits_as_uint(Rounded x) { return std::bit_cast<uint>(static_cast<float>(x.value)); }
inline Rounded of_bits(uint bits) { return exactly(static_cast<double>(std::bit_cast<float>(bits))); }
// GLSL leaves quotients by 0 open. They must not stop the program.
template <typename Integer>
Integer quotient(Integer a, Integer b, bool rest) {
  const std::int64_t y = b == 0 ? 1 : std::int64_t{b};
  return static_cast<Integer>(rest ? a % y : a / y);
}
