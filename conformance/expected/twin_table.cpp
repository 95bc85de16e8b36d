#include "expected/twin_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/entry_named.hpp"
#include "expected/twin.hpp"

namespace hn {
namespace {

std::span<const TwinEntry> entries_for(const Configuration& configuration) {
  constexpr std::array kTables = {
#define TWIN(index) twin_entries<index>,
#include "expected/twins.inc"
#undef TWIN
  };
  return kTables.at(static_cast<std::size_t>(configuration.index))();
}

// Below this many points per thread, starting the thread costs more than it saves.
constexpr std::size_t kFewestPoints = 4096;

}  // namespace

std::vector<std::uint32_t> evaluate_twin(const Function& function, const Configuration& configuration,
                                         std::span<const std::uint32_t> inputs) {
  const TwinEntry& entry = entry_named(entries_for(configuration), &TwinEntry::id, function.id, "function of the twin");
  if (entry.evaluate == nullptr) {
    throw std::logic_error(fmt::format("the twin has no {} with {}", function.id, configuration.name));
  }
  const std::size_t points = inputs.size() / kInputWords;
  std::vector<std::uint32_t> outputs(points * kOutputWords);
  const std::size_t most = std::max<std::size_t>(1, points / kFewestPoints);
  const std::size_t parts = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most);
  const auto evaluate = [&](std::size_t part) {
    const std::size_t begin = points * part / parts;
    const std::size_t end = points * (part + 1) / parts;
    entry.evaluate(&inputs[begin * kInputWords], &outputs[begin * kOutputWords], end - begin);
  };
  std::vector<std::jthread> threads;  // beside this one, which a single row needs alone
  for (std::size_t part = 1; part < parts; ++part) threads.emplace_back(evaluate, part);
  evaluate(0);
  threads.clear();  // joins them
  return outputs;
}

}  // namespace hn
