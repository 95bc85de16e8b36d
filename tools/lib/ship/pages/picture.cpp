// Draws the pictures of pages with the C++ twin: the sheets of sheets.inc, whose tiles are lines of tiles.inc, which
// picture.py makes of the pages. They may call the functions of functions.inc.
//   picture            draws the files
//   picture --check    exit status 1 if a file shows another picture; of tiles above 256 pixels it compares a grid of
//                      256 by 256 pixels
// Exit status: 0 done, 1 another picture, 2 a file that cannot be read or written.
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "shading.hpp"

namespace hashnoise {
#include "functions.inc"
}

namespace {

using hashnoise::vec2;
using hashnoise::vec3;

constexpr int kCompared = 256;  // pixels along the side of a tile
constexpr int kBorder = 4;      // pixels between tiles

using Tile = vec3 (*)(vec2 uv);
constexpr Tile kTiles[] = {
// A line may call a function that sets the nearest cell and an offset, before a comma.
#define TILE(...)                   \
  [](vec2 uv) -> vec3 {             \
    using namespace hashnoise;      \
    [[maybe_unused]] ivec2 nearest; \
    [[maybe_unused]] vec2 offset;   \
    return __VA_ARGS__;             \
  },
#include "tiles.inc"
};

png_byte to_byte(float value) { return static_cast<png_byte>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); }

using Pixel = std::array<png_byte, 3>;

// Some of the tiles in rows.
struct Sheet {
  int columns() const { return std::min(static_cast<int>(tiles.size()), most); }
  int width() const { return columns() * (side + kBorder) - kBorder; }
  int height() const {
    return (static_cast<int>(tiles.size()) + columns() - 1) / columns() * (side + kBorder) - kBorder;
  }
  int step() const { return std::max(1, side / kCompared); }  // between the pixels that a check compares

  Pixel pixel(int x, int y) const {
    const int stride = side + kBorder;
    const std::size_t place = static_cast<std::size_t>(y / stride * columns() + x / stride);
    x %= stride;
    y %= stride;
    if (x >= side || y >= side || place >= tiles.size()) return {255, 255, 255};
    // As a shader sees a square: the middle of the pixel, and y upwards.
    const vec2 uv =
        vec2(static_cast<float>(2 * x + 1), static_cast<float>(2 * (side - y) - 1)) * (0.5f / static_cast<float>(side));
    const vec3 colour = tiles[place](uv);
    return {to_byte(colour.x), to_byte(colour.y), to_byte(colour.z)};
  }

  const char* path;
  int side;  // pixels of a tile
  int most;  // columns
  std::vector<Tile> tiles;
};

png_image empty_image() {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  return image;
}

int write(const Sheet& sheet) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < sheet.height(); ++y) {
    for (int x = 0; x < sheet.width(); ++x) pixels.push_back(sheet.pixel(x, y));
  }
  png_image image = empty_image();
  image.width = static_cast<png_uint_32>(sheet.width());
  image.height = static_cast<png_uint_32>(sheet.height());
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, sheet.path, 0, pixels.data(), 0, nullptr)) return 0;
  std::fprintf(stderr, "picture: cannot write %s: %s\n", sheet.path, image.message);
  return 2;
}

bool shows(const Sheet& sheet, const png_image& image, const std::vector<Pixel>& pixels) {
  if (static_cast<int>(image.width) != sheet.width() || static_cast<int>(image.height) != sheet.height()) return false;
  for (int y = 0; y < sheet.height(); y += sheet.step()) {
    for (int x = 0; x < sheet.width(); x += sheet.step()) {
      if (pixels[static_cast<std::size_t>(y * sheet.width() + x)] != sheet.pixel(x, y)) return false;
    }
  }
  return true;
}

int check(const Sheet& sheet) {
  png_image image = empty_image();
  if (!png_image_begin_read_from_file(&image, sheet.path)) {
    std::fprintf(stderr, "picture: cannot read %s: %s\n", sheet.path, image.message);
    return 2;
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<Pixel> pixels(PNG_IMAGE_SIZE(image) / sizeof(Pixel));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  if (shows(sheet, image, pixels)) return 0;
  std::fprintf(stderr, "picture: %s shows another picture; draw it again by tools/make pages\n", sheet.path);
  return 1;
}

}  // namespace

int main(int argc, char**) {
  const Sheet sheets[] = {
#include "sheets.inc"
  };
  int worst = 0;
  for (const Sheet& sheet : sheets) worst = std::max(worst, argc > 1 ? check(sheet) : write(sheet));
  return worst;
}
