// Grids in other hands: header only, and by the compiled library. Both have the bits of the scalar functions.
#define HN_ARITHMETIC HN_FIXED
#include <cstdio>
#include <hashnoise/field.hpp>
#include <hashnoise/grid.hpp>
#include <hashnoise/hashnoise.hpp>
#include <vector>

namespace {

constexpr int kWidth = 37;
constexpr int kHeight = 3;

// Point i along an axis, as in points.hpp.
float coordinate(float origin, float step, int i) {
  return static_cast<float>(static_cast<double>(origin) + static_cast<double>(i) * static_cast<double>(step));
}

// How many values differ from those of the scalar function.
int differences(const hashnoise::Grid<2>& grid, const std::vector<float>& values) {
  int count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const hashnoise::vec2 p(coordinate(grid.origin[0], grid.step[0], x), coordinate(grid.origin[1], grid.step[1], y));
      const float value = hashnoise::hn_simplex(p, 7u);
      if (!(values[static_cast<std::size_t>(y * kWidth + x)] == value)) ++count;
    }
  }
  return count;
}

}  // namespace

int main() {
  const hashnoise::Grid<2> grid{{-1.5f, 2.0f}, {0.1f, 0.3f}, {kWidth, kHeight}};
  std::vector<float> values(kWidth * kHeight);
  namespace lanes = hashnoise::lanes;
  lanes::fill(grid, values, [](lanes::vec2 p) { return lanes::hn_simplex(p, 7u); });
  const int of_headers = differences(grid, values);
  values.assign(values.size(), 0.0f);
  hashnoise::Settings settings;
  settings.noise = "simplex";
  settings.arithmetic = hashnoise::Arithmetic::kFixed;
  settings.seed = 7;
  hashnoise::Field<2>(settings).fill(grid, values, hashnoise::threads(2));
  const int of_library = differences(grid, values);
  std::printf("%d and %d of %d values differ\n", of_headers, of_library, kWidth * kHeight);
  return of_headers + of_library;
}
