#include "cases/deal.hpp"

#include <set>
#include <string_view>

namespace hn {
namespace {

std::vector<std::size_t> able(const Case& test, std::span<const DealtDriver> drivers) {
  std::vector<std::size_t> able;
  for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
    if (drivers[driver].can_run(test)) able.push_back(driver);
  }
  return able;
}

// Each driver as many times as it has turns.
std::vector<std::size_t> in_a_round(const std::vector<std::size_t>& candidates, std::span<const DealtDriver> drivers) {
  std::vector<std::size_t> round;
  for (const std::size_t driver : candidates) {
    round.insert(round.end(), static_cast<std::size_t>(drivers[driver].turns), driver);
  }
  return round;
}

}  // namespace

std::vector<std::vector<std::size_t>> deal(std::span<const Case> cases, std::span<const DealtDriver> drivers) {
  std::vector<std::vector<std::size_t>> dealt(drivers.size());
  if (drivers.empty()) return dealt;
  std::size_t turn = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (i > 0 && cases[i].name.setting() != cases[i - 1].name.setting()) ++turn;
    const auto candidates = able(cases[i], drivers);
    if (cases[i].extent == Extent::every_driver && !candidates.empty()) {
      std::set<std::string_view> renderers;
      for (const std::size_t driver : candidates) {
        if (renderers.insert(drivers[driver].renderer).second) dealt[driver].push_back(i);
      }
      continue;
    }
    const auto turns = in_a_round(candidates, drivers);
    dealt[turns.empty() ? 0 : turns[turn % turns.size()]].push_back(i);
  }
  return dealt;
}

}  // namespace hn
