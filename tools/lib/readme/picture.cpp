// Draws a picture of a page with the C++ twin: a tile for each line of tiles.inc, which picture.py makes of the page.
//   picture OUT.png            draws it
//   picture --check FILE.png   exit status 1 if the file shows another picture
// Exit status: 0 done, 1 another picture, 2 bad usage or a file that cannot be read or written.
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <hashnoise/hashnoise.hpp>
#include <iterator>
#include <vector>

namespace {

using hashnoise::vec2;
using hashnoise::vec3;

constexpr int kTile = 256;  // pixels along the side of a tile
constexpr int kBorder = 4;  // pixels between tiles

// GLSL's, which the library has no need of.
vec3 mix(vec3 from, vec3 to, float t) { return from * (1.0f - t) + to * t; }

using Tile = vec3 (*)(vec2 uv);
constexpr Tile kTiles[] = {
// A line may call a function that sets a cell and an offset, before a comma.
#define TILE(...)                 \
  [](vec2 uv) -> vec3 {           \
    using namespace hashnoise;    \
    [[maybe_unused]] ivec2 cell;  \
    [[maybe_unused]] vec2 offset; \
    return __VA_ARGS__;           \
  },
#include "tiles.inc"
};

png_byte to_byte(float value) { return static_cast<png_byte>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); }

constexpr int kWidth = static_cast<int>(std::size(kTiles)) * (kTile + kBorder) - kBorder;

std::vector<png_byte> draw() {
  std::vector<png_byte> pixels(std::size_t{kWidth} * kTile * 3, 255);
  for (int tile = 0; tile < static_cast<int>(std::size(kTiles)); ++tile) {
    for (int y = 0; y < kTile; ++y) {
      for (int x = 0; x < kTile; ++x) {
        // As a shader sees a square: the middle of the pixel, and y upwards.
        const vec2 uv = vec2(static_cast<float>(2 * x + 1), static_cast<float>(2 * (kTile - y) - 1)) * (0.5f / kTile);
        const vec3 colour = kTiles[static_cast<std::size_t>(tile)](uv);
        const int column = tile * (kTile + kBorder) + x;
        const auto at = (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(column)) * 3;
        pixels[at] = to_byte(colour.x);
        pixels[at + 1] = to_byte(colour.y);
        pixels[at + 2] = to_byte(colour.z);
      }
    }
  }
  return pixels;
}

png_image empty_image() {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  return image;
}

int write(const char* path) {
  png_image image = empty_image();
  image.width = kWidth;
  image.height = kTile;
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, path, 0, draw().data(), 0, nullptr)) return 0;
  std::fprintf(stderr, "picture: cannot write %s: %s\n", path, image.message);
  return 2;
}

int check(const char* path) {
  png_image image = empty_image();
  if (!png_image_begin_read_from_file(&image, path)) {
    std::fprintf(stderr, "picture: cannot read %s: %s\n", path, image.message);
    return 2;
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  if (pixels == draw()) return 0;
  std::fprintf(stderr, "picture: %s shows another picture; draw it again by tools/readme\n", path);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--check") == 0) return check(argv[2]);
  if (argc == 2) return write(argv[1]);
  std::fprintf(stderr, "usage: picture OUT.png, or picture --check FILE.png\n");
  return 2;
}
