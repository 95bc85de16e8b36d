// Prints a digest of what the C++ twin computes at many points, a line per function. twin_flags_test.py compiles it
// with many flags, of which some let a compiler make of floats what it likes: so nothing here but the twin computes in
// them.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>

namespace {

using namespace hashnoise;

constexpr int kPoints = 1 << 15;  // of each function

// SplitMix64
std::uint64_t state = 1;
uint word() {
  state += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return static_cast<uint>((z ^ (z >> 31)) >> 32);
}

// Of either sign, with a biased exponent from low to high: 0 is subnormal, 254 huge.
float number(uint low, uint high) {
  const uint exponent = low + word() % (high - low + 1);
  return std::bit_cast<float>((exponent << 23) | (word() & 0x807FFFFFu));
}

float coordinate() {
  switch (word() % 6) {
    case 0:
      return number(0, 254);
    case 1:
      return number(0, 0);
    case 2:
      return number(90, 126);  // from 2^-37 to 1
    case 3:
      return std::bit_cast<float>(word() & 0x80000000u);  // 0 and -0
    default:
      return number(127, 152);  // from 1 to 2^26
  }
}

// In [0, 1], or anywhere.
float fraction() { return word() % 4 == 0 ? coordinate() : std::bit_cast<float>(word() % 0x3F800001u); }

vec2 position2() {
  const float x = coordinate();
  return {x, coordinate()};
}
vec3 position3() {
  const float x = coordinate();
  const float y = coordinate();
  return {x, y, coordinate()};
}
ivec2 cell2() {
  const int x = static_cast<int>(word());
  return {x, static_cast<int>(word())};
}
ivec3 cell3() {
  const int x = static_cast<int>(word());
  const int y = static_cast<int>(word());
  return {x, y, static_cast<int>(word())};
}

struct Settings {
  int octaves;
  float lacunarity;
  float gain;
};
Settings settings() {
  const int octaves = static_cast<int>(word() % 8) - 1;
  const float lacunarity = word() % 2 == 0 ? 2.0f : number(120, 135);
  return {octaves, lacunarity, word() % 2 == 0 ? 0.5f : number(110, 128)};
}

uint bits(float value) { return std::bit_cast<uint>(value); }
uint bits(vec2 v) { return bits(v.x) * 31u + bits(v.y); }
uint bits(vec3 v) { return (bits(v.x) * 31u + bits(v.y)) * 31u + bits(v.z); }

template <typename Evaluate>
void digest(const char* name, Evaluate evaluate) {
  std::uint64_t hash = 14695981039346656037u;
  for (int i = 0; i < kPoints; ++i) hash = (hash ^ bits(evaluate())) * 1099511628211u;
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(hash));
}

template <typename Position>
void digest_sums(const char* fbm, const char* turbulence, const char* clouds, Position position) {
  digest(fbm, [=] {
    const auto p = position();
    const auto [octaves, lacunarity, gain] = settings();
    return hn_fbm(p, octaves, lacunarity, gain, word());
  });
  digest(turbulence, [=] {
    const auto p = position();
    const auto [octaves, lacunarity, gain] = settings();
    return hn_turbulence(p, octaves, lacunarity, gain, word());
  });
  digest(clouds, [=] {
    const auto p = position();
    const auto [octaves, lacunarity, gain] = settings();
    return hn_clouds(p, octaves, lacunarity, gain, word());
  });
}

}  // namespace

int main() {
#ifdef HN_TEST_OVERFLOW
  std::printf("%d\n", static_cast<int>(word() >> 1) * static_cast<int>(word() >> 1));
#endif
  digest("gradient2", [] {
    const ivec2 cell = cell2();
    return hn_gradient(cell, word());
  });
  digest("gradient3", [] {
    const ivec3 cell = cell3();
    return hn_gradient(cell, word());
  });
  digest("perlin2", [] {
    const vec2 p = position2();
    return hn_perlin(p, word());
  });
  digest("perlin3", [] {
    const vec3 p = position3();
    return hn_perlin(p, word());
  });
  digest("perlin_cell2", [] {
    const ivec2 cell = cell2();
    const float x = fraction();
    const float y = fraction();
    return hn_perlin(cell, vec2(x, y), word());
  });
  digest("perlin_cell3", [] {
    const ivec3 cell = cell3();
    const float x = fraction();
    const float y = fraction();
    const float z = fraction();
    return hn_perlin(cell, vec3(x, y, z), word());
  });
  digest_sums("fbm2", "turbulence2", "clouds2", position2);
  digest_sums("fbm3", "turbulence3", "clouds3", position3);
}
