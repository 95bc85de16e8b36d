// Simulates frames of the pattern, writes the last as a PNG file, and compares each pixel with the library in C++.
//
//     ./pattern FRAMES FILE.png
#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <hashnoise/hashnoise.hpp>
#include <vector>

#include "Vpattern.h"

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

// The grey of a pixel in that frame, as noise.frag has it.
int grey(int x, int y, int frame) {
  using namespace hashnoise;
  hn_octaves2 octaves = hn_octaves(hn_place(ivec2(x + frame, y), 1, 64), 4, 2.0f, 0.5f, 7u);
  do hn_add(octaves, hn_simplex(octaves.place, octaves.seed));
  while (hn_next(octaves));
  const int level = (int(hn_mean(octaves) * 2097152.0f) >> 13) + 128;
  return level < 0 ? 0 : level > 255 ? 255 : level;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: pattern FRAMES FILE.png\n"), 2;
  Vpattern top;
  std::vector<unsigned char> pixels;
  int frame = 0;
  long differing = 0;
  const int frames = std::atoi(arguments[1]);
  while (frame < frames) {
    top.clock = 0;
    top.eval();
    top.clock = 1;
    top.eval();
    if (!top.shown) continue;
    const int at = int(pixels.size()) / 3;
    differing += top.grey != grey(at % kWidth, at / kWidth, frame);
    pixels.insert(pixels.end(), 3, top.grey);
    if (at + 1 == kWidth * kHeight && ++frame < frames) pixels.clear();
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = kWidth;
  image.height = kHeight;
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, arguments[2], 0, pixels.data(), 0, nullptr)) return 1;
  std::printf("%ld of %ld pixels differ from the library\n", differing, long(frames) * kWidth * kHeight);
  return differing != 0;
}
