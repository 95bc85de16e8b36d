// How high the land of the examples' pictures is by the twin, and how thick the clouds of Bevy's are at the start: for
// each pixel, from the upper left, the word of a float.
//   heights vulkan|raylib|webgl|bevy|cuda [X Y]    one pixel alone, in decimals; else all, as they are in memory
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

static float of_bevy(int x, int y) {
  const hashnoise::vec2 uv((static_cast<float>(x) + 0.5f) / 1280.0f, (static_cast<float>(y) + 0.5f) / 720.0f);
  return hashnoise::hn_clouds(hashnoise::vec3(uv.x * 8.0f, uv.y * 4.5f, 0.0f), 6, 2.0f, 0.5f, 7u);
}

static float of_cuda(int x, int y) {
  return hashnoise::hn_fbm(hashnoise::vec2(hashnoise::ivec2(x, y)) / 128.0f, 6, 2.0f, 0.5f, 7u);
}

struct Picture {
  const char* name;
  float (*height)(int x, int y);
  int width, lines;
};
static constexpr Picture kPictures[] = {
    {"vulkan", of_vulkan, 640, 480}, {"raylib", of_raylib, 640, 480}, {"webgl", of_webgl, 640, 480},
    {"bevy", of_bevy, 1280, 720},    {"cuda", of_cuda, 640, 480},
};

int main(int count, char** arguments) {
  if (count != 2 && count != 4) return 2;
  for (const Picture& picture : kPictures) {
    if (std::strcmp(arguments[1], picture.name) != 0) continue;
    if (count == 4) {
      std::printf("%.6f\n", static_cast<double>(picture.height(std::atoi(arguments[2]), std::atoi(arguments[3]))));
      return 0;
    }
    std::vector<float> heights;
    for (int y = 0; y < picture.lines; ++y) {
      for (int x = 0; x < picture.width; ++x) heights.push_back(picture.height(x, y));
    }
    return std::fwrite(heights.data(), sizeof(float), heights.size(), stdout) == heights.size() ? 0 : 1;
  }
  return 2;
}
