#include "base/ratio.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hn {
namespace {

// The value below which a part of the sorted samples lies, between two of them if need be.
double quantile(std::vector<double> samples, double part) {
  if (samples.empty()) return 0.0;
  std::sort(samples.begin(), samples.end());
  const double place = part * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, samples.size() - 1);
  const double rest = place - static_cast<double>(below);
  return samples[below] * (1.0 - rest) + samples[above] * rest;
}

}  // namespace

double Timing::median() const { return quantile(samples, 0.5); }
double Timing::spread() const { return (quantile(samples, 0.75) - quantile(samples, 0.25)) / 2.0; }

Ratio ratio(const Timing& timing, const Timing& reference, const Timing& empty) {
  const std::size_t rounds = std::min({timing.samples.size(), reference.samples.size(), empty.samples.size()});
  Timing ratios;
  for (std::size_t i = 0; i < rounds; ++i) {
    const double base = reference.samples[i] - empty.samples[i];
    if (base > 0.0) ratios.samples.push_back((timing.samples[i] - empty.samples[i]) / base);
  }
  // Where the reference seldom takes longer than nothing, the remaining rounds prove nothing.
  if (ratios.samples.empty() || 2 * ratios.samples.size() < rounds) return {};
  return {ratios.median(), ratios.spread()};
}

std::string text_of(const Ratio& ratio) {
  return ratio.known() ? fmt::format("{:.2f} ± {:.2f}", ratio.value, ratio.spread) : "cannot be told";
}

}  // namespace hn
