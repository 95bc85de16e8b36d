#include "base/csv.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

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
