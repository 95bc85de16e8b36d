#include "grid/ranges.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bake/planes.hpp"
#include "bake/tests/options_fixture.hpp"
#include "base/file.hpp"
#include "grid/functions.hpp"

namespace hn {
namespace {

using hashnoise::grid::documented_range;

std::string text_of_glsl(const std::string& name) {
  const auto text = read_file(fmt::format("{}/{}.glsl", HN_GLSL_DIRECTORY, name));
  EXPECT_TRUE(text) << text.error().text();
  std::string joined;  // a range may be broken into two lines
  for (std::size_t i = 0; text && i < text->size(); ++i) {
    const std::string_view rest = std::string_view(*text).substr(i);
    if (rest.starts_with("\n//            ")) {
      joined += ' ';
      i += 14;
    } else {
      joined += rest.front();
    }
  }
  return joined;
}

std::string written(double value) { return value == 0.875 ? "7/8" : fmt::format("{}", value); }
std::string written(const Interval& range) {
  return fmt::format("[{}, {}]", written(range.least), written(range.greatest));
}

struct Row {
  std::string noise;
  int dimensions;
  std::string component;
  std::string file;
};

// Every range that is not [-1, 1] or [0, 1] stands in the comment of its function.
TEST(Ranges, AreThoseOfTheFunctions) {
  int found = 0;
  for (const int dimensions : {1, 2, 3, 4}) {
    for (const std::string_view noise : hashnoise::noises(dimensions)) {
      for (const bool rotating : {false, true}) {
        // A noise with a wave has a phase in all of its forms.
        const hashnoise::grid::NoiseRow& row = hashnoise::grid::kNoiseRows[hashnoise::grid::noise_named(noise)];
        if (rotating && (!row.has_phase() || row.has_wave() || dimensions == 1 || dimensions == 4)) continue;
        BakeOptions options;
        options.function = noise;
        options.settings.noise = noise;
        options.size.assign(static_cast<std::size_t>(dimensions), 1);
        if (rotating) options.settings.phase = 0.25f;
        const std::string stem(rotating && noise.ends_with("_d") ? noise.substr(0, noise.size() - 2) : noise);
        const std::string text = text_of_glsl(fmt::format("{}{}{}d", stem, rotating ? "_phase" : "", dimensions));
        for (const std::string& component : component_names(options)) {
          const auto range = documented_range(options.settings, dimensions, component);
          ASSERT_TRUE(range) << noise << dimensions << component;
          if (*range == Interval{-1.0, 1.0} || *range == Interval{0.0, 1.0}) continue;
          // The page of two distances has the rest on three.
          const std::string own = component != "f3" && noise != "cellular" && component.starts_with("f")
                                      ? text_of_glsl(fmt::format("cellular{}d", dimensions))
                                      : text;
          EXPECT_NE(own.find(written(*range)), std::string::npos)
              << noise << dimensions << component << written(*range);
          ++found;
        }
      }
    }
  }
  EXPECT_GT(found, 30);
}

// No value is outside of the range, and most of it is used.
TEST(Ranges, HoldAndAreUsed) {
  for (const int dimensions : {2, 3}) {
    const auto noises = hashnoise::noises(dimensions);
    auto names = noises;
    for (const auto sum : hashnoise::fractals(dimensions)) names.push_back(sum);
    for (const std::string_view name : names) {
      const auto options =
          parsed({std::string(name), "--size", dimensions == 2 ? "200x200" : "40x40x40", "--cells", "37"});
      ASSERT_TRUE(options) << options.error().err;
      for (const Plane& plane : compute(*options, {}).planes) {
        const auto range = documented_range(options->settings, dimensions, plane.component);
        if (name == "fbm_d" && plane.component != "value") {
          EXPECT_FALSE(range);
          continue;
        }
        ASSERT_TRUE(range) << name;
        // The fixed arithmetic may exceed a range by its error.
        EXPECT_GE(static_cast<double>(plane.range.least), range->least - 1e-3) << name << plane.component;
        EXPECT_LE(static_cast<double>(plane.range.greatest), range->greatest + 1e-3) << name << plane.component;
        const double used = static_cast<double>(plane.range.greatest) - static_cast<double>(plane.range.least);
        EXPECT_GE(used, 0.2 * (range->greatest - range->least)) << name << plane.component;
      }
    }
  }
}

TEST(Ranges, OfAnotherMetricAreNotDocumented) {
  const auto options = parsed({"cellular", "--metric", "manhattan"});
  ASSERT_TRUE(options);
  EXPECT_FALSE(documented_range(options->settings, 2, "f1"));
}

TEST(Ranges, OfWarpsAreTheAmplitude) {
  const auto options = parsed({"warp", "--amplitude", "2.5"});
  ASSERT_TRUE(options);
  EXPECT_EQ(documented_range(options->settings, 2, "x"), (Interval{-2.5, 2.5}));
}

}  // namespace
}  // namespace hn
