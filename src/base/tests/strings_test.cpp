#include "base/strings.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

using Parts = std::vector<std::string_view>;

TEST(Strings, AreSplitAtEachSeparator) {
  EXPECT_EQ(split("a.bc.d", '.'), (Parts{"a", "bc", "d"}));
  EXPECT_EQ(split("", '.'), Parts{""});
  EXPECT_EQ(split("one\n", '\n'), (Parts{"one", ""}));
}

TEST(Strings, HaveAsciiLettersInUpperCase) {
  EXPECT_EQ(in_upper_case("partial_fnv1"), "PARTIAL_FNV1");
  EXPECT_EQ(in_upper_case("{~\xC3\xA4"), "{~\xC3\xA4");
}

}  // namespace
}  // namespace hn
