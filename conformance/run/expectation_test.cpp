#include "run/expectation.hpp"

#include <gtest/gtest.h>

#include "base/folder.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

constexpr std::string_view kHeader = "driver,renderer,case,status,reason\n";

Result<std::vector<Expectation>> parse(const std::string& rows) {
  return parse_expectations(std::string(kHeader) + rows, "x.csv");
}

TEST(Expectations, AreRowsWithNamedColumns) {
  const auto rows = parse("egl*,Some*,a.b,fail,\"shifts, all of them\"\n# a comment\nosmesa,*,c.*,crash,why\n");
  ASSERT_TRUE(rows) << rows.error().text();
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ(rows->at(0).renderer, "Some*");
  EXPECT_EQ(rows->at(0).reason, "shifts, all of them");
  EXPECT_EQ(rows->at(1).status, Status::crash);
  EXPECT_EQ(rows->at(1).place, "x.csv:4");
  const auto other_order = parse_expectations("reason,status,case,renderer,driver\nwhy,fail,c,r,d\n", "x.csv");
  ASSERT_TRUE(other_order) << other_order.error().text();
  EXPECT_EQ(other_order->at(0).driver, "d");
}

TEST(Expectations, SayWhatIsWrongAndWhere) {
  const auto error_of = [](const auto& rows) { return rows ? std::string("none") : rows.error().message; };
  EXPECT_NE(error_of(parse("d,r,c,pass,why\n")).find("x.csv:2: the status \"pass\""), std::string::npos);
  EXPECT_NE(error_of(parse("d,r,c,fail,\n")).find("x.csv:2: there must be a reason"), std::string::npos);
  EXPECT_NE(error_of(parse("d,,c,fail,why\n")).find("x.csv:2: driver, renderer"), std::string::npos);
  EXPECT_NE(error_of(parse("d,r,c,fail\n")).find("2"), std::string::npos);
  EXPECT_NE(error_of(parse("d,r,c,fail,a,b\n")).find("2"), std::string::npos);
  EXPECT_NE(error_of(parse("d,r,c,fail,\"open\n")).find("2"), std::string::npos);
  EXPECT_NE(error_of(parse_expectations("", "x.csv")).find("x.csv"), std::string::npos);
  EXPECT_NE(error_of(parse_expectations("driver,case,status,reason\n", "x.csv")).find("renderer"), std::string::npos);
}

TEST(Expectations, NeedNoEndOfTheLastLine) {
  for (const char* last : {"", "\n", "\n# a comment", "\n# a comment\n", "\r\n"}) {
    const auto rows = parse("d,r,c,fail,why" + std::string(last));
    ASSERT_TRUE(rows) << rows.error().text();
    EXPECT_EQ(rows->size(), 1u) << last;
  }
}

TEST(Expectations, WithANulAreNone) {
  using namespace std::string_literals;
  const auto rows = parse("d,r,c,fail,why\nd,r,c,fail,why\0not"s);
  ASSERT_FALSE(rows);
  EXPECT_EQ(rows.error().message, "x.csv:3: a table must not contain NUL");
}

TEST(Expectations, ExcuseOnlyWhatTheyName) {
  const auto rows = parse("osm*,r,a*,fail,known\n");
  ASSERT_TRUE(rows);
  hn::Run run = run_of(
      {result("a1", Status::fail), result("a2", Status::crash), result("b", Status::fail), result("c", Status::pass)});
  apply_expectations(*rows, run);
  EXPECT_EQ(run.cases[0].excuse, "known (x.csv:2)");
  EXPECT_TRUE(as_expected(run.cases[0]));
  EXPECT_FALSE(as_expected(run.cases[1])) << "a crash is not a failure";
  EXPECT_FALSE(as_expected(run.cases[2]));
  EXPECT_TRUE(as_expected(run.cases[3]));
  hn::Run elsewhere = run_of({result("a1", Status::fail)});
  elsewhere.info.renderer = "another";
  apply_expectations(*rows, elsewhere);
  EXPECT_FALSE(as_expected(elsewhere.cases[0]));
}

TEST(Expectations, OfWhatIsRightAreWrongThemselves) {
  const auto rows = parse("*,*,a*,fail,known\n");
  ASSERT_TRUE(rows);
  hn::Run run = run_of({result("a1", Status::pass), result("a2", Status::warning), result("a3", Status::unsupported)});
  apply_expectations(*rows, run);
  EXPECT_FALSE(as_expected(run.cases[0]));
  EXPECT_FALSE(as_expected(run.cases[1]));
  EXPECT_TRUE(as_expected(run.cases[2])) << "what cannot run is neither";
  EXPECT_FALSE(run.as_expected());
  run.way = short_way();
  apply_expectations(*rows, run);
  EXPECT_TRUE(run.as_expected()) << "the driver has another shader";
  run.cases = {result("a1", Status::fail)};
  run.cases[0].outcome.step = {1, "", ""};
  apply_expectations(*rows, run);
  EXPECT_FALSE(as_expected(run.cases[0])) << "a translator refused the shader";
}

TEST(Expectations, OfNoCaseAreAnError) {
  const std::vector<std::string> ids = {"a.b"};
  EXPECT_TRUE(check_expectations(*parse("*,*,a.*,fail,why\n"), ids));
  const auto unknown = check_expectations(*parse("*,*,a.c,fail,why\n"), ids);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().message, "x.csv:2: no case matches \"a.c\"");
}

TEST(Expectations, AreReadFromEveryTableOfAFolder) {
  const TemporaryFolder folder;
  folder.write("a.csv", std::string(kHeader) + "*,*,a,fail,why\n");
  folder.write("b.csv", std::string(kHeader) + "*,*,b,fail,why\n");
  folder.write("README.md", "no table");
  ASSERT_TRUE(read_expectations(folder.path()));
  EXPECT_EQ(read_expectations(folder.path())->size(), 2u);
  EXPECT_FALSE(read_expectations(folder.path() / "missing"));
}

}  // namespace
}  // namespace hn
