#include "bench/subject.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "bench/counts.hpp"
#include "gpu/gpu.hpp"
#include "gpu/osmesa_fixture.hpp"
#include "gpu/spirv.hpp"
#include "library/configurations.hpp"

namespace hn {
namespace {

bool has(const std::vector<Subject>& subjects, const std::string& id) {
  return std::any_of(subjects.begin(), subjects.end(), [&](const Subject& s) { return s.id == id; });
}

TEST(Subjects, CoverEveryFunctionInEachConfiguration) {
  std::size_t expected = 0;
  const auto all = library_subjects();
  for (const Configuration& configuration : all_configurations()) {
    const auto subjects = library_subjects(configuration);
    for (const Function& function : all_functions()) {
      const std::string any = std::string(function.id) + ".any";
      const std::string own = std::string(function.id) + "." + std::string(configuration.name);
      // A row without a call is measured by another.
      const bool covered = covers(configuration, function) && !function.call.empty();
      expected += covered ? 1 : 0;
      EXPECT_EQ(has(subjects, function.family == Family::independent ? any : own), covered) << own;
      EXPECT_EQ(has(all, function.family == Family::independent ? any : own),
                covered || function.family == Family::independent)
          << own;
    }
  }
  // And the sums over a noise of the user's own.
  for (const char* const id : {"fbm.fbm2.own_noise", "fbm.fbm3.own_noise"}) EXPECT_TRUE(has(all, id)) << id;
  EXPECT_EQ(all.size(), expected + 2);
}

TEST(Subjects, HaveIdsOfTheirOwn) {
  auto subjects = library_subjects();
  for (const int dimensions : {2, 3}) {
    for (Subject& subject :
         std::vector{empty_subject(dimensions), float_subject(dimensions), integer_subject(dimensions)}) {
      EXPECT_EQ(subject.dimensions, dimensions);
      subjects.push_back(std::move(subject));
    }
  }
  std::set<std::string> ids;
  for (const Subject& subject : subjects) EXPECT_TRUE(ids.insert(subject.id).second) << subject.id;
}

class SubjectShaders : public OnOsmesa<> {
 protected:
  void SetUp() override {
    OnOsmesa::SetUp();
    if (HasFatalFailure()) return;
    sources_.add("against/value",
                 "float value_noise(vec2 p) { return fract(sin(dot(p, vec2(12.9, 78.2))) * 43758.5); }\n",
                 "/home/me/value.glsl");
  }

  Result<void> link(const std::string& fragment, std::string_view profile = "gl330") {
    const auto vertex_text = expand(sources_, profile_named(profile), quad_vertex_shader());
    const auto fragment_text = expand(sources_, profile_named(profile), fragment);
    if (!fragment_text) return tl::unexpected(fragment_text.error());
    const auto program = Program::build(*context_, *vertex_text, *fragment_text);
    if (!program) return tl::unexpected(program.error());
    return {};
  }

  Result<void> compile_for_vulkan(const std::string& fragment) {
    const auto text = expand(sources_, profile_named("vulkan"), fragment);
    return text ? reference_.check(*text, profile_named("vulkan"), Stage::fragment) : tl::unexpected(text.error());
  }

  void expect_shaders_work(const Subject& subject) {
    const auto vulkan = compile_for_vulkan(quad_shader(subject));
    EXPECT_TRUE(vulkan) << subject.id << ": " << vulkan.error().text();
    for (const std::string& text : {quad_shader(subject), loop_shader(subject)}) {
      const auto linked = link(text, subject.profile);
      EXPECT_TRUE(linked) << subject.id << ": " << linked.error().text();
    }
  }

  void expect_refused(const Subject& subject, std::string_view named) {
    for (const auto& refused : {link(loop_shader(subject)), compile_for_vulkan(quad_shader(subject))}) {
      ASSERT_FALSE(refused) << subject.expression;
      EXPECT_NE(refused.error().log.find(named), std::string::npos) << refused.error().text();
    }
  }

  const ReferenceCompiler reference_;
  SourceSet sources_ = with_comparison_shaders(SourceSet::embedded());
};

// Some of them: golden cases compile what rows call, and tools/test --thorough takes all.
std::vector<Subject> some_of(const std::vector<Subject>& all, std::size_t every) {
  std::vector<Subject> some;
  for (std::size_t i = 0; i < all.size(); i += std::getenv("HN_THOROUGH") ? 1 : every) some.push_back(all[i]);
  return some;
}

TEST_F(SubjectShaders, OfTheLibraryCompile) {
  for (const Subject& subject : some_of(library_subjects(default_configuration()), 37)) expect_shaders_work(subject);
}

// A row of the table makes the same calls with each setting, so some of the rows show that the setting arrives.
TEST_F(SubjectShaders, OfOtherSettingsCompile) {
  for (const std::string_view name : {"custom", "fnv1+sine", "lattice+precise", "lattice+fixed"}) {
    ASSERT_EQ(configuration_named(name).name, name);
    const std::vector<Subject> subjects = some_of(library_subjects(configuration_named(name)), 11);
    for (std::size_t i = 0; i < subjects.size(); i += 5) expect_shaders_work(subjects[i]);
  }
}

TEST_F(SubjectShaders, OfTheComparisonsCompile) {
  for (const int dimensions : {2, 3}) {
    expect_shaders_work(empty_subject(dimensions));
    expect_shaders_work(float_subject(dimensions));
    expect_shaders_work(integer_subject(dimensions));
  }
}

// The value must reach the picture, or a compiler would throw away what is to be measured.
TEST_F(SubjectShaders, CostMoreThanTheEmptyOnes) {
  const auto count = [&](const Subject& subject) {
    const auto text = expand(sources_, profile_named("vulkan"), quad_shader(subject));
    const auto words = text ? reference_.spirv(*text, Stage::fragment) : tl::unexpected(text.error());
    const auto optimised = words ? optimise_spirv(*words) : words;
    return optimised ? count_spirv(*optimised) : 0;
  };
  std::vector<Subject> subjects = some_of(library_subjects(default_configuration()), 31);
  for (const int dimensions : {2, 3}) {
    subjects.push_back(float_subject(dimensions));
    subjects.push_back(integer_subject(dimensions));
  }
  for (const Subject& subject : subjects) {
    EXPECT_GT(count(subject), count(empty_subject(subject.dimensions))) << subject.id;
  }
}

TEST_F(SubjectShaders, OfSomebodyElseMustBeFloats) {
  for (const std::string_view expression :
       {"p", "vec3(p, 0.0)", "int(p.x)", "uint(p.x)", "p.x < 0.5", "ivec2(p)", ""}) {
    expect_refused(foreign_subject("value", "against/value", expression, 2), "the case's shader:");
  }
}

}  // namespace
}  // namespace hn
