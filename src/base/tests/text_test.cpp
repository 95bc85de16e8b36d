#include "base/text.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

using namespace std::string_literals;

constexpr const char* kReplaced = "\xEF\xBF\xBD";

TEST(CleanText, LeavesWhatIsText) {
  const std::string text = "a\tb\nc\r\n\"<&>]]> \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80";
  EXPECT_EQ(clean_text(text), text);
  EXPECT_EQ(clean_text(""), "");
}

TEST(CleanText, ReplacesWhatXmlForbids) {
  EXPECT_EQ(clean_text("a\0b"s), "a"s + kReplaced + "b");
  EXPECT_EQ(clean_text("\x1b[1m"), kReplaced + "[1m"s);
  EXPECT_EQ(clean_text("x\xEF\xBF\xBFy\xEF\xBF\xBEz"), "x"s + kReplaced + "y" + kReplaced + "z");
  EXPECT_EQ(clean_text("\xED\xA0\x80").find('\xED'), std::string::npos) << "half of a surrogate pair";
  EXPECT_EQ(clean_text("a\xFFz"), "a"s + kReplaced + "z");
  EXPECT_EQ(clean_text("end\xE2\x82"), "end"s + kReplaced);
}

TEST(Printable, LeavesTheTerminalAlone) {
  EXPECT_EQ(printable("a\tb\n\xC3\xA4 \xC2\xA0"), "a\tb\n\xC3\xA4 \xC2\xA0");
  EXPECT_EQ(printable("\x1b[2J\x7f\xC2\x9b"), kReplaced + "[2J"s + kReplaced + kReplaced);
  EXPECT_EQ(printable("over\rwritten\r\n"), "overwritten\n");
}

TEST(InQuotes, IsPrintableAndNotLong) {
  EXPECT_EQ(in_quotes("rows 2"), "\"rows 2\"");
  EXPECT_EQ(in_quotes("a\0\r\x1b\xff\xC3\xA4"s), R"("a\x00\r\x1b\xff\xc3\xa4")");
  EXPECT_EQ(in_quotes("abcde", 3), "\"abc\" and 2 bytes more");
  EXPECT_EQ(in_quotes(""), "\"\"");
}

TEST(Shortened, SaysWhatIsLeftOut) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcde", 3), "abc ... (2 characters more)");
}

}  // namespace
}  // namespace hn
