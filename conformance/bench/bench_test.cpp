#include "bench/bench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "base/file.hpp"
#include "base/folder.hpp"
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
                                {.rounds = 3, .most_at_a_time = 2}, nowhere);
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

TEST(BenchFile, HasFactsAndARowForEachSubject) {
  BenchReport report = report_of({measured("noise2d.perlin.lattice", 1.0 / 3.0, 0.25), failed("broken"),
                                  measured("unknown", std::nan(""), std::nan(""))});
  report.measurements[0].problem = "SPIR-V: the shader is too hard\xFF";
  Provenance provenance{"2026-01-02T03:04:05Z", "hn-conform bench --filter '*'", "voodoo", {}};
  provenance.library = {.folder = "my/copy", .digest = "0123", .changed = {"hash.glsl"}};
  const TemporaryFolder folder;
  const auto written = write_bench(folder.path(), provenance, report, false);
  ASSERT_TRUE(written) << written.error().text();
  const std::string csv = read_file(folder.path() / "bench.csv").value();
  for (const std::string_view part :
       {"# date: 2026-01-02T03:04:05Z\n", "# driver: voodoo\n", "# library: the library in my/copy (hash.glsl differs",
        "\nid,dimensions,call,ratio,spread,evaluations_per_second,compile_ms,spirv,problem\n",
        "\nnoise2d.perlin.lattice,2,1.0,0.33333,0.25,too fast to tell,0.0,failed,SPIR-V: the",
        "\nbroken,2,1.0,failed,failed,failed,failed,failed,\"it does not compile",
        "\nunknown,2,1.0,cannot be told,cannot be told,"}) {
    EXPECT_NE(csv.find(part), std::string::npos) << part << " is not in\n" << csv;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "spirv"));
}

}  // namespace
}  // namespace hn
