// With Arithmetic::kFixed and kPrecise a field has the bits of the scalar functions, at any place, with any settings,
// with every instruction set.
#include <gtest/gtest.h>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "fields.hpp"
#include "subjects.hpp"

namespace hashnoise::twin {
namespace {

constexpr int kMostPoints = 400;
constexpr float kFarOut = 0x1p22f;

class Bits : public testing::TestWithParam<std::tuple<int, Arithmetic>> {
 protected:
  template <typename Each>
  void in_dimensions(const Each& each) {
    twin::in_dimensions(std::get<0>(GetParam()), each);
  }

  Arithmetic arithmetic() const { return std::get<1>(GetParam()); }
  Chance chance{7 + 16 * static_cast<std::uint64_t>(std::get<0>(GetParam()))};

  template <int D>
  void expect_bits_everywhere(Settings settings, bool can_have_period = true, bool has_cells = true) {
    settings.arithmetic = arithmetic();
    for (const bool tiled : {false, true}) {
      if (tiled && !can_have_period) continue;
      const auto draw = [&] { draw_settings(settings, D, tiled, Draw::kWild, chance); };
      draw();
      expect_bits<D>(settings, draw_grid<D>(kMostPoints, kFarOut, Draw::kWild, chance));
      draw();
      expect_bits<D>(settings, Points<D>(draw_points<D>(chance.whole(1, 200), kFarOut, Draw::kWild, chance)));
      if (!has_cells) continue;
      draw();
      expect_bits<D>(settings, draw_cell_grid<D>(kMostPoints, chance));
      draw();
      expect_bits<D>(settings, CellPoints<D>(draw_cell_points<D>(chance.whole(1, 200), chance)));
    }
  }
};

TEST_P(Bits, OfNoises) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    for (int round = 0; round < 6; ++round) {
      for (const Settings& settings : noise_subjects(D)) expect_bits_everywhere<D>(settings);
    }
  });
}

TEST_P(Bits, OfSums) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    for (int round = 0; round < 2; ++round) {
      for (const Settings& settings : sum_subjects(D)) expect_bits_everywhere<D>(settings);
    }
  });
}

TEST_P(Bits, OfSumsWithDetailAndFootprint) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    for (Settings settings : sum_subjects(D)) {
      if (settings.fractal != "fbm") continue;
      settings.detail = 1.0f;
      expect_bits_everywhere<D>(settings, false, false);
      settings.detail.reset();
      settings.footprint = 1.0f;
      expect_bits_everywhere<D>(settings, false, false);
    }
  });
}

// Where a float has no fraction, and where the cell does not fit an int.
TEST_P(Bits, FarOut) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    for (Settings settings : noise_subjects(D)) {
      settings.arithmetic = arithmetic();
      for (const bool tiled : {false, true}) {
        draw_settings(settings, D, tiled, Draw::kWild, chance);
        PointList<D> list;
        for (auto& axis : list.p) {
          for (int i = 0; i < 64; ++i) {
            axis.push_back(chance.of({8388607.5f, -8388608.0f, 16777215.0f, 2147483520.0f, 2147483648.0f,
                                      -2147483648.0f, -2147483904.0f, 1e20f, -3e38f, std::numeric_limits<float>::max(),
                                      0.25f, std::ldexp(chance.between(-1.0f, 1.0f), 40)}));
          }
        }
        expect_bits<D>(settings, Points<D>(list));
      }
    }
  });
}

#if defined(__SSE2__)
// GCC and Clang do this at the start of a program that is linked with -ffast-math or -Ofast: subnormal numbers count as
// 0, in operands and in results.
class SubnormalsAreZero {
 public:
  SubnormalsAreZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); }
  ~SubnormalsAreZero() { _mm_setcsr(before_); }
  SubnormalsAreZero(const SubnormalsAreZero&) = delete;
  SubnormalsAreZero& operator=(const SubnormalsAreZero&) = delete;

 private:
  unsigned before_;
};

TEST(Processor, HasNoSubnormals) {
  const volatile float subnormal = 0x1p-140f;
  EXPECT_NE(subnormal * 4.0f, 0.0f);
  const SubnormalsAreZero processor;
  EXPECT_EQ(subnormal * 4.0f, 0.0f);
}

TEST_P(Bits, InAProgramWithFastMath) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    std::vector<Settings> subjects = noise_subjects(D);
    for (const Settings& sum : sum_subjects(D)) subjects.push_back(sum);
    for (Settings settings : subjects) {
      settings.arithmetic = arithmetic();
      draw_settings(settings, D, false, Draw::kWild, chance);
      PointList<D> list;
      for (auto& axis : list.p) {
        for (int i = 0; i < 64; ++i) {
          axis.push_back(chance.of({0x1p-140f, -0x1p-149f, -0x1p-126f, 0x1p-100f, 0x1p-32f, -0x1p-31f, 0.0f, 0.25f,
                                    chance.between(-1.0f, 1.0f)}));
        }
      }
      expect_bits<D, SubnormalsAreZero>(settings, Points<D>(list));
    }
  });
}
#endif

// A row that is several tasks, and many rows that are one.
TEST_P(Bits, OfManyPoints) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    constexpr std::array<std::array<int, 4>, 4> kSizes = {
        {{70001, 1, 1, 1}, {131, 67, 1, 1}, {33, 17, 19, 1}, {3, 61, 7, 9}}};
    for (const std::string noise : {"perlin_d", "value"}) {
      Settings settings;
      settings.noise = noise;
      settings.arithmetic = arithmetic();
      Grid<D> grid;
      CellGrid<D> cells;
      for (std::size_t axis = 0; axis < D; ++axis) {
        grid.size[axis] = cells.size[axis] = kSizes[D - 1][axis];
        grid.origin[axis] = -3.7f + static_cast<float>(axis);
        grid.step[axis] = 0.0371f;
        cells.cell[axis] = std::numeric_limits<std::int32_t>::max() - 2;  // the last cells are beyond the wrap
        cells.f[axis] = 0.125f;
        cells.step[axis] = 0.0371;
      }
      expect_bits<D>(settings, grid);
      expect_bits<D>(settings, cells);
    }
  });
}

// Rows in which neighbours share cells: narrow ones and such as are taken in several parts, with steps up to those from
// which on they are not taken so, to both sides, over the wrap of cells, and where positions are rounded to halves and
// to whole numbers.
TEST_P(Bits, OfRowsOfNearPoints) {
  const auto near_rows = [&]<int D>(std::integral_constant<int, D>, Settings settings) {
    settings.arithmetic = arithmetic();
    for (const float step : {0.0f, 1e-7f, 0x1p-24f, 0.0371f, 0.125f, 0.13f, 0.25f, 0.26f, 0.51f, 0.6f, 0.61f, 0.849f}) {
      settings.seed = chance.word();
      Grid<D> grid;
      CellGrid<D> cells;
      for (std::size_t axis = 0; axis < D; ++axis) {
        grid.size[axis] = cells.size[axis] = axis == 0 ? chance.of({3, 16, 50, 255, 257, 600}) : 2;
        grid.origin[axis] = axis == 0 ? chance.of({-1.0f, 0.9999f, 0x1p22f, 8388000.0f, -8388610.0f, 0x1p24f})
                                      : draw_coordinate(4.0f, Draw::kWild, chance);
        cells.cell[axis] = chance.of({std::numeric_limits<std::int32_t>::max() - 2, -2, 0});
        cells.f[axis] = chance.of({0.0f, 0.5f, 1.0f - 0x1p-24f, chance.between(0.0f, 1.0f)});
        grid.step[axis] = chance.one_in(2) ? step : -step;
        cells.step[axis] = static_cast<double>(grid.step[axis]);
      }
      expect_bits<D>(settings, grid);
      if (settings.lacunarity.value_or(2.0f) >= 0.0f) expect_bits<D>(settings, cells);
    }
  };
  in_dimensions([&]<int D>(std::integral_constant<int, D> dimensions) {
    for (const std::string noise : {"value", "perlin", "simplex", "simplex_smooth", "cellular"}) {
      if (D != 2 && D != 3 && noise != "perlin") continue;
      for (const std::string sum : {"", "fbm", "ridged"}) {
        if (!sum.empty() && noise == "cellular") continue;
        for (const int period : {0, 7}) {
          Settings settings;
          settings.noise = noise;
          settings.fractal = sum;
          settings.period.fill(period);
          if (!sum.empty()) {
            settings.octaves = chance.whole(1, 5);
            // Others are errors: in a tile, and what is negative where positions are whole numbers.
            settings.lacunarity = period > 0                           ? chance.of({2.0f, 2.0f, 1.0f, 3.0f})
                                  : arithmetic() == Arithmetic::kFixed ? chance.of({2.0f, 2.0f, 0.5f, 3.7f})
                                                                       : chance.of({2.0f, 2.0f, 0.5f, 3.7f, -1.3f});
          }
          if (noise == "cellular") {
            settings.jitter = chance.of({1.0f, 0.0f, 0.6f});
            if (chance.one_in(4)) settings.metric = Metric::kManhattan;
          }
          near_rows(dimensions, settings);
        }
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(, Bits,
                         testing::Combine(testing::Range(1, 5),
                                          testing::Values(Arithmetic::kPrecise, Arithmetic::kFixed)),
                         [](const auto& parameters) {
                           return std::to_string(std::get<0>(parameters.param)) + "d_" +
                                  (std::get<1>(parameters.param) == Arithmetic::kFixed ? "fixed" : "precise");
                         });

}  // namespace
}  // namespace hashnoise::twin
