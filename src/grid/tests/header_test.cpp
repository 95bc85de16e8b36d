// The header-only fill of grid.hpp, with the instructions that this file is compiled for: the bits of the scalar
// functions, over every kind of places.
#define HN_ARITHMETIC HN_FIXED
#include <gtest/gtest.h>

#include <array>
#include <hashnoise/grid.hpp>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "compare.hpp"
#include "places.hpp"
#include "subjects.hpp"

namespace hashnoise::twin {
namespace {

template <typename Places, typename Noise>
void expect_bits(const Settings& settings, const Places& where, const Noise& noise) {
  constexpr int kDimensions = 2;
  const auto places = places_of(where);
  const std::vector<float> expected = planes_of(function<kDimensions>(settings), places);
  std::vector<float> values(expected.size());
  const Range range = lanes::fill(where, values, noise);
  EXPECT_TRUE(same_bits(values, expected, places.size())) << settings << ", points " << places.size();
  EXPECT_EQ(range, range_of(expected, places.size()));
}

// Each of `at` and `in` gives the noise of the settings.
template <typename At, typename In>
void expect_bits_everywhere(Settings settings, const At& at, const In& in) {
  settings.arithmetic = Arithmetic::kFixed;
  Chance chance(5);
  for (int round = 0; round < 50; ++round) {
    expect_bits(settings, draw_grid<2>(400, 0x1p22f, Draw::kWild, chance), at);
    expect_bits(settings, Points<2>(draw_points<2>(chance.whole(1, 70), 0x1p22f, Draw::kWild, chance)), at);
    expect_bits(settings, draw_cell_grid<2>(400, chance), in);
    expect_bits(settings, CellPoints<2>(draw_cell_points<2>(chance.whole(1, 70), chance)), in);
  }
}

TEST(Header, FillsWithNoisesAndSums) {
  Settings settings;
  settings.noise = "perlin";
  settings.seed = 7;
  expect_bits_everywhere(
      settings, [](lanes::vec2 p) { return lanes::hn_perlin(p, 7u); },
      [](lanes::ivec2 cell, lanes::vec2 f) { return lanes::hn_perlin(lanes::hn_place(cell, f), 7u); });
  settings.fractal = "ridged";
  expect_bits_everywhere(
      settings, [](lanes::vec2 p) { return lanes::hn_ridged(p, 6, 2.0f, 0.5f, 7u); },
      [](lanes::ivec2 cell, lanes::vec2 f) { return lanes::hn_ridged(lanes::hn_place(cell, f), 6, 2.0f, 0.5f, 7u); });
  settings.fractal = "";
  settings.noise = "simplex_d";  // which has planes
  expect_bits_everywhere(
      settings, [](lanes::vec2 p) { return lanes::hn_simplex_d(p, 7u); },
      [](lanes::ivec2 cell, lanes::vec2 f) { return lanes::hn_simplex_d(lanes::hn_place(cell, f), 7u); });
}

struct Named {
  double x, y, z;
};

TEST(Header, FillsPointsThatLieOneBehindTheOther) {
  const std::vector<float> x = {0.5f, 0.75f, -3.25f}, y = {0.25f, 0.125f, 7.5f}, z = {1.5f, 2.25f, 0.5f};
  const auto expect = [&](const auto& points) {
    const Columns<3> columns(points);
    const Points<3> found = columns.points();
    EXPECT_EQ(std::vector(found.p[0].begin(), found.p[0].end()), x);
    EXPECT_EQ(std::vector(found.p[1].begin(), found.p[1].end()), y);
    EXPECT_EQ(std::vector(found.p[2].begin(), found.p[2].end()), z);
    std::vector<float> values(3), expected(3);
    const auto noise = [](lanes::vec3 p) { return lanes::hn_perlin(p, 7u); };
    lanes::fill(Columns<3>(points).points(), values, noise);
    lanes::fill(Points<3>{{x, y, z}}, expected, noise);
    EXPECT_EQ(values, expected);
  };
  expect(std::vector<std::array<float, 3>>{{0.5f, 0.25f, 1.5f}, {0.75f, 0.125f, 2.25f}, {-3.25f, 7.5f, 0.5f}});
  expect(std::vector<vec3>{vec3(0.5f, 0.25f, 1.5f), vec3(0.75f, 0.125f, 2.25f), vec3(-3.25f, 7.5f, 0.5f)});
  expect(std::vector<Named>{{0.5, 0.25, 1.5}, {0.75, 0.125, 2.25}, {-3.25, 7.5, 0.5}});
}

// Points of another layout do not compile.
template <typename Container, int D>
constexpr bool kTakes = std::is_constructible_v<Columns<D>, const Container&>;
static_assert(kTakes<std::vector<std::array<float, 2>>, 2> && kTakes<std::array<vec2, 5>, 2>);
static_assert(!kTakes<std::vector<float>, 2> && !kTakes<std::vector<std::array<float, 3>>, 2>);
static_assert(!kTakes<std::vector<std::array<int, 2>>, 2> && !kTakes<std::vector<vec2>, 3>);
static_assert(!kTakes<std::vector<float*>, 2> && !kTakes<std::vector<std::span<const float>>, 4>);
static_assert(!std::is_constructible_v<std::span<const float>, const std::vector<vec2>&>);
static_assert(!std::is_constructible_v<std::span<const float>, const std::vector<std::array<float, 2>>&>);

TEST(Header, FillsNothingAndRejectsWhatDoesNotFit) {
  const auto noise = [](lanes::vec2 p) { return lanes::hn_perlin(p, 7u); };
  const auto in_cell = [](lanes::ivec2 cell, lanes::vec2 f) { return lanes::hn_perlin(lanes::hn_place(cell, f), 7u); };
  std::vector<float> none, values(11);
  const std::vector<float> two(2), three(3);
  using Size = std::array<int, 2>;
  for (const Size& size : {Size{0, 5}, Size{5, 0}}) {
    EXPECT_EQ(lanes::fill(Grid<2>{{0, 0}, {1, 1}, size}, none, noise), Range{});
    EXPECT_EQ(lanes::fill(CellGrid<2>{{0, 0}, {0, 0}, {1, 1}, size}, none, in_cell), Range{});
  }
  EXPECT_EQ(lanes::fill(Points<2>{}, none, noise), Range{});
  EXPECT_EQ(lanes::fill(CellPoints<2>{}, none, in_cell), Range{});
  for (const Size& size : {Size{3, 4}, Size{-1, -11}, Size{-11, -1}, Size{0, 11}, Size{11, 0}}) {
    EXPECT_THROW(lanes::fill(Grid<2>{{0, 0}, {1, 1}, size}, values, noise), std::invalid_argument);
  }
  for (const Size& first : {Size{-536870912, 0}, Size{0, 536870911}}) {
    EXPECT_THROW(lanes::fill(Grid<2>{{0, 0}, {1, 1}, {11, 1}, first}, values, noise), std::invalid_argument);
  }
  EXPECT_THROW(lanes::fill(Points<2>{{two, two}}, values, noise), std::invalid_argument);
  EXPECT_THROW(lanes::fill(Points<2>{{two, three}}, values, noise), std::invalid_argument);
}

}  // namespace
}  // namespace hashnoise::twin
