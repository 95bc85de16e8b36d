// Draws the pictures of pages with the C++ twin: of the lines of tiles.inc, which picture.py makes of the pages, each
// is a tile. They may call the functions of functions.inc.
//   picture (FILE.png SIDE COLUMNS TILE,TILE...)...          draws files, each of these tiles, COLUMNS of them in a
//   row;
//                                                            a tile has SIDE by SIDE pixels
//   picture --check (FILE.png SIDE COLUMNS TILE,TILE...)...  exit status 1 if a file shows another picture; of tiles
//                                                            above 256 pixels it compares a grid of 256 by 256 pixels
// Exit status: 0 done, 1 another picture, 2 bad usage or a file that cannot be read or written.
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
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
  Sheet(int side_of_tile, int most_columns, const char* numbers) : side(side_of_tile), most(most_columns) {
    std::istringstream words(numbers);
    for (std::string word; std::getline(words, word, ',');) tiles.push_back(std::stoul(word));
  }

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
    const vec3 colour = kTiles[tiles[place]](uv);
    return {to_byte(colour.x), to_byte(colour.y), to_byte(colour.z)};
  }

  std::vector<std::size_t> tiles;
  int side;  // pixels of a tile
  int most;
};

png_image empty_image() {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  return image;
}

int write(const Sheet& sheet, const char* path) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < sheet.height(); ++y) {
    for (int x = 0; x < sheet.width(); ++x) pixels.push_back(sheet.pixel(x, y));
  }
  png_image image = empty_image();
  image.width = static_cast<png_uint_32>(sheet.width());
  image.height = static_cast<png_uint_32>(sheet.height());
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, path, 0, pixels.data(), 0, nullptr)) return 0;
  std::fprintf(stderr, "picture: cannot write %s: %s\n", path, image.message);
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

int check(const Sheet& sheet, const char* path) {
  png_image image = empty_image();
  if (!png_image_begin_read_from_file(&image, path)) {
    std::fprintf(stderr, "picture: cannot read %s: %s\n", path, image.message);
    return 2;
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<Pixel> pixels(PNG_IMAGE_SIZE(image) / sizeof(Pixel));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  if (shows(sheet, image, pixels)) return 0;
  std::fprintf(stderr, "picture: %s shows another picture; draw it again by tools/make pages\n", path);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool checks = argc > 1 && std::strcmp(argv[1], "--check") == 0;
  const int first = checks ? 2 : 1;
  if (argc == first || (argc - first) % 4 != 0) {
    std::fprintf(stderr, "usage: picture [--check] (FILE.png SIDE COLUMNS TILE,TILE...)...\n");
    return 2;
  }
  int worst = 0;
  for (int i = first; i < argc; i += 4) {
    const Sheet sheet(std::atoi(argv[i + 1]), std::atoi(argv[i + 2]), argv[i + 3]);
    worst = std::max(worst, checks ? check(sheet, argv[i]) : write(sheet, argv[i]));
  }
  return worst;
}
