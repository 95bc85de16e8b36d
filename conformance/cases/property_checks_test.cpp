// The checks at points where floats end, and the batches of more points than a grid takes, on a library with a fault.
#include <optional>

#include "cases/faulty_library_fixture.hpp"
#include "cases/value_checks.hpp"
#include "expected/points.hpp"

namespace hn {
namespace {

class Extreme : public FaultyLibrary {};

constexpr std::string_view kPerlins[] = {"noise2d.perlin.lattice.fast.fragment.gl330.finite",
                                         "noise2d.perlin.lattice.precise.fragment.gl400.finite",
                                         "noise2d.perlin.lattice.fixed.fragment.gl330.finite"};

TEST_F(Extreme, NanAndInfinityAreCaught) {
  for (const std::string_view id : kPerlins) {
    expect_caught(id, "perlin2d.glsl",
                  "hn_perlin(args) (abs(p.x) > 3.0e38 ? uintBitsToFloat(0x7FC00000u) : hn_perlin(args))");
    expect_caught(id, "perlin2d.glsl",
                  "hn_perlin(args) (abs(p.x) > 3.0e38 ? uintBitsToFloat(0x7F800000u) : hn_perlin(args))");
  }
}

TEST_F(Extreme, ANoiseThatIsNotZeroWhereNoAxisHasAFractionIsCaught) {
  for (const std::string_view id : kPerlins) {
    expect_caught(id, "perlin2d.glsl",
                  "hn_perlin(args) (min(abs(p.x), abs(p.y)) > 1.0e9 ? hn_perlin(args) + 1.0e-6 : hn_perlin(args))");
  }
}

TEST_F(Extreme, AValueBeyondTheRangeAtATinyPositionIsCaught) {
  for (const std::string_view id : kPerlins) {
    expect_caught(id, "perlin2d.glsl", "hn_perlin(args) (p.x != 0.0 && abs(p.x) < 1.0e-30 ? 1.5 : hn_perlin(args))");
  }
}

TEST_F(Extreme, AnOctaveSumIsHeldToItToo) {
  for (const std::string_view id :
       {"fbm.fbm3.lattice.fast.fragment.gl330.finite", "fbm.fbm3.lattice.fixed.fragment.gl330.finite"}) {
    expect_caught(id, "fbm3d.glsl",
                  "hn_fbm(q, o, l, args) (abs(p.x) > 1.0e28 ? uintBitsToFloat(0x7F800000u) : hn_fbm(q, o, l, args))");
  }
}

// Without the limit of a position, of a setting, or of a mean that is no number.
TEST_F(Extreme, ASumThatLeavesItsRangeForAbsurdNumbersIsCaught) {
  constexpr Replacement kFaults[] = {
      {"fbm.fbm2.lattice.fixed.fragment.gl330.finite", "detail/arithmetic.glsl", "hn_float q = hn_i_in_cells(p);",
       "hn_float q = p;"},
      {"fbm.fbm2_cell.lattice.fixed.fragment.gl330.finite", "detail/octave.glsl", "min(max(0.0f, x), most)", "x"},
      {"fbm.turbulence3.lattice.fast.fragment.gl330.finite", "detail/octave.glsl", "abs(mean) < 1.0e38f", "true"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

// One that lies in the range of an fBm is beyond that of others.
TEST_F(Extreme, SumsHaveRangesOfTheirOwn) {
  struct {
    std::string_view id;
    std::string_view fault;
  } constexpr kFaults[] = {
      {"fbm.turbulence2.lattice.fast.fragment.gl330.range",
       "hn_turbulence(q, o, l, args) (hn_turbulence(q, o, l, args) - 0.2)"},
      {"fbm.ridged2.lattice.fast.fragment.gl330.range", "hn_ridged(q, o, l, args) (hn_ridged(q, o, l, args) - 0.3)"},
      {"fbm.ridged2_cell.lattice.fixed.fragment.gl330.range",
       "hn_ridged(c, o, l, g, args) (hn_ridged(c, o, l, g, args) + 0.2)"},
      {"fbm.billow2.lattice.precise.fragment.gl400.range", "hn_billow(q, o, l, args) (hn_billow(q, o, l, args) - 0.2)"},
      {"fbm.ping_pong2.lattice.fast.fragment.gl330.range",
       "hn_ping_pong(q, o, l, g, s, args) (hn_ping_pong(q, o, l, g, s, args) + 0.001)"},
      {"fbm.ping_pong2_cell.lattice.fixed.fragment.gl330.range",
       "hn_ping_pong(c, o, l, g, s, args) (hn_ping_pong(c, o, l, g, s, args) - 0.0000005)"},
      {"fbm.weighted2.lattice.fast.fragment.gl330.range",
       "hn_weighted(q, o, l, g, s, args) (hn_weighted(q, o, l, g, s, args) * 1.5)"}};
  for (const auto& [id, fault] : kFaults) expect_caught(id, "fbm2d.glsl", fault);
}

// The settings decide how far a shift can be, and how steep a sum.
TEST_F(Extreme, RangesThatDependOnSettingsAreHeld) {
  expect_caught("warp.warp2.lattice.fast.fragment.gl330.range", "warp2d.glsl",
                "hn_warp(q, o, l, g, s, args) (hn_warp(q, o, l, g, s, args) * 1.2)");
  expect_caught("warp.warp_progressive3_cell.lattice.fixed.fragment.gl330.range", "warp3d.glsl",
                "hn_warp_progressive(c, o, l, g, s, args) (hn_warp_progressive(c, o, l, g, s, args) * 1.2)");
  expect_caught("fbm_d.fbm_d2.lattice.fast.fragment.gl330.range", "fbm_d2d.glsl",
                "hn_fbm_d(q, o, l, args) (hn_fbm_d(q, o, l, args) * vec3(1.0, 1.0, 2.0))");
  expect_caught("fbm_d.fbm_d3.lattice.fixed.fragment.gl330.finite", "fbm_d3d.glsl",
                "hn_fbm_d(q, o, l, args) (hn_fbm_d(q, o, l, args) * vec4(1.0, 1.0, 1.0, 5000.0))");
  expect_caught("noise2d.gullies.lattice.fast.fragment.gl330.range", "gullies2d.glsl",
                "hn_gullies(q, e, o, l, g, d, args) (3.0 * hn_gullies(q, e, o, l, g, d, args))");
  expect_caught("noise3d.perlin_worley.lattice.fast.fragment.gl330.range", "perlin_worley3d.glsl",
                "hn_perlin_worley(q, o, l, args) (0.5 + hn_perlin_worley(q, o, l, args))");
}

// Not the noise, the octaves' weights, or a sum's step of each octave.
TEST_F(Extreme, ASumOverAnotherNoiseThatIsNotThatSumIsCaught) {
  constexpr Replacement kFaults[] = {
      {"fbm.fbm2.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "hn_i_summed(s.value, n, weight)",
       "hn_i_summed(s.value, n, HN_I_WEIGHT_ONE)"},
      {"fbm.ridged3_cell.lattice.fixed.fragment.gl330.other_noise", "detail/octave.glsl",
       "next.feedback = min(hn_i_plus(ridge, ridge), HN_I_WEIGHT_ONE)", "next.feedback = HN_I_WEIGHT_ONE"},
      {"fbm.ping_pong2_cell_period.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "floor(t * 0.5f)",
       "floor(t)"},
      {"fbm.weighted2.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "(0.5f - 0.5f * n)",
       "(0.5f + 0.5f * n)"},
      {"fbm.ridged4.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "min(hn_i_plus(ridge, ridge), ",
       "min(ridge, "},
      {"fbm_d.fbm_d2_cell.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl",
       "hn_i_wide_minus(hn_i_wide_times(k.x, g.y), hn_i_wide_times(k.y, g.x))",
       "hn_i_wide_plus(hn_i_wide_times(k.x, g.y), hn_i_wide_times(k.y, g.x))"},
      {"fbm_d.fbm_d2.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
       "min(max(-4.0f, g), 4.0f)"},
      {"fbm_d.fbm_d3.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
       "min(max(-50.0f, g), 50.0f)"},
      {"fbm_d.fbm_d2.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
       "min(max(-128.0f, g), 130.0f)"},
      {"fbm_d.fbm_d3.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
       "min(max(-130.0f, g), 128.0f)"},
      {"fbm_d.eroded3.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "(hn_i_octave_slope(g) >> 7)",
       "(hn_i_octave_slope(g) >> 8)"},
      {"fbm_d.eroded2_cell_period.lattice.fast.fragment.gl330.other_noise", "detail/jacobian.glsl",
       "hn_i_num2 next = e;", "hn_i_num2 next = hn_i_rotated(e);"},
      {"fbm.hybrid2.lattice.fixed.fragment.gl330.other_noise", "detail/octave.glsl",
       "int(min(max(-1.0f, n), 1.0f) * HN_I_FLOAT_UNITS_VALUE)",
       "int(min(max(-1.0f, n), 1.015625f) * HN_I_FLOAT_UNITS_VALUE)"},
      {"fbm.ping_pong3.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl",
       "hn_i_bounded_octave(hn_float n) { return min(max(-1.0f, n), 1.0f); }",
       "hn_i_bounded_octave(hn_float n) { return min(max(-1.015625f, n), 1.0f); }"},
      {"warp.warp3.lattice.fast.fragment.gl330.other_noise", "detail/jacobian.glsl",
       "hn_i_bounded(hn_i_mean(s, sum, total))", "hn_i_bounded(hn_i_mean(s, sum, total + 1.0))"},
      {"warp.warp_progressive2_cell_period.lattice.fixed.fragment.gl330.other_noise", "warp2d.glsl",
       "s.y = hn_i_summed(s.y,", "s.y = hn_i_summed(s.x,"},
      {"fbm.fbm3_detail.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "hn_float total = part",
       "hn_float total = 1.0f"},
      // The position of a place that is outside of its cell.
      {"fbm.fbm2.lattice.fast.fragment.gl330.other_noise", "detail/cell2d.glsl",
       "hn_i_float(cell) + (fraction + hn_i_float(rest))", "hn_i_float(cell) - (fraction + hn_i_float(rest))"},
      {"fbm.fbm3_cell.lattice.fixed.fragment.gl330.other_noise", "detail/cell2d.glsl", "fraction * 16 + rest",
       "fraction * 32 + rest"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

TEST_F(Extreme, FixedArithmeticHasANumberForWhatIsNone) {
  expect_caught(kPerlins[2], "perlin2d.glsl", "hn_perlin(args) (isinf(p.x) ? p.x : hn_perlin(args))");
}

// Ordinary points would hide both: a subnormal position is seen, and it counts.
TEST_F(Extreme, TwinPointsOfFixedAndPreciseArithmeticAreExtremeToo) {
  for (const std::string_view id :
       {"noise2d.perlin.lattice.fixed.fragment.gl330.twin", "noise2d.perlin.lattice.precise.fragment.gl400.twin"}) {
    for (const std::string_view where : {"abs(p.x) > 1.0e30", "p.x != 0.0 && abs(p.x) < 1.0e-30"}) {
      expect_caught(id, "perlin2d.glsl", fmt::format("hn_perlin(args) ({} ? 0.123 : hn_perlin(args))", where));
    }
  }
}

constexpr std::string_view kTwin = "noise2d.perlin.lattice.fast.fragment.gl330.twin";

class Batches : public FaultyLibrary {
 protected:
  void SetUp() override {
    FaultyLibrary::SetUp();
    if (HasFatalFailure()) return;
    session_.emplace(Suite{sources_, reference_, HN_GOLDEN_DIRECTORY, 1, 2500}, *context_, 1000);
  }

  // Makes the value wrong, by difference, where x is a point's.
  void break_at(const Words& inputs, std::size_t point, double difference) {
    faults_ += fmt::format("+ (floatBitsToUint(p.x) == {}u ? {:.9f} : 0.0) ", inputs[point * kInputWords], difference);
    append("perlin2d.glsl", fmt::format("#define hn_perlin(args) (hn_perlin(args) {})", faults_));
  }

  // The points of the batch; copied, since the session keeps those of one batch only.
  Words points_of(std::uint64_t batch) {
    const auto& function = find_function("noise2d.perlin");
    return session_->twin_points(function, default_configuration(), 1000, batch).inputs;
  }

  std::optional<Session> session_;
  std::string faults_;
};

TEST_F(Batches, TogetherHaveAsManyPointsAsWereAskedFor) {
  int parts = 0;
  session_->still_alive = [&] { ++parts; };
  const Outcome outcome = run(*session_, kTwin);
  EXPECT_EQ(outcome.status, Status::pass) << outcome.message;
  EXPECT_EQ(outcome.samples, 2500u);
  EXPECT_EQ(parts, 2);
  session_->points = 1000;
  EXPECT_EQ(run(*session_, kTwin).samples, 1000u);
  session_->points = 1;
  EXPECT_EQ(run(*session_, kTwin).samples, 1u);
}

TEST_F(Batches, HavePointsOfTheirOwn) {
  const Words first = points_of(0);
  EXPECT_EQ(first, points_of(0));
  EXPECT_NE(first, points_of(1));
  EXPECT_NE(points_of(1), points_of(2));
  // Without --points there is one batch, and it is the first.
  EXPECT_EQ(first, random_points(find_function("noise2d.perlin"), 1000, Random(1, "noise2d.perlin")));
}

TEST_F(Batches, AddUpWhatIsWrongAndKeepTheLargestDifference) {
  const Words first = points_of(0);
  const Words second = points_of(1);
  break_at(first, 7, 0.5);
  break_at(second, 3, 0.25);
  const Outcome outcome = run(*session_, kTwin);
  EXPECT_EQ(outcome.status, Status::fail);
  EXPECT_EQ(outcome.samples, 2500u);
  EXPECT_EQ(outcome.mismatches, 2u);
  EXPECT_NEAR(outcome.max_abs, 0.5, 1e-5);
  ASSERT_EQ(outcome.examples.size(), 2u);
  EXPECT_EQ(outcome.examples[0].point, 7u);
  EXPECT_EQ(outcome.examples[1].point, 1003u);
  EXPECT_EQ(outcome.examples[1].words[0], second[3 * kInputWords]);
}

// The last bit of a fraction, a corner that is beside the corner, a first octave in the cell behind the place, and a
// number of cells in the place of a position.
TEST_F(FaultyLibrary, APositionThatIsNotThatOfThePlaceIsCaught) {
  constexpr std::string_view kFast = "place.all.lattice.fast.vertex.gl330.positions";
  constexpr std::string_view kFixed = "place.all.lattice.fixed.vertex.gl330.positions";
  for (const Replacement& fault : {
           Replacement{kFixed, "octaves1d.glsl", "HN_I_REST(o.x.y & 15)", "HN_I_REST(o.x.y & 14)"},
           Replacement{kFixed, "octaves4d.glsl", "HN_I_REST(o.w.y & 15)", "HN_I_REST(o.w.y & 14)"},
           Replacement{kFast, "place.glsl", "vec3(0.0f, 0.0f, 0.0f)", "vec3(0.0f, 0.0f, 0.015625f)"},
           Replacement{kFixed, "place.glsl", "vec3(0.0f, 0.0f, 0.0f)", "vec3(0.0f, 0.0f, 0.015625f)"},
           Replacement{kFixed, "place.glsl", "HN_I_REST(hn_i_rest_of_position(p.y))", "HN_I_REST(0)"},
           Replacement{kFast, "position.glsl",
                       "hn_place(hn_int position, hn_int cells, hn_int units) {\n"
                       "  return hn_place(hn_cell(position, cells, units), hn_fraction(position, cells, units));",
                       "hn_place(hn_int position, hn_int cells, hn_int units) {\n"
                       "  return hn_place(hn_cell(position, cells, units), hn_fraction(cells, position, units));"},
           Replacement{kFixed, "position.glsl", "hn_fraction(position.w, cells, units)",
                       "hn_fraction(position.w + 1, cells, units)"},
           Replacement{kFast, "octaves2d.glsl", "ivec2(o.x.x, o.y.x)", "ivec2(o.x.x, o.y.x + (o.y.y >> 24))"},
           Replacement{kFixed, "octaves2d.glsl", "ivec2(o.x.x, o.y.x)", "ivec2(o.x.x, o.y.x + (o.y.y >> 24))"},
       }) {
    expect_replaced_caught(fault);
  }
}

}  // namespace
}  // namespace hn
