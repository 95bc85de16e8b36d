#include "run/results.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "library/source.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

TEST(Run, IsAsExpectedOnlyIfSomethingPassedAndNothingFailed) {
  const auto pass = result("a", Status::pass);
  const auto unsupported = result("b", Status::unsupported);
  EXPECT_TRUE(run_of({pass, unsupported}).as_expected());
  EXPECT_FALSE(run_of({pass, result("c", Status::fail)}).as_expected());
  EXPECT_FALSE(run_of({pass, result("c", Status::error)}).as_expected());
  EXPECT_FALSE(run_of({unsupported}).as_expected());
  EXPECT_FALSE(run_of({}).as_expected());
}

TEST(Run, ThatEndedTooEarlyIsNoPass) {
  hn::Run run = run_of({result("a", Status::pass)});
  EXPECT_TRUE(all_as_expected({run}));
  EXPECT_FALSE(only_unfinished({run}));
  run.not_run = 3;
  EXPECT_FALSE(run.as_expected());
  EXPECT_FALSE(all_as_expected({run}));
  EXPECT_FALSE(all_as_expected({run, run_of({result("a", Status::pass)})}));
  EXPECT_TRUE(only_unfinished({run}));
  const auto json = nlohmann::json::parse(results_text({run})).at("runs").at(0);
  EXPECT_EQ(json.at("not_run"), 3);
  EXPECT_EQ(json.at("as_expected"), false);
  EXPECT_EQ(parse_results(results_text({run})).value()[0].not_run, 3u);
  run.cases.push_back(result("b", Status::fail));
  EXPECT_FALSE(only_unfinished({run}));
}

TEST(Run, ThatLacksAShardIsNoPass) {
  hn::Run run = run_of({result("a", Status::pass)});
  run.shard = "1/4";
  run.whole = 4;
  run.missing = 3;
  EXPECT_FALSE(run.as_expected());
  EXPECT_FALSE(all_as_expected({run}));
  EXPECT_EQ(nlohmann::json::parse(results_text({run}))["runs"][0]["missing"], 3);
  EXPECT_EQ(parse_results(results_text({run})).value()[0].missing, 3u);
}

TEST(Run, InWhichNothingPassedIsNoneThatFailed) {
  const hn::Run unsupported = run_of({result("a", Status::unsupported)});
  EXPECT_TRUE(nothing_passed({unsupported}));
  EXPECT_FALSE(nothing_passed({unsupported, run_of({result("a", Status::pass)})}));
  EXPECT_FALSE(nothing_passed({unsupported, run_of({result("a", Status::fail)})}));
  EXPECT_TRUE(run_of({result("a", Status::warning)}).as_expected());
  hn::Run unfinished = unsupported;
  unfinished.not_run = 1;
  EXPECT_FALSE(nothing_passed({unfinished}));
  hn::Run absent;
  absent.absent = "no library";
  EXPECT_FALSE(nothing_passed({absent}));
}

TEST(Json, HasTheSchemaOfTheDocumentation) {
  const auto json =
      nlohmann::json::parse(results_text({run_of({result("a.b", Status::pass), result("c.d", Status::fail)})}));
  EXPECT_EQ(json["schema"], 2);
  EXPECT_EQ(json["version"], library_version());
  const auto& run = json["runs"].at(0);
  EXPECT_EQ(run["driver"], "osmesa");
  EXPECT_EQ(run["vendor"], "v");
  EXPECT_EQ(run["renderer"], "r");
  EXPECT_EQ(run["gl_version"], "4.5");
  EXPECT_EQ(run["glsl_version"], "4.50");
  EXPECT_EQ(
      run["totals"],
      nlohmann::json(
          {{"pass", 1}, {"warning", 0}, {"fail", 1}, {"unsupported", 0}, {"crash", 0}, {"timeout", 0}, {"error", 0}}));
  EXPECT_EQ(run["cases"].at(0), nlohmann::json({{"id", "a.b"},
                                                {"status", "pass"},
                                                {"samples", 10},
                                                {"mismatches", 0},
                                                {"max_abs", 0.25},
                                                {"max_ulp", 3},
                                                {"seconds", 0.5},
                                                {"message", "why"}}));
}

TEST(Json, TakesALogThatIsNoUtf8) {
  auto bad = result("a", Status::fail);
  bad.outcome.message = "\xff\xfe";
  EXPECT_TRUE(nlohmann::json::accept(results_text({run_of({bad})})));
}

TEST(Json, IsReadAgain) {
  CaseResult bad = result("a.b", Status::timeout);
  bad.excuse = "known";
  bad.outcome.examples = {{3, {1, 2}, "x=1", "0x00000001", "0x00000002"}};
  bad.outcome.step = {2, "ways/a.b/2-naga.wgsl", "fn main() {}"};
  bad.evidence = {
      .shader = "void main() {}", .got = "QQ==", .reference = "", .difference = "", .factor = 2.5, .note = "n"};
  hn::Run run = run_of({bad, result("c.d", Status::pass)});
  run.shard = "1/2";
  run.whole = 4;
  run.library = {.folder = "my/copy", .digest = "0123", .changed = {"hash.glsl"}};
  run.date = "2026-11-20T10:00:00Z";
  run.commands = {"hn-conform run", "hn-conform run --shard 2/2"};
  run.golden = "89abcdef";
  run.checked = {"f.glsl:f(p)", "osmesa in gl330", false};
  run.way = short_way();
  run.info.system = "Linux";
  run.info.browser = "Firefox 140";
  run.cases[1].outcome.checksum = 0x12abu;
  hn::Run absent;
  absent.driver = "zink";
  absent.absent = "no Vulkan";
  const std::string text = results_text({run, absent});
  const auto again = parse_results(text);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(results_text(*again), text);
  EXPECT_EQ(again->at(0).library, run.library);
  EXPECT_EQ(again->at(0).golden, run.golden);
  EXPECT_EQ(again->at(0).name(), "osmesa through spirv-opt 2023.1");
  EXPECT_EQ(again->at(0).info.system, run.info.system);
  EXPECT_EQ(again->at(0).info.browser, run.info.browser);
  EXPECT_EQ(again->at(0).cases[0].outcome.step, bad.outcome.step);
  EXPECT_EQ(again->at(0).cases[1].outcome.checksum, run.cases[1].outcome.checksum);
  EXPECT_NE(text.find("\"checksum\": \"000012ab\""), std::string::npos) << text;
}

TEST(Json, ThatIsNoneIsRefusedWithWhatIsWrong) {
  CaseResult one = result("a.b", Status::pass);
  one.outcome.checksum = 0x12345678u;
  one.outcome.examples = {{3, {4294967295u}, "x=1", "0x00000001", "0x00000002"}};
  hn::Run run = run_of({one});
  run.way = short_way();
  const std::string good = results_text({run});
  ASSERT_TRUE(parse_results(good));
  const auto counts = [](std::string_view name) {
    std::vector<std::string> wrong = {"-1", "1.5", "1e300", "true", "null", "\"1\"", "12345678901234567890123456789"};
    for (std::string& number : wrong) number = fmt::format("\"{}\": {}", name, number);
    return wrong;
  };
  const std::string version = "\"" + library_version() + "\"";
  const struct {
    std::string text;
    std::vector<std::string> instead;
    std::string message;  // a part of it
  } rows[] = {
      {"\"schema\": 2", {"\"schema\": 1"}, "its schema is 1"},
      {version, {"\"9.9.9\""}, "9.9.9"},
      {"\"pass\",", {"\"passed\","}, "\"passed\" is not a status"},
      {"\"seconds\": 0.5", {"\"seconds\": \"x\""}, "run 1"},
      {"\"id\"", {"\"ident\""}, "run 1"},
      {"12345678", {"1234567", "123456789", "1234567g", "0x345678", "ABCDEF01", "-1234567", ""}, "is not a checksum"},
      {"4294967295", {"-1", "1.5", "4294967296", "4e93", "true", "null"}, "run 1, case 1 is not a results.json: "},
      {"\"takes\": \"spirv\"", {"\"takes\": \"spir\""}, "run 1 is not a results.json: \"spir\" is not a form"},
      {"\"samples\": 10", counts("samples"), "run 1, case 1 is not a results.json: "},
      {"\"max_ulp\": 3", counts("max_ulp"), "run 1, case 1 is not a results.json: "},
      {"\"seed\": 7", counts("seed"), "run 1 is not a results.json: "},
      {"\"schema\": 2", counts("schema"), "the file is not a results.json: "},
  };
  for (const auto& row : rows) {
    for (const std::string& instead : row.instead) {
      std::string text = good;
      text.replace(text.find(row.text), row.text.size(), instead);
      const auto parsed = parse_results(text);
      ASSERT_FALSE(parsed) << row.text << " " << instead;
      EXPECT_NE(parsed.error().message.find(row.message), std::string::npos) << parsed.error().message;
    }
  }
  const std::string head = "{\"schema\": 2, \"version\": " + version + ", \"runs\": ";
  EXPECT_TRUE(parse_results(head + "[]}"));
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("{}"), std::string("7"), std::string("{\"schema\": 2}"),
        head + "null}", head + "{}}", head + "7}", head + "\"\"}"}) {
    EXPECT_FALSE(parse_results(text)) << text;
  }
}

// Whoever reads it knows the file, and not the library that reads JSON.
TEST(Json, WhatIsWrongIsSaidInWordsOfTheFile) {
  CaseResult wrong = result("a.b", Status::fail);
  wrong.outcome.examples = {{7, {1, 2}, "x=1", "2", "3"}};
  wrong.evidence = Evidence{"s", "g", "r", "d", 2.0, "n"};
  wrong.outcome.step = {1, "i", "t"};
  hn::Run run = run_of({wrong});
  run.way = short_way();
  const std::string text = results_text({run});
  const auto good = nlohmann::json::parse(text).flatten();
  std::size_t refused = 0;
  for (const auto& [path, value] : good.items()) {
    for (const char* other : {"null", "7", "-1", "\"text\"", "[]", "{}", "[{}]"}) {
      auto changed = good.unflatten();
      changed[nlohmann::json::json_pointer(path)] = nlohmann::json::parse(other);
      const auto parsed = parse_results(changed.dump());
      if (parsed) continue;
      ++refused;
      EXPECT_EQ(parsed.error().message.find("exception"), std::string::npos) << path << ": " << parsed.error().message;
    }
    auto without = good.unflatten();
    const auto slash = path.rfind('/');
    auto& parent = without[nlohmann::json::json_pointer(path.substr(0, slash))];
    if (!parent.is_object()) continue;
    parent.erase(path.substr(slash + 1));
    const auto parsed = parse_results(without.dump());
    EXPECT_TRUE(parsed || parsed.error().message.find("is missing") != std::string::npos)
        << path << ": " << parsed.error().message;
  }
  EXPECT_GT(refused, 50u);
  const auto message = [](const std::string& cut) { return parse_results(cut).error().message; };
  EXPECT_EQ(message(text.substr(0, text.size() / 2)), "the file is not a results.json: the JSON ends too early");
  EXPECT_EQ(message("{\n \"schema\": 2 3}"),
            "the file is not a results.json: there is no JSON any more in line 2, column 14");
  EXPECT_EQ(message("{\"schema\": 1e999}"), "the file is not a results.json: a number in it is too large");
}

// To print it, or to copy it, would need more stack than there is.
TEST(Json, MayNotBeNestedWithoutEnd) {
  const std::string good = results_text({run_of({result("a", Status::pass)})});
  const auto nested = [&](std::size_t depth) {
    std::string text = good;
    return parse_results(text.insert(1, "\"unknown\": " + std::string(depth, '[') + std::string(depth, ']') + ","));
  };
  EXPECT_TRUE(nested(50));
  for (const std::size_t depth : {100u, 1000000u}) {
    const auto runs = nested(depth);
    ASSERT_FALSE(runs);
    EXPECT_NE(runs.error().message.find("nested deeper than 64 levels"), std::string::npos);
  }
}

TEST(Verdict, OfSeveralDriversNeedsAllThatAreHere) {
  const hn::Run good = run_of({result("a", Status::pass)});
  const hn::Run bad = run_of({result("a", Status::crash)});
  const hn::Run nothing = run_of({result("a", Status::unsupported)});
  hn::Run absent;
  absent.absent = "why";
  hn::Run reference = good;
  reference.driver = kReferenceCompiler;
  EXPECT_TRUE(all_as_expected({reference}));
  EXPECT_FALSE(all_as_expected({nothing, reference})) << "glslang is no driver";
  EXPECT_FALSE(all_as_expected({absent, reference}));
  EXPECT_TRUE(all_as_expected({good, absent, nothing}));
  EXPECT_FALSE(all_as_expected({good, bad}));
  EXPECT_FALSE(all_as_expected({absent}));
  EXPECT_FALSE(all_as_expected({nothing}));
  EXPECT_FALSE(all_as_expected({}));
}

}  // namespace
}  // namespace hn
