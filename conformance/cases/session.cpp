#include "cases/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "expected/compare.hpp"
#include "expected/points.hpp"

namespace hn {

Session::Session(const Suite& suite, std::unique_ptr<Evaluator> evaluator_, std::size_t most_points_)
    : Suite(suite), evaluator(std::move(evaluator_)), most_points(most_points_) {}

Session::Session(const Suite& suite, const Context& context, std::size_t most_points_)
    : Session(suite, evaluator_on(context), most_points_) {}

Result<Evaluable*> Session::evaluable(const Evaluation& evaluation) {
  // The programs of a function and a configuration: each version and stage, and a variant.
  constexpr std::size_t kKept = 8;
  const std::string shader = evaluation_shader(evaluation);
  // Bugs that only WGSL can express have no text here.
  const std::string key = fmt::format("{} {} {}", evaluation.profile.name, evaluation.function.id, shader);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const CacheEntry& kept) { return kept.key == key; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front().evaluable.get();
  }
  HN_TRY(auto built, evaluator->build(sources, evaluation, shader));
  kept_.push_front({key, std::move(built)});
  if (kept_.size() > kKept) kept_.pop_back();
  return kept_.front().evaluable.get();
}

const Session::PointSet& Session::twin_points(const Function& function, const Configuration& configuration,
                                              std::size_t count, std::uint64_t batch) {
  // An undecided value follows from the words, so there the hash counts.
  const std::string key =
      fmt::format("{} {} {} {} {}", function.id, configuration.sine(), arithmetic_name(function, configuration),
                  function.jumps() ? configuration.hash : "", batch);
  if (kept_points_of_ == key && kept_points_.inputs.size() >= count * kInputWords) return kept_points_;
  // A seed has 32 bits.
  const Random random(seed + (batch << 32), function.id);
  kept_points_.inputs = random_points(function, count, random, defined_extremes(configuration));
  kept_points_.allowed.assign(count * function.outputs.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < kept_points_.allowed.size() && !has_same_bits(function, configuration); ++i) {
    if (!function.jumps(i % function.outputs.size())) continue;  // else all of them may be undecided
    const auto inputs = std::span(kept_points_.inputs).subspan(i / function.outputs.size() * kInputWords, kInputWords);
    kept_points_.allowed[i] = allowed_to_twin(function, configuration, inputs, i % function.outputs.size());
  }
  kept_points_of_ = key;
  return kept_points_;
}

}  // namespace hn
