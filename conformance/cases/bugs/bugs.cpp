#include "cases/bugs/bugs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/text.hpp"
#include "cases/bugs/given.hpp"
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

bool is_among(std::string_view names, std::string_view name) {
  const auto all = split(names, ' ');
  return std::ranges::find(all, name) != all.end();
}

// A process of a compiler costs more than the rest of a case: only some of the rows start one in a default run.
Extent extent_of(const Bug& bug, const Profile& profile) {
  if (profile.in_glsl()) return Extent::every_driver;
  const auto number = &bug - all_bugs().data();
  const bool is_left_out = (profile.name == "hlsl50" && number % 2 == 0) || (profile.name == "msl" && number % 4 != 0);
  return is_left_out ? Extent::thorough : Extent::one_driver;
}

void add_cases(std::vector<Case>& cases, const Bug& bug) {
  for (const std::string_view name : split(bug.profiles, ' ')) {
    const Profile& profile = profile_named(name);
    cases.push_back(
        {{.function = std::string(bug.function.id),
          .configuration = "any",
          .arithmetic = std::string(bug.arithmetic()),
          .stage = evaluation_of(bug, profile).stage,
          .profile = std::string(profile.name),
          .check = std::string(bug.check(profile))},
         BugKind{&bug, &profile},
         extent_of(bug, profile),
         fmt::format("  reported in: {}\n  specification: {}\n", bug.reference, bug.rule_in(profile).text)});
  }
}

bool are_nan(std::uint32_t got, std::uint32_t expected) {
  return std::isnan(number_of(got)) && std::isnan(number_of(expected));
}

std::string distance_of(std::uint32_t got, std::uint32_t expected) {
  if (!std::isfinite(number_of(got)) || !std::isfinite(number_of(expected))) return "";
  const auto units = ulp_distance(std::bit_cast<float>(got), std::bit_cast<float>(expected));
  return fmt::format(", {} {} in the last place away", units, units == 1 ? "unit" : "units");
}

std::vector<Bug>& kept_bugs() {
  static std::vector<Bug> bugs = [] {
    std::vector<Bug> all;
    for (const auto& part : {integer_bugs(), float_bugs(), flow_bugs(), language_bugs()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return bugs;
}

}  // namespace

const Rule& Bug::rule_in(const Profile& profile) const { return is_among(exceptions, profile.name) ? exception : rule; }

std::string Bug::code_in(const Profile& profile) const {
  const bool in_wgsl = profile.language == Language::wgsl && !wgsl.empty();
  return in_wgsl ? fmt::format("{}{}", wgsl_declarations, wgsl) : fmt::format("{}{}", declarations, function.body);
}

std::span<const Bug> all_bugs() { return kept_bugs(); }

const Bug& give(const GivenFunction& function) {
  // The row refers to these texts.
  static const GivenFunction kept = function;
  static const std::string rule = fmt::format("The expected values are those of {}", kept.expected_from);
  const auto columns = [](const std::vector<GivenColumn>& given) {
    std::vector<Column> all;
    for (const GivenColumn& column : given) all.push_back({column.name, column.type});
    return all;
  };
  Bug row{.function = {.id = kept.id,
                       .file = kept.file,
                       .call = {},
                       .body = kept.body,
                       .inputs = columns(kept.inputs),
                       .outputs = columns(kept.outputs),
                       .plain = {}},
          .reference = {},
          .rule = {rule, true, kept.tolerance},
          .profiles = kept.profiles,
          .points = kept.points,
          .given = true};
  return kept_bugs().emplace_back(std::move(row));
}

std::string Bug::note(const Profile& profile) const {
  const std::string_view text = rule_in(profile).text;
  return given ? std::string(text) : fmt::format("{}. Reported in: {}", text, reference);
}

Evaluation evaluation_of(const Bug& bug, const Profile& profile) {
  const Stage stage = profile.platform() == Platform::opengl ? Stage::fragment : Stage::compute;
  return {bug.function, default_configuration(), profile, {.declarations = bug.declarations}, stage};
}

tl::expected<std::vector<std::uint32_t>, Outcome> outputs_of(Session& session, const Bug& bug, const Profile& profile) {
  const auto grid = grid_of(bug);
  const std::size_t most = session.most_points * kInputWords;
  std::vector<std::uint32_t> outputs;
  for (std::size_t begin = 0; begin < grid.size(); begin += most) {
    if (begin > 0) session.still_alive();
    const auto part = std::span(grid).subspan(begin, std::min(most, grid.size() - begin));
    HN_TRY(const auto some, evaluate(session, evaluation_of(bug, profile), part));
    outputs.insert(outputs.end(), some.begin(), some.end());
  }
  return outputs;
}

Outcome check_bug(Session& session, const Bug& bug, const Profile& profile) {
  const auto outputs = outputs_of(session, bug, profile);
  return outputs ? judge_bug(bug, profile, *outputs) : outputs.error();
}

Outcome judge_bug(const Bug& bug, const Profile& profile, std::span<const std::uint32_t> outputs) {
  const Rule& rule = bug.rule_in(profile);
  const auto grid = grid_of(bug);
  Comparison comparison(bug.function, grid);
  std::vector<std::string> distances;  // of the examples from the right values
  std::size_t wrong_points = 0;
  std::size_t nan_points = 0;
  std::string first_nan;
  for (std::size_t i = 0; i < bug.points.size(); ++i) {
    const auto inputs = std::span(grid).subspan(i * kInputWords, kInputWords);
    const std::uint64_t wrong_before = comparison.mismatches();
    bool has_nan = false;
    for (std::size_t column = 0; column < bug.function.outputs.size(); ++column) {
      const std::uint64_t before = comparison.mismatches();
      const std::uint32_t got = outputs[i * kOutputWords + column];
      const std::uint32_t expected = bug.points[i].expected[column];
      const bool is_float = bug.function.outputs[column].type == WordType::f32;
      if (is_float && bug.given && (got == expected || are_nan(got, expected))) {
        comparison.require(true, inputs, {}, {});
        has_nan = has_nan || are_nan(got, expected);
      } else if (is_float) {
        comparison.number(inputs, std::bit_cast<float>(got), number_of(expected), rule.allowed, column);
      } else {
        comparison.bits(inputs, got, expected, column);
      }
      const bool is_example = comparison.mismatches() != before && before < kExamplesKept;
      if (is_example) distances.push_back(is_float ? distance_of(got, expected) : "");
    }
    wrong_points += comparison.mismatches() != wrong_before ? 1 : 0;
    if (has_nan && nan_points++ == 0) first_nan = describe_inputs(bug.function, inputs);
  }
  Outcome outcome = comparison.finish();
  if (outcome.status == Status::pass && nan_points != 0) {
    outcome.status = Status::warning;
    outcome.message = fmt::format(
        "NaN, as expected, at {} of {} points, first at {}. GLSL leaves NaN open: a driver may return a number there. "
        "{}",
        nan_points, bug.points.size(), first_nan, bug.note(profile));
  }
  if (outcome.status != Status::fail) return outcome;
  if (bug.given) {
    for (std::size_t i = 0; i < outcome.examples.size(); ++i) outcome.examples[i].expected += distances[i];
    outcome.message = fmt::format("differs {}{}, and at {} of {} points. {}", outcome.message, distances.front(),
                                  wrong_points, bug.points.size(), bug.note(profile));
    return outcome;
  }
  if (!rule.defined) outcome.status = Status::warning;
  outcome.message =
      fmt::format("{}: {}. {}. The shader has:\n{}", rule.defined ? "wrong" : "not the usual value, but allowed",
                  outcome.message, bug.note(profile), bug.code_in(profile));
  return outcome;
}

void add_bug_cases(std::vector<Case>& cases) {
  for (const Bug& bug : all_bugs()) add_cases(cases, bug);
}

}  // namespace hn
