#include "cases/case.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "cases/bugs/bugs.hpp"
#include "cases/value_checks.hpp"
#include "gpu/way/evaluator.hpp"

namespace hn {
namespace {

Judged run(Session& session, const GoldenKind& kind) { return check_golden(session, kind.evaluation); }
Judged run(Session& session, const PairingKind& kind) {
  return check_pairing(session, kind.make(kind.evaluation, session.seed, kPairingPoints));
}
Judged run(Session& session, const CheckKind& kind) { return kind.check(session, kind.evaluation); }
Judged run(Session& session, const BugKind& kind) { return check_bug(session, *kind.bug, *kind.profile); }
Judged run(Session& session, const CompilationKind& kind) { return check_compilation(session, kind); }
Judged run(Session& session, const ReferenceKind& kind) { return kind.check(session); }

// Counts this process, and those that it started and that have ended.
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
    const Judged judged = run();
    result.outcome = judged ? *judged : judged.error();
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

namespace {

CaseResult run_once(Session& session, const Case& test) {
  return timed(test.id, [&] { return std::visit([&](const auto& kind) { return run(session, kind); }, *test.kind); });
}

bool has_wrong_values(const Outcome& outcome) { return outcome.status == Status::fail && outcome.mismatches > 0; }

// Whether a case of wrong values has them after so many steps, too, without one of them; nothing if it cannot be seen.
std::optional<bool> is_wrong_after(Session& session, WayEvaluator& way, const Case& test, std::size_t count,
                                   std::optional<std::size_t> without = {}) {
  session.forget_evaluables();
  if (!way.use_steps(count, without)) return std::nullopt;
  const Outcome then = run_once(session, test).outcome;
  session.still_alive();
  if (has_wrong_values(then)) return true;
  if (then.status == Status::pass || then.status == Status::warning) return false;
  return std::nullopt;
}

// Runs the case once more with each number of steps, to name the first after which values are wrong. Where the driver
// cannot run a form between steps, those that keep the form are left out, one at a time.
void find_faulty_step(Session& session, WayEvaluator& way, const Case& test, Outcome& outcome) {
  const std::vector<Step>& steps = way.steps().steps;
  const auto name = [&](std::size_t number) { return steps[number - 1].text(); };
  std::optional<std::size_t> right;  // after so many steps
  std::optional<std::size_t> wrong;
  way.start(test.id, true);
  for (std::size_t count = 0; count <= steps.size() && !wrong; ++count) {
    const auto is_wrong = is_wrong_after(session, way, test, count);
    if (is_wrong) (*is_wrong ? wrong : right) = count;
  }
  way.start(test.id, false);
  std::string text = "right when it is run again";
  if (wrong == std::size_t{0}) {
    text = "wrong without a translator, too";
  } else if (wrong) {
    const std::size_t first = right.value_or(0) + 1;
    text = !right ? fmt::format("wrong after {}", name(*wrong))
                  : fmt::format("right before {}, wrong after {}", name(first), first == *wrong ? "it" : name(*wrong));
    for (std::size_t number = first; number < *wrong; ++number) {
      if (steps[number - 1].takes != steps[number - 1].gives) continue;
      if (is_wrong_after(session, way, test, *wrong, number) != false) continue;
      text = fmt::format("right without {}, wrong with it", name(number));
      wrong = number;
    }
    outcome.step = FaultyStep{*wrong, way.input_of(*wrong)};
  }
  way.use_steps(steps.size());
  session.forget_evaluables();
  constexpr std::string_view kWrong = "wrong: ";  // of a row of bugs
  const bool twice = wrong && outcome.message.starts_with(kWrong);
  outcome.message = fmt::format("{}: {}", text, outcome.message.substr(twice ? kWrong.size() : 0));
}

void judge_way(Session& session, WayEvaluator& way, const Case& test, Outcome& outcome) {
  if (has_wrong_values(outcome)) return find_faulty_step(session, way, test, outcome);
  const auto failed = way.failed_step();
  if (outcome.status != Status::fail || !failed) return;
  if (failed->end == StepEnd::not_completed) {
    outcome.status = Status::unsupported;
    return;
  }
  if (failed->end == StepEnd::crashed) outcome.status = Status::crash;
  if (failed->end == StepEnd::hung) outcome.status = Status::timeout;
  outcome.step = FaultyStep{failed->number, way.input_of(failed->number)};
}

}  // namespace

CaseResult run_case(Session& session, const Case& test) {
  WayEvaluator* const way = session.evaluator->way();
  if (way) way->start(test.id, false);
  CaseResult result = run_once(session, test);
  if (way) judge_way(session, *way, test, result.outcome);
  return result;
}

CaseResult run_case(const Suite& suite, const Case& test) {
  return timed(test.id, [&]() -> Judged { return std::get<ReferenceKind>(*test.kind).check(suite); });
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

// Returns those of a thorough run's cases that begin with one of these, and some others. All are 80,000, and a
// process wants a few.
std::vector<Case> thorough_cases_of(const Subjects& subjects) {
  const auto is_function = [](std::string_view subject) {
    return std::ranges::any_of(all_functions(), [&](const Function& function) { return function.id == subject; });
  };
  std::vector<Case> cases;
  add_value_cases(cases, Scope::thorough, &subjects);
  if (!std::ranges::all_of(subjects, is_function)) add_compile_cases(cases, Scope::thorough);
  return cases;
}

// Adds those of the cases that have one of these ids to `found`.
void add_found(std::map<std::string_view, const Case*>& found, const std::vector<Case>& cases,
               const std::set<std::string_view>& ids) {
  for (const Case& test : cases) {
    if (const auto id = ids.find(test.id); id != ids.end()) found.emplace(*id, &test);
  }
}

}  // namespace

Result<std::vector<Case>> cases_with(std::span<const std::string> ids) {
  static const std::vector<Case> covered = all_cases(Scope::covered);
  const std::set<std::string_view> wanted(ids.begin(), ids.end());
  std::map<std::string_view, const Case*> found;
  add_found(found, covered, wanted);
  std::vector<Case> further;
  if (found.size() < wanted.size()) {
    Subjects subjects;
    for (const std::string_view id : wanted) {
      if (!found.contains(id)) subjects.insert(function_of(id));
    }
    further = thorough_cases_of(subjects);
    add_found(found, further, wanted);
  }
  std::vector<Case> cases;
  for (const std::string& id : ids) {
    const auto test = found.find(id);
    if (test == found.end()) return fail(fmt::format("there is no case {}", id));
    cases.push_back(*test->second);
  }
  return cases;
}

Case case_named(std::string_view id) {
  const auto found = cases_with(std::array{std::string(id)});
  if (!found) throw std::logic_error(found.error().text());
  return found->front();
}

std::vector<Target> targets_of(const Configuration& configuration) {
  std::vector<Target> targets;
  const auto add = [&](const Profile& profile, Stage stage, bool main) { targets.push_back({&profile, stage, main}); };
  add(main_profile(configuration, false), Stage::fragment, true);
  add(main_profile(configuration, true), Stage::fragment, true);
  const bool precise = configuration.arithmetic == Arithmetic::precise;
  if (!precise) add(profile_named("gl140"), Stage::fragment, false);
  add(main_profile(configuration, false), Stage::vertex, false);
  if (!precise) add(profile_named("es300"), Stage::vertex, false);
  add(profile_named("gl430"), Stage::compute, false);
  if (!precise) add(profile_named("es310"), Stage::compute, false);
  add(profile_named("vulkan"), Stage::compute, false);
  add(profile_named("hlsl60"), Stage::compute, false);
  // By way of vkd3d-compiler, which takes minutes over Jenkins' hash and drops `precise`.
  if (!precise && configuration.default_but_for_arithmetic()) add(profile_named("hlsl50"), Stage::compute, false);
  if (!precise) add(profile_named("msl"), Stage::compute, false);
  if (!precise) add(profile_named("wgsl"), Stage::compute, false);
  return targets;
}

}  // namespace hn
