// Draws the pictures of pages with the C++ twin: of the lines of tiles.inc, which picture.py makes of the pages, each
// is a tile. They may call what is in functions.inc.
//   picture (FILE.png COLUMNS TILE,TILE...)...           draws files, each of these tiles, COLUMNS of them in a row
//   picture --check (FILE.png COLUMNS TILE,TILE...)...   exit status 1 if a file shows another picture
// Exit status: 0 done, 1 another picture, 2 bad usage or a file that cannot be read or written.
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "shading.hpp"
#include "simulated_erosion.hpp"

namespace hashnoise {
#include "functions.inc"
}

namespace {

using hashnoise::vec2;
using hashnoise::vec3;

constexpr int kTile = 256;  // pixels along the side of a tile
constexpr int kBorder = 4;  // pixels between tiles

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

// Some of the tiles in rows.
struct Sheet {
  Sheet(int most_columns, const char* numbers) : most(most_columns) {
    std::istringstream words(numbers);
    for (std::string word; std::getline(words, word, ',');) tiles.push_back(std::stoul(word));
  }

  int columns() const { return std::min(static_cast<int>(tiles.size()), most); }
  int width() const { return columns() * (kTile + kBorder) - kBorder; }
  int height() const {
    return (static_cast<int>(tiles.size()) + columns() - 1) / columns() * (kTile + kBorder) - kBorder;
  }

  std::vector<std::size_t> tiles;
  int most;
};

// The pixels of a tile, which several sheets may show.
const std::vector<png_byte>& pixels_of(std::size_t tile) {
  static std::vector<std::vector<png_byte>> known(std::size(kTiles));
  std::vector<png_byte>& pixels = known[tile];
  if (!pixels.empty()) return pixels;
  for (int y = 0; y < kTile; ++y) {
    for (int x = 0; x < kTile; ++x) {
      // As a shader sees a square: the middle of the pixel, and y upwards.
      const vec2 uv = vec2(static_cast<float>(2 * x + 1), static_cast<float>(2 * (kTile - y) - 1)) * (0.5f / kTile);
      const vec3 colour = kTiles[tile](uv);
      pixels.insert(pixels.end(), {to_byte(colour.x), to_byte(colour.y), to_byte(colour.z)});
    }
  }
  return pixels;
}

std::vector<png_byte> draw(const Sheet& sheet) {
  std::vector<png_byte> pixels(static_cast<std::size_t>(sheet.width()) * static_cast<std::size_t>(sheet.height()) * 3,
                               255);
  int place = 0;
  for (const std::size_t tile : sheet.tiles) {
    const std::vector<png_byte>& of_tile = pixels_of(tile);
    for (int y = 0; y < kTile; ++y) {
      const int row = place / sheet.columns() * (kTile + kBorder) + y;
      const int column = place % sheet.columns() * (kTile + kBorder);
      std::copy_n(of_tile.begin() + y * kTile * 3, kTile * 3, pixels.begin() + (row * sheet.width() + column) * 3);
    }
    ++place;
  }
  return pixels;
}

png_image empty_image() {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  return image;
}

int write(const Sheet& sheet, const char* path) {
  png_image image = empty_image();
  image.width = static_cast<png_uint_32>(sheet.width());
  image.height = static_cast<png_uint_32>(sheet.height());
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, path, 0, draw(sheet).data(), 0, nullptr)) return 0;
  std::fprintf(stderr, "picture: cannot write %s: %s\n", path, image.message);
  return 2;
}

int check(const Sheet& sheet, const char* path) {
  png_image image = empty_image();
  if (!png_image_begin_read_from_file(&image, path)) {
    std::fprintf(stderr, "picture: cannot read %s: %s\n", path, image.message);
    return 2;
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  if (pixels == draw(sheet)) return 0;
  std::fprintf(stderr, "picture: %s shows another picture; draw it again by tools/make readme\n", path);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool checks = argc > 1 && std::strcmp(argv[1], "--check") == 0;
  const int first = checks ? 2 : 1;
  if (argc == first || (argc - first) % 3 != 0) {
    std::fprintf(stderr, "usage: picture [--check] (FILE.png COLUMNS TILE,TILE...)...\n");
    return 2;
  }
  int worst = 0;
  for (int i = first; i < argc; i += 3) {
    const Sheet sheet(std::atoi(argv[i + 1]), argv[i + 2]);
    worst = std::max(worst, checks ? check(sheet, argv[i]) : write(sheet, argv[i]));
  }
  return worst;
}
