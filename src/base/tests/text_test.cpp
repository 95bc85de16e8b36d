#include "base/text.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/csv.hpp"

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

TEST(CommandLine, IsAsAShellWouldTakeItAgain) {
  const std::vector<const char*> arguments = {"/usr/bin/hn-conform", "bench", "--filter", "a*", "it's", "", "x=y"};
  EXPECT_EQ(command_line("hn-conform", static_cast<int>(arguments.size()), arguments.data()),
            "hn-conform bench --filter 'a*' 'it'\\''s' '' x=y");
}

using Cells = std::vector<std::string>;

TEST(Csv, PlainFieldsAreNotQuoted) {
  EXPECT_EQ(to_csv(Cells{"hash", "ns per pixel"}, std::vector<Cells>{{"pcg", "1.25"}, {"", "-3e-7"}}),
            "hash,ns per pixel\npcg,1.25\n,-3e-7\n");
}

TEST(Csv, CommasQuotesAndLineEndsAreQuoted) {
  EXPECT_EQ(to_csv(Cells{"a,b", "c\"d"}, std::vector<Cells>{{"e\nf", "g\rh"}, {"\"", "i"}}),
            "\"a,b\",\"c\"\"d\"\n\"e\nf\",\"g\rh\"\n\"\"\"\",i\n");
}

TEST(Csv, ARecordHasItsFactsFirstEachInALine) {
  EXPECT_EQ(to_record({{"by", "a, b"}, {"why", "c\nd\xFF"}}, Cells{"a"}, std::vector<Cells>{{"x\ny"}}),
            "# by: a, b\n# why: c d\xEF\xBF\xBD\na\n\"x\ny\"\n");
}

TEST(Csv, NoRows) { EXPECT_EQ(to_csv(Cells{"a", "b"}, {}), "a,b\n"); }

TEST(Csv, AnEmptyFieldAloneIsNoEmptyLine) {
  EXPECT_EQ(to_csv(Cells{"a"}, std::vector<Cells>{{""}, {"x"}}), "a\n\"\"\nx\n");
}

}  // namespace
}  // namespace hn
