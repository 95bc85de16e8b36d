// The comparison of fields must report their faults.
#include "compare.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string>
#include <vector>

#include "fields.hpp"
#include "places.hpp"
#include "subjects.hpp"

namespace hashnoise::twin {
namespace {

Settings fixed(const std::string& noise) {
  Settings settings;
  settings.noise = noise;
  settings.arithmetic = Arithmetic::kFixed;
  return settings;
}

const Grid<2> kGrid = {{0.3f, -1.7f}, {0.17f, 0.23f}, {9, 7}};

std::vector<float> planes(const Settings& settings) { return planes_of(function<2>(settings), places_of(kGrid)); }
std::vector<float> planes(const std::string& noise) { return planes(fixed(noise)); }

// Each of these is wrong: one bit of one number, all numbers by a plane, and one number less.
TEST(Comparison, NoticesWrongValues) {
  const std::vector<float> expected = planes("perlin_d");
  EXPECT_TRUE(same_bits(expected, expected, 63));
  std::vector<std::vector<float>> wrong(6, expected);
  const std::array<std::size_t, 4> places = {0, 62, 63, expected.size() - 1};
  for (std::size_t i = 0; i < places.size(); ++i) {
    float& number = wrong[i][places[i]];
    number = std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) ^ 1u);
  }
  std::rotate(wrong[4].begin(), wrong[4].begin() + 63, wrong[4].end());
  wrong[5].pop_back();
  for (std::size_t i = 0; i < wrong.size(); ++i) EXPECT_FALSE(same_bits(wrong[i], expected, 63)) << i;
  EXPECT_FALSE(same_bits(std::vector{-0.0f}, std::vector{0.0f}, 1));
  const std::vector nan = {std::numeric_limits<float>::quiet_NaN()};
  EXPECT_FALSE(same_bits(nan, nan, 1));
  const auto any = [](auto, auto) { return 10.0; };
  EXPECT_FALSE(within(nan, nan, 1, any));
  EXPECT_FALSE(within(wrong[5], expected, 63, any));
  // The bound is that of the component and the point.
  const std::vector<float> right = {0.0f, 0.25f, 1.0f, 2.0f}, got = {0.0f, 0.25f, 1.0f, 2.125f};
  EXPECT_TRUE(within(got, right, 2, [](auto component, auto point) { return component + point == 2 ? 0.125 : 0.0; }));
  EXPECT_FALSE(within(got, right, 2, [](auto, auto point) { return point == 0 ? 0.125 : 0.12; }));
  EXPECT_FALSE(within(got, right, 2, [](auto component, auto) { return component == 0 ? 0.125 : 0.12; }));
}

TEST(Comparison, NoticesWhatIsWrittenBesides) {
  // A field cannot be made to write elsewhere. So this is a stand-in for one.
  struct CarelessField {
    int component_count() const { return 1; }
    Range fill(const Grid<2>&, std::span<float> values, const Executor&) const {
      *(values.data() + values.size()) = 0.0f;
      return {};
    }
  };
  struct TidyField : CarelessField {
    Range fill(const Grid<2>&, std::span<float>, const Executor&) const { return {}; }
  };
  EXPECT_NONFATAL_FAILURE(static_cast<void>(fill(CarelessField{}, kGrid, 63, {})), "behind the values");
  static_cast<void>(fill(TidyField{}, kGrid, 63, {}));
}

TEST(Places, AreNearestFloatsAndCellsWrap) {
  EXPECT_EQ(places_of(Grid<1>{{16777216.0f}, {1.0f}, {3}}),
            (std::vector<Position<1>>{{16777216.0f}, {16777216.0f}, {16777218.0f}}));  // 16777217 is no float
  constexpr std::int32_t kLast = std::numeric_limits<std::int32_t>::max();
  const CellGrid<1> grid = {{kLast}, {0.5f}, {0.75}, {4}};
  const auto places = places_of(grid);
  ASSERT_EQ(places.size(), 4u);
  EXPECT_EQ(places[0], (CellPlace<1>{{kLast}, {0.5f}}));
  EXPECT_EQ(places[1], (CellPlace<1>{{-kLast - 1}, {0.25f}}));
  EXPECT_EQ(places[2], (CellPlace<1>{{-kLast}, {0.0f}}));
  EXPECT_EQ(places[3], (CellPlace<1>{{-kLast}, {0.75f}}));
  const CellGrid<1> back = {{-kLast - 1}, {0.25f}, {-0.5}, {2}};
  EXPECT_EQ(places_of(back)[1], (CellPlace<1>{{kLast}, {0.75f}}));
  // The place is cut off to a multiple of 2^-24, and the end of a cell is the start of the next.
  const CellGrid<1> fine = {{5}, {1.0f}, {-0x1p-32}, {2}};
  EXPECT_EQ(places_of(fine)[0], (CellPlace<1>{{6}, {0.0f}}));
  EXPECT_EQ(places_of(fine)[1], (CellPlace<1>{{5}, {1.0f - 0x1p-24f}}));
}

// points.hpp computes with integers that wrap; the results are those of integers of any size.
TEST(Places, AreThoseOfTheHeader) {
  Chance chance(17);
  for (int round = 0; round < 20000; ++round) {
    const Grid<1> grid = draw_grid<1>(10, 0x1p22f, Draw::kWild, chance);
    const CellGrid<1> cells = draw_cell_grid<1>(10, chance);
    const int i = chance.of({0, 1, 2, 15, 1000003, (1 << 29) - 1, chance.whole(0, (1 << 29) - 1)});
    EXPECT_EQ(detail::position_of(grid.origin[0], grid.step[0], i), coordinate(grid.origin[0], grid.step[0], i)) << i;
    const double step = chance.one_in(4) ? (chance.one_in(2) ? 1 : -1) * (0x1p31 - 0x1p-21) : cells.step[0];
    const auto got = detail::cell_and_place_of(cells.cell[0], cells.f[0], step, i);
    const auto expected = cell_coordinate(cells.cell[0], cells.f[0], step, i);
    EXPECT_EQ(got.cell, expected.cell) << i << " " << step;
    EXPECT_EQ(got.f, expected.f) << i << " " << step;
  }
}

}  // namespace
}  // namespace hashnoise::twin
