// Prints what the functions of the library return at 2^18 random points within 4096 cells of the origin, a line each:
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

constexpr std::size_t kPoints = std::size_t{1} << 18;

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
  std::sort(values.begin(), values.end());
  const double mean = sum / kPoints;
  const float low = values[kPoints / 100];
  const float high = values[kPoints - 1 - kPoints / 100];
  std::printf("%s %d %.4f %.4f %.4f %.4f\n", name, axes, mean, std::sqrt(squares / kPoints - mean * mean),
              static_cast<double>(low), static_cast<double>(high));
}

float line(vec4 p) { return p.x; }
vec2 plane(vec4 p) { return vec2(p.x, p.y); }
vec3 space(vec4 p) { return vec3(p.x, p.y, p.z); }
vec4 all(vec4 p) { return p; }

// Of a vector one component stands for all.
float first(float value) { return value; }
float first(vec2 value) { return value.x; }
float first(vec3 value) { return value.x; }

}  // namespace

#define PRINT_AT(axes, place, name, ...) \
  print_typical(#name, axes, [](vec4 p) { return first(hashnoise::name(place(p) __VA_OPT__(, ) __VA_ARGS__)); })
#define PRINT(name, ...)                               \
  PRINT_AT(2, plane, name __VA_OPT__(, ) __VA_ARGS__); \
  PRINT_AT(3, space, name __VA_OPT__(, ) __VA_ARGS__)
#define PRINT_ALL(name, ...)                          \
  PRINT_AT(1, line, name __VA_OPT__(, ) __VA_ARGS__); \
  PRINT(name __VA_OPT__(, ) __VA_ARGS__);             \
  PRINT_AT(4, all, name __VA_OPT__(, ) __VA_ARGS__)

int main() {
  PRINT(hn_perlin);
  PRINT(hn_value);
  PRINT(hn_value_cubic);
  PRINT(hn_simplex);
  PRINT(hn_simplex_smooth);
  PRINT_ALL(hn_fbm, 6, 2.0f, 0.5f);
  PRINT_ALL(hn_turbulence, 6, 2.0f, 0.5f);
  PRINT_ALL(hn_billow, 6, 2.0f, 0.5f);
  PRINT_ALL(hn_clouds, 6, 2.0f, 0.5f);
  PRINT_ALL(hn_ridged, 6, 2.0f, 0.5f);
  PRINT_ALL(hn_ping_pong, 6, 2.0f, 0.5f, 2.0f);
  PRINT_ALL(hn_weighted, 6, 2.0f, 0.5f, 1.0f);
  PRINT(hn_eroded, 6, 2.0f, 0.5f, 1.0f);
  PRINT(hn_warp, 6, 2.0f, 0.5f, 1.0f);
  PRINT(hn_warp_progressive, 6, 2.0f, 0.5f, 1.0f);
}
