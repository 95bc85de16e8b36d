#include "cases/case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "cases/value_checks.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

TEST(Cases, IdsAreUniqueAndHaveSevenParts) {
  std::set<std::string> seen;
  for (const Case& test : all_cases()) {
    EXPECT_TRUE(seen.insert(test.id).second) << test.id;
    EXPECT_EQ(std::count(test.id.begin(), test.id.end(), '.'), 6) << test.id;
  }
}

TEST(Cases, EveryCheckIsDescribed) {
  std::set<std::string_view> described;
  for (const CheckDescription& description : check_descriptions()) {
    EXPECT_TRUE(described.insert(description.check).second) << description.check << " is described twice";
  }
  std::set<std::string_view> checks;
  const std::vector<Case> cases = all_cases();
  for (const Case& test : cases) checks.insert(test.name.check);
  EXPECT_EQ(described, checks) << "write what it holds against what into cases/checks.cpp";
}

TEST(Cases, EveryConfigurationAndFunctionHasGoldenAndTwin) {
  std::set<std::string> seen;
  for (const Case& test : all_cases()) seen.insert(test.id);
  for (const Function& function : all_functions()) {
    for (const Configuration& configuration : all_configurations()) {
      if (!covers(configuration, function)) continue;
      const auto name = configuration_name(function, configuration);
      const bool precise = configuration.arithmetic == Arithmetic::precise;
      const std::string start = fmt::format("{}.{}.{}.fragment.{}.", function.id, name,
                                            arithmetic_name(function, configuration), precise ? "gl400" : "gl330");
      EXPECT_TRUE(seen.contains(start + "golden")) << start;
      EXPECT_TRUE(seen.contains(start + "twin")) << start;
    }
  }
}

Judged throws(Session&, const Evaluation&) { throw std::runtime_error("thrown"); }

class CasesOnOsmesa : public OnOsmesa<> {};

TEST_F(CasesOnOsmesa, AnExceptionIsAnError) {
  const SourceSet sources = SourceSet::embedded();
  const ReferenceCompiler reference;
  Session session({sources, reference, "", 1}, *context_, 1);
  const Evaluation evaluation{find_function("hash.word"), default_configuration(), profile_named("gl330")};
  const CaseResult result = run_case(session, {name_of(evaluation, "throws"), CheckKind{evaluation, throws}});
  EXPECT_EQ(result.id, "hash.word.lattice.exact.fragment.gl330.throws");
  EXPECT_EQ(result.outcome.status, Status::error);
  EXPECT_EQ(result.outcome.message, "exception: thrown");
}

}  // namespace
}  // namespace hn
