// A session has the things that a case may use while it runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "gpu/evaluator.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/shaders.hpp"
#include "library/source.hpp"

namespace hn {

// The resources of every case.
struct Suite {
  const SourceSet& sources;
  const ReferenceCompiler& reference;
  std::filesystem::path golden_directory;
  std::uint64_t seed;               // of the random points
  std::uint64_t points = 0;         // of each comparison with the twin; 0 for the case's own number
  bool thorough = false;            // with --thorough a case reports more
  std::filesystem::path pick = {};  // tools/pick, which writes short shaders; an installed suite has none
};

// The further resources of a case on a driver.
struct Session : Suite {
  const std::unique_ptr<Evaluator> evaluator;
  std::size_t most_points;  // of one evaluation: an evaluator takes 2^20; a slow driver is given fewer

  const ContextInfo& info() const { return evaluator->info(); }

  // Random points for a function, and how far the driver and the twin may differ at each. They are the same for every
  // hash, and are kept until another function needs points. There may be more than count. Each batch has other points.
  struct PointSet {
    std::vector<std::uint32_t> inputs;  // kInputWords per point
    std::vector<double> allowed;        // per point and output, as compare_with_twin takes it
  };
  const PointSet& twin_points(const Function& function, const Configuration& configuration, std::size_t count,
                              std::uint64_t batch = 0);

  // A long case calls this after each part of its work.
  std::function<void()> still_alive = [] {};

  // The evaluable of a function. The last few are kept, since cases that share one follow each other; a result lasts
  // until the next call.
  Result<Evaluable*> evaluable(const Evaluation& evaluation);
  void forget_evaluables() { kept_.clear(); }

  Session(const Suite& suite, std::unique_ptr<Evaluator> evaluator, std::size_t most_points = std::size_t{1} << 20);
  Session(const Suite& suite, const Context& context, std::size_t most_points = std::size_t{1} << 20);

 private:
  struct CacheEntry {
    std::string key;
    std::unique_ptr<Evaluable> evaluable;
  };
  std::list<CacheEntry> kept_;  // the most recently used first
  std::string kept_points_of_;
  PointSet kept_points_;
};

}  // namespace hn
