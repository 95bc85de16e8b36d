#include "bake/planes.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "bake/tests/options_fixture.hpp"

namespace hn {
namespace {

using hashnoise::CellPoints;
using hashnoise::Field;
using hashnoise::Settings;

// The value at one point.
template <int D>
std::vector<float> at(const Settings& settings, const std::array<std::int32_t, D>& cell,
                      const std::array<float, D>& f) {
  const Field<D> field(settings);
  CellPoints<D> points;
  for (std::size_t axis = 0; axis < D; ++axis) {
    points.cell[axis] = {&cell[axis], 1};
    points.f[axis] = {&f[axis], 1};
  }
  std::vector<float> values(static_cast<std::size_t>(field.component_count()));
  field.fill(points, values);
  return values;
}

TEST(Planes, AreTheValuesOfTheFieldInTheirOrder) {
  const auto options = parsed(
      {"simplex_d", "--size", "37x20x5", "--cells", "37x40x10", "--seed", "9", "--origin", "0.25x-0.125x1000000000.5"});
  ASSERT_TRUE(options) << options.error().err;
  const Planes planes = compute(*options, {});
  ASSERT_EQ(planes.planes.size(), 4u);
  std::size_t i = 0;
  for (int z = 0; z < 5; ++z) {
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 37; ++x, ++i) {
        const auto values = at<3>(options->settings, {x, 2 * y - 1, 1000000000 + 2 * z}, {0.25f, 0.875f, 0.5f});
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_EQ(planes.planes[c].values[i], values[c]) << x << " " << y << " " << z;
      }
    }
  }
  EXPECT_EQ(planes.planes[3].component, "dz");
}

TEST(Planes, HaveTheirRanges) {
  const auto options = parsed({"cellular", "--size", "50x50"});
  ASSERT_TRUE(options);
  for (const Plane& plane : compute(*options, {}).planes) {
    EXPECT_EQ(plane.range.least, *std::min_element(plane.values.begin(), plane.values.end()));
    EXPECT_EQ(plane.range.greatest, *std::max_element(plane.values.begin(), plane.values.end()));
  }
}

TEST(Planes, DoNotDependOnThreadsAndInstructions) {
  for (const char* const arithmetic : {"fixed", "precise"}) {
    const auto options = parsed({"fbm", "--noise", "simplex", "--size", "700x90", "--arithmetic", arithmetic});
    ASSERT_TRUE(options);
    const Planes reference = compute(*options, {});
    for (const hashnoise::InstructionSet set : hashnoise::instruction_sets()) {
      for (const int threads : {1, 2, 7}) {
        BakeOptions other = *options;
        other.threads = threads;
        other.settings.instruction_set = set;
        EXPECT_EQ(compute(other, {}).planes[0].values, reference.planes[0].values)
            << arithmetic << name(set) << threads;
      }
    }
  }
}

// The column and the row that follow the last ones of a tile are the first.
TEST(Planes, OfATileHaveNoSeam) {
  const std::vector<std::vector<std::string>> calls = {
      {"fbm", "--noise", "simplex"}, {"perlin"}, {"cellular"}, {"ridged"}, {"warp"}, {"value_cubic"}};
  for (std::vector<std::string> call : calls) {
    call.insert(call.end(), {"--size", "100x36", "--cells", "7x5", "--tile"});
    const auto options = parsed(call);
    ASSERT_TRUE(options) << options.error().err;
    BakeOptions larger = *options;  // the same period, and points beyond it
    larger.size = {200, 72};
    larger.cells = {14.0, 10.0};
    const auto tile = compute(*options, {});
    const auto four = compute(larger, {});
    for (std::size_t c = 0; c < tile.planes.size(); ++c) {
      for (std::size_t y = 0; y < 72; ++y) {
        for (std::size_t x = 0; x < 200; ++x) {
          ASSERT_EQ(four.planes[c].values[y * 200 + x], tile.planes[c].values[y % 36 * 100 + x % 100])
              << call.front() << " " << x << " " << y;
        }
      }
    }
  }
}

TEST(Planes, WithoutATileHaveASeam) {
  const auto options = parsed({"fbm", "--size", "200x20", "--cells", "14x1"});
  ASSERT_TRUE(options);
  const auto values = compute(*options, {}).planes[0].values;
  EXPECT_NE(values[0], values[100]);
}

TEST(Planes, OfSomeComponents) {
  const auto all = parsed({"cellular", "--size", "9x9"});
  const auto one = parsed({"cellular", "--size", "9x9", "--components", "f2"});
  ASSERT_TRUE(all && one);
  const Planes planes = compute(*one, {});
  ASSERT_EQ(planes.planes.size(), 1u);
  EXPECT_EQ(planes.planes[0].values, compute(*all, {}).planes[1].values);
  for (const char* const wrong : {"f3", "f1,f1"}) {
    const auto options = parsed({"cellular", "--components", wrong});
    ASSERT_TRUE(options);
    EXPECT_THROW(component_names(*options), std::invalid_argument) << wrong;
  }
}

TEST(Planes, WithADetail) {
  const auto options = parsed({"fbm", "--size", "40x3", "--detail", "2.5"});
  const auto whole = parsed({"fbm", "--size", "40x3", "--octaves", "3"});
  ASSERT_TRUE(options && whole);
  const auto values = compute(*options, {}).planes[0].values;
  ASSERT_EQ(values.size(), 120u);
  EXPECT_NE(values, compute(*whole, {}).planes[0].values);
}

TEST(Planes, TellOfEveryRow) {
  const auto options = parsed({"perlin", "--size", "16385x7"});
  ASSERT_TRUE(options);
  std::atomic<std::size_t> rows = 0;
  compute(*options, [&](std::size_t done) { rows += done; });
  EXPECT_EQ(rows, 7u);
}

}  // namespace
}  // namespace hn
