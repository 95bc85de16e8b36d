// Draws the picture of the README with the C++ twin: noise, fBm, turbulence and clouds, side by side.
//   picture OUT.png            draws it
//   picture --check FILE.png   exit status 1 if the file shows another picture
// Exit status: 0 done, 1 another picture, 2 bad usage or a file that cannot be read or written.
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <hashnoise/hashnoise.hpp>
#include <vector>

namespace {

using hashnoise::vec2;
using hashnoise::vec3;

constexpr int kTile = 256;      // pixels along the side of a tile
constexpr int kBorder = 4;      // pixels between tiles
constexpr float kCells = 8.0f;  // lattice cells along the side of a tile

vec3 grey(float value) { return vec3(value); }
vec3 signed_grey(float value) { return grey(0.5f + 0.5f * value); }

// From a blue sky to white clouds.
vec3 sky(float density) { return vec3(0.25f, 0.45f, 0.78f) * (1.0f - density) + vec3(density); }

using Tile = vec3 (*)(vec2 p);
constexpr std::array<Tile, 4> kTiles = {
    [](vec2 p) { return signed_grey(hashnoise::hn_perlin(p)); },
    [](vec2 p) { return signed_grey(hashnoise::hn_fbm(p * 0.5f, 6, 2.0f, 0.5f)); },
    [](vec2 p) { return grey(hashnoise::hn_turbulence(p * 0.5f, 6, 2.0f, 0.5f) * 1.5f); },
    [](vec2 p) { return sky(hashnoise::hn_clouds(p * 0.4f, 7, 2.0f, 0.5f)); },
};

png_byte to_byte(float value) { return static_cast<png_byte>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); }

constexpr int kWidth = static_cast<int>(kTiles.size()) * (kTile + kBorder) - kBorder;

std::vector<png_byte> draw() {
  std::vector<png_byte> pixels(std::size_t{kWidth} * kTile * 3, 255);
  for (int tile = 0; tile < static_cast<int>(kTiles.size()); ++tile) {
    for (int y = 0; y < kTile; ++y) {
      for (int x = 0; x < kTile; ++x) {
        const vec2 p = vec2(static_cast<float>(x), static_cast<float>(y)) * (kCells / static_cast<float>(kTile));
        const vec3 colour = kTiles[static_cast<std::size_t>(tile)](p);
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
  std::fprintf(stderr, "picture: %s shows another picture; draw it again\n", path);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--check") == 0) return check(argv[2]);
  if (argc == 2) return write(argv[1]);
  std::fprintf(stderr, "usage: picture OUT.png, or picture --check FILE.png\n");
  return 2;
}
