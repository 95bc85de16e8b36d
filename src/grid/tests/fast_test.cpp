// With Arithmetic::kFast a field is as near to the scalar functions as twice their error: each of the two may be off by
// it. The bounds are those that tools/make bounds derives (docs/measured/accuracy.md).
//
// Sums over the noises of the GLSL functions are compared at positions and from cells. Sums over other noises are
// compared from cells, where the positions of the octaves are whole numbers, and the same in both.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "compare.hpp"
#include "expected/tolerance.hpp"
#include "fields.hpp"
#include "grid/functions.hpp"
#include "subjects.hpp"

namespace hashnoise::twin {
namespace {

constexpr auto kGradient = hn::Gradient::octahedral;

// --- Noises ----------------------------------------------------------------------------------------------------------

bool is_slope(const std::string& noise, std::size_t component) { return noise.ends_with("_d") && component > 0; }

double error_of_noise(const Settings& s, int dimensions, std::size_t component, bool from_cell) {
  const std::string name =
      s.phase && !row_of(s.noise).has_wave() ? s.noise + "_phase" : s.noise;  // a wave has a phase always
  const hn::NoiseBounds& bounds = is_slope(s.noise, component) ? hn::slope_bounds(name, dimensions, kGradient)
                                                               : hn::noise_bounds(name, dimensions, kGradient);
  return from_cell ? bounds.cell_error : bounds.error;
}

// A derivative of cellular_d is off by that of the point, divided by the distance; and it may be that of another point
// which is as near up to the error. There it is not compared.
template <int D, typename Place>
Bound bound_of_noise(const Settings& s, const std::vector<Place>& places) {
  constexpr bool kFromCell = !std::is_same_v<Place, Position<D>>;
  std::vector<float> distances;
  if constexpr (D == 2 || D == 3) {
    if (s.noise == "cellular_d") {
      Settings cellular = s;
      cellular.noise = "cellular";
      cellular.metric = Metric::kEuclidean;
      distances = planes_of(function<D>(cellular), places);
    }
  }
  return [=, points = places.size()](std::size_t component, std::size_t point) {
    const double error = 2.0 * error_of_noise(s, D, component, kFromCell);
    if (distances.empty() || component == 0) return error;
    const double nearest = static_cast<double>(distances[point]);
    const double second = static_cast<double>(distances[points + point]);
    return second - nearest < 1e-4 ? 2.0 : error / nearest;
  };
}

// --- Sums ------------------------------------------------------------------------------------------------------------

// The row of the suite's table.
const hn::Function& row_of_sum(const Settings& s, int dimensions, bool from_cell, bool tiled) {
  for (const hn::Function& row : hn::all_functions()) {
    if (row.bound == s.fractal && row.axes == dimensions && row.takes_cell() == from_cell &&
        row.takes_period() == tiled && row.takes_detail() == s.detail.has_value() &&
        row.takes_footprint() == s.footprint.has_value() && row.takes_phase() == s.phase.has_value()) {
      return row;
    }
  }
  throw std::logic_error("the suite has no such row of " + s.fractal);
}

using Words = std::array<std::uint32_t, hn::kInputWords>;
void put(Words& words, const hn::Function& row, std::string_view column, std::uint32_t word) {
  const int at = row.input(column);
  if (at >= 0) words[static_cast<std::size_t>(at)] = word;
}
void put(Words& words, const hn::Function& row, std::string_view column, float number) {
  put(words, row, column, std::bit_cast<std::uint32_t>(number));
}

Words words_of(const Settings& s, const hn::Function& row) {
  Words words{};
  put(words, row, "octaves", static_cast<std::uint32_t>(octaves_of(s)));
  put(words, row, "lacunarity", lacunarity_of(s));
  put(words, row, "gain", gain_of(s));
  put(words, row, "strength", strength_of(s));
  put(words, row, "amplitude", amplitude_of(s));
  put(words, row, "phase", s.phase.value_or(0.0f));
  if (s.detail) put(words, row, "detail", *s.detail);
  if (s.footprint) put(words, row, "footprint", *s.footprint);
  return words;
}

constexpr std::array kCells = {"cx", "cy", "cz", "cw"}, kFractions = {"fx", "fy", "fz", "fw"};
template <int D>
void put_place(Words& words, const hn::Function& row, const CellPlace<D>& place) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    put(words, row, kCells[axis], static_cast<std::uint32_t>(place.cell[axis]));
    put(words, row, kFractions[axis], place.f[axis]);
  }
}
template <int D>
void put_place(Words& words, const hn::Function& row, const Position<D>& p) {
  if (!row.takes_cell()) {
    for (std::size_t axis = 0; axis < D; ++axis) words[axis] = std::bit_cast<std::uint32_t>(p[axis]);
    return;
  }
  CellPlace<D> place;
  for (std::size_t axis = 0; axis < D; ++axis) {
    place.cell[axis] = static_cast<std::int32_t>(std::floor(p[axis]));
    place.f[axis] = p[axis] - std::floor(p[axis]);
  }
  put_place<D>(words, row, place);
}

// Over any noise, from a cell or in a tile: there the positions of octaves are whole numbers, and the same in both. So
// only the noise and the sum are off. The bound is far above their roundings, and far below another seed or place.
template <int D>
Bound bound_of_other(const Settings& s) {
  double error = 1e-3;
  if (grid::sum_row(s.fractal).of == grid::Shape::kValue) {
    error = 32.0 * hn::noise_bounds(s.noise.empty() ? "perlin" : s.noise, D, kGradient).cell_error + 1e-6;
  }
  return [=](std::size_t, std::size_t) { return error; };
}

// Over the noise of the GLSL function.
template <int D, typename Place>
Bound bound_of_sum(const Settings& s, const std::vector<Place>& places) {
  const bool tiled = has_period(s, D);
  const bool from_place = tiled || !std::is_same_v<Place, Position<D>>;
  if (from_place && grid::sum_row(s.fractal).of == grid::Shape::kValue) return bound_of_other<D>(s);
  const hn::Function& row = row_of_sum(s, D, from_place, tiled);
  Words words = words_of(s, row);
  std::vector<double> bounds;
  for (const Place& place : places) {
    put_place<D>(words, row, place);
    for (std::size_t output = 0; output < row.outputs.size(); ++output) {
      bounds.push_back(2.0 * hn::tolerance(row, hn::default_configuration(), words, output));
    }
  }
  return [=, components = row.outputs.size()](std::size_t component, std::size_t point) {
    return bounds[point * components + component];
  };
}

// --- The tests -------------------------------------------------------------------------------------------------------

class Fast : public testing::TestWithParam<int> {
 protected:
  template <typename Each>
  void in_dimensions(const Each& each) {
    twin::in_dimensions(GetParam(), each);
  }

  template <int D, typename Places, typename BoundOf>
  void expect_near(Settings settings, const Places& where, const BoundOf& bound_of) {
    const auto places = places_of(where);
    const std::vector<float> expected = planes_of(function<D>(settings), places);
    const Bound bound = bound_of(places);
    for (const InstructionSet set : instruction_sets()) {
      settings.instruction_set = set;
      const Field<D> field(settings);
      const FieldValues filled = fill(field, where, places.size());
      EXPECT_TRUE(within(filled.values, expected, places.size(), bound)) << settings;
      EXPECT_EQ(filled.range, range_of(filled.values, places.size())) << settings;
    }
  }

  // At positions up to each of the numbers, and in cells; the settings are drawn anew each time.
  template <int D, typename BoundOf>
  void expect_near(Settings s, bool tiled, const std::vector<float>& largest, bool in_cells, const BoundOf& bound_of) {
    const auto bound = [&](const auto& places) { return bound_of(s, places); };
    const auto draw = [&] { draw_settings(s, D, tiled, Draw::kTame, chance); };
    for (const float most : largest) {
      draw();
      expect_near<D>(s, draw_grid<D>(400, most, Draw::kTame, chance), bound);
      draw();
      expect_near<D>(s, Points<D>(draw_points<D>(100, most, Draw::kTame, chance)), bound);
    }
    if (!in_cells) return;
    draw();
    expect_near<D>(s, draw_cell_grid<D>(400, chance), bound);
    draw();
    expect_near<D>(s, CellPoints<D>(draw_cell_points<D>(100, chance)), bound);
  }

  Chance chance{11};
};

TEST_P(Fast, Noises) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    const auto bound = [](const Settings& s, const auto& places) { return bound_of_noise<D>(s, places); };
    for (const Settings& settings : noise_subjects(D)) {
      for (const bool tiled : {false, true}) expect_near<D>(settings, tiled, {16.0f, 0x1p22f}, true, bound);
    }
  });
}

TEST_P(Fast, Sums) {
  in_dimensions([&]<int D>(std::integral_constant<int, D>) {
    const auto bound = [](const Settings& s, const auto& places) { return bound_of_sum<D>(s, places); };
    const auto bound_in_cells = [](const Settings& s, const auto&) { return bound_of_other<D>(s); };
    for (Settings settings : sum_subjects(D)) {
      for (const bool tiled : {false, true}) {
        if (settings.noise == noise_below(settings.fractal)) {
          expect_near<D>(settings, tiled, {16.0f}, true, bound);
        } else if (settings.fractal != "warp_progressive") {  // whose steps are taken at a place that has an error
          expect_near<D>(settings, tiled, {}, true, bound_in_cells);
        }
      }
      if (settings.fractal != "fbm" || settings.noise != "perlin") continue;
      settings.detail = 1.0f;
      expect_near<D>(settings, false, {16.0f}, false, bound);
      settings.detail.reset();
      settings.footprint = 1.0f;
      expect_near<D>(settings, false, {16.0f}, false, bound);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(, Fast, testing::Range(1, 5),
                         [](const auto& parameter) { return std::to_string(parameter.param) + "d"; });

// The bounds are small: fields with another seed, or at places that are off by a thousandth of a cell, are beyond them.
TEST(FastBounds, RejectWhatIsWrong) {
  const Grid<2> grid = {{0.3f, -1.7f}, {0.17f, 0.23f}, {9, 7}};
  const Grid<2> moved = {{0.301f, -1.7f}, {0.17f, 0.23f}, {9, 7}};
  CellGrid<2> cells = {{3, -7}, {0.3f, 0.7f}, {0.17, 0.23}, {9, 7}};
  CellGrid<2> moved_cells = cells;
  moved_cells.f[0] += 0.001f;
  // A noise that jumps is the same in the whole cell.
  const auto moves = [](const Settings& s) {
    return s.noise.empty() || std::isfinite(hn::noise_bounds(s.noise, 2, kGradient).lipschitz);
  };
  const auto expect_rejected = [&](const Settings& s, const auto& where, const auto& moved_to, const Bound& bound) {
    const std::size_t points = places_of(where).size();
    const std::vector<float> right = planes_of(function<2>(s), places_of(where));
    EXPECT_TRUE(within(right, right, points, bound));
    if (moves(s)) {
      EXPECT_FALSE(within(planes_of(function<2>(s), places_of(moved_to)), right, points, bound)) << s;
    }
    Settings other = s;
    other.seed += 1;
    EXPECT_FALSE(within(planes_of(function<2>(other), places_of(where)), right, points, bound)) << s;
  };
  for (const Settings& s : noise_subjects(2)) {
    if (s.noise == "cell_border") continue;  // its bound is more than a thousandth
    expect_rejected(s, grid, moved, bound_of_noise<2>(s, places_of(grid)));
    expect_rejected(s, cells, moved_cells, bound_of_noise<2>(s, places_of(cells)));
  }
  for (const Settings& s : sum_subjects(2)) {
    if (s.fractal == "warp_progressive" || s.noise == "cell_border") continue;
    const bool is_default = s.noise == noise_below(s.fractal);
    expect_rejected(s, cells, moved_cells, is_default ? bound_of_sum<2>(s, places_of(cells)) : bound_of_other<2>(s));
    if (is_default) expect_rejected(s, grid, moved, bound_of_sum<2>(s, places_of(grid)));
  }
}

}  // namespace
}  // namespace hashnoise::twin
