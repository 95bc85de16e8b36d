// Prints how far pixels of a plane that recedes to the horizon are from the mean of many places in them, with the
// footprint of hn_fbm and without: root mean squares over the far half of the picture, a line each. The plane is that
// of the picture in docs/reference/fractals.md.
#include <cmath>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>

namespace {

using hashnoise::vec2;

constexpr int kPixels = 256;
constexpr int kPlaces = 16;  // along each side of a pixel
constexpr int kOctaves = 8;
constexpr float kGain = 0.6f;
constexpr hashnoise::uint kSeed = 7;

vec2 place(float u, float v) { return vec2(u - 0.5f, 1.0f) * (3.0f / (1.02f - v)); }

// The larger side of a pixel, in cells: of its two sides, that in depth.
float size(float v) { return 3.0f / (kPixels * (1.02f - v) * (1.02f - v)); }

float fbm(vec2 p) { return hashnoise::hn_fbm(p, kOctaves, 2.0f, kGain, kSeed); }

double mean(int x, int y) {
  double sum = 0.0;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    const float u = (static_cast<float>(x) + (static_cast<float>(i % kPlaces) + 0.5f) / kPlaces) / kPixels;
    const float v = (static_cast<float>(y) + (static_cast<float>(i / kPlaces) + 0.5f) / kPlaces) / kPixels;
    sum += static_cast<double>(fbm(place(u, v)));
  }
  return sum / (kPlaces * kPlaces);
}

}  // namespace

int main() {
  double with = 0.0;
  double without = 0.0;
  double squares = 0.0;
  int pixels = 0;
  for (int y = kPixels / 2; y < kPixels; ++y) {
    for (int x = y % 4; x < kPixels; x += 4) {
      const float v = (static_cast<float>(y) + 0.5f) / kPixels;
      const vec2 p = place((static_cast<float>(x) + 0.5f) / kPixels, v);
      const double right = mean(x, y);
      const double plain = static_cast<double>(fbm(p));
      const double limited = static_cast<double>(hashnoise::hn_fbm(p, size(v), kOctaves, 2.0f, kGain, kSeed));
      with += (limited - right) * (limited - right);
      without += (plain - right) * (plain - right);
      squares += plain * plain;
      ++pixels;
    }
  }
  std::printf("with %.6f\nwithout %.6f\ndeviation %.6f\n", std::sqrt(with / pixels), std::sqrt(without / pixels),
              std::sqrt(squares / pixels));
}
