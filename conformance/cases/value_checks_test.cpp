// How many points a check takes, and the batches of more than a grid takes.
#include "cases/value_checks.hpp"

#include <optional>

#include "cases/faulty_library_fixture.hpp"
#include "expected/points.hpp"

namespace hn {
namespace {

TEST_F(FaultyLibrary, ADriverGetsAsManyTwinPointsAsItsSessionSays) {
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

}  // namespace
}  // namespace hn
