#include "cases/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "expected/compare.hpp"
#include "expected/points.hpp"

namespace hn {

Session::Session(const Suite& suite, const Context& context_, std::size_t most_points_)
    : Suite(suite), context(context_), info(describe(context_)), most_points(most_points_), grid(context_) {}

Result<Program> Session::build(const Evaluation& evaluation, std::string_view shader) const {
  HN_TRY(const auto text, expand(sources, evaluation.profile, shader));
  if (evaluation.stage == Stage::compute) return Program::build_compute(context, text);
  const bool of_vertices = evaluation.stage == Stage::vertex;
  HN_TRY(const auto other, expand(sources, evaluation.profile, of_vertices ? idle_fragment_shader() : vertex_shader()));
  return Program::build(context, of_vertices ? text : other, of_vertices ? other : text, evaluation.stage);
}

Result<const Program*> Session::evaluation_program(const Evaluation& evaluation) {
  // Those of a function and a configuration: in each version and stage, and a variant.
  constexpr std::size_t kKept = 8;
  const std::string shader = evaluation_shader(evaluation);
  const std::string key = fmt::format("{} {}", evaluation.profile.name, shader);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const KeptProgram& kept) { return kept.key == key; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return &kept_.front().program;
  }
  HN_TRY(auto program, build(evaluation, shader));
  program.set("trips", static_cast<std::int32_t>(kLoopTrips));
  program.set("variant_seed", kVariantSeed);
  kept_.push_front({key, std::move(program)});
  if (kept_.size() > kKept) kept_.pop_back();
  return &kept_.front().program;
}

const Session::PointSet& Session::twin_points(const Function& function, const Configuration& configuration,
                                              std::size_t count, std::uint64_t batch) {
  // What is undecided follows from the words, so there the hash counts.
  const std::string key =
      fmt::format("{} {} {} {} {}", function.id, configuration.sine(), arithmetic_name(function, configuration),
                  function.jumps() ? configuration.hash : "", batch);
  if (kept_points_of_ == key && kept_points_.inputs.size() >= count * kInputWords) return kept_points_;
  // A seed has 32 bits.
  const Random random(seed + (batch << 32), function.id);
  kept_points_.inputs = random_points(function, count, random, defined_extremes(configuration));
  kept_points_.allowed.assign(count * function.outputs.size(), 0.0);
  for (std::size_t i = 0; i < kept_points_.allowed.size() && !has_same_bits(function, configuration); ++i) {
    const auto inputs = std::span(kept_points_.inputs).subspan(i / function.outputs.size() * kInputWords, kInputWords);
    kept_points_.allowed[i] = allowed_to_twin(function, configuration, inputs, i % function.outputs.size());
  }
  kept_points_of_ = key;
  return kept_points_;
}

}  // namespace hn
