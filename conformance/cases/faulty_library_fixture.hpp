// For tests that give the library a fault, and look what cases report about it.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cases/case.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {

// A fault of the library, and the case that must catch it: a text, in all places of a file, and its replacement; or a
// macro at the end of the file, so that all code after its include sees it.
struct LibraryFault {
  std::string_view id;
  std::string_view file;
  std::string_view text;  // or kMacro
  std::string_view fault;
  std::string_view where = {};  // a shader's name for itself, if only such shaders see the macro

  std::string_view check() const { return id.substr(id.rfind('.') + 1); }
};
inline constexpr std::string_view kMacro;

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

  // The case passes, and fails with the fault.
  Outcome expect_caught(const LibraryFault& fault) {
    expect_faultless_passes(fault.id);
    if (fault.text != kMacro) {
      replace(fault.file, fault.text, fault.fault);
    } else if (fault.where.empty()) {
      append(fault.file, fmt::format("#define {}", fault.fault));
    } else {
      append(fault.file, fmt::format("#ifdef {}\n#define {}\n#endif", fault.where, fault.fault));
    }
    return expect_fails(fault.id, fault.fault);
  }

  void replace(std::string_view file, std::string_view before, std::string_view after) {
    std::string text = SourceSet::embedded().find(file)->text;
    auto at = text.find(before);
    ASSERT_NE(at, std::string::npos) << file << ": " << before;
    for (; at != std::string::npos; at = text.find(before, at + after.size())) text.replace(at, before.size(), after);
    sources_.add(std::string(file), text, std::string(file));
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
  Outcome expect_fails(std::string_view id, std::string_view fault) {
    const Outcome wrong = run(id);
    EXPECT_EQ(wrong.status, Status::fail) << id << ": " << fault << ": " << wrong.message;
    EXPECT_NE(wrong.mismatches, 0u) << id << ": " << fault << ": " << wrong.message;
    return wrong;
  }

  const ReferenceCompiler reference_;
  SourceSet sources_ = SourceSet::embedded();
};

}  // namespace hn
