#include "cases/bugs/bugs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "base/text.hpp"
#include "cases/bugs/tables.hpp"
#include "cases/value_checks.hpp"
#include "expected/compare.hpp"

namespace hn {
namespace {

std::vector<std::uint32_t> grid_of(const Bug& bug) {
  std::vector<std::uint32_t> words(bug.points.size() * kInputWords);
  for (std::size_t i = 0; i < bug.points.size(); ++i) {
    std::copy(bug.points[i].inputs.begin(), bug.points[i].inputs.end(),
              words.begin() + static_cast<std::ptrdiff_t>(i * kInputWords));
  }
  return words;
}

void add_cases(std::vector<Case>& cases, const Bug& bug) {
  for (const std::string_view name : split(bug.profiles, ' ')) {
    const Profile& profile = profile_named(name);
    cases.push_back({{.function = std::string(bug.function.id),
                      .configuration = "any",
                      .arithmetic = std::string(bug.arithmetic()),
                      .stage = evaluation_of(bug, profile).stage,
                      .profile = std::string(profile.name),
                      .check = std::string(bug.check())},
                     BugKind{&bug, &profile},
                     Extent::every_driver,
                     fmt::format("  reported in: {}\n  specification: {}\n", bug.reference, bug.specification)});
  }
}

}  // namespace

std::span<const Bug> all_bugs() {
  static const std::vector<Bug> kBugs = [] {
    std::vector<Bug> all;
    for (const auto& part : {integer_bugs(), float_bugs(), flow_bugs(), position_bugs()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return kBugs;
}

Evaluation evaluation_of(const Bug& bug, const Profile& profile) {
  const Stage stage = profile.platform() == Platform::opengl ? Stage::fragment : Stage::compute;
  return {bug.function, default_configuration(), profile, {.knobs = bug.declarations}, stage};
}

Outcome check_bug(Session& session, const Bug& bug, const Profile& profile) {
  const auto outputs = evaluate(session, evaluation_of(bug, profile), grid_of(bug));
  return outputs ? judge_bug(bug, *outputs) : outputs.error();
}

Outcome judge_bug(const Bug& bug, std::span<const std::uint32_t> outputs) {
  const auto grid = grid_of(bug);
  Comparison comparison(bug.function, grid);
  for (std::size_t i = 0; i < bug.points.size(); ++i) {
    const auto inputs = std::span(grid).subspan(i * kInputWords, kInputWords);
    for (std::size_t column = 0; column < bug.function.outputs.size(); ++column) {
      const std::uint32_t got = outputs[i * kOutputWords + column];
      const std::uint32_t expected = bug.points[i].expected[column];
      if (bug.function.outputs[column].type == WordType::f32) {
        comparison.number(inputs, std::bit_cast<float>(got), number_of(expected), bug.allowed, column);
      } else {
        comparison.bits(inputs, got, expected, column);
      }
    }
  }
  Outcome outcome = comparison.finish();
  if (outcome.status != Status::fail) return outcome;
  if (!bug.defined) outcome.status = Status::warning;
  outcome.message = fmt::format("{}: {}. {}. Reported in: {}. The shader has:\n{}{}",
                                bug.defined ? "wrong" : "not the usual value, but allowed", outcome.message,
                                bug.specification, bug.reference, bug.declarations, bug.function.body);
  return outcome;
}

void add_bug_cases(std::vector<Case>& cases) {
  for (const Bug& bug : all_bugs()) add_cases(cases, bug);
}

}  // namespace hn
