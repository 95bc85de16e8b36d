#include "bench/timing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <string_view>

#include "bench/subject.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

TEST(Timing, MedianAndSpread) {
  struct Row {
    std::vector<double> samples;
    double median;
    double spread;
  };
  const Row rows[] = {
      {{}, 0.0, 0.0},
      {{7.0}, 7.0, 0.0},
      {{9.0, 1.0}, 5.0, 2.0},
      {{9.0, 1.0, 2.0}, 2.0, 2.0},
      {{8.0, 1.0, 4.0, 2.0}, 3.0, 1.625},
      {{5.0, 1.0, 4.0, 2.0, 3.0}, 3.0, 1.0},
      {{2.0, 2.0, 1000.0, 2.0, 2.0}, 2.0, 0.0},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(Timing{row.samples}.median(), row.median);
    EXPECT_EQ(Timing{row.samples}.spread(), row.spread);
  }
}

TEST(Ratio, OfTooFewRoundsCannotBeTold) {
  EXPECT_FALSE(ratio({{6.0}}, {{1.0}}, {{1.0}}).known());
  EXPECT_FALSE(ratio({}, {}, {}).known());
  // Two of three rounds prove nothing.
  EXPECT_FALSE(ratio({{6.0, 6.0, 6.0}}, {{1.0, 0.5, 3.0}}, {{1.0, 1.0, 1.0}}).known());
  EXPECT_EQ(text_of({}), "cannot be told");
  EXPECT_EQ(text_of({1.234, 0.056}), "1.23 ± 0.06");
}

struct RatioRow {
  std::string_view what;
  std::vector<double> timing;
  std::vector<double> reference;
  std::vector<double> empty;
  double value;
  double spread;
};

TEST(Ratio, OfRounds) {
  const RatioRow rows[] = {
      {"the empty shader is taken off both", {7.0}, {3.0}, {1.0}, 3.0, 0.0},
      {"as fast as the empty shader", {1.0}, {3.0}, {1.0}, 0.0, 0.0},
      {"round by round, so that what slows a round down leaves its ratio", {4.0, 40.0}, {2.0, 20.0}, {0, 0}, 2.0, 0.0},
      {"the median of the rounds", {1.0, 2.0, 90.0}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, 2.0, 22.25},
      {"half the distance of the quartiles", {5.0, 1.0, 4.0, 2.0, 3.0}, {1, 1, 1, 1, 1}, {0, 0, 0, 0, 0}, 3.0, 1.0},
      {"rounds whose reference is no longer than the empty shader are left out",
       {6.0, 6.0, 6.0},
       {3.0, 0.5, 3.0},
       {1.0, 1.0, 1.0},
       2.5,
       0.0},
      {"more samples of the subject", {4.0, 100.0}, {2.0}, {0.0, 0.0}, 2.0, 0.0},
      {"more samples of the reference", {4.0}, {2.0, 100.0}, {0.0, 0.0}, 2.0, 0.0},
      {"more samples of the empty shader", {4.0}, {2.0}, {0.0, 100.0}, 2.0, 0.0},
  };
  for (const RatioRow& row : rows) {
    const Ratio is = ratio({row.timing}, {row.reference}, {row.empty});
    EXPECT_EQ(is.value, row.value) << row.what;
    EXPECT_EQ(is.spread, row.spread) << row.what;
  }
}

TEST(JudgeQuery, BelievesWhatGrowsWithTheWork) {
  for (const double factor : {3.0, 4.0, 5.0}) {
    EXPECT_EQ(judge_query(factor, 4.0, 4.0).clock, Clock::query) << factor;
    EXPECT_EQ(judge_query(4.0, factor, 4.0).clock, Clock::query) << factor;
    EXPECT_EQ(judge_query(4.0, 4.0, factor).clock, Clock::query) << factor;
  }
}

TEST(JudgeQuery, DoesNotBelieveOneNumberBeyondItsLimits) {
  for (const double factor : {0.0, 1.0, std::nextafter(3.0, 0.0), std::nextafter(5.0, 9.0), 16.0,
                              std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(judge_query(factor, 4.0, 4.0).clock, Clock::wall) << factor;
    EXPECT_EQ(judge_query(4.0, factor, 4.0).clock, Clock::wall) << factor;
    EXPECT_EQ(judge_query(4.0, 4.0, factor).clock, Clock::wall) << factor;
  }
}

TEST(JudgeQuery, SaysWhy) {
  const Gate gate = judge_query(1.5, 3.25, 4.75);
  EXPECT_EQ(gate.pixels, 1.5);
  EXPECT_EQ(gate.iterations, 3.25);
  EXPECT_EQ(gate.draws, 4.75);
  for (const std::string_view part : {"pixels take 1.5 times", "iterations 3.25 times", "4 draws 4.75 times", "not "}) {
    EXPECT_NE(gate.reason.find(part), std::string::npos) << gate.reason;
  }
  EXPECT_EQ(judge_query(4.0, 4.0, 4.0).reason.find("not "), std::string::npos);
}

class Stopwatched : public OnOsmesa<> {
 protected:
  void SetUp() override {
    OnOsmesa::SetUp();
    if (HasFatalFailure()) return;
    stopwatch_ = std::make_unique<Stopwatch>(*context_);
  }

  Result<Program> build(const std::string& fragment) {
    const SourceSet sources = SourceSet::embedded();
    const auto vertex_text = expand(sources, profile_named("gl330"), quad_vertex_shader());
    const auto fragment_text = expand(sources, profile_named("gl330"), fragment);
    if (!fragment_text) return tl::unexpected(fragment_text.error());
    return Program::build(*context_, *vertex_text, *fragment_text);
  }

  std::unique_ptr<Stopwatch> stopwatch_;
};

// Other programs on the machine can spoil a measurement, but hardly every time.
constexpr int kAttempts = 5;

TEST_F(Stopwatched, TimeGrowsWithTheWork) {
  constexpr int kRounds = 15;
  const auto program = build(loop_shader({"noise", 3, "#include \"noise3d.glsl\"\n", "hn_perlin(p)"}));
  ASSERT_TRUE(program) << program.error().text();
  const auto load = stopwatch_->sufficient_load(*program);
  ASSERT_TRUE(load) << load.error().text();
  Workload larger = *load;
  larger.width *= 2;
  larger.height *= 2;
  Workload twice_as_long = *load;
  twice_as_long.iterations *= 2;
  double pixels = 0.0;
  double iterations = 0.0;
  const auto as_expected = [&] { return pixels >= 2.5 && pixels <= 6.0 && iterations >= 1.4 && iterations <= 3.0; };
  for (int attempt = 0; attempt < kAttempts && !as_expected(); ++attempt) {
    const auto timings = stopwatch_->measure(std::array{*load, larger, twice_as_long}, kRounds);
    ASSERT_TRUE(timings) << timings.error().text();
    ASSERT_EQ(timings->size(), 3u);
    for (const Timing& timing : *timings) ASSERT_EQ(timing.samples.size(), std::size_t{kRounds});
    const Timing nothing{std::vector(kRounds, 0.0)};
    pixels = ratio((*timings)[1], (*timings)[0], nothing).value;
    iterations = ratio((*timings)[2], (*timings)[0], nothing).value;
  }
  EXPECT_TRUE(as_expected()) << "4 times the pixels: " << pixels << ", twice the iterations: " << iterations;
}

// How long a draw takes by measure, which makes several of them at a time, over how long it takes alone.
Result<double> together_over_alone(Stopwatch& stopwatch, const Workload& workload, const GladGLContext& gl) {
  constexpr int kRounds = 25;
  constexpr int kDraws = 5;
  Timing quotients;
  for (int round = 0; round < kRounds; ++round) {
    const auto timings = stopwatch.measure(std::array{workload}, 1);
    if (!timings) return tl::unexpected(timings.error());
    // Into the same picture, which is still bound.
    gl.Finish();
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kDraws; ++i) {
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
      gl.Finish();
    }
    const double alone = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kDraws;
    quotients.samples.push_back(timings->front().samples.front() / alone);
  }
  return quotients.median();
}

// llvmpipe drops what a later draw of the same batch paints over, at least in the tiles inside of a triangle: of a
// large picture, that would be most of the work. The quotient is then 0.4 or less.
TEST_F(Stopwatched, NoDrawOfASampleIsSkipped) {
  const auto program = build(quad_shader(empty_subject(2)));
  ASSERT_TRUE(program) << program.error().text();
  constexpr double kEnough = 0.75;
  Result<double> quotient = 0.0;
  for (int attempt = 0; attempt < kAttempts && quotient && *quotient < kEnough; ++attempt) {
    quotient = together_over_alone(*stopwatch_, {&*program, 1024, 1024}, context_->gl());
  }
  ASSERT_TRUE(quotient) << quotient.error().text();
  EXPECT_GE(*quotient, kEnough);
}

TEST_F(Stopwatched, ChoosesAClockAndSaysWhy) {
  const auto program = build(loop_shader({"noise", 2, "#include \"noise2d.glsl\"\n", "hn_perlin(p)"}));
  ASSERT_TRUE(program) << program.error().text();
  const auto load = stopwatch_->sufficient_load(*program);
  ASSERT_TRUE(load) << load.error().text();
  EXPECT_GE(load->width, 64);
  EXPECT_EQ(load->width, load->height);
  const Gate& gate = stopwatch_->choose_clock(*load);
  EXPECT_EQ(gate.reason, judge_query(gate.pixels, gate.iterations, gate.draws).reason);
  EXPECT_EQ(gate.clock, judge_query(gate.pixels, gate.iterations, gate.draws).clock);
}

TEST_F(Stopwatched, AFirstDrawTakesItsTime) {
  const auto program = build(loop_shader(empty_subject(2)));
  ASSERT_TRUE(program) << program.error().text();
  EXPECT_GT(stopwatch_->first_draw(*program), 0.0);
}

}  // namespace
}  // namespace hn
