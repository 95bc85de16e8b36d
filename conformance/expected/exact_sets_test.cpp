#include "expected/exact_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/temporary_folder.hpp"
#include "expected/golden.hpp"

namespace hn {
namespace {

TEST(ExactSets, AreThoseOfTheGoldenFilesInTheOrderOfTheirNames) {
  const auto& sets = exact_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_TRUE(std::ranges::is_sorted(sets, {}, &ExactSet::function));
  std::size_t count = 0;
  for (const Function& function : all_functions()) {
    for (const GoldenSetting& setting : golden_settings(function)) {
      if (!setting.name.ends_with(":exact") && !setting.name.ends_with(":fixed")) continue;
      ASSERT_LT(count, sets.size());
      count += std::ranges::count_if(
          sets, [&](const ExactSet& set) { return set.function == function.id && set.setting == setting.name; });
    }
  }
  EXPECT_EQ(count, sets.size());  // and none of floats
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
