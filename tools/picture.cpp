// Draws the picture of the README with the C++ twin: noise, fBm, turbulence and clouds, side by side.
//   picture OUT.png        exit status 0, 2 if the file cannot be written
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdio>
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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: picture OUT.png\n");
    return 2;
  }
  constexpr int kWidth = static_cast<int>(kTiles.size()) * (kTile + kBorder) - kBorder;
  std::vector<png_byte> pixels(std::size_t{kWidth} * kTile * 3, 255);
  for (int tile = 0; tile < static_cast<int>(kTiles.size()); ++tile) {
    for (int y = 0; y < kTile; ++y) {
      for (int x = 0; x < kTile; ++x) {
        const vec2 p = vec2(static_cast<float>(x), static_cast<float>(y)) * (kCells / static_cast<float>(kTile));
        const vec3 colour = kTiles[static_cast<std::size_t>(tile)](p);
        const auto at =
            (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(tile * (kTile + kBorder) + x)) * 3;
        pixels[at] = to_byte(colour.x);
        pixels[at + 1] = to_byte(colour.y);
        pixels[at + 2] = to_byte(colour.z);
      }
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = kWidth;
  image.height = kTile;
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, argv[1], 0, pixels.data(), 0, nullptr)) return 0;
  std::fprintf(stderr, "picture: cannot write %s: %s\n", argv[1], image.message);
  return 2;
}
