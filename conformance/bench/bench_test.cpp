#include "bench/bench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/temporary_folder.hpp"
#include "bench/bench_page.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

Measurement measured(const std::string& id, double value, double spread) {
  Measurement measurement;
  measurement.subject = {id, 2, "", "1.0"};
  measurement.ratio = {value, spread};
  return measurement;
}

Measurement failed(const std::string& id) {
  Measurement measurement = measured(id, 0.0, 0.0);
  measurement.error = Error{"it does not compile", "a.glsl:1: \xFF is not UTF-8"};
  return measurement;
}

BenchReport report_of(std::vector<Measurement> measurements) {
  BenchReport report;
  report.measurements = std::move(measurements);
  return report;
}

TEST(CompareWithBaseline, SlowerIsBeyondBothSpreads) {
  struct Row {
    Ratio before;
    Ratio now;
    bool slower;
  };
  // Powers of two, so that sums are exact.
  const Row rows[] = {
      {{1.0, 0.25}, {1.0, 0.25}, false},
      {{1.0, 0.25}, {1.5, 0.25}, false},  // just the sum of the spreads
      {{1.0, 0.25}, {std::nextafter(1.5, 2.0), 0.25}, true},
      {{1.0, 0.5}, {1.5, 0.0}, false},
      {{1.0, 0.0}, {1.5, 0.5}, false},
      {{1.0, 0.0}, {1.0, 0.0}, false},
      {{1.0, 0.0}, {std::nextafter(1.0, 2.0), 0.0}, true},
      {{1.0, 0.25}, {0.25, 0.25}, false},  // faster
      {{0.0, 0.0}, {4.0, 0.5}, true},
      {{-0.5, 0.125}, {0.0, 0.125}, true},
  };
  for (const Row& row : rows) {
    const auto changes =
        compare_with_baseline({"", {{"a", row.before}}}, report_of({measured("a", row.now.value, row.now.spread)}));
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].id, "a");
    EXPECT_EQ(changes[0].before.value, row.before.value);
    EXPECT_EQ(changes[0].before.spread, row.before.spread);
    EXPECT_EQ(changes[0].now.value, row.now.value);
    EXPECT_EQ(changes[0].now.spread, row.now.spread);
    EXPECT_EQ(changes[0].slower, row.slower) << row.before.value << " " << row.now.value;
  }
}

TEST(CompareWithBaseline, OnlyWhatIsInBoth) {
  const Baseline baseline = {"", {{"kept", {1.0, 0.0}}, {"gone", {1.0, 0.0}}, {"broken", {1.0, 0.0}}}};
  const auto changes = compare_with_baseline(
      baseline, report_of({measured("new", 9.0, 0.0), measured("kept", 9.0, 0.0), failed("broken")}));
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].id, "kept");
  EXPECT_TRUE(changes[0].slower);
  EXPECT_TRUE(compare_with_baseline({}, report_of({measured("kept", 9.0, 0.0)})).empty());
  EXPECT_TRUE(compare_with_baseline(baseline, {}).empty());
}

TEST(Batches, AreAllOfThemInOrderAndAlike) {
  for (const std::size_t count : {0u, 1u, 127u, 128u, 129u, 300u, 1000u}) {
    const std::vector<Batch> dealt = batches(count, 128);
    EXPECT_EQ(dealt.size(), count == 0 ? 1 : (count + 127) / 128);
    EXPECT_EQ(dealt.back().end, count);
    for (std::size_t i = 0; i < dealt.size(); ++i) {
      EXPECT_EQ(dealt[i].begin, i == 0 ? 0 : dealt[i - 1].end);
      EXPECT_LE(dealt[i].end - dealt[i].begin, 128u);
      EXPECT_GE(dealt[i].end - dealt[i].begin, count / dealt.size());
    }
  }
}

class BenchRun : public OnOsmesa<> {};

TEST_F(BenchRun, MeasuresEachBatchWithTheReferencesAndReportsAllInOrder) {
  const auto subject = [](const std::string& id, const std::string& expression) {
    return Subject{id, 2, "#include \"perlin2d.glsl\"\n", expression};
  };
  const std::string noise = "hn_perlin(p, 0u)";
  const std::vector<Subject> subjects = {subject("one", noise), subject("broken", "undeclared"), subject("same", noise),
                                         subject("twice", noise + " + hn_perlin(p, 1u)"), subject("last", noise)};
  std::FILE* const nowhere = std::fopen("/dev/null", "w");
  const auto report = run_bench(*context_, SourceSet::embedded(), ReferenceCompiler(), subjects,
                                {.rounds = 3, .counts = false, .most_at_a_time = 2}, nowhere);
  std::fclose(nowhere);
  ASSERT_TRUE(report) << report.error().text();
  std::vector<std::string> ids;
  for (const Measurement& measurement : report->measurements) {
    ids.push_back(measurement.subject.id);
    EXPECT_EQ(measurement.error.has_value(), ids.back() == "broken");
    EXPECT_EQ(measurement.ratio.known(), ids.back() != "broken");
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"empty2", "empty3", "table.float2", "table.float3", "table.integer2",
                                           "table.integer3", "one", "broken", "same", "twice", "last"}));
}

class BaselineFile : public testing::Test {
 protected:
  Result<Baseline> read(std::string_view text) {
    folder_.write("bench.json", text);
    return read_baseline(path_);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "bench.json";
};

TEST_F(BaselineFile, HasRatiosById) {
  const auto baseline = read(
      R"({"schema": 1, "more": [], "subjects": [{"id": "a", "ratio": 0.5, "spread": 0.25, "more": 1},
          {"id": "b", "ratio": 2, "spread": 0}, {"id": "c", "error": "it does not compile"}]})");
  ASSERT_TRUE(baseline) << baseline.error().text();
  ASSERT_EQ(baseline->ratios.size(), 2u);
  EXPECT_EQ(baseline->ratios.at("a").value, 0.5);
  EXPECT_EQ(baseline->ratios.at("a").spread, 0.25);
  EXPECT_EQ(baseline->ratios.at("b").value, 2.0);
  EXPECT_TRUE(read(R"({"schema": 1, "subjects": []})"));
}

TEST_F(BaselineFile, ThatIsNoneIsAnErrorThatNamesIt) {
  for (const std::string_view text : {
           "",
           "no JSON",
           R"({"schema": 1, "subjects": [)",
           "[]",
           "1",
           "null",
           "{}",
           R"({"subjects": []})",
           R"({"schema": 2, "subjects": []})",
           R"({"schema": "1", "subjects": []})",
           R"({"schema": 1})",
           R"({"schema": 1, "runs": []})",
           R"({"schema": 1, "subjects": null})",
           R"({"schema": 1, "subjects": 1})",
           R"({"schema": 1, "subjects": {}})",
           R"({"schema": 1, "subjects": [1]})",
           R"({"schema": 1, "subjects": [{"ratio": 1, "spread": 0}]})",
           R"({"schema": 1, "subjects": [{"id": 1, "ratio": 1, "spread": 0}]})",
           R"({"schema": 1, "subjects": [{"id": "a", "spread": 0}]})",
           R"({"schema": 1, "subjects": [{"id": "a", "ratio": 1}]})",
           R"({"schema": 1, "subjects": [{"id": "a", "ratio": "1", "spread": 0}]})",
           R"({"schema": 1, "subjects": [{"id": "a", "ratio": 1, "spread": null}]})",
       }) {
    const auto baseline = read(text);
    ASSERT_FALSE(baseline) << text;
    EXPECT_NE(baseline.error().message.find(path_.string() + " is not a bench.json"), std::string::npos)
        << baseline.error().message;
  }
}

TEST_F(BaselineFile, ThatIsMissingIsAnErrorThatNamesIt) {
  const auto baseline = read_baseline(folder_.path() / "none.json");
  ASSERT_FALSE(baseline);
  EXPECT_NE(baseline.error().message.find("cannot read"), std::string::npos);
  EXPECT_NE(baseline.error().message.find("none.json"), std::string::npos);
  EXPECT_FALSE(read_baseline(folder_.path()));
}

TEST_F(BaselineFile, OfAReportIsThatReport) {
  // Numbers that no decimal of few digits is.
  BenchReport report = report_of({measured("a", 1.0 / 3.0, 1e-17), measured("b", 2.0 / 7.0, 0.0), failed("c")});
  report.measurements[0].counts.problems = {"navi21: \xFE"};
  report.absent = {{"nvidia", "it is not NVIDIA's"}};
  const auto written = write_bench(folder_.path(), {}, report, {}, true);
  ASSERT_TRUE(written) << written.error().text();
  const auto baseline = read_baseline(path_);
  ASSERT_TRUE(baseline) << baseline.error().text();
  EXPECT_EQ(baseline->ratios.size(), 2u);
  for (const Change& change : compare_with_baseline(*baseline, report)) {
    EXPECT_EQ(change.before.value, change.now.value);
    EXPECT_EQ(change.before.spread, change.now.spread);
    EXPECT_FALSE(change.slower);
  }
  report.measurements[0].ratio.value = std::nextafter(1.0 / 3.0, 1.0);
  report.measurements[1].ratio.value = 3.0 / 7.0;
  const auto changes = compare_with_baseline(*baseline, report);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_TRUE(changes[0].slower);
  EXPECT_TRUE(changes[1].slower);
}

TEST_F(BaselineFile, PagesAndTablesNameEverySubject) {
  BenchReport report = report_of({measured("noise2d.perlin.lattice", 0.5, 0.25), failed("broken<2>")});
  report.measurements[0].counts.instructions = {{"spirv", 123456}};
  report.measurements[0].counts.problems = {"navi21: the shader is <too> hard"};
  report.absent = {{"nvidia", "it is not NVIDIA's"}};
  const Provenance provenance{"2026-01-02T03:04:05Z", "hn-conform bench --filter '*'", "voodoo", {}};
  const std::vector<Change> changes = {{"noise2d.perlin.lattice", {0.25, 0.0}, {0.5, 0.25}, true}};
  const auto written = write_bench(folder_.path(), provenance, report, changes, false);
  ASSERT_TRUE(written) << written.error().text();
  const auto text_of = [&](std::string_view name) {
    std::ifstream in(folder_.path() / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string page = text_of("index.html");
  for (const std::string_view part :
       {"noise2d.perlin.lattice", "broken&lt;2&gt;", "it does not compile", "the shader is &lt;too&gt; hard", "123456",
        "2026-01-02T03:04:05Z", "voodoo", "No counts from nvidia here", "slower", "0.250"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("<2>"), std::string::npos);
  EXPECT_NE(page.find("<dd>hashnoise "), std::string::npos);
  const std::string csv = text_of("bench.csv");
  EXPECT_NE(csv.find("\nnoise2d.perlin.lattice,0.500,0.250,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nbroken<2>,"), std::string::npos) << csv;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "spirv"));
}

// Of 10^9 evaluations in a second a frame has 2.07 milliseconds' worth.
Measurement costing(const std::string& id, int dimensions, double cost) {
  Measurement measurement = measured(id, cost / 4.0, cost / 64.0);
  measurement.subject.dimensions = dimensions;
  measurement.subject.expression = "call_of_" + id;
  measurement.evaluations_per_second = 1e9 / cost;
  return measurement;
}

std::string page_of(const BenchReport& report, const Provenance& provenance = {}) {
  const auto page = bench_page(provenance, report, {});
  EXPECT_TRUE(page) << page.error().text();
  return page.value_or("");
}

TEST(BenchPage, BeginsWithAFrameOfWhatPeopleUse) {
  const std::string page = page_of(report_of(
      {costing("empty2", 2, 0.5), costing("table.float2", 2, 4.0), costing("fbm.fbm2.lattice", 2, 8.0),
       costing("noise2d.perlin.lattice", 2, 2.0), costing("noise2d.perlin.fnv1", 2, 3.0), costing("simplex2", 2, 5.0),
       costing("noise2d.perlin_cell.lattice", 2, 1.0), costing("hash.word.lattice", 2, 0.25),
       costing("noise3d.perlin.lattice", 3, 6.0), failed("fbm.clouds2.lattice")}));
  const std::string frames = page.substr(page.find("A frame of"), page.find("<h2>") - page.find("A frame of"));
  std::size_t at = 0;
  for (const std::string row :
       {"call_of_noise2d.perlin.lattice</code></th><td class=\"number\">4.15</td><td class=\"number\">1</td>",
        "Perlin/Float, tables in textures</code></th><td class=\"number\">8.29</td><td class=\"number\">2.00 ± "
        "0.25</td>",
        "simplex2</code></th><td class=\"number\">10.4</td><td class=\"number\">2.50 ± 0.31</td>",
        "call_of_fbm.fbm2.lattice</code></th><td class=\"number\">16.6</td><td class=\"number\">4.00 ± 0.50</td>",
        "3D: p is a vec3", "call_of_noise3d.perlin.lattice</code></th><td class=\"number\">12.4</td>"}) {
    const auto found = frames.find(row, at);
    ASSERT_NE(found, std::string::npos) << row << " is not behind the row before it in\n" << frames;
    at = found;
  }
  for (const char* absent : {">empty", "fnv1", "cell", "hash.word", "clouds"}) {
    EXPECT_EQ(frames.find(absent), std::string::npos) << absent;
  }
}

TEST(BenchPage, SaysWhatCannotBeTold) {
  Measurement perlin = costing("noise2d.perlin.lattice", 2, 2.0);
  perlin.ratio.spread = perlin.ratio.value;
  Measurement fast = costing("simplex2", 2, 2.0);
  fast.evaluations_per_second.reset();
  std::string page = page_of(report_of({perlin, fast}));
  EXPECT_EQ(page.find("<th>noise2d.perlin.lattice</th>"), std::string::npos) << "it is the default";
  EXPECT_NE(page.find("<th>simplex2</th>"), std::string::npos) << "it is not";
  EXPECT_NE(
      page.find("simplex2</code></th><td class=\"number\">too fast to tell</td><td class=\"number\">cannot be told"),
      std::string::npos);
  page = page_of(report_of({costing("simplex2", 2, 2.0), costing("table.float2", 2, 4.0)}));
  EXPECT_NE(page.find("times Perlin/Float</th>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"number\">0.50 ± 0.06</td>"), std::string::npos) << page;
  EXPECT_EQ(page_of(report_of({costing("hash.word.fnv1", 2, 2.0)})).find("A frame of"), std::string::npos);
}

TEST(BenchPage, IsSortedAndMarksTheDefault) {
  const std::string page =
      page_of(report_of({failed("noise2d.perlin.pcg"), costing("noise2d.perlin.murmur", 2, 3.0),
                         costing("noise2d.perlin.lattice", 2, 2.0), costing("noise2d.perlin.fnv1", 2, 1.0)}));
  const std::string table = page.substr(page.find("<h2>Everything"));
  EXPECT_LT(table.find("perlin.fnv1"), table.find("perlin.lattice <span class=\"mark\">default</span>"));
  EXPECT_LT(table.find("perlin.lattice"), table.find("perlin.murmur</th>"));
  EXPECT_LT(table.find("perlin.murmur"), table.find("perlin.pcg</th>"));
  EXPECT_LT(page.find(">fnv1<"), page.find(">lattice (default)<"));
  EXPECT_LT(page.find(">lattice (default)<"), page.find(">murmur<"));
}

TEST(BenchPage, NamesTheEditedLibrary) {
  Provenance provenance;
  provenance.library = {.folder = "my/copy", .digest = "0123", .changed = {"hash.glsl"}};
  EXPECT_NE(
      page_of(report_of({costing("simplex2", 2, 2.0)}), provenance).find("the library in my/copy (hash.glsl differs"),
      std::string::npos);
  EXPECT_EQ(to_json(provenance).at("library").at("digest"), "0123");
}

}  // namespace
}  // namespace hn
