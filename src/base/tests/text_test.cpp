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
  EXPECT_EQ(command_line({"hn-conform", "bench", "--filter", "a*", "it's", "", "x=y"}),
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

// "a|b/c|d": the fields of rows, or the error.
std::string table_of(std::string_view text) {
  const auto rows = parse_csv(text, "t.csv");
  if (!rows) return rows.error().text();
  std::string all;
  for (const CsvRow& row : *rows) {
    for (const std::string& field : row.fields) all += field + (&field == &row.fields.back() ? "/" : "|");
  }
  return all;
}

TEST(Csv, IsReadAsProgramsWriteIt) {
  const struct {
    const char* about;
    std::string text;
    const char* table;
  } rows[] = {
      {"a plain one", "p.x,p.y\n1,2\n", "p.x|p.y/1|2/"},
      {"no end of the last line", "p\n1", "p/1/"},
      {"ends of lines of Windows and of old spreadsheets", "p,q\r\n1,2\r\n\r\n3,4\r\n", "p|q/1|2/3|4/"},
      {"only carriage returns", "p\r1\r", "p/1/"},
      {"a byte order mark, and a comment behind it", "\xEF\xBB\xBF# from a spreadsheet\np\n1\n", "p/1/"},
      {"a byte order mark and quotes", "\xEF\xBB\xBF\"p\"\n\"1\"\n", "p/1/"},
      {"PowerShell's Export-Csv", "#TYPE System.Management\r\n\"p.x\",\"p.y\"\r\n\"0.5\",\"0.25\"\r\n",
       "p.x|p.y/0.5|0.25/"},
      {"a comment that a spreadsheet completed", "\"# by a, b\",\np,q\n# more,,\n1,2\n", "p|q/1|2/"},
      {"blanks and tabs around fields", " p ,\t\"q\" \n 1 , 2\t\n \t\n", "p|q/1|2/"},
      {"quotes in quotes, and commas", "a,b\n\"1\"\"2\",\"3,4\"\n", "a|b/1\"2|3,4/"},
      {"quotes in a field", "a\n5\"\n", "a/5\"/"},
      {"empty fields behind the header's", "p,q,,\n1,2,,\n3,,\n", "p|q/1|2/3|/"},
      {"an empty field in quotes", "p\n\"\"\n", "p//"},
  };
  for (const auto& [about, text, table] : rows) EXPECT_EQ(table_of(text), table) << about;
}

TEST(Csv, ThatIsWrongIsRefusedWithItsPlace) {
  const std::pair<std::string, const char*> rows[] = {
      {"", "t.csv: it has no header"},
      {"# nothing\n\n", "t.csv: it has no header"},
      {"p,q\n1\n", "t.csv:2: it has 1 fields, and the header has 2"},
      {"p\n\n0,5\n", "t.csv:3: it has 2 fields, and the header has 1; numbers have a point and no comma"},
      {"p,q\n1,\"2\n", "t.csv:2:2: the field has a quote that its line does not close"},
      {"p,q\n\"1\" 2,3\n", "t.csv:2:1: the field has \"2\" behind its closing quote"},
      {"p.x;p.y\n0,5;0,25\n", "t.csv:1: it has semicolons between its fields; write commas, and points in numbers"},
      {"#\n\"p.x\";\"p.y\"\n", "t.csv:2: it has semicolons"},
      {"p.x\tp.y\n", "t.csv:1: it has tabs between its fields"},
      {"p\n1\0\n"s, "t.csv:2: a table must not contain NUL"},
      {"\xFF\xFEp\0\n\0"s, "t.csv: it is UTF-16, as > in PowerShell 5 writes; write UTF-8"},
      {"\xFE\xFF\0p\0\n"s, "t.csv: it is UTF-16"},
      {"p\0\n\0"s, "t.csv: it is UTF-16"},
  };
  for (const auto& [text, message] : rows) EXPECT_EQ(table_of(text).find(message), 0u) << table_of(text);
}

}  // namespace
}  // namespace hn
