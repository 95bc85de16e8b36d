#include "paper/algorithm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "base/file.hpp"
#include "gpu/reference_compiler.hpp"
#include "gpu/spirv.hpp"
#include "paper/files.hpp"

namespace hn {
namespace {

std::vector<std::string> ids_of_entries() {
  std::vector<std::string> ids;
  for (const Entry& entry : all_entries()) ids.push_back(entry.id());
  return ids;
}

TEST(Algorithm, EveryOneIsThereInEachOfItsForms) {
  EXPECT_EQ(ids_of_entries(),
            (std::vector<std::string>{
                "fnv1.published", "fnv1.intended", "fnv1.ours", "partial_fnv1.published", "partial_fnv1.intended",
                "partial_fnv1.ours", "jenkins.published", "jenkins.intended", "jenkins.ours",
                "partial_jenkins.published", "partial_jenkins.intended", "partial_jenkins.ours", "murmur.published",
                "murmur.intended", "murmur.ours", "float.table", "integer.table", "lattice.ours"}));
}

TEST(Algorithm, SubjectsHaveIdsOfTheirOwn) {
  std::set<std::string> ids;
  std::set<std::string> texts;
  for (const Entry& entry : all_entries()) {
    for (const int dimensions : {2, 3}) {
      for (const Picture picture : {Picture::noise, Picture::turbulence, Picture::clouds}) {
        const Subject subject = subject_of(entry, dimensions, picture);
        EXPECT_EQ(subject.dimensions, dimensions);
        ids.insert(subject.id);
        texts.insert(quad_shader(subject));
      }
    }
  }
  EXPECT_EQ(ids.size(), 18u * 2u * 3u);
  EXPECT_EQ(texts.size(), 18u * 2u * 3u);
}

TEST(Algorithm, APeriodIsTheNoises) {
  EXPECT_EQ(subject_of(all_entries().back(), 3, Picture::noise, 48).expression, "hn_perlin(hn_tile(p, ivec3(48)), 0u)");
  const Subject subject = subject_of(all_entries().back(), 2, Picture::clouds, 48);
  EXPECT_EQ(subject.id, "lattice.ours.2d.clouds");
  constexpr std::string_view kLoop =
      "do hn_add(o, hn_perlin(hn_tile(hn_position(o.place), ivec2(48)), o.seed)); while (hn_next(o));\n";
  EXPECT_NE(subject.prelude.find(kLoop), std::string::npos);
  EXPECT_NE(subject.prelude.find("return hn_density(o);\n"), std::string::npos);
  EXPECT_EQ(subject.expression, "paper_sum(hn_octaves(p, 6, 2.0, 0.5, 0u))");
  EXPECT_EQ(subject_of(all_entries().back(), 2, Picture::turbulence).expression, "hn_turbulence(p, 6, 2.0, 0.5)");
}

// The algorithm and the number of dimensions of each line of printed.csv behind the first.
std::vector<std::pair<std::string, int>> printed_lines(std::string_view csv) {
  std::vector<std::pair<std::string, int>> lines;
  csv.remove_prefix(csv.find('\n') + 1);
  while (!csv.empty()) {
    const std::string_view line = csv.substr(0, csv.find('\n'));
    csv.remove_prefix(std::min(line.size() + 1, csv.size()));
    const auto comma = line.find(',');
    int dimensions = 0;
    std::from_chars(line.data() + comma + 1, line.data() + line.size(), dimensions);
    lines.emplace_back(line.substr(0, comma), dimensions);
  }
  return lines;
}

// Rows of the table without an algorithm, and algorithms of the paper without a row.
std::set<std::string> missing(std::string_view csv) {
  std::set<std::pair<std::string, int>> expected;
  for (const Algorithm& algorithm : all_algorithms()) {
    for (const int dimensions : {2, 3}) {
      if (algorithm.printed) expected.emplace(algorithm.title, dimensions);
    }
  }
  std::set<std::string> faults;
  for (const auto& line : printed_lines(csv)) {
    if (expected.erase(line) == 0) faults.insert("not expected: " + line.first + std::to_string(line.second));
  }
  for (const auto& line : expected) faults.insert("missing: " + line.first + std::to_string(line.second));
  return faults;
}

// The table that the page shows beside ours.
std::string printed() {
  const auto root = std::filesystem::path(HN_GOLDEN_DIRECTORY).parent_path().parent_path().parent_path();
  return *read_file(root / "conformance/paper/printed.csv");
}

TEST(Algorithm, EveryOneOfThePaperIsInItsTable) {
  const std::string csv = printed();
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "algorithm,dimensions,instructions,ms_800x600,ms_1024x768");
  EXPECT_EQ(printed_lines(csv).size(), 14u);
  EXPECT_EQ(missing(csv), std::set<std::string>{});
}

TEST(Algorithm, ALineThatIsMissingOrTooManyIsSeen) {
  std::string csv = printed();
  csv.replace(csv.find("Murmur,3"), 8, "Murmur,4");
  EXPECT_EQ(missing(csv), (std::set<std::string>{"missing: Perlin/Murmur3", "not expected: Perlin/Murmur4"}));
}

Result<std::vector<std::uint32_t>> spirv_of(const Subject& subject) {
  static const ReferenceCompiler compiler;
  static const SourceSet sources = with_published_listings(with_comparison_shaders(SourceSet::embedded()));
  const auto text = expand(sources, profile_named("vulkan"), quad_shader(subject));
  return text ? compiler.spirv(*text, Stage::fragment) : tl::unexpected(text.error());
}

TEST(Algorithm, EverySubjectCompilesForVulkan) {
  // Turbulence and clouds take turns, since what each adds to a noise is the same for all.
  Picture other = Picture::clouds;
  for (const Entry& entry : all_entries()) {
    other = other == Picture::clouds ? Picture::turbulence : Picture::clouds;
    for (const int dimensions : {2, 3}) {
      for (const Picture picture : {Picture::noise, other}) {
        const Subject subject = subject_of(entry, dimensions, picture);
        const auto words = spirv_of(subject);
        ASSERT_TRUE(words) << subject.id << ": " << words.error().text();
        const auto valid = validate_spirv(*words);
        EXPECT_TRUE(valid) << subject.id << ": " << valid.error().text();
      }
    }
  }
}

TEST(Algorithm, ASubjectThatDoesNotCompileIsSeen) {
  Subject subject = subject_of(all_entries().front(), 2);
  subject.expression = "paper_noise(p)";
  const auto words = spirv_of(subject);
  ASSERT_FALSE(words);
  EXPECT_NE(words.error().text().find("paper_noise"), std::string::npos) << words.error().text();
}

}  // namespace
}  // namespace hn
