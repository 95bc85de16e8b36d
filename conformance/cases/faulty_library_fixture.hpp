// For tests that give the library a fault, and look what cases report about it.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cases/case_named.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {

// A text of the library, in all places of a file, and its replacement.
struct Replacement {
  std::string_view id;
  std::string_view file;
  std::string_view text;
  std::string_view fault;
};

class FaultyLibrary : public OnOsmesa<> {
 protected:
  // Appends lines to a file, so that all code after its include sees them.
  void append(std::string_view file, std::string_view lines) {
    sources_.add(std::string(file), fmt::format("{}\n{}\n", SourceSet::embedded().find(file)->text, lines),
                 std::string(file));
  }

  Outcome run(Session& session, std::string_view id) { return run_case(session, case_named(id)).outcome; }

  Outcome run(std::string_view id) {
    Session session({sources_, reference_, HN_GOLDEN_DIRECTORY, 1}, *context_);
    return run(session, id);
  }

  // A case passes (tried in thorough runs), and fails once the macro `fault` stands at the end of a file.
  void expect_caught(std::string_view id, std::string_view file, std::string_view fault) {
    expect_faultless_passes(id);
    append(file, fmt::format("#define {}", fault));
    expect_fails(id, fault);
  }

  void expect_replaced_caught(const Replacement& fault) {
    expect_faultless_passes(fault.id);
    std::string text = SourceSet::embedded().find(fault.file)->text;
    auto at = text.find(fault.text);
    ASSERT_NE(at, std::string::npos) << fault.file << ": " << fault.text;
    for (; at != std::string::npos; at = text.find(fault.text, at + fault.fault.size())) {
      text.replace(at, fault.text.size(), fault.fault);
    }
    sources_.add(std::string(fault.file), text, std::string(fault.file));
    expect_fails(fault.id, fault.fault);
  }

  // A run of the cases shows it as well, and a driver takes as long to compile this as what follows.
  void expect_faultless_passes(std::string_view id) {
    sources_ = SourceSet::embedded();
    if (std::getenv("HN_THOROUGH")) expect_passes(id);
  }

  void expect_passes(std::string_view id) {
    sources_ = SourceSet::embedded();
    const Outcome right = run(id);
    EXPECT_EQ(right.status, Status::pass) << id << ": " << right.message;
  }

  // With mismatches: a fault that does not compile is none that the check has found.
  void expect_fails(std::string_view id, std::string_view fault) {
    const Outcome wrong = run(id);
    EXPECT_EQ(wrong.status, Status::fail) << id << ": " << fault << ": " << wrong.message;
    EXPECT_NE(wrong.mismatches, 0u) << id << ": " << fault << ": " << wrong.message;
  }

  const ReferenceCompiler reference_;
  SourceSet sources_ = SourceSet::embedded();
};

}  // namespace hn
