// The checks of cellular noise, on a library with a fault.
#include "cases/faulty_library_fixture.hpp"

namespace hn {
namespace {

class CellularChecks : public FaultyLibrary {
 protected:
  template <std::size_t count>
  void expect_all_caught(const Replacement (&faults)[count]) {
    for (const Replacement& fault : faults) expect_replaced_caught(fault);
  }
};

// The block of cells is too small by a row, or has the wrong ones.
TEST_F(CellularChecks, ABlockThatIsTooSmallIsCaughtByTheSearch) {
  constexpr Replacement kFaults[] = {
      {"noise2d.cellular.lattice.fast.fragment.gl330.search", "detail/feature_points2d.glsl",
       "cells, cells.following.y, s)", "cells, cells.cell.y, s)"},
      {"noise2d.cellular_cell_nearest.lattice.fixed.fragment.gl330.search", "detail/feature_points2d.glsl",
       "cells, cells.previous.y, s)", "cells, cells.cell.y, s)"},
      {"noise3d.cellular_offset.lattice.precise.fragment.gl400.search", "detail/feature_points3d.glsl",
       "joins.z, odds.z, x", "joins.y, odds.y, x"},
      {"noise2d.cellular_three.lattice.fast.fragment.gl330.search", "cellular_three2d.glsl",
       "best = hn_i_insert(best, hn_i_ranks(hashes, x, y, jitter, metric), HN_I_NO_CODE, 0);", ""},
      {"noise2d.cellular_three_full.lattice.fixed.fragment.gl330.search", "detail/feature_points.glsl",
       "hn_i_select_int(d > HN_I_NO_OFFSET, 2, -2)", "hn_i_select_int(d > HN_I_NO_OFFSET, 2, 2)"},
      {"noise3d.cellular_three_cell_full.lattice.fast.vertex.gl330.search", "cellular_three3d.glsl",
       "hn_i_slab_z(d, axis, steps, n)", "hn_i_slab_z(d, axis, steps, -n)"},
      {"noise3d.cellular_three_cell_full.lattice.fixed.fragment.gl330.search", "cellular_three3d.glsl", "n <= 1",
       "n < 1"},
      {"noise2d.cell_border.lattice.fast.fragment.gl330.search", "cell_border2d.glsl",
       "best = hn_i_border(best, hashes, x, hn_i_equal_triple(y.z), jitter, hn_i_code(0, 1), 1, from, nearest);", ""},
      {"noise2d.cell_border_cell.lattice.fixed.fragment.gl330.search", "cell_border2d.glsl",
       "hashes, x, hn_i_equal_triple(y.x), jitter", "hashes, x, hn_i_equal_triple(y.y), jitter"},
      {"noise3d.cell_border.lattice.fixed.fragment.gl330.search", "cell_border3d.glsl", "slab = -1;", "slab = 0;"}};
  expect_all_caught(kFaults);
}

TEST_F(CellularChecks, AnotherMetricAndAnotherJitterAreCaughtByTheSearch) {
  constexpr Replacement kFaults[] = {
      {"noise2d.cellular_full.lattice.fast.fragment.gl330.search", "detail/feature_points2d.glsl",
       "return hn_i_sum(a, b);", "return max(a, b);"},
      {"noise3d.cellular_three_cell_full.lattice.fixed.fragment.gl330.search", "detail/feature_points3d.glsl",
       "metric == HN_METRIC_CHEBYSHEV) return", "metric == HN_METRIC_CHEBYSHEV || metric == 6) return"},
      {"noise3d.cellular_smooth_full.lattice.fast.fragment.gl330.search", "detail/feature_points.glsl",
       "max(0.0f, jitter), 1.0f)", "max(0.0f, jitter), 1.5f)"},
      {"noise2d.cellular_d_full.lattice.fixed.fragment.gl330.search", "detail/feature_points.glsl",
       "min(max(0.0f, jitter), 1.0f)", "min(max(0.01f, jitter), 1.0f)"}};
  expect_all_caught(kFaults);
}

// The name, the way and the distance of different points, a name beyond the period, and a value of its own.
TEST_F(CellularChecks, PartsThatDoNotBelongTogetherAreCaught) {
  constexpr Replacement kFaults[] = {
      {"noise2d.cellular_cell_nearest.lattice.fast.fragment.gl330.cell_names", "detail/feature_points2d.glsl",
       "hn_uvec2 after = hn_i_following(c, place.period);\n  return ivec2",
       "hn_uvec2 after = c + uvec2(1u, 1u);\n  return ivec2"},
      {"noise3d.cellular_cell_nearest.lattice.fixed.fragment.gl330.cell_names", "cellular3d.glsl",
       "offset = hn_i_toward(", "offset = -hn_i_toward("},
      {"noise2d.cellular_cell_nearest.lattice.precise.fragment.gl400.cell_names", "cellular2d.glsl",
       "best.w));\n  return hn_i_two_distances(best, metric);",
       "best.w));\n  return hn_i_two_distances(best, HN_METRIC_SQUARED);"},
      {"noise2d.cell_border_nearest.lattice.fast.fragment.gl330.cell_names", "cell_border2d.glsl",
       "nearest = hn_i_cell_of(place, best.w);", "nearest = hn_i_cell_of(place, best.w) + ivec2(0, 1);"}};
  expect_all_caught(kFaults);
}

TEST_F(CellularChecks, AValueOfItsOwnBesideTheNearestPointIsCaught) {
  constexpr Replacement kFaults[] = {
      {"noise2d.cell_border_nearest.lattice.fast.fragment.gl330.returned", "cell_border2d.glsl",
       "return hn_i_cell_border(cells, hn_i_far_cell(place, cells, d), d, jitter, seed, best);",
       "return -hn_i_cell_border(cells, hn_i_far_cell(place, cells, d), d, jitter, seed, best);"},
      {"noise3d.cell_border_cell_offset.lattice.fixed.fragment.gl330.returned", "cell_border3d.glsl",
       "hn_i_jitter(jitter), seed, nearest, offset);", "hn_i_jitter(0.5f), seed, nearest, offset);"},
      {"noise2d.cellular_phase_nearest.lattice.precise.fragment.gl400.returned", "cellular_phase2d.glsl",
       "return hn_i_two_distances(best, HN_METRIC_EUCLIDEAN);", "return hn_i_two_distances(best, HN_METRIC_SQUARED);"}};
  expect_all_caught(kFaults);
}

TEST_F(CellularChecks, AnotherOfTwoEquallyNearPointsIsCaught) {
  expect_replaced_caught({"noise2d.cellular_nearest.lattice.fixed.fragment.gl330.search", "detail/feature_points.glsl",
                          "hn_i_select(rank < best.x,", "hn_i_select(rank <= best.x,"});
}

TEST_F(CellularChecks, BordersInTheWrongPlaceAreCaught) {
  expect_caught("noise2d.cell_border.lattice.fast.fragment.gl330.border", "cell_border2d.glsl",
                "hn_cell_border(args) (hn_cell_border(args) * 4.0)");
  expect_caught("noise3d.cell_border_cell.lattice.fixed.fragment.gl330.border", "cell_border3d.glsl",
                "hn_cell_border(c, args) (hn_cell_border(c, args) + 0.02)");
  expect_replaced_caught({"noise3d.cell_border.lattice.precise.fragment.gl400.border", "cell_border3d.glsl",
                          "nearest.w);\n}", "nearest.w * 0.0f);\n}"});
}

// A length that is not 1, and a direction that is another.
TEST_F(CellularChecks, WrongDerivativesAreCaught) {
  expect_caught("noise2d.cellular_d.lattice.fast.fragment.gl330.derivative", "cellular_d2d.glsl",
                "hn_cellular_d(args) (vec3(1.0, 1.001, 1.001) * hn_cellular_d(args))");
  expect_caught("noise3d.cellular_d_cell_full.lattice.fixed.fragment.gl330.derivative", "cellular_d3d.glsl",
                "hn_cellular_d(t, j, args) hn_cellular_d(t, j, args).xzyw");
}

// Where the block of cells changes: at a wall, and in the middle of a cell.
TEST_F(CellularChecks, JumpsAreCaught) {
  expect_caught("noise2d.cellular.lattice.fast.fragment.gl330.seams", "cellular2d.glsl",
                "hn_cellular(args) (hn_cellular(args) + (fract(p.x) < 0.5 ? 0.001 : 0.0))");
  expect_caught("noise3d.cell_border_cell.lattice.fixed.fragment.gl330.seams", "cell_border3d.glsl",
                "hn_cell_border(c, args) (hn_cell_border(c, args) + (f.z > 0.5 ? 0.05 : 0.0))");
  expect_caught(
      "noise2d.cellular_d_cell.lattice.precise.fragment.gl400.seams", "cellular_d2d.glsl",
      "hn_cellular_d(c, args) (hn_cellular_d(c, args) * (cell.y % 2 == 0 ? vec3(1.0) : vec3(1.0, -1.0, 1.0)))");
}

TEST_F(CellularChecks, FieldsThatAreAlikeAreCaught) {
  constexpr Replacement kFaults[] = {{"noise2d.cellular.lattice.fast.fragment.gl330.seeds", "cellular2d.glsl",
                                      "HN_METRIC_EUCLIDEAN, seed);", "HN_METRIC_EUCLIDEAN, seed & 0x7FFFFFFFu);"},
                                     {"noise3d.cellular.lattice.fast.fragment.gl330.mirror", "cellular3d.glsl",
                                      "hn_cellular(hn_place(p), seed)", "hn_cellular(hn_place(abs(p)), seed)"}};
  expect_all_caught(kFaults);
}

// With rounded floats every output but those that jump is compared, and an undecided point is no excuse elsewhere.
TEST_F(CellularChecks, ANearestPointThatIsWrongIsNotLeftOut) {
  expect_replaced_caught({"noise2d.cellular_nearest.lattice.fast.fragment.gl330.twin", "detail/feature_points.glsl",
                          "hn_i_select(rank < best.x, hn_i_rank_of_code(code), best.w)",
                          "hn_i_select(rank < best.x + 0.002f, hn_i_rank_of_code(code), best.w)"});
}

}  // namespace
}  // namespace hn
