// How high the land of the examples' pictures is by the twin: for each pixel, from the upper left, the word of a float.
//   heights vulkan|raylib|webgl [X Y]    one pixel alone, in decimals; else all, as they are in memory
#define HN_ARITHMETIC HN_FIXED
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <hashnoise/hashnoise.hpp>
#include <vector>

namespace hashnoise {
#include "vulkan/height.glsl"
}

static float of_vulkan(int x, int y) { return hashnoise::height(hashnoise::ivec2(x, y)); }

static float of_raylib(int x, int y) {  // in OpenGL y goes up, and the middle of a pixel is at a half
  const float up = static_cast<float>(479 - y) + 0.5f;
  return hashnoise::hn_fbm_d(hashnoise::vec2(static_cast<float>(x) + 0.5f, up) / 128.0f, 6, 2.0f, 0.5f, 1u).x;
}

static float of_webgl(int x, int y) {
  const hashnoise::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(479 - y) + 0.5f);
  return hashnoise::hn_fbm(middle / 64.0f, 6, 2.0f, 0.5f, 7u);
}

int main(int count, char** arguments) {
  if (count != 2 && count != 4) return 2;
  const auto named = [&](const char* name) { return std::strcmp(arguments[1], name) == 0; };
  const auto height = named("vulkan") ? of_vulkan : named("webgl") ? of_webgl : of_raylib;
  if (count == 4) {
    std::printf("%.6f\n", static_cast<double>(height(std::atoi(arguments[2]), std::atoi(arguments[3]))));
    return 0;
  }
  std::vector<float> heights;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) heights.push_back(height(x, y));
  }
  return std::fwrite(heights.data(), sizeof(float), heights.size(), stdout) == heights.size() ? 0 : 1;
}
