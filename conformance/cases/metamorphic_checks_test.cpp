// The metamorphic checks and the stages, on a library with a fault that shows in one place only.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/faulty_library_fixture.hpp"

namespace hn {
namespace {

class Metamorphic : public FaultyLibrary {};

struct Way {
  std::string_view name;   // what the shader calls itself
  std::string_view check;  // stage.profile.check
};

class AFault : public Metamorphic, public testing::WithParamInterface<Way> {
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

TEST_P(AFault, InANoiseIsCaught) {
  // More than two evaluations may differ by, and less than an eye would see.
  expect_caught("noise2d.perlin.lattice.fast", "perlin2d.glsl", "#define hn_perlin(args) (hn_perlin(args) + 0.00001)");
}

TEST_P(AFault, InTheLastBitOfAHashIsCaught) {
  expect_caught("hash.lattice3.lattice.exact", "hash.glsl", "#define hn_lattice(args) (hn_lattice(args) ^ 1u)");
}

INSTANTIATE_TEST_SUITE_P(
    Ways, AFault,
    testing::Values(Way{"CASE_INLINED", "fragment.gl330.inlined"}, Way{"CASE_INLINED", "fragment.es300.inlined"},
                    Way{"CASE_IN_LOOP", "fragment.gl330.in_loop"},
                    Way{"CASE_CONSTANT_SEED", "fragment.gl330.constant_seed"},
                    Way{"CASE_UNIFORM_SEED", "fragment.gl330.uniform_seed"},
                    Way{"CASE_CONSTANT", "fragment.gl330.folded"}, Way{"CASE_VERTEX", "vertex.gl330.as_fragment"},
                    Way{"CASE_VERTEX", "vertex.es300.as_fragment"}, Way{"CASE_COMPUTE", "compute.gl430.as_fragment"},
                    Way{"CASE_COMPUTE", "compute.es310.as_fragment"}, Way{"CASE_VERTEX", "vertex.es300.golden"},
                    Way{"CASE_COMPUTE", "compute.gl430.golden"}, Way{"CASE_FRAGMENT", "fragment.es300.twin"}));

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
  const auto found = std::find_if(cases_.begin(), cases_.end(), [&](const Case& test) { return test.id == kId; });
  const auto program = session.evaluation_program(*found->evaluation());
  ASSERT_TRUE(program);
  for (const int trips : {0, 3, 5}) {
    (*program)->set("trips", trips);
    EXPECT_NE(run(session, kId).mismatches, 0u) << trips;
  }
}

struct Aperiodic {
  std::string_view id;  // without check
  std::string_view file;
  std::string_view fault;
};

TEST_F(Metamorphic, AFunctionWithoutItsPeriodIsCaught) {
  constexpr Aperiodic kFaults[] = {
      {"gradient.lattice2.lattice+period48.exact", "gradient.glsl",
       "hn_gradient(args) (hn_gradient(args) + float(int(a.x)))"},
      {"gradient.sine3.fnv1+sine+period1048576.fast", "gradient.glsl",
       "hn_gradient(args) (hn_gradient(args) + float(int(a.y)))"},
      {"noise2d.perlin.lattice+period64.fast", "perlin2d.glsl", "hn_perlin(args) (hn_perlin(args) + 0.00001 * p.x)"},
      {"noise3d.perlin_cell.lattice+period1048576.fast", "perlin3d.glsl",
       "hn_perlin(c, args) (hn_perlin(c, args) + float(cell.z))"},
      {"fbm.clouds3.lattice+period48.fast", "fbm3d.glsl",
       "hn_clouds(q, o, l, args) (hn_clouds(q, o, l, args) + 0.00001 * p.z)"},
      {"fbm.fbm2.lattice+period48.fixed", "fbm2d.glsl",
       "hn_fbm(q, o, l, args) (hn_fbm(q, o, l, args) + 0.0000005 * p.x)"},
      // Only many octaves come to so large a cell.
      {"fbm.fbm2.lattice+period48.fixed", "perlin2d.glsl",
       "hn_i_perlin(cell, f, seed) hn_i_perlin(clamp(cell, -8388608, 8388607), f, seed)"}};
  for (const Aperiodic& fault : kFaults) {
    for (const std::string_view profile : {"gl330", "es300"}) {
      if (fault.id.ends_with(".fixed") && profile == "es300") continue;  // it has no such case
      const auto id = fmt::format("{}.fragment.{}.period", fault.id, profile);
      sources_ = SourceSet::embedded();
      EXPECT_EQ(run(id).status, Status::pass) << id;
      append(fault.file, fmt::format("#define {}", fault.fault));
      const Outcome wrong = run(id);
      EXPECT_NE(wrong.mismatches, 0u) << id << ": " << wrong.message;
    }
  }
}

TEST_F(Metamorphic, ADriverGetsAsManyTwinPointsAsItsSessionSays) {
  Session session({sources_, reference_, HN_GOLDEN_DIRECTORY, 1}, *context_);
  constexpr std::string_view kGl = "hash.word.pcg.exact.fragment.gl330.twin";
  constexpr std::string_view kEs = "hash.word.pcg.exact.fragment.es300.twin";
  EXPECT_EQ(run(session, "hash.word.lattice.exact.fragment.gl330.twin").samples, 1u << 18);
  EXPECT_EQ(run(session, "hash.word.lattice.exact.fragment.es300.twin").samples, 1u << 14);
  EXPECT_EQ(run(session, kGl).samples, 1u << 16);
  EXPECT_EQ(run(session, kEs).samples, 1u << 12);
  EXPECT_EQ(run(session, "fbm.fbm2.lattice.fast.fragment.gl330.twin").samples, 1u << 16);
  EXPECT_EQ(run(session, "noise3d.perlin.lattice.fixed.fragment.gl330.twin").samples, 1u << 18);
  EXPECT_EQ(run(session, "noise3d.perlin.lattice.precise.fragment.gl400.twin").samples, 1u << 18);
  session.most_points = 1000;
  for (const std::string_view id : {kGl, kEs}) {
    const Outcome outcome = run(session, id);
    EXPECT_EQ(outcome.samples, 1000u);
    EXPECT_EQ(outcome.status, Status::pass);
  }
}

}  // namespace
}  // namespace hn
