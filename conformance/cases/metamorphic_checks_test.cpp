// The metamorphic checks and the stages, on a library with a fault that shows in one place only.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cases/faulty_library_fixture.hpp"
#include "cases/value_checks.hpp"
#include "expected/twin.hpp"

namespace hn {
namespace {

// The relations of every function in HN_FIXED, on the C++ twin: a run of pairs tries a part of them on a driver.
// Variants of a shader are the same function there. With tools/test --thorough in all arithmetics, at as many points as
// on drivers.
TEST(Relations, HoldInTheTwin) {
  const bool thorough = std::getenv("HN_THOROUGH") != nullptr;
  std::size_t held = 0;
  for (const Configuration& configuration : all_configurations()) {
    if (!configuration.default_but_for_arithmetic()) continue;
    if (!thorough && configuration.arithmetic != Arithmetic::fixed) continue;
    const Target target{&main_profile(configuration, false), Stage::fragment, true};
    for (const Function& function : all_functions()) {
      if (!covers(configuration, function)) continue;
      const Evaluation evaluation{function, configuration, *target.profile};
      std::vector<Relation> relations = relations_of(evaluation, target);
      for (const Relation& repetition : repetitions_of(evaluation)) relations.push_back(repetition);
      for (const Relation& relation : relations) {
        const auto* const kind = std::get_if<PairingKind>(&relation.kind);
        if (!kind || kind->make == variant_pairing || kind->make == folded_pairing) continue;
        const Pairing pairing = kind->make(kind->evaluation, 1, thorough ? kPairingPoints : kPairingPoints / 4);
        const auto got = evaluate_twin(pairing.evaluation.function, configuration, pairing.inputs);
        const auto expected = evaluate_twin(pairing.other.function, configuration, pairing.other_inputs);
        const Outcome outcome = judge_pairing(pairing, got, expected);
        EXPECT_EQ(outcome.status, Status::pass)
            << function.id << ' ' << configuration.name << ' ' << relation.check << ": " << outcome.message;
        ++held;
      }
    }
  }
  EXPECT_GT(held, 400u);
}

class Metamorphic : public FaultyLibrary {};

struct Detour {
  std::string_view name;   // the shader's name for itself
  std::string_view check;  // stage.profile.check
};

class DetourFault : public Metamorphic, public testing::WithParamInterface<Detour> {
 protected:
  void expect_caught(std::string_view function, std::string_view file, std::string_view fault) {
    const auto id = fmt::format("{}.{}", function, GetParam().check);
    const Outcome right = run(id);
    EXPECT_EQ(right.status, Status::pass) << id << ": " << right.message;
    append(file, fmt::format("#ifdef {}\n{}\n#endif", GetParam().name, fault));
    const Outcome wrong = run(id);
    EXPECT_EQ(wrong.status, Status::fail) << id << ": " << wrong.message;
    EXPECT_NE(wrong.mismatches, 0u) << id;
  }
};

TEST_P(DetourFault, InANoiseIsCaught) {
  // More than two evaluations may differ by, and less than an eye would see.
  expect_caught("noise2d.perlin.lattice.fast", "perlin2d.glsl", "#define hn_perlin(args) (hn_perlin(args) + 0.00001)");
}

TEST_P(DetourFault, InTheLastBitOfAHashIsCaught) {
  expect_caught("hash.lattice3.lattice.exact", "hash.glsl", "#define hn_lattice(args) (hn_lattice(args) ^ 1u)");
}

INSTANTIATE_TEST_SUITE_P(
    Ways, DetourFault,
    testing::Values(Detour{"CASE_INLINED", "fragment.gl330.inlined"}, Detour{"CASE_INLINED", "fragment.es300.inlined"},
                    Detour{"CASE_IN_LOOP", "fragment.gl330.in_loop"},
                    Detour{"CASE_CONSTANT_SEED", "fragment.gl330.constant_seed"},
                    Detour{"CASE_UNIFORM_SEED", "fragment.gl330.uniform_seed"},
                    Detour{"CASE_CONSTANT", "fragment.gl330.folded"}, Detour{"CASE_VERTEX", "vertex.gl330.as_fragment"},
                    Detour{"CASE_VERTEX", "vertex.es300.as_fragment"},
                    Detour{"CASE_COMPUTE", "compute.gl430.as_fragment"},
                    Detour{"CASE_COMPUTE", "compute.es310.as_fragment"}, Detour{"CASE_VERTEX", "vertex.es300.golden"},
                    Detour{"CASE_COMPUTE", "compute.gl430.golden"}, Detour{"CASE_FRAGMENT", "fragment.es300.twin"}));

// The least that a result can differ by.
TEST_F(Metamorphic, InPreciseAndFixedArithmeticEveryBitCounts) {
  struct {
    std::string_view id;
    std::string_view name;
  } constexpr kWays[] = {
      {"noise3d.perlin.lattice.fixed.fragment.gl330.inlined", "CASE_INLINED"},
      {"noise3d.perlin.lattice.fixed.fragment.gl330.folded", "CASE_CONSTANT"},
      {"noise3d.perlin.lattice.fixed.compute.es310.as_fragment", "CASE_COMPUTE"},
      {"noise3d.perlin.lattice.fixed.vertex.es300.golden", "CASE_VERTEX"},
      {"noise3d.perlin.lattice.fixed.fragment.gl140.golden", "CASE_FRAGMENT"},
      {"noise3d.perlin.lattice.fixed.fragment.es300.twin", "CASE_FRAGMENT"},
      {"noise3d.perlin.lattice.precise.fragment.gl400.inlined", "CASE_INLINED"},
      {"noise3d.perlin.lattice.precise.vertex.gl400.as_fragment", "CASE_VERTEX"},
      {"noise3d.perlin.lattice.precise.fragment.gl400.twin", "CASE_FRAGMENT"},
  };
  for (const auto& [id, name] : kWays) {
    sources_ = SourceSet::embedded();
    const Outcome right = run(id);
    EXPECT_EQ(right.status, Status::pass) << id << ": " << right.message;
    EXPECT_EQ(right.max_ulp, 0u) << id;
    append("perlin3d.glsl",
           fmt::format("#ifdef {}\n#define hn_perlin(args) uintBitsToFloat(floatBitsToUint(hn_perlin(args)) + 1u)\n"
                       "#endif",
                       name));
    const Outcome wrong = run(id);
    EXPECT_EQ(wrong.status, Status::fail) << id << ": " << wrong.message;
    EXPECT_EQ(wrong.mismatches, wrong.samples) << id;
    EXPECT_NE(wrong.max_ulp, 0u) << id;
  }
}

TEST_F(Metamorphic, AVariantNeedsItsSeed) {
  for (const std::string_view check : {"constant_seed", "uniform_seed"}) {
    const auto macro = check == "constant_seed" ? "CASE_CONSTANT_SEED" : "CASE_UNIFORM_SEED";
    append("perlin3d.glsl", fmt::format("#ifdef {}\n#define hn_perlin(args) hn_perlin(p, 0u)\n#endif", macro));
    EXPECT_NE(run(fmt::format("noise3d.perlin.lattice.fast.fragment.es300.{}", check)).mismatches, 0u) << check;
  }
}

TEST_F(Metamorphic, EveryTripOfTheLoopCounts) {
  Session session({sources_, reference_, HN_GOLDEN_DIRECTORY, 1}, *context_);
  constexpr std::string_view kId = "fbm.fbm2.lattice.fast.fragment.gl330.in_loop";
  EXPECT_EQ(run(session, kId).status, Status::pass);
  const Case test = case_named(kId);
  const auto evaluable = session.evaluable(*test.evaluation());
  ASSERT_TRUE(evaluable);
  for (const std::uint32_t trips : {0u, 3u, 5u}) {
    (*evaluable)->uniforms.trips = trips;
    EXPECT_NE(run(session, kId).mismatches, 0u) << trips;
  }
}

// Every point of a check of periods must be able to show a fault; so each is tried on the ways that a noise can go.
struct Aperiodic {
  std::string_view id;  // without stage
  std::string_view check;
  std::string_view file;
  std::string_view fault;
};

class Periods : public Metamorphic {
 protected:
  using FaultyLibrary::expect_caught;
  void expect_caught(const Aperiodic& fault) {
    expect_caught(fmt::format("{}.{}", fault.id, fault.check), fault.file, fault.fault);
  }
};

TEST_F(Periods, AFunctionThatDoesNotRepeatIsCaught) {
  constexpr Aperiodic kFaults[] = {
      {"noise2d.perlin_period.lattice.fast.fragment.gl330", "period", "perlin2d.glsl",
       "hn_perlin(t, args) (hn_perlin(t, args) + 0.00001 * p.x)"},
      {"noise2d.perlin_period.lattice.fast.fragment.es300", "period", "perlin2d.glsl",
       "hn_perlin(t, args) (hn_perlin(t, args) + 0.00001 * p.x)"},
      {"noise3d.perlin_cell_period.lattice.fast.fragment.gl330", "period", "perlin3d.glsl",
       "hn_perlin(t, args) (hn_perlin(t, args) + float(cell.z))"},
      {"noise2d.perlin_cell_period.lattice+sine.fast.fragment.gl330", "period", "perlin2d.glsl",
       "hn_perlin(t, args) (hn_perlin(t, args) + 0.001 * float(cell.y & 64))"},
      // A seam that is one cell late.
      {"noise1d.value_cell_period.lattice.fixed.fragment.gl330", "period", "value1d.glsl",
       "hn_value(t, args) hn_value(hn_tile(t, period + int(period > 0)), args)"},
      {"noise4d.perlin_d_cell_period.lattice.fast.fragment.gl330", "period", "perlin_d4d.glsl",
       "hn_perlin_d(t, args) hn_perlin_d(hn_tile(t, ivec4(period.x, period.y, period.z, 0)), args)"},
      {"fbm.clouds3_cell_period.lattice.fast.fragment.gl330", "period", "fbm3d.glsl",
       "hn_clouds(t, o, l, g, args) (hn_clouds(t, o, l, g, args) + 0.00001 * float(cell.z))"},
      {"fbm.fbm2_period.lattice.fixed.fragment.gl330", "period", "fbm2d.glsl",
       "hn_fbm(t, o, l, g, args) (hn_fbm(t, o, l, g, args) + 0.0000005 * p.x)"}};
  for (const Aperiodic& fault : kFaults) expect_caught(fault);
  // Only many octaves come to so large a cell.
  expect_replaced_caught({"fbm.fbm2_period.lattice.fixed.fragment.gl330.period", "octaves2d.glsl",
                          "ivec2(o.x.x, o.y.x)", "clamp(ivec2(o.x.x, o.y.x), -8388608, 8388607)"});
  expect_replaced_caught({"fbm.billow2_cell_period.lattice.fast.fragment.gl330.period", "detail/octave.glsl",
                          "return int(uint(period) * uint(lacunarity));",
                          "return int(uint(period) * uint(lacunarity)) + int(period > 0);"});
  // A tile that rotates.
  expect_replaced_caught({"warp.warp_progressive2_cell_period.lattice.fixed.fragment.gl330.period", "octaves2d.glsl",
                          "hn_i_shifted(x, HN_I_SHIFT_X)",
                          "hn_i_shifted(hn_i_rotated_axis(x, y, HN_I_COS_XY, -HN_I_SIN_XY), HN_I_SHIFT_X)"});
}

// From a cell, in every arithmetic and with a period: the fraction, and a step that only one of the two goes.
TEST_F(Periods, ASumFromACellThatIsNotThatAtThePositionIsCaught) {
  constexpr Replacement kFaults[] = {
      {"fbm.fbm2_cell.lattice.fast.fragment.gl330.from_cell", "octaves2d.glsl",
       "o.x = hn_i_fixed_position(place.cell.x, place.fraction.x, ",
       "o.x = hn_i_fixed_position(place.cell.x, 0.999f * place.fraction.x, "},
      {"fbm.ridged3_cell.lattice.fixed.fragment.gl330.from_cell", "place.glsl", "hn_i_place(cell, hn_i_to_num(f),",
       "hn_i_place(cell, hn_i_to_num(f) ^ 256,"},
      {"warp.warp_progressive2_cell.lattice.fast.fragment.gl330.from_cell", "detail/jacobian.glsl",
       "hn_i_minus(n, cells)", "hn_i_minus(0.5f * n, 0.5f * cells)"},
      {"fbm.fbm2_cell_period.lattice.precise.fragment.gl400.from_cell", "detail/cell2d.glsl",
       "hn_i_place(cell, hn_i_to_num(f),", "hn_i_place(cell, 0.999f * hn_i_to_num(f),"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

TEST_F(Periods, AWholeDetailThatIsNoNumberOfOctavesIsCaught) {
  constexpr Replacement kFaults[] = {{"fbm.fbm2_detail.lattice.fast.fragment.gl330.whole_detail", "detail/octave.glsl",
                                      "float(octaves - 1));", "float(octaves - 1) + 0.01f);"},
                                     {"fbm.fbm3_detail.lattice.precise.fragment.gl400.whole_detail",
                                      "detail/octave.glsl", "float(octaves - 1));", "float(octaves - 1) + 0.00001f);"},
                                     {"fbm.fbm3_detail.lattice.fixed.fragment.gl330.whole_detail", "detail/octave.glsl",
                                      "detail), 32.0f", "detail), 31.0f"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

TEST_F(Periods, ASmallFootprintThatFadesOctavesIsCaught) {
  constexpr Replacement kFaults[] = {
      {"fbm.fbm2_footprint.lattice.fast.fragment.gl330.small_footprint", "detail/octave.glsl",
       "hn_i_minus(1.5f, footprint)", "hn_i_minus(1.4f, footprint)"},
      {"fbm.fbm3_footprint.lattice.fixed.fragment.gl330.small_footprint", "detail/octave.glsl",
       "3 * HN_I_UNITS_WEIGHT / 2 - (footprint >> 6)", "3 * HN_I_UNITS_WEIGHT / 2 - 16 - (footprint >> 6)"},
      {"fbm.fbm3_footprint.lattice.precise.fragment.gl400.small_footprint", "detail/octave.glsl",
       "hn_i_times(footprint, max(lacunarity, 1.0f))", "hn_i_times(footprint, 2.0f * max(lacunarity, 1.0f))"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

// The form without periods is under test as well, so only the other's calls may be wrong.
TEST_F(Periods, AFormThatIsNotTheOneWithoutPeriodsIsCaught) {
  constexpr Replacement kFaults[] = {
      // A period of 0 that is one of 2^20, and a large one that counts as none.
      {"noise2d.perlin_cell_period.lattice.fast.fragment.gl330.wrapped", "perlin2d.glsl", "hn_i_cell_corners(place)",
       "hn_i_cell_corners(hn_tile(place, ivec2(place.tiled && place.period.x == 0 ? 1048576 : place.period.x, "
       "place.period.y)))"},
      {"noise3d.value_cell_period.lattice.fixed.fragment.gl330.wrapped", "value3d.glsl", "hn_i_cell_corners(place)",
       "hn_i_cell_corners(hn_tile(place, ivec3(place.period.xy, place.period.z > 1073741824 ? 0 : place.period.z)))"},
      // Cells below 0 count towards it.
      {"noise2d.value_cubic_cell_period.lattice.precise.fragment.gl400.wrapped", "detail/cell2d.glsl",
       "hn_i_select(c < 0, mask - rest, rest)", "rest"},
      {"noise1d.perlin_d_cell_period.lattice.fast.fragment.gl330.wrapped", "perlin_d1d.glsl", "place.fraction",
       "place.fraction + (place.tiled ? 0.001 : 0.0)"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

TEST_F(Periods, AConstantPeriodThatCountsOtherwiseIsCaught) {
  constexpr std::string_view kFault =
      "#ifdef CASE_CONSTANT_PERIOD\n#define hn_perlin(t, args) hn_perlin(hn_tile(t, period + 1), args)\n#endif";
  constexpr std::string_view kIds[] = {"noise3d.perlin_cell_period.lattice.fast.fragment.gl330.constant_period",
                                       "noise3d.perlin_cell_period.lattice.fixed.fragment.gl330.constant_period"};
  for (const std::string_view id : kIds) {
    sources_ = SourceSet::embedded();
    const Outcome right = run(id);
    EXPECT_EQ(right.status, Status::pass) << id << ": " << right.message;
    append("perlin3d.glsl", kFault);
    EXPECT_EQ(run(id).status, Status::fail) << id;
  }
}

class Derivatives : public Periods {};

// In every dimension and arithmetic: a sign, a factor, components in another order, and what the slope of the fade
// curve adds.
TEST_F(Derivatives, FaultsAreCaught) {
  constexpr Aperiodic kFaults[] = {
      {"noise1d.perlin_d.lattice.fast.fragment.gl330", "derivative", "perlin_d1d.glsl",
       "hn_perlin_d(args) (vec2(1.0, -1.0) * hn_perlin_d(args))"},
      {"noise2d.value_d.lattice.fast.fragment.gl330", "derivative", "value_d2d.glsl",
       "hn_value_d(args) (vec3(1.0, 1.0, 1.01) * hn_value_d(args))"},
      {"noise2d.perlin_d_cell.lattice.fixed.fragment.gl330", "derivative", "perlin_d2d.glsl",
       "hn_perlin_d(c, args) (vec3(1.0, 1.01, 1.0) * hn_perlin_d(c, args))"},
      {"noise3d.perlin_d.lattice.precise.fragment.gl400", "derivative", "perlin_d3d.glsl",
       "hn_perlin_d(args) hn_perlin_d(args).xzyw"},
      {"noise3d.value_d_cell_period.lattice.fixed.fragment.gl330", "derivative", "value_d3d.glsl",
       "hn_value_d(t, args) hn_value_d(t, args).xzyw"},
      {"noise4d.perlin_d.lattice.fast.fragment.gl330", "derivative", "detail/derivative.glsl",
       "hn_i_d_fade(f) (0.0 * hn_i_d_fade(f))"},
      {"noise2d.perlin_d.lattice.fast.fragment.gl330", "derivative", "detail/derivative.glsl",
       "hn_i_d_fade(f) (0.0 * hn_i_d_fade(f))"},
      {"noise3d.value_d.lattice.fixed.fragment.gl330", "derivative", "detail/derivative.glsl",
       "hn_i_d_fade(f) (hn_i_d_fade(f) / 128 * 127)"}};
  for (const Aperiodic& fault : kFaults) expect_caught(fault);
}

// A sign, components in another order, an octave that does not grow, and a rotation in the other direction.
TEST_F(Derivatives, FaultsOfSumsAreCaught) {
  constexpr Replacement kFaults[] = {
      {"fbm_d.fbm_d2.lattice.fast.fragment.gl330.derivative", "detail/jacobian.glsl",
       "hn_i_wide_minus(hn_i_wide_times(k.x, g.y), hn_i_wide_times(k.y, g.x))",
       "hn_i_wide_plus(hn_i_wide_times(k.x, g.y), hn_i_wide_times(k.y, g.x))"},
      {"fbm_d.fbm_d2.lattice.fast.fragment.es300.derivative", "fbm_d2d.glsl",
       "hn_i_octave_slope(n.y), hn_i_octave_slope(n.z)", "hn_i_octave_slope(n.z), hn_i_octave_slope(n.y)"},
      {"fbm_d.fbm_d3_cell.lattice.fast.fragment.gl330.derivative", "detail/jacobian.glsl",
       "next.z = hn_i_rotated_by(z, y, HN_I_COS_YZ, HN_I_SIN_YZ);",
       "next.z = hn_i_rotated_by(z, y, HN_I_COS_YZ, -HN_I_SIN_YZ);"},
      {"fbm_d.fbm_d2_cell_period.lattice.precise.fragment.gl400.derivative", "detail/jacobian.glsl",
       "hn_i_num2 next = hn_i_wide_times(k, growth);", "hn_i_num2 next = k;"},
      {"fbm_d.fbm_d3_cell_period.lattice.fast.fragment.gl330.derivative", "detail/jacobian.glsl",
       "next.y = hn_i_wide_times(k.y, growth);", "next.y = hn_i_wide_times(k.y, 1.2f * growth);"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

TEST_F(Derivatives, ASumWithoutStrengthThatIsNoFbmIsCaught) {
  constexpr Replacement kFaults[] = {
      {"fbm_d.eroded2.lattice.fast.fragment.gl330.zero_strength", "detail/jacobian.glsl",
       "hn_i_multiply_add(square, strength, 1.0f)", "hn_i_multiply_add(square, strength + 0.001f, 1.0f)"},
      {"fbm_d.eroded3_cell.lattice.precise.fragment.gl400.zero_strength", "fbm_d3d.glsl", "hn_i_octave(n.x)",
       "hn_i_octave(n.y)"},
      {"fbm_d.eroded2_cell_period.lattice.fixed.fragment.gl330.zero_strength", "detail/jacobian.glsl",
       "divisor = 65536u", "divisor = 65537u"}};
  for (const Replacement& fault : kFaults) expect_replaced_caught(fault);
}

TEST_F(Derivatives, AnotherValueIsCaught) {
  expect_replaced_caught({"fbm_d.fbm_d3_cell.lattice.fixed.fragment.gl330.derivative_value", "fbm_d3d.glsl",
                          "hn_i_add_noise(o.sum, n.x);", "hn_i_add_noise(o.sum, n.x + 0.000001f);"});
  constexpr Aperiodic kFaults[] = {
      {"noise2d.perlin_d.lattice.fast.fragment.gl330", "derivative_value", "perlin_d2d.glsl",
       "hn_perlin_d(args) (vec3(0.0001, 0.0, 0.0) + hn_perlin_d(args))"},
      {"noise3d.value_d_cell.lattice.fixed.fragment.gl330", "derivative_value", "value_d3d.glsl",
       "hn_value_d(c, args) (vec4(0.0000005, 0.0, 0.0, 0.0) + hn_value_d(c, args))"}};
  for (const Aperiodic& fault : kFaults) expect_caught(fault);
  expect_replaced_caught({"noise4d.perlin_d_cell_period_value.lattice.precise.fragment.gl400.derivative_value",
                          "perlin_d4d.glsl", "n.value = hn_i_value(", "n.value = 1.0000001f * hn_i_value("});
}

// The polynomial through a cell's values has the derivative of the noise on both sides of a border.
TEST_F(Derivatives, AJumpAtTheBorderOfACellIsCaught) {
  expect_caught({"noise2d.value_d_cell.lattice.fast.fragment.gl330", "derivative", "value_d2d.glsl",
                 "hn_value_d(c, args) (hn_value_d(c, args) + vec3(0.0, f.x == 1.0 ? 0.02 : 0.0, 0.0))"});
}

TEST_F(Derivatives, NoiseThatIsNotZeroAtLatticePointsIsCaught) {
  expect_caught({"noise1d.perlin.lattice.fast.fragment.gl330", "zero", "perlin1d.glsl",
                 "hn_perlin(args) (hn_perlin(args) + 0.00001)"});
  expect_replaced_caught({"noise4d.perlin_d_value.lattice.fixed.fragment.gl330.zero", "perlin_d4d.glsl",
                          "n.value = hn_i_value(", "n.value = 0.00001f + hn_i_value("});
}

TEST_F(Metamorphic, ADriverGetsAsManyTwinPointsAsItsSessionSays) {
  Session session({sources_, reference_, HN_GOLDEN_DIRECTORY, 1}, *context_);
  constexpr std::string_view kGl = "hash.word.pcg.exact.fragment.gl330.twin";
  constexpr std::string_view kEs = "hash.word.pcg.exact.fragment.es300.twin";
  const auto samples = [&](std::string_view id) { return run(session, id).samples; };
  EXPECT_EQ(samples("hash.word.lattice.exact.fragment.gl330.twin"), 1u << 16);
  EXPECT_EQ(samples("hash.word.lattice.exact.fragment.es300.twin"), 1u << 14);
  EXPECT_EQ(samples(kGl), 1u << 14);
  EXPECT_EQ(samples(kEs), 1u << 12);
  EXPECT_EQ(samples("fbm.fbm2.lattice.fast.fragment.gl330.twin"), 1u << 14);
  session.thorough = true;
  EXPECT_EQ(samples("hash.word.lattice.exact.fragment.gl330.twin"), 1u << 18);
  EXPECT_EQ(samples("hash.word.lattice.exact.fragment.es300.twin"), 1u << 14);
  EXPECT_EQ(samples(kGl), 1u << 16);
  EXPECT_EQ(samples(kEs), 1u << 12);
  EXPECT_EQ(samples("fbm.fbm2.lattice.fast.fragment.gl330.twin"), 1u << 16);
  EXPECT_EQ(samples("noise3d.perlin.lattice.fixed.fragment.gl330.twin"), 1u << 18);
  EXPECT_EQ(samples("noise3d.perlin.lattice.precise.fragment.gl400.twin"), 1u << 18);
  session.most_points = 1000;
  for (const std::string_view id : {kGl, kEs}) {
    const Outcome outcome = run(session, id);
    EXPECT_EQ(outcome.samples, 1000u);
    EXPECT_EQ(outcome.status, Status::pass);
  }
}

}  // namespace
}  // namespace hn
