// The checks that hold values against the golden files and against the twin.
#include "cases/value_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "base/file.hpp"
#include "expected/golden.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"
#include "expected/twin.hpp"
#include "output/encoding.hpp"

namespace hn {

tl::expected<Words, Outcome> evaluate(Session& session, const Evaluation& evaluation,
                                      std::span<const std::uint32_t> inputs) {
  if (const auto reason = session.evaluator->unsupported(evaluation.profile, evaluation.stage); !reason.empty()) {
    return tl::unexpected(outcome_with(Status::unsupported, {reason, {}}));
  }
  if (const auto reason = session.sources.untranslated(evaluation.profile); !reason.empty()) {
    return tl::unexpected(outcome_with(Status::unsupported, {reason, {}}));
  }
  const auto evaluable = session.evaluable(evaluation);
  if (!evaluable) return tl::unexpected(outcome_with(Status::fail, evaluable.error()));
  auto outputs = (*evaluable)->evaluate(inputs);
  if (!outputs) return tl::unexpected(outcome_with(Status::fail, outputs.error()));
  return *outputs;
}

namespace {

// By their cost: with the default knobs 2^16, and thoroughly a quarter of a million, in each arithmetic; of octave
// sums, which are several noises, of derivatives and in 4D a quarter of that; with other knobs, which are many, a
// quarter, too; in the versions beside the main one of desktop OpenGL, a quarter, and thoroughly, where they are many,
// a sixteenth.
std::uint64_t twin_points(const Session& session, const Evaluation& evaluation) {
  if (session.points != 0) return session.points;
  std::uint64_t points = std::uint64_t{1} << (session.thorough ? 18 : 16);
  if (evaluation.function.is_costly()) points /= 4;
  if (!evaluation.configuration.default_but_for_arithmetic()) points /= 4;
  if (evaluation.profile.name != main_profile(evaluation.configuration, false).name)
    points /= session.thorough ? 16 : 4;
  return std::min<std::uint64_t>(points, session.most_points);
}

Words inputs_of(const Golden& golden) {
  Words words(golden.rows.size() * kInputWords);
  for (std::size_t i = 0; i < golden.rows.size(); ++i) {
    std::copy(golden.rows[i].inputs.begin(), golden.rows[i].inputs.end(),
              words.begin() + static_cast<std::ptrdiff_t>(i * kInputWords));
  }
  return words;
}

// Sums up the words that came out, row by row.
std::uint32_t checksum_of(const Golden& golden, const Words& outputs) {
  Words words;
  for (std::size_t i = 0; i < golden.rows.size(); ++i) {
    const auto row = result(outputs, i).first(golden.rows[i].values.size());
    words.insert(words.end(), row.begin(), row.end());
  }
  return crc32_of(bytes_of(std::span<const std::uint32_t>(words)));
}

Judged check_digest(Session& session, const Evaluation& evaluation, const GoldenDigest& digest, Outcome outcome) {
  const Words inputs = digest.inputs();
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Words values(digest.points());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = outputs[i * kOutputWords];
  outcome.samples += values.size();
  const std::uint64_t got = fnv1a64(values);
  if (got == digest.fnv1a64) return outcome;
  ++outcome.mismatches;
  outcome.status = Status::fail;
  outcome.message = fmt::format("the digest of {} points from {} is {:016x}, expected {:016x}", values.size(),
                                describe_inputs(evaluation.function, point(inputs, 0)), got, digest.fnv1a64);
  return outcome;
}

}  // namespace

Judged check_golden(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const auto golden = read_golden(golden_path(session.golden_directory, function), function, configuration);
  if (!golden) return outcome_with(Status::error, golden.error());
  const Words inputs = inputs_of(*golden);
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < golden->rows.size(); ++i) {
    compare_with_golden(comparison, function, configuration, point(inputs, i), result(outputs, i),
                        golden->rows[i].values);
  }
  Outcome outcome = comparison.finish();
  if (has_exact_values(function, configuration)) outcome.checksum = checksum_of(*golden, outputs);
  if (!golden->digest || outcome.status != Status::pass) return outcome;
  return check_digest(session, evaluation, *golden->digest, outcome);
}

// As many as fit are evaluated at a time.
Judged check_twin(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const std::uint64_t all = twin_points(session, evaluation);
  Comparison comparison(function, {});
  std::uint64_t done = 0;
  for (std::uint64_t batch = 0; done < all; ++batch) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(all - done, session.most_points));
    const Session::PointSet& points = session.twin_points(function, configuration, count, batch);
    const auto inputs = std::span(points.inputs).first(count * kInputWords);
    HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
    const Words expected = evaluate_twin(function, configuration, inputs);
    comparison.next_grid(inputs);
    for (std::size_t i = 0; i < count; ++i) {
      compare_with_twin(comparison, evaluation, point(inputs, i), result(outputs, i), result(expected, i),
                        std::span(points.allowed).subspan(i * function.outputs.size()));
    }
    done += count;
    if (done < all) session.still_alive();
  }
  return comparison.finish();
}

}  // namespace hn
