#include "case.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <utility>

#include "points.hpp"
#include "tolerance.hpp"

namespace hn {

Session::Session(const Suite& suite, const Context& context_, std::size_t most_twin_points_)
    : Suite(suite), context(context_), info(describe(context_)), most_twin_points(most_twin_points_), grid(context_) {}

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

namespace {

template <typename Run>
CaseResult timed(const std::string& id, Run run) {
  const auto start = std::chrono::steady_clock::now();
  CaseResult result;
  result.id = id;
  try {
    result.outcome = run();
  } catch (const std::exception& exception) {
    result.outcome = outcome_with(Status::error, {fmt::format("exception: {}", exception.what()), {}});
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

CaseResult run_case(Session& session, const Case& test) {
  return timed(test.id, [&] { return test.run(session); });
}

CaseResult run_case(const Suite& suite, const Case& test) {
  return timed(test.id, [&] { return test.compile(suite); });
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_value_cases(cases);
  add_compile_cases(cases);
  return cases;
}

std::vector<std::string> ids_of(const std::vector<Case>& cases) {
  std::vector<std::string> ids;
  for (const Case& test : cases) ids.push_back(test.id);
  return ids;
}

}  // namespace hn
