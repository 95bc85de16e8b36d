// Prints the values of the library's functions at 2^16 random points within 4096 cells of the origin, a line each:
// its name, the axes, then mean, deviation, and the values below which 1 and 99 of 100 lie.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
#include <random>
#include <vector>

namespace {

using hashnoise::vec2;
using hashnoise::vec3;
using hashnoise::vec4;

constexpr std::size_t kPoints = std::size_t{1} << 16;

template <typename Noise>
void print_typical(const char* name, int axes, Noise noise) {
  std::mt19937 random(1);
  // Not std::uniform_real_distribution, whose values each standard library chooses.
  const auto coordinate = [&] { return static_cast<float>(random()) * (8192.0f / 4294967296.0f) - 4096.0f; };
  std::vector<float> values(kPoints);
  double sum = 0.0;
  double squares = 0.0;
  for (float& value : values) {
    const float x = coordinate();
    const float y = coordinate();
    const float z = coordinate();
    value = noise(axes < 4 ? vec4(x, y, z, 0.0f) : vec4(x, y, z, coordinate()));
    sum += static_cast<double>(value);
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  const double mean = sum / kPoints;
  const auto low = values.begin() + kPoints / 100;
  const auto high = values.end() - 1 - kPoints / 100;
  std::nth_element(values.begin(), low, values.end());
  std::nth_element(low + 1, high, values.end());  // none before is larger than the low one
  std::printf("%s %d %.4f %.4f %.4f %.4f\n", name, axes, mean, std::sqrt(squares / kPoints - mean * mean),
              static_cast<double>(*low), static_cast<double>(*high));
}

// One component of a vector stands for all.
float first(float value) { return value; }
template <typename Vector>
auto first(const Vector& value) -> decltype(value.x) {
  return value.x;
}

// At the dimensions that a function has.
template <typename Noise>
void print_in(const char* name, int first_dimension, int last_dimension, Noise noise) {
  const auto has = [&](int axes) { return first_dimension <= axes && axes <= last_dimension; };
  if constexpr (requires { first(noise(1.0f)); }) {
    if (has(1)) print_typical(name, 1, [&](vec4 p) { return first(noise(p.x)); });
  }
  if constexpr (requires { first(noise(vec2())); }) {
    if (has(2)) print_typical(name, 2, [&](vec4 p) { return first(noise(vec2(p.x, p.y))); });
  }
  if constexpr (requires { first(noise(vec3())); }) {
    if (has(3)) print_typical(name, 3, [&](vec4 p) { return first(noise(vec3(p.x, p.y, p.z))); });
  }
  if constexpr (requires { first(noise(vec4())); }) {
    if (has(4)) print_typical(name, 4, [&](vec4 p) { return first(noise(p)); });
  }
}

}  // namespace

// A call that is no function in some dimensions.
#define CALL(name, ...)                                                        \
  [](auto p) -> decltype(hashnoise::hn_##name(p __VA_OPT__(, ) __VA_ARGS__)) { \
    return hashnoise::hn_##name(p __VA_OPT__(, ) __VA_ARGS__);                 \
  }
// With the usual settings; sums by what their strength is called.
#define HN_CATALOG_NOISE(Id, name, ...) print_in("hn_" #name, 2, 3, CALL(name));
#define STRENGTH_none(usual)
#define STRENGTH_strength(usual) , usual, 0u
#define STRENGTH_amplitude(usual) , usual, 0u
#define HN_CATALOG_SUM(Id, name, begin, end, shape, of, noise, strength, usual, ...) \
  print_in("hn_" #name, begin, end, CALL(name, 6, 2.0f, 0.5f STRENGTH_##strength(usual##.0f)));

int main() {
#include "../../../../src/grid/catalog.inc"
}
