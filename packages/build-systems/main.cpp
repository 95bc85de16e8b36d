// The game of the tests: it reads the name of a function and the words of its arguments from each line, and writes the
// word of the value.
#define HN_ARITHMETIC HN_FIXED
#include <bit>
#include <cstdint>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
#include <iostream>
#include <string>

namespace {

std::uint32_t word() {
  std::uint32_t read = 0;
  std::cin >> std::hex >> read;
  return read;
}

float number() { return std::bit_cast<float>(word()); }

}  // namespace

int main() {
  using namespace hashnoise;
  std::string function;
  while (std::cin >> function) {
    float value = 0.0f;
    if (function == "noise2d.perlin") {
      const float x = number(), y = number();
      value = hn_perlin(vec2(x, y), word());
    } else if (function == "noise3d.simplex") {
      const float x = number(), y = number(), z = number();
      value = hn_simplex(vec3(x, y, z), word());
    } else if (function == "fbm.fbm2") {
      const float x = number(), y = number();
      const int octaves = std::bit_cast<int>(word());
      const float lacunarity = number(), gain = number();
      value = hn_fbm(vec2(x, y), octaves, lacunarity, gain, word());
    } else {
      std::cerr << function << " is not known\n";
      return 1;
    }
    std::printf("%08x\n", std::bit_cast<std::uint32_t>(value));
  }
}
