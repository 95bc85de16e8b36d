#include "cases/bugs/bugs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/bugs/tables.hpp"
#include "cases/value_checks.hpp"
#include "expected/compare.hpp"

namespace hn {
namespace {

// A word as its type has it, and its bits.
std::string describe(WordType type, std::uint32_t word) {
  if (type == WordType::f32) return fmt::format("{:.9g} (0x{:08x})", std::bit_cast<float>(word), word);
  if (type == WordType::i32) return fmt::format("{} (0x{:08x})", static_cast<std::int32_t>(word), word);
  return fmt::format("{} (0x{:08x})", word, word);
}

// Adds the difference of two floats to the outcome; whether it is allowed. NaN never is, and -0 is 0.
bool is_near(Outcome& outcome, float got, float expected, double allowed) {
  const double difference = std::fabs(static_cast<double>(got) - static_cast<double>(expected));
  outcome.max_ulp = std::max(outcome.max_ulp, ulp_distance(got, expected));
  if (!(difference <= outcome.max_abs)) {
    outcome.max_abs = std::isfinite(difference) ? difference : std::numeric_limits<double>::max();
  }
  return difference <= allowed;
}

bool is_right(Outcome& outcome, const Bug& bug, WordType type, std::uint32_t got, std::uint32_t expected) {
  ++outcome.samples;
  if (type != WordType::f32) return got == expected;
  return is_near(outcome, std::bit_cast<float>(got), std::bit_cast<float>(expected), bug.allowed);
}

std::vector<std::uint32_t> grid_of(const Bug& bug) {
  std::vector<std::uint32_t> words(bug.points.size() * kInputWords);
  for (std::size_t i = 0; i < bug.points.size(); ++i) {
    std::copy(bug.points[i].inputs.begin(), bug.points[i].inputs.end(),
              words.begin() + static_cast<std::ptrdiff_t>(i * kInputWords));
  }
  return words;
}

std::string message_of(const Bug& bug, const Outcome& outcome) {
  const Mismatch& first = outcome.examples.front();
  return fmt::format("{} at {}: got {}, expected {}. {}. Reported in: {}",
                     bug.defined ? "wrong" : "other than usual, and allowed", first.inputs, first.got, first.expected,
                     bug.specification, bug.reference);
}

void add_cases(std::vector<Case>& cases, const Bug& bug) {
  std::string_view profiles = bug.profiles;
  while (!profiles.empty()) {
    const auto end = std::min(profiles.find(' '), profiles.size());
    const Profile& profile = profile_named(profiles.substr(0, end));
    profiles.remove_prefix(std::min(end + 1, profiles.size()));
    cases.push_back(
        {{.function = std::string(bug.function.id),
          .configuration = "any",
          .arithmetic = std::string(bug.arithmetic()),
          .stage = Stage::fragment,
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
    std::vector<Bug> bugs;
    add_integer_bugs(bugs);
    add_float_bugs(bugs);
    add_flow_bugs(bugs);
    return bugs;
  }();
  return kBugs;
}

Evaluation evaluation_of(const Bug& bug, const Profile& profile) {
  return {bug.function, default_configuration(), profile, {.knobs = bug.declarations}};
}

Outcome check_bug(Session& session, const Bug& bug, const Profile& profile) {
  const auto outputs = evaluate(session, evaluation_of(bug, profile), grid_of(bug));
  return outputs ? judge_bug(bug, *outputs) : outputs.error();
}

Outcome judge_bug(const Bug& bug, std::span<const std::uint32_t> outputs) {
  Outcome outcome;
  for (std::size_t i = 0; i < bug.points.size(); ++i) {
    const auto& [inputs, expected] = bug.points[i];
    for (std::size_t column = 0; column < bug.function.outputs.size(); ++column) {
      const auto& [name, type] = bug.function.outputs[column];
      const std::uint32_t got = outputs[i * kOutputWords + column];
      if (is_right(outcome, bug, type, got, expected[column])) continue;
      ++outcome.mismatches;
      std::vector<std::uint32_t> words = inputs;
      words.resize(kInputWords);
      outcome.examples.push_back({i, words, describe_inputs(bug.function, words),
                                  fmt::format("{}={}", name, describe(type, got)), describe(type, expected[column])});
    }
  }
  if (outcome.mismatches == 0) return outcome;
  outcome.status = bug.defined ? Status::fail : Status::warning;
  outcome.message = message_of(bug, outcome);
  return outcome;
}

void add_bug_cases(std::vector<Case>& cases) {
  for (const Bug& bug : all_bugs()) add_cases(cases, bug);
}

}  // namespace hn
