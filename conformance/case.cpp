#include "case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "points.hpp"
#include "tolerance.hpp"

namespace hn {

std::string_view name_of(Status status) {
  switch (status) {
    case Status::pass:
      return "pass";
    case Status::warning:
      return "warning";
    case Status::fail:
      return "fail";
    case Status::unsupported:
      return "unsupported";
    case Status::crash:
      return "crash";
    case Status::timeout:
      return "timeout";
    case Status::error:
      break;
  }
  return "error";
}

std::optional<Status> status_named(std::string_view name) {
  for (const Status status : kStatuses) {
    if (name_of(status) == name) return status;
  }
  return std::nullopt;
}

bool is_bad(Status status) {
  return status == Status::fail || status == Status::crash || status == Status::timeout || status == Status::error;
}

Outcome outcome_with(Status status, const Error& error) {
  Outcome outcome;
  outcome.status = status;
  outcome.message = error.text();
  return outcome;
}

Session::Session(const Context& context_, const SourceSet& sources_, const ReferenceCompiler& reference_,
                 std::filesystem::path golden_directory_, std::uint64_t seed_)
    : context(context_),
      info(describe(context_)),
      sources(sources_),
      reference(reference_),
      golden_directory(std::move(golden_directory_)),
      seed(seed_),
      grid(context_) {}

Result<Program> Session::build(const Evaluation& evaluation, std::string_view shader) const {
  const auto text = expand(sources, evaluation.profile, shader);
  if (!text) return tl::unexpected(text.error());
  if (evaluation.stage == Stage::compute) return Program::build_compute(context, *text);
  const bool of_vertices = evaluation.stage == Stage::vertex;
  const auto other = expand(sources, evaluation.profile, of_vertices ? idle_fragment_shader() : vertex_shader());
  if (!other) return tl::unexpected(other.error());
  return Program::build(context, of_vertices ? *text : *other, of_vertices ? *other : *text, evaluation.stage);
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
  auto program = build(evaluation, shader);
  if (!program) return tl::unexpected(program.error());
  program->set("trips", static_cast<std::int32_t>(kLoopTrips));
  program->set("variant_seed", kVariantSeed);
  kept_.push_front({key, std::move(*program)});
  if (kept_.size() > kKept) kept_.pop_back();
  return &kept_.front().program;
}

const Session::PointSet& Session::twin_points(const Function& function, const Configuration& configuration,
                                              std::size_t count) {
  const std::string key = fmt::format("{} {}", function.id, configuration.sine());
  if (kept_points_of_ == key && kept_points_.allowed.size() >= count) return kept_points_;
  kept_points_.inputs = random_points(function, count, Random(seed, function.id));
  kept_points_.allowed.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Both the driver and the twin may be off the exact value by the tolerance.
    kept_points_.allowed[i] =
        2.0 * tolerance(function, configuration, std::span(kept_points_.inputs).subspan(i * kInputWords, kInputWords));
  }
  kept_points_of_ = key;
  return kept_points_;
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_value_cases(cases);
  add_compile_cases(cases);
  add_bug_cases(cases);
  return cases;
}

}  // namespace hn
