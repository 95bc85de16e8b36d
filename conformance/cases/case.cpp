#include "cases/case.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <exception>
#include <functional>
#include <map>
#include <utility>

#include "cases/bugs/bugs.hpp"
#include "cases/value_checks.hpp"

namespace hn {

namespace {

Outcome run(Session& session, const GoldenKind& kind) { return check_golden(session, kind.evaluation); }
Outcome run(Session& session, const PairingKind& kind) {
  return check_pairing(session, kind.make(kind.evaluation, session.seed, kPairingPoints));
}
Outcome run(Session& session, const CheckKind& kind) { return kind.check(session, kind.evaluation); }
Outcome run(Session& session, const BugKind& kind) { return check_bug(session, *kind.bug, *kind.profile); }
Outcome run(Session& session, const CompilationKind& kind) { return check_compilation(session, kind); }
Outcome run(Session& session, const ReferenceKind& kind) { return kind.check(session); }

// Of this process, and of those that it started and that have ended.
double processor_seconds() {
  double seconds = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
  }
  return seconds;
}

template <typename Run>
CaseResult timed(const std::string& id, Run run) {
  const auto start = std::chrono::steady_clock::now();
  const double processor_start = processor_seconds();
  CaseResult result;
  result.id = id;
  try {
    result.outcome = run();
  } catch (const std::exception& exception) {
    result.outcome = outcome_with(Status::error, {fmt::format("exception: {}", exception.what()), {}});
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.processor_seconds = processor_seconds() - processor_start;
  return result;
}

}  // namespace

std::string CaseName::setting() const {
  return fmt::format("{}.{}.{}.{}.{}", function, configuration, arithmetic, name_of(stage), profile);
}

std::string CaseName::id() const { return fmt::format("{}.{}", setting(), check); }

Case::Case(CaseName name_, CaseKind kind_, Extent extent_, std::string about_)
    : name(std::move(name_)),
      id(name.id()),
      kind(std::make_shared<const CaseKind>(std::move(kind_))),
      extent(extent_),
      about(std::move(about_)) {}

const Evaluation* Case::evaluation() const {
  return std::visit(
      [](const auto& any) -> const Evaluation* {
        if constexpr (requires { any.evaluation; }) {
          return &any.evaluation;
        } else {
          return nullptr;
        }
      },
      *kind);
}

CaseResult run_case(Session& session, const Case& test) {
  return timed(test.id, [&] { return std::visit([&](const auto& kind) { return run(session, kind); }, *test.kind); });
}

CaseResult run_case(const Suite& suite, const Case& test) {
  return timed(test.id, [&] { return std::get<ReferenceKind>(*test.kind).check(suite); });
}

std::vector<Case> all_cases(Scope scope) {
  std::vector<Case> cases;
  add_value_cases(cases, scope);
  add_compile_cases(cases, scope);
  add_bug_cases(cases);
  return cases;
}

std::vector<std::string> ids_of(const std::vector<Case>& cases) {
  std::vector<std::string> ids;
  for (const Case& test : cases) ids.push_back(test.id);
  return ids;
}

namespace {

// The cases by their ids. A process that asks again does not list them again.
const std::map<std::string, Case, std::less<>>& cases_by_id(Scope scope) {
  static std::map<Scope, std::map<std::string, Case, std::less<>>> lists;
  auto& list = lists[scope];
  if (!list.empty()) return list;
  for (Case& test : all_cases(scope)) {
    std::string id = test.id;
    list.emplace(std::move(id), std::move(test));
  }
  return list;
}

}  // namespace

Result<std::vector<Case>> cases_with(std::span<const std::string> ids) {
  std::vector<Case> cases;
  for (const Scope scope : {Scope::covered, Scope::thorough}) {  // the second takes ten times as long to list
    const auto& all = cases_by_id(scope);
    cases.clear();
    std::string missing;
    for (const std::string& id : ids) {
      const auto found = all.find(id);
      if (found != all.end()) {
        cases.push_back(found->second);
      } else {
        missing = id;
      }
    }
    if (missing.empty()) return cases;
    if (scope == Scope::thorough) return fail(fmt::format("there is no case {}", missing));
  }
  return cases;
}

}  // namespace hn
