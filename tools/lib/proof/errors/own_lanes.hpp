// The lanes beneath own.hpp (lanes.cpp includes it in their namespace).

// To the nearest: while the lanes run the processor rounds down.
consteval float operator""_f(long double x) { return static_cast<float>(x); }

inline bool decided(Mask mask) { return static_cast<bool>(mask); }
inline std::int32_t whole(std::int32_t n) { return n; }
inline std::int32_t whole(Int n) { return hn::roundings::leader.chosen(n.v); }
inline std::int32_t whole(Uint n) { return whole(Int(n)); }
inline std::int64_t selector(Int n) { return whole(n); }
inline std::int64_t selector(Uint n) { return static_cast<std::uint32_t>(whole(n)); }
inline void tie(const Float&) {}  // only the text in doubles keeps where it may jump
inline void tie_of_whole(const Float&) {}

inline Float inverse_root(const Float& x) { return inversesqrt(x); }
inline Int to_int(const Float& x) { return ::hashnoise::detail::convert<Int>(x); }
inline Int to_int(Uint n) { return Int(n); }
inline Uint to_uint(const Float& x) { return Uint(x); }
inline Uint to_uint(Int n) { return Uint(n); }
inline Uint bits_as_uint(const Float& x) { return floatBitsToUint(x); }
inline Float of_bits(Uint bits) { return uintBitsToFloat(bits); }

inline Int operator~(Int n) { return Int(~n.v); }
inline Uint operator~(Uint n) { return Uint(~n.v); }
// GLSL leaves quotients by 0 open. They must not stop the program.
template <typename Integer>
Integer quotient(Integer a, const Integer& b, bool rest) {
  for (int i = 0; i < kCount; ++i) {
    const std::int64_t x = a.v[i], y = b.v[i] == 0 ? 1 : std::int64_t{b.v[i]};
    a.v[i] = static_cast<std::remove_cvref_t<decltype(a[0])>>(rest ? x % y : x / y);
  }
  return a;
}
