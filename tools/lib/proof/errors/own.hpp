// GLSL of users beyond that of the library. lanes.cpp and rounded.cpp include it behind the library, each in its
// namespace, where a float is a number of theirs. cpp.py writes the text of the user so that it calls these.
#include "own_types.hpp"

// --- Built-in functions ---

template <typename A>
A own_floor(const A& a) {
  return each(
      [](const float& x) {
        tie_of_whole(x);
        return floor(x);
      },
      a);
}
template <typename A>
A own_ceil(const A& a) {
  return -own_floor(-a);
}
template <typename A>
A own_trunc(const A& a) {
  return each(
      [](const float& x) {
        tie_of_whole(x);
        return trunc(x);
      },
      a);
}
// GLSL leaves the direction of a half open.
template <typename A>
A own_round(const A& a) {
  return each(
      [](const float& x) {
        const float below = floor(x), rest = x - below;
        tie(rest - float(0.5_f));
        return below + float(rest >= float(0.5_f));
      },
      a);
}
template <typename A>
A own_fract(const A& a) {
  return a - own_floor(a);
}
template <typename A>
A own_abs(const A& a) {
  return each(
      [](const auto& x) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(x)>, float>) {
          return abs(x);
        } else {
          return max(x, -x);
        }
      },
      a);
}
template <typename A>
A own_sign(const A& a) {
  return each(
      [](const auto& x) {
        using X = std::remove_cvref_t<decltype(x)>;
        if constexpr (std::is_same_v<X, float>) tie(x);
        return X(x > X{}) - X(x < X{});
      },
      a);
}
template <typename A, typename B>
auto own_min(const A& a, const B& b) {
  return each([](const auto& x, const auto& y) { return min(x, y); }, a, b);
}
template <typename A, typename B>
auto own_max(const A& a, const B& b) {
  return each([](const auto& x, const auto& y) { return max(x, y); }, a, b);
}
template <typename A, typename B, typename C>
auto own_clamp(const A& x, const B& least, const C& most) {
  return own_min(own_max(x, least), most);
}
template <typename A, typename B, typename C>
auto own_mix(const A& a, const B& b, const C& c) {
  if constexpr (std::is_same_v<C, bool>) {
    return c ? Joined<A, B>(b) : Joined<A, B>(a);
  } else {
    return each([](const float& x, const float& y, const float& t) { return x * (float(1.0_f) - t) + y * t; }, a, b, c);
  }
}
template <typename A, typename B>
auto own_step(const A& edge, const B& a) {
  return each(
      [](const float& e, const float& x) {
        tie(x - e);
        return float(x >= e);
      },
      edge, a);
}
template <typename A, typename B, typename C>
auto own_smoothstep(const A& from, const B& to, const C& a) {
  return each(
      [](const float& e, const float& f, const float& x) {
        const float t = min(max((x - e) / (f - e), float(0.0_f)), float(1.0_f));
        return t * t * (float(3.0_f) - float(2.0_f) * t);
      },
      from, to, a);
}
template <typename A, typename B>
auto own_mod(const A& a, const B& b) {
  return each([](const float& x, const float& y) { return x - y * own_floor(x / y); }, a, b);
}
template <typename A>
A own_sqrt(const A& a) {
  return each([](const float& x) { return sqrt(x); }, a);
}
template <typename A>
A own_inversesqrt(const A& a) {
  return each([](const float& x) { return inverse_root(x); }, a);
}
template <typename A>
A own_radians(const A& a) {
  return a * float(0.017453292519943295_f);
}
template <typename A>
A own_degrees(const A& a) {
  return a * float(57.29577951308232_f);
}
template <typename A, typename B, typename C>
auto own_fma(const A& a, const B& b, const C& c) {
  return a * b + c;
}
template <typename A>
float own_dot(const A& a, const A& b) {
  if constexpr (kSize<A> == 1) {
    return a * b;
  } else {
    return Matrix<kSize<A>>::dot_of(a, b);
  }
}
template <typename A>
float own_length(const A& a) {
  if constexpr (kSize<A> == 1) {
    return abs(a);
  } else {
    return sqrt(own_dot(a, a));
  }
}
template <typename A>
float own_distance(const A& a, const A& b) {
  return own_length(a - b);
}
template <typename A>
A own_normalize(const A& a) {
  return a / own_length(a);
}
inline vec3 own_cross(const vec3& a, const vec3& b) {
  return vec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
}
template <typename A>
A own_reflect(const A& a, const A& n) {
  return a - float(2.0_f) * own_dot(n, a) * n;
}
template <typename A>
A own_faceforward(const A& n, const A& a, const A& by) {
  return compared<Less>(own_dot(by, a), float(0.0_f)) ? n : -n;
}
template <std::int32_t size>
Matrix<size> own_transpose(const Matrix<size>& m) {
  Matrix<size> other;
  for (std::int32_t i = 0; i < size; ++i) {
    for (std::int32_t k = 0; k < size; ++k) other.number(i, k) = m.number(k, i);
  }
  return other;
}
inline uint own_floatBitsToUint(const float& x) { return bits_as_uint(x); }
inline int own_floatBitsToInt(const float& x) { return bits_as_int(x); }
inline float own_uintBitsToFloat(const uint& bits) { return of_bits(bits); }
inline float own_intBitsToFloat(const int& bits) { return of_bits(uint(bits)); }

// --- Constructors ---

template <typename T>
auto own_int(const T& x) {
  if constexpr (std::is_same_v<T, float>) {
    tie_of_whole(x);
    return to_int(x);
  } else if constexpr (std::is_same_v<T, uint>) {
    return to_int(x);
  } else {
    return int(x);
  }
}
template <typename T>
auto own_uint(const T& x) {
  if constexpr (std::is_same_v<T, float>) {
    tie_of_whole(x);
    return to_uint(x);
  } else if constexpr (std::is_same_v<T, int>) {
    return to_uint(x);
  } else {
    return uint(x);
  }
}
template <typename T>
bool own_bool(const T& x) {
  if constexpr (std::is_same_v<T, bool>) {
    return x;
  } else {
    return !compared<Same>(x, T{});
  }
}

// --- The text ---

// Loops count their rounds: a program that does not end would be of no use.
constexpr std::uint32_t kRounds = 100000;
inline std::uint32_t rounds = 0;
inline bool another() {
  if (++rounds > kRounds) std::_Exit(3);  // program.py knows it
  return true;
}

struct File {
  std::uint32_t started = rounds = 0;
#include "own.inc"
};
