// Cases that evaluate functions on the driver: against the golden files, against the twin, and for properties.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "cases/targets.hpp"
#include "cases/value_checks.hpp"
#include "expected/golden.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"
#include "expected/twin.hpp"

namespace hn {

tl::expected<Words, Outcome> evaluate(Session& session, const Evaluation& evaluation,
                                      std::span<const std::uint32_t> inputs) {
  if (const auto reason = unsupported_to_run(evaluation.profile, session.info.languages); !reason.empty()) {
    return tl::unexpected(outcome_with(Status::unsupported, {reason, {}}));
  }
  if (const auto reason = unsupported_reason(session.context.gl(), evaluation.stage); !reason.empty()) {
    return tl::unexpected(outcome_with(Status::unsupported, {reason, {}}));
  }
  const auto program = session.evaluation_program(evaluation);
  if (!program) return tl::unexpected(outcome_with(Status::fail, program.error()));
  auto outputs = session.grid.evaluate(**program, inputs);
  if (!outputs) return tl::unexpected(outcome_with(Status::fail, outputs.error()));
  return *outputs;
}

namespace {

// With the default knobs a million, and all that a grid takes, in each arithmetic; with the others a quarter, which are
// many. In ES, which is there for the contexts that have no GLSL 3.30, a sixteenth of that.
std::uint64_t twin_points(const Session& session, const Evaluation& evaluation) {
  if (session.points != 0) return session.points;
  std::uint64_t points = std::uint64_t{1} << 20;
  if (!evaluation.configuration.default_but_for_arithmetic()) points /= 4;
  if (evaluation.profile.name != main_profile(evaluation.configuration, false).name) points /= 16;
  return std::min<std::uint64_t>(points, session.most_points);
}

// --- Golden ----------------------------------------------------------------------------------------------------------

Words inputs_of(const Golden& golden) {
  Words words(golden.rows.size() * kInputWords);
  for (std::size_t i = 0; i < golden.rows.size(); ++i) {
    std::copy(golden.rows[i].inputs.begin(), golden.rows[i].inputs.end(),
              words.begin() + static_cast<std::ptrdiff_t>(i * kInputWords));
  }
  return words;
}

Outcome check_digest(Session& session, const Evaluation& evaluation, const GoldenDigest& digest, Outcome outcome) {
  const Words inputs = digest.inputs();
  const auto outputs = evaluate(session, evaluation, inputs);
  if (!outputs) return outputs.error();
  Words values(digest.points());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = (*outputs)[i * kOutputWords];
  outcome.samples += values.size();
  const std::uint64_t got = fnv1a64(values);
  if (got == digest.fnv1a64) return outcome;
  ++outcome.mismatches;
  outcome.status = Status::fail;
  outcome.message = fmt::format("the digest of {} points from {} is {:016x}, expected {:016x}", values.size(),
                                describe_inputs(evaluation.function, point(inputs, 0)), got, digest.fnv1a64);
  return outcome;
}

Outcome check_golden(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const auto golden =
      read_golden(golden_path(session.golden_directory, function, configuration), function, configuration);
  if (!golden) return outcome_with(Status::error, golden.error());
  const Words inputs = inputs_of(*golden);
  const auto outputs = evaluate(session, evaluation, inputs);
  if (!outputs) return outputs.error();
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < golden->rows.size(); ++i) {
    compare_with_golden(comparison, function, configuration, point(inputs, i), result(*outputs, i),
                        golden->rows[i].values);
  }
  const Outcome outcome = comparison.finish();
  if (!golden->digest || outcome.status != Status::pass) return outcome;
  return check_digest(session, evaluation, *golden->digest, outcome);
}

// --- Twin ------------------------------------------------------------------------------------------------------------

// As many as fit are evaluated at a time.
Outcome check_twin(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const std::uint64_t all = twin_points(session, evaluation);
  Comparison comparison(function, {});
  std::uint64_t done = 0;
  for (std::uint64_t batch = 0; done < all; ++batch) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(all - done, session.most_points));
    const Session::PointSet& points = session.twin_points(function, configuration, count, batch);
    const auto inputs = std::span(points.inputs).first(count * kInputWords);
    const auto outputs = evaluate(session, evaluation, inputs);
    if (!outputs) return outputs.error();
    Words expected(count * kOutputWords);
    evaluate_twin(function, configuration, inputs, expected);
    comparison.next_grid(inputs);
    for (std::size_t i = 0; i < count; ++i) {
      compare_with_twin(comparison, evaluation, point(inputs, i), result(*outputs, i), result(expected, i),
                        points.allowed[i]);
    }
    done += count;
    if (done < all) session.still_alive();
  }
  return comparison.finish();
}

// ---------------------------------------------------------------------------------------------------------------------

// What holds for a function by its row alone.
void add_properties(std::vector<Case>& cases, const Evaluation& evaluation, Extent extent) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const auto add = [&](std::string_view name, Check* check) { add_case(cases, evaluation, name, check, extent); };
  const bool once = configuration.is_default();  // for what does not depend on the knobs
  if (once && function.seed_word() >= 0) add("unseeded", check_unseeded);
  // HN_FIXED converts a noise that the user names to an integer.
  const bool names_noise = once || configuration.name == "lattice+fixed";
  if (names_noise && function.is_octave_sum()) add("noise_knob", check_noise_knob);
  if (once && function.family == Family::gradient) add("wrapped", check_wrapped);
  if (function.exact()) return;
  add("range", check_range);
  // A period and a hash change no value's size.
  if (configuration.period == 0 && configuration.hash == default_configuration().hash) add("finite", check_finite);
  if (!function.is_noise() || function.takes_cell()) return;
  if (function.family == Family::gradient_noise) add("zero", check_zero);
  // With the sine gradient a hash is as weak as published, and a period of 48 cells has not room for many points.
  if (!configuration.hash_only()) return;
  add("seeds", check_seeds);
  add("mirror", check_mirror);
}

}  // namespace

void add_case(std::vector<Case>& cases, const Evaluation& evaluation, std::string_view name, Check* check,
              Extent extent) {
  const std::string id = fmt::format("{}.{}.{}.{}.{}.{}", evaluation.function.id,
                                     configuration_name(evaluation.function, evaluation.configuration),
                                     arithmetic_name(evaluation.function, evaluation.configuration),
                                     name_of(evaluation.stage), evaluation.profile.name, name);
  const auto kept = std::make_shared<const Evaluation>(evaluation);
  cases.push_back({.id = id, .run = [=](Session& session) { return check(session, *kept); }, .evaluation = kept,
                   .extent = extent});
}

void add_value_cases(std::vector<Case>& cases) {
  for (std::size_t number = 0; number < all_functions().size(); ++number) {
    const Function& function = all_functions()[number];
    for (const Configuration& configuration : all_configurations()) {
      for (const Target& target : targets_of(configuration)) {
        const Evaluation evaluation{function, configuration, *target.profile, {}, target.stage};
        const Extent extent = extent_of(number, configuration, target);
        if (covers(configuration, function)) {
          add_case(cases, evaluation, "golden", check_golden, extent);
          if (target.stage == Stage::fragment) add_case(cases, evaluation, "twin", check_twin, extent);
          if (target.main) add_properties(cases, evaluation, extent);
        }
        add_metamorphic_cases(cases, evaluation, number, target, extent);
      }
    }
  }
}

}  // namespace hn
