#include "cases/programs.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "cases/case.hpp"
#include "cases/value_checks.hpp"
#include "library/files.hpp"

namespace hn {
namespace {

TEST(Cover, TakesOfARoundWhatShowsMostAndOfEqualsTheCheapest) {
  const Candidate candidates[] = {{{0}, 0, 0}, {{0, 1}, 0, 9}, {{0, 1}, 0, 5}, {{1}, 1, 0}};
  EXPECT_EQ(cover_of(candidates, 2), (std::vector{false, false, true, false}));
}

TEST(Cover, TakesMoreOfARoundForWhatIsLeft) {
  const Candidate candidates[] = {{{0, 1}, 0, 0}, {{2}, 0, 0}, {{0}, 1, 0}};
  EXPECT_EQ(cover_of(candidates, 3), (std::vector{true, true, false}));
}

TEST(Cover, WhatIsAddedAtTheEndChangesNothingBefore) {
  std::vector<Candidate> candidates = {{{0, 2}, 0, 0}, {{1, 2}, 0, 0}, {{1, 2, 3}, 1, 0}};
  const auto before = cover_of(candidates, 5);
  candidates.push_back({{1, 3, 4}, 2, 0});
  auto after = cover_of(candidates, 5);
  after.pop_back();
  EXPECT_EQ(after, before);
}

TEST(Programs, ARunShowsAllThatTheProductShows) {
  EXPECT_EQ(fmt::format("{}", fmt::join(not_shown(program_extents()), "; ")), "");
}

// The list reports missing pairs: so it must change.
TEST(Programs, WhatIsLeftOutIsListed) {
  std::vector<Extent> extents = program_extents();
  const std::vector<PlannedProgram>& programs = all_programs();
  std::set<std::string> shown;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (programs[i].function->id != "noise2d.simplex_phase" || extents[i] == Extent::thorough) continue;
    extents[i] = Extent::thorough;
    for (std::string& word : shown_by(programs[i])) shown.insert(std::move(word));
  }
  const std::vector<std::string> missing = not_shown(extents);
  EXPECT_TRUE(std::ranges::find(missing, "noise2d.simplex_phase") != missing.end());
  for (const std::string& word : missing) EXPECT_TRUE(shown.contains(word)) << word;
}

TEST(Programs, ThereAreFewOfManyAndOfEachFunctionAtMostSevenWithTheDefaults) {
  std::map<std::string_view, int> of;
  int chosen = 0;
  for (std::size_t i = 0; i < all_programs().size(); ++i) {
    const bool opengl = all_programs()[i].target.profile->platform() == Platform::opengl;
    if (program_extents()[i] == Extent::thorough || !opengl) continue;
    ++chosen;
    if (!all_programs()[i].configuration->default_but_for_arithmetic()) continue;
    // Seven of one that takes what few others take together, a period and a footprint, and stands for many pairs.
    EXPECT_LE(++of[all_programs()[i].function->id], 7) << all_programs()[i].function->id;
  }
  EXPECT_LT(chosen * 10, static_cast<int>(all_programs().size()));
}

TEST(Programs, EveryDriverRunsSomeOfEachPlatform) {
  std::map<Platform, int> count;
  for (std::size_t i = 0; i < all_programs().size(); ++i) {
    if (program_extents()[i] == Extent::every_driver) ++count[all_programs()[i].target.profile->platform()];
  }
  EXPECT_GT(count[Platform::opengl], 10);
  EXPECT_LT(count[Platform::opengl], 40);
  EXPECT_GT(count[Platform::vulkan], 5);
}

TEST(Programs, WithEsAloneEveryFunctionIsRunAndEachNoiseInEachArithmeticThatEsHas) {
  std::set<std::string> shown;
  std::set<std::string> all;
  for (std::size_t i = 0; i < all_programs().size(); ++i) {
    const PlannedProgram& program = all_programs()[i];
    if (program.target.profile->name != "es300") {
      EXPECT_FALSE(is_in_es_cover()[i]) << program.function->id;
      continue;
    }
    for (const std::string& word : shown_by(program)) {
      all.insert(word);
      if (is_in_es_cover()[i]) shown.insert(word);
    }
  }
  EXPECT_FALSE(all.empty());
  EXPECT_EQ(shown, all);
}

// The words of a run without --thorough, among all.
std::set<std::string> words_of(Scope scope, std::string (*word_of)(const Case&)) {
  std::set<std::string> words;
  for (const Case& test : all_cases(scope)) {
    if (scope == Scope::covered && !test.is_covered()) continue;
    if (std::string word = word_of(test); !word.empty()) words.insert(std::move(word));
  }
  return words;
}

void expect_same(std::string (*word_of)(const Case&)) {
  EXPECT_EQ(words_of(Scope::covered, word_of), words_of(Scope::thorough, word_of));
}

TEST(Extent, EveryCheckIsRunButOneThatAnotherCovers) {
  // A stage is compared with the twin, which is stricter than a comparison with the fragment stage.
  expect_same([](const Case& test) { return test.name.check == "as_fragment" ? "" : test.name.check; });
}

TEST(Extent, EveryVersionAndStageIsRun) {
  expect_same([](const Case& test) {
    return test.name.check == "golden" ? test.name.profile + " " + std::string(name_of(test.name.stage)) : "";
  });
}

TEST(Extent, EveryVersionIsCompiled) {
  expect_same([](const Case& test) {
    const std::string& check = test.name.check;
    const bool compiles = check == "glslang" || check == "spirv" || check == "driver";
    return compiles && test.name.function.ends_with(".all") ? check + " " + test.name.profile : "";
  });
}

TEST(Extent, EveryFileIsCompiledInEveryArithmetic) {
  const auto files = words_of(Scope::covered, [](const Case& test) {
    const bool alone = test.name.check == "highp" || test.name.check == "uncontracted";
    return alone ? test.name.function + " " + test.name.arithmetic : "";
  });
  for (const auto& [file, text] : kLibraryFiles) {
    if (!file.ends_with(".glsl") || file == "hash.glsl") continue;
    for (const std::string_view arithmetic : {"fast", "fixed", "precise"}) {
      const std::string_view name = file.substr(file.rfind('/') + 1);
      const auto word = fmt::format("{}.all {}", name.substr(0, name.find('.')), arithmetic);
      EXPECT_TRUE(files.contains(word)) << word;
    }
  }
}

TEST(Extent, EveryVariantMeetsEveryFamilyAndArithmetic) {
  static const std::set<std::string_view> kVariants = {"inlined", "in_loop", "constant_seed", "uniform_seed", "folded"};
  expect_same([](const Case& test) {
    const Evaluation* const evaluation = test.evaluation();
    if (!evaluation || !kVariants.contains(test.name.check)) return std::string();
    return fmt::format("{} {}", test.name.check, static_cast<unsigned>(evaluation->function.family));
  });
  expect_same([](const Case& test) {
    return kVariants.contains(test.name.check) ? test.name.check + " " + test.name.arithmetic : "";
  });
}

TEST(Extent, EveryRelationMeetsEveryNoiseAndSum) {
  static const std::set<std::string_view> kRelations = {
      "wrapped",        "from_cell",        "whole_detail", "small_footprint", "phase_zero", "zero_strength",
      "zero_bandwidth", "derivative_value", "derivative",   "period",          "loop",       "half_turn"};
  expect_same([](const Case& test) {
    const Evaluation* const evaluation = test.evaluation();
    if (!evaluation || !kRelations.contains(test.name.check)) return std::string();
    return fmt::format("{} {}", test.name.check, evaluation->function.bound);
  });
}

TEST(Extent, EveryFunctionThatSetsTheNearestPointIsHeldAgainstTheOneThatDoesNot) {
  expect_same([](const Case& test) {
    const Evaluation* const evaluation = test.evaluation();
    if (!evaluation || test.name.check != "returned") return std::string();
    return fmt::format("{} of {} axes", evaluation->function.bound, evaluation->function.axes);
  });
  for (const std::string_view noise : {"cellular", "cellular_phase", "cell_border"}) {
    const Function& function = find_function(fmt::format("noise2d.{}_nearest", noise));
    ASSERT_TRUE(returning(function)) << noise;
    EXPECT_TRUE(returning(function)->id == fmt::format("noise2d.{}_full", noise) ||
                returning(function)->id == fmt::format("noise2d.{}", noise))
        << returning(function)->id;
  }
  EXPECT_FALSE(returning(find_function("noise2d.cellular_full")));
}

TEST(Extent, EveryOverloadWithoutASeedIsCompared) {
  std::set<std::string_view> files;
  for (const Case& test : all_cases(Scope::covered)) {
    if (test.name.check == "unseeded") files.insert(test.evaluation()->function.file);
  }
  for (const Function& function : all_functions()) {
    const bool own = function.has_unseeded && function.file != "hashnoise.glsl";
    EXPECT_TRUE(!own || files.contains(function.file)) << function.id;
  }
}

}  // namespace
}  // namespace hn
