// The comparison of fields must report their faults.
#include "compare.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
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

// Each of these is wrong, and the values themselves are right.
TEST(Comparison, NoticesWrongValues) {
  const std::vector<float> expected = planes("perlin_d");
  const auto any = [](auto, auto) { return 10.0; };
  EXPECT_TRUE(same_bits(expected, expected, 63));
  EXPECT_TRUE(within(expected, expected, 63, [](auto, auto) { return 0.0; }));
  std::vector<std::vector<float>> wrong;
  for (const std::size_t i : {std::size_t{0}, std::size_t{62}, std::size_t{63}, expected.size() - 1}) {
    wrong.push_back(expected);  // one bit of one number
    wrong.back()[i] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(expected[i]) ^ 1u);
  }
  wrong.push_back(expected);  // dx by a point
  std::rotate(wrong.back().begin() + 63, wrong.back().begin() + 64, wrong.back().begin() + 126);
  wrong.push_back(expected);  // all by a plane
  std::rotate(wrong.back().begin(), wrong.back().begin() + 63, wrong.back().end());
  wrong.emplace_back();  // the numbers of a point side by side
  for (std::size_t i = 0; i < 63; ++i) {
    for (std::size_t component = 0; component < 3; ++component) wrong.back().push_back(expected[63 * component + i]);
  }
  wrong.emplace_back();  // y fastest
  for (std::size_t i = 0; i < expected.size(); ++i) {
    wrong.back().push_back(expected[63 * (i / 63) + 9 * (i % 7) + i % 63 / 7]);
  }
  wrong.emplace_back(expected.begin(), expected.end() - 1);
  EXPECT_FALSE(within(wrong.back(), expected, 63, any));
  for (std::size_t i = 0; i < wrong.size(); ++i) EXPECT_FALSE(same_bits(wrong[i], expected, 63)) << i;
  EXPECT_FALSE(same_bits(std::vector{-0.0f}, std::vector{0.0f}, 1));
  const std::vector nan = {std::numeric_limits<float>::quiet_NaN()};
  EXPECT_FALSE(same_bits(nan, nan, 1));
  EXPECT_FALSE(within(nan, nan, 1, any));
}

TEST(Comparison, NoticesWhatIsBeyondTheBound) {
  const std::vector<float> expected = {0.0f, 0.25f, 1.0f, 2.0f};
  const std::vector<float> got = {0.0f, 0.25f, 1.0f, 2.125f};
  // The bound is that of the component and the point.
  EXPECT_TRUE(
      within(got, expected, 2, [](auto component, auto point) { return component + point == 2 ? 0.125 : 0.0; }));
  EXPECT_FALSE(within(got, expected, 2, [](auto, auto point) { return point == 0 ? 0.125 : 0.12; }));
  EXPECT_FALSE(within(got, expected, 2, [](auto component, auto) { return component == 0 ? 0.125 : 0.12; }));
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

// Bits of other arithmetics, seeds, periods, and so on are not taken for each other.
TEST(Twin, IsAnotherWithOtherSettings) {
  const std::vector<float> expected = planes("perlin");
  std::vector<Settings> others(4, fixed("perlin"));
  others[0].arithmetic = Arithmetic::kPrecise;
  others[1].seed = 1;
  others[2].period = {1, 0};
  others[3].phase = 0.25f;
  for (Settings other : noise_subjects(2)) {
    other.arithmetic = Arithmetic::kFixed;
    if (other.noise != "perlin") others.push_back(other);
  }
  for (Settings other : sum_subjects(2)) {
    other.arithmetic = Arithmetic::kFixed;
    others.push_back(other);
  }
  for (const Settings& other : others) EXPECT_FALSE(same_bits(planes(other), expected, 63)) << other;
}

TEST(Places, OfAGridAreNearestFloats) {
  const Grid<2> grid = {{16777216.0f, 0.1f}, {1.0f, -0.1f}, {3, 2}};
  const auto places = places_of(grid);
  ASSERT_EQ(places.size(), 6u);
  EXPECT_EQ(places[0], (Position<2>{16777216.0f, 0.1f}));
  EXPECT_EQ(places[1], (Position<2>{16777216.0f, 0.1f}));  // 16777217 is no float
  EXPECT_EQ(places[2], (Position<2>{16777218.0f, 0.1f}));
  EXPECT_EQ(places[3], (Position<2>{16777216.0f, 0.0f}));
}

TEST(Places, OfACellGridWrap) {
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
