// A case: one thing that a driver can get right or wrong, with its evidence; and in which versions and stages the cases
// evaluate functions.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.hpp"
#include "cases/session.hpp"
#include "expected/pairing.hpp"
#include "expected/verdict.hpp"
#include "library/functions.hpp"
#include "library/profile.hpp"

namespace hn {

// Where a case belongs.
enum class Extent {
  every_driver,  // for each driver
  one_driver,    // run --deal runs it on one of the drivers that can
  thorough,      // run --thorough alone runs it
};

// A version and a stage in which functions are evaluated.
struct Target {
  const Profile* profile;
  Stage stage;
  bool main;  // one of the versions in which a configuration has most of its cases: of desktop OpenGL, or of ES
};

// The targets of a configuration: its main versions, GLSL without bit casts, the other stages, and Vulkan's.
std::vector<Target> targets_of(const Configuration& configuration);

// The kinds of cases. A kind is data, as far as it can be, so that a browser's page can run the same.

// The function against its golden file.
struct GoldenKind {
  Evaluation evaluation;
};

// Two ways to compute the same values.
using MakePairing = Pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points);
struct PairingKind {
  Evaluation evaluation;
  MakePairing* make;
};

// A check that exists only in C++.
// The outcome of a check, or of an evaluation that it could not make.
using Judged = tl::expected<Outcome, Outcome>;
using Check = Judged(Session& session, const Evaluation& evaluation);
struct CheckKind {
  Evaluation evaluation;
  Check* check;
};

struct Bug;  // bugs/bugs.hpp
struct BugKind {
  const Bug* bug;
  const Profile* profile;
};

// A case that only makes the driver compile something.
struct CompilationKind {
  const Profile* profile;
  // Writes the shader, before its includes are expanded: of the many cases that are listed few are run.
  std::function<std::string()> fragment;
  std::string_view refusal =
      {};                // the word that the driver's error must have; empty if the shader must compile and link
  bool too_old = false;  // a driver may refuse the version before it reads the library's words
};

// A case that needs only the reference compiler.
struct ReferenceKind {
  std::function<Outcome(const Suite&)> check;
};

// The parts of a case's id.
struct CaseName {
  std::string function;       // with its file: "noise2d.perlin"; "noise2d.all" is the file as a whole
  std::string configuration;  // without the arithmetic, or "any"
  std::string arithmetic;
  Stage stage;
  std::string profile;
  std::string check;

  // All but the check. Cases with the same subject use one program, or variants of it.
  std::string setting() const;
  std::string id() const;
};

using CaseKind = std::variant<GoldenKind, PairingKind, CheckKind, BugKind, CompilationKind, ReferenceKind>;

struct Case {
  CaseName name;
  std::string id;  // of the name
  std::shared_ptr<const CaseKind> kind;
  Extent extent;
  bool for_es = false;  // a driver that has GLSL ES 3.00 alone runs it, too
  std::string about;    // where it comes from, in lines for hn-conform list --about; mostly nothing

  Case(CaseName name_, CaseKind kind_, Extent extent_ = Extent::every_driver, std::string about_ = {});

  template <typename Kind>
  bool is() const {
    return std::holds_alternative<Kind>(*kind);
  }
  bool needs_driver() const { return !is<ReferenceKind>(); }
  // Whether a run has it without --thorough: on a driver with desktop versions, or on one without.
  bool is_covered(bool es_alone = false) const { return extent != Extent::thorough || (es_alone && for_es); }
  // The evaluation of a function of the library, or null.
  const Evaluation* evaluation() const;
};

// Runs the case, and times it. An exception in it gives the status `error`.
CaseResult run_case(Session& session, const Case& test);
CaseResult run_case(const Suite& suite, const Case& test);  // of one that needs no driver

// How much of the product of functions, settings, versions and stages: the part of a run without --thorough, or all.
enum class Scope { covered, thorough };
// Every case, in the order in which they run.
std::vector<Case> all_cases(Scope scope = Scope::thorough);
std::vector<std::string> ids_of(const std::vector<Case>& cases);
Result<std::vector<Case>> cases_with(std::span<const std::string> ids);
Case case_named(std::string_view id);  // throws std::logic_error if there is none

using Subjects = std::set<std::string_view>;  // ids of functions
// The parts of all_cases, a file each.
void add_compile_cases(std::vector<Case>& cases, Scope scope);
void add_value_cases(std::vector<Case>& cases, Scope scope, const Subjects* subjects = nullptr);  // null: of all
void add_bug_cases(std::vector<Case>& cases);                                                     // bugs/

struct CheckDescription {
  std::string_view check;  // the last part of a case's id
  std::string_view text;   // sentences, in Markdown
};

// Every check, in the order of the page.
std::span<const CheckDescription> check_descriptions();

}  // namespace hn
