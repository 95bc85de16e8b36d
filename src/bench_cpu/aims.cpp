#include "bench_cpu/aims.hpp"

#include <array>

namespace hn {

std::string_view name_of(Comparison comparison) {
  constexpr std::array<std::string_view, kComparisons> kNames = {"grids",   "points", "octaves", "fixed",
                                                                 "precise", "tiles",  "lists",   "threads"};
  return kNames[static_cast<std::size_t>(comparison)];
}

std::optional<double> aim_of(Comparison comparison, const Subject& subject) {
  switch (comparison) {
    case Comparison::grids:
      return subject.aim;
    case Comparison::fixed:
      return 0.6;
    case Comparison::lists:
      return 0.5;
    case Comparison::points:
    case Comparison::octaves:
    case Comparison::precise:
    case Comparison::tiles:
    case Comparison::threads:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace hn
