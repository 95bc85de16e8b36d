#include "expected/exact_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/temporary_folder.hpp"
#include "expected/golden.hpp"
#include "library/configurations.hpp"

namespace hn {
namespace {

TEST(ExactSets, AreThoseOfTheGoldenFilesInTheOrderOfTheirNames) {
  const auto& sets = exact_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_TRUE(std::ranges::is_sorted(sets, {}, &ExactSet::function));
  std::size_t count = 0;
  for (const Function& function : all_functions()) {
    for (const GoldenSetting& setting : golden_settings(function)) {
      const bool exact = setting.name.ends_with(":exact") || setting.name.ends_with(":fixed");
      const auto number = exact_set(function, *setting.configuration);
      ASSERT_EQ(number.has_value(), exact) << function.id << ' ' << setting.name;
      if (!exact) continue;
      EXPECT_EQ(sets.at(*number).function, function.id);
      EXPECT_EQ(sets.at(*number).setting, setting.name);
      // The words in a case's id.
      EXPECT_EQ(exact_set(function.id, configuration_name(function, *setting.configuration),
                          arithmetic_name(function, *setting.configuration)),
                number);
      ++count;
    }
  }
  EXPECT_EQ(count, sets.size());
}

TEST(ExactSets, HaveNoFloats) {
  EXPECT_FALSE(exact_set(find_function("noise2d.perlin"), default_configuration()));
  EXPECT_FALSE(exact_set("noise2d.perlin", "lattice", "fast"));
  EXPECT_FALSE(exact_set("noise2d.nothing", "lattice", "fixed"));
  EXPECT_TRUE(exact_set("noise2d.perlin", "lattice", "fixed"));
}

TEST(GoldenChecksum, IsThatOfAllFilesInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  folder.write("b.golden", "6789");
  folder.write("a.golden", "12345");
  folder.write("note.txt", "x");
  EXPECT_EQ(golden_checksum(folder.path()), "cbf43926");  // that of 123456789, by which a CRC-32 is known
  folder.write("a.golden", "12354");
  EXPECT_NE(golden_checksum(folder.path()), "cbf43926");
}

}  // namespace
}  // namespace hn
