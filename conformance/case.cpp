#include "case.hpp"

#include <fmt/format.h>

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

Result<const Program*> Session::evaluation_program(const Evaluation& evaluation) {
  const Profile& profile = evaluation.profile;
  const std::string key = fmt::format("{} {} {} {} {}", evaluation.function.id, evaluation.configuration.name,
                                      profile.name, evaluation.variant.seeded, evaluation.variant.knobs);
  if (kept_ && key == kept_key_) return kept_.get();
  const auto vertex = expand(sources, profile, vertex_shader());
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = expand(sources, profile, evaluation_shader(evaluation));
  if (!fragment) return tl::unexpected(fragment.error());
  auto program = Program::build(context, *vertex, *fragment);
  if (!program) return tl::unexpected(program.error());
  kept_ = std::make_unique<Program>(std::move(*program));
  kept_key_ = key;
  return kept_.get();
}

const Session::PointSet& Session::twin_points(const Function& function, const Configuration& configuration,
                                              std::size_t count) {
  const std::string key = fmt::format("{} {}", function.id, configuration.sine());
  if (kept_points_of_ == key && kept_points_.allowed.size() == count) return kept_points_;
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
