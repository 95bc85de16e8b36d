// For tests that give the library a fault, and look what cases say about it.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cases/case.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {

class FaultyLibrary : public OnOsmesa<> {
 protected:
  // Appends lines to a file, so that all code after its include sees them.
  void append(std::string_view file, std::string_view lines) {
    sources_.add(std::string(file), fmt::format("{}\n{}\n", SourceSet::embedded().find(file)->text, lines),
                 std::string(file));
  }

  Outcome run(Session& session, std::string_view id) {
    const auto found = std::find_if(cases_.begin(), cases_.end(), [&](const Case& test) { return test.id == id; });
    EXPECT_NE(found, cases_.end()) << id;
    return found == cases_.end() ? outcome_with(Status::error, {"no such case", {}})
                                 : run_case(session, *found).outcome;
  }

  Outcome run(std::string_view id) {
    Session session({sources_, reference_, HN_GOLDEN_DIRECTORY, 1}, *context_);
    return run(session, id);
  }

  const std::vector<Case> cases_ = all_cases();
  const ReferenceCompiler reference_;
  SourceSet sources_ = SourceSet::embedded();
};

}  // namespace hn
