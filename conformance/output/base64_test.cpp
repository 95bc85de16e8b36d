#include "output/base64.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheRfc) {
  EXPECT_EQ(to_base64(""), "");
  EXPECT_EQ(to_base64("f"), "Zg==");
  EXPECT_EQ(to_base64("fo"), "Zm8=");
  EXPECT_EQ(to_base64("foo"), "Zm9v");
  EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesEveryByte) {
  EXPECT_EQ(to_base64(std::string_view("\0\xff\xfb", 3)), "AP/7");
  EXPECT_EQ(to_base64(std::string_view("\0\0\0\0", 4)), "AAAAAA==");
}

}  // namespace
}  // namespace hn
