#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "library/source.hpp"
#include "report/report.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

hn::Run absent_run() {
  hn::Run run;
  run.driver = "zink";
  run.absent = "no Vulkan";
  return run;
}

pugi::xml_document parsed(const std::vector<hn::Run>& runs) {
  pugi::xml_document document;
  const auto done = document.load_string(junit_text(runs).c_str());
  EXPECT_TRUE(done) << done.description();
  return document;
}

std::string totals_of(pugi::xml_node node) {
  return std::string(node.attribute("tests").value()) + " tests, " + node.attribute("failures").value() +
         " failures, " + node.attribute("errors").value() + " errors, " + node.attribute("skipped").value() +
         " skipped";
}

TEST(Junit, HasEveryStatus) {
  CaseResult excused = result("a.b.excused", Status::crash);
  CaseResult unneeded = result("a.b.unneeded", Status::pass);
  excused.excuse = unneeded.excuse = "known";
  const auto document =
      parsed({run_of({result("a.b.pass", Status::pass), result("a.b.warning", Status::warning),
                      result("a.b.fail", Status::fail), result("a.b.unsupported", Status::unsupported),
                      result("a.b.crash", Status::crash), result("a.b.timeout", Status::timeout),
                      result("a.b.error", Status::error), excused, unneeded}),
              absent_run()});
  const auto suites = document.child("testsuites");
  const auto suite = suites.child("testsuite");
  EXPECT_EQ(totals_of(suite), "9 tests, 2 failures, 3 errors, 2 skipped");
  EXPECT_EQ(totals_of(suites), "10 tests, 2 failures, 3 errors, 3 skipped");
  EXPECT_STREQ(suite.attribute("name").value(), "osmesa");
  EXPECT_STREQ(suite.attribute("time").value(), "4.500");
  const auto test = [&](const char* name) { return suite.find_child_by_attribute("testcase", "name", name); };
  EXPECT_STREQ(test("a.b.pass").attribute("classname").value(), "a.b");
  EXPECT_FALSE(test("a.b.pass").first_child());
  EXPECT_STREQ(test("a.b.warning").child("system-out").text().get(), "warning: why");
  EXPECT_STREQ(test("a.b.fail").child("failure").attribute("message").value(), "why");
  EXPECT_STREQ(test("a.b.unsupported").child("skipped").attribute("message").value(), "why");
  for (const char* name : {"crash", "timeout", "error"}) {
    EXPECT_STREQ(test(("a.b." + std::string(name)).c_str()).child("error").attribute("type").value(), name);
  }
  EXPECT_STREQ(test("a.b.excused").child("skipped").attribute("message").value(), "crash, excused: known");
  EXPECT_STREQ(test("a.b.unneeded").child("failure").attribute("type").value(), "unneeded excuse");
  const auto other = suite.next_sibling();
  EXPECT_EQ(totals_of(other), "1 tests, 0 failures, 0 errors, 1 skipped");
  EXPECT_STREQ(other.child("testcase").child("skipped").text().get(), "no Vulkan");
}

TEST(Junit, SaysWhereItRan) {
  hn::Run run = run_of({result("a.b.c", Status::pass)});
  run.date = "2026-11-20T10:00:00Z";
  run.way = short_way();
  const auto document = parsed({run});
  const auto suite = document.child("testsuites").child("testsuite");
  EXPECT_STREQ(suite.attribute("name").value(), "osmesa through spirv-opt 2023.1");
  EXPECT_STREQ(suite.attribute("timestamp").value(), "2026-11-20T10:00:00Z");
  const auto value = [&](const char* name) {
    return suite.child("properties").find_child_by_attribute("name", name).attribute("value").value();
  };
  EXPECT_STREQ(value("renderer"), "r");
  EXPECT_STREQ(value("seed"), "7");
  EXPECT_EQ(value("hashnoise"), library_version());
}

TEST(Junit, NamesTheEditedLibrary) {
  hn::Run run = run_of({result("a.b.c", Status::pass)});
  run.library = {.folder = "my/copy", .digest = "0123", .changed = {"hash.glsl"}};
  const auto document = parsed({run});
  const auto properties = document.child("testsuites").child("testsuite").child("properties");
  EXPECT_EQ(properties.find_child_by_attribute("name", "hashnoise").attribute("value").value(),
            library_text(run.library));
}

TEST(Junit, TakesEveryByte) {
  CaseResult bad = result("a.b.<&\"'>]]>", Status::fail);
  bad.outcome.message = "]]> & <tag>\n";
  for (int byte = 0; byte < 256; ++byte) bad.outcome.message += static_cast<char>(byte);
  bad.outcome.message += "\xEF\xBF\xBF";
  hn::Run run = run_of({bad});
  run.info.renderer = "\x01\xFF";
  const auto document = parsed({run});
  const auto test = document.child("testsuites").child("testsuite").child("testcase");
  EXPECT_STREQ(test.attribute("name").value(), "a.b.<&\"'>]]>");
  EXPECT_STREQ(test.child("failure").attribute("message").value(), "]]> & <tag>");
  const std::string text = junit_text({run});
  EXPECT_EQ(text.find('\x01'), std::string::npos);
  EXPECT_EQ(text.find("&#1;"), std::string::npos) << "XML has no such character, not even so";
  EXPECT_EQ(text.find("\xEF\xBF\xBF"), std::string::npos);
  EXPECT_NE(text.find(">]]&gt; &amp; &lt;tag&gt;"), std::string::npos) << "]]> may stand in attributes only";
}

TEST(Junit, OfNothingIsValid) {
  EXPECT_EQ(totals_of(parsed({}).child("testsuites")), "0 tests, 0 failures, 0 errors, 0 skipped");
}

TEST(Junit, AProblemIsAnErrorSoThatItIsNoGreenFile) {
  pugi::xml_document document;
  ASSERT_TRUE(
      document.load_string(junit_text({run_of({result("a.b.pass", Status::pass)})}, {"1 case is <missing>"}).c_str()));
  const pugi::xml_node suites = document.child("testsuites");
  EXPECT_EQ(totals_of(suites), "2 tests, 0 failures, 1 errors, 0 skipped");
  const pugi::xml_node problem = suites.find_child_by_attribute("name", "hn-conform");
  EXPECT_NE(std::string(problem.child("testcase").child("error").text().get()).find("1 case is <missing>"),
            std::string::npos);
}

}  // namespace
}  // namespace hn
