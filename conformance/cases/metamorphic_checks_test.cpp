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

TEST_F(Metamorphic, AFaultOnOneWayAloneIsCaught) {
  for (const auto& [name, check] :
       {Detour{"CASE_INLINED", "fragment.gl330.inlined"}, Detour{"CASE_INLINED", "fragment.es300.inlined"},
        Detour{"CASE_IN_LOOP", "fragment.gl330.in_loop"}, Detour{"CASE_CONSTANT_SEED", "fragment.gl330.constant_seed"},
        Detour{"CASE_UNIFORM_SEED", "fragment.gl330.uniform_seed"}, Detour{"CASE_CONSTANT", "fragment.gl330.folded"},
        Detour{"CASE_VERTEX", "vertex.gl330.as_fragment"}, Detour{"CASE_VERTEX", "vertex.es300.as_fragment"},
        Detour{"CASE_COMPUTE", "compute.gl430.as_fragment"}, Detour{"CASE_COMPUTE", "compute.es310.as_fragment"},
        Detour{"CASE_VERTEX", "vertex.es300.golden"}, Detour{"CASE_COMPUTE", "compute.gl430.golden"},
        Detour{"CASE_FRAGMENT", "fragment.es300.twin"}}) {
    // More than two evaluations may differ by, and less than an eye would see.
    expect_caught({fmt::format("noise2d.perlin.lattice.fast.{}", check), "perlin2d.glsl", kMacro,
                   "hn_perlin(args) (hn_perlin(args) + 0.00001)", name});
    expect_caught({fmt::format("hash.lattice3.lattice.exact.{}", check), "hash.glsl", kMacro,
                   "hn_lattice(args) (hn_lattice(args) ^ 1u)", name});
  }
}

// The least that a result can differ by.
TEST_F(Metamorphic, InPreciseAndFixedArithmeticEveryBitCounts) {
  for (const auto& [name, check] :
       {Detour{"CASE_INLINED", "fixed.fragment.gl330.inlined"}, Detour{"CASE_CONSTANT", "fixed.fragment.gl330.folded"},
        Detour{"CASE_COMPUTE", "fixed.compute.es310.as_fragment"}, Detour{"CASE_VERTEX", "fixed.vertex.es300.golden"},
        Detour{"CASE_FRAGMENT", "fixed.fragment.gl140.golden"}, Detour{"CASE_FRAGMENT", "fixed.fragment.es300.twin"},
        Detour{"CASE_INLINED", "precise.fragment.gl400.inlined"},
        Detour{"CASE_VERTEX", "precise.vertex.gl400.as_fragment"},
        Detour{"CASE_FRAGMENT", "precise.fragment.gl400.twin"}}) {
    const Outcome wrong =
        expect_caught({fmt::format("noise3d.perlin.lattice.{}", check), "perlin3d.glsl", kMacro,
                       "hn_perlin(args) uintBitsToFloat(floatBitsToUint(hn_perlin(args)) + 1u)", name});
    EXPECT_EQ(wrong.mismatches, wrong.samples) << check;
    EXPECT_NE(wrong.max_ulp, 0u) << check;
  }
}

TEST_F(Metamorphic, AVariantNeedsItsSeed) {
  for (const auto& [name, check] :
       {Detour{"CASE_CONSTANT_SEED", "constant_seed"}, Detour{"CASE_UNIFORM_SEED", "uniform_seed"}}) {
    expect_caught({fmt::format("noise3d.perlin.lattice.fast.fragment.es300.{}", check), "perlin3d.glsl", kMacro,
                   "hn_perlin(args) hn_perlin(p, 0u)", name});
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

TEST_F(Metamorphic, AConstantPeriodThatCountsOtherwiseIsCaught) {
  for (const std::string_view arithmetic : {"fast", "fixed"}) {
    expect_caught({fmt::format("noise3d.perlin_cell_period.lattice.{}.fragment.gl330.constant_period", arithmetic),
                   "perlin3d.glsl", kMacro, "hn_perlin(t, args) hn_perlin(hn_tile(t, period + 1), args)",
                   "CASE_CONSTANT_PERIOD"});
  }
}

}  // namespace
}  // namespace hn
