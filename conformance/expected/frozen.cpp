// Checksums of the values that never change from version 1.0 on, for tools/make freeze:
//
//   hn-frozen COUNT [FUNCTION...]     all functions that have such values, or those
//
// It prints a line for each set of exact_sets(), FUNCTION,SETTING,POINTS,VALUES: CRC-32 of the words that go in at so
// many points and of those that come out of the C++ header, point by point, each little-endian.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "expected/golden.hpp"
#include "expected/points.hpp"
#include "expected/twin.hpp"
#include "output/encoding.hpp"

namespace {

static_assert(std::endian::native == std::endian::little);

// How many metrics and noises there were in version 1.0: of these the points are drawn, so that they stay. A number
// that named none may name one later, and its value is not frozen.
constexpr std::uint32_t kMetrics = 5;
constexpr std::uint32_t kSpreads = 18;

std::vector<std::uint32_t> frozen_points(const hn::Function& function, hn::Extremes extremes, std::size_t count) {
  std::vector<std::uint32_t> words = hn::random_points(function, count, hn::Random(1, function.id), extremes, kMetrics);
  for (const auto& [name, names] : {std::pair("metric", kMetrics), std::pair("spread", kSpreads)}) {
    const int column = function.input(name);
    if (column < 0) continue;
    for (auto i = static_cast<std::size_t>(column); i < words.size(); i += hn::kInputWords) {
      words[i] = 1 + words[i] % names;
    }
  }
  return words;
}

// Sums up the first words of each point, which has `stride`.
std::uint32_t checksum(std::span<const std::uint32_t> words, std::size_t stride, std::size_t first) {
  std::uint32_t sum = 0;
  for (; !words.empty(); words = words.subspan(stride)) {
    sum = hn::crc32_of({reinterpret_cast<const char*>(words.data()), first * sizeof(std::uint32_t)}, sum);
  }
  return sum;
}

const hn::Configuration& configuration_of(const hn::Function& function, std::string_view setting) {
  for (const hn::GoldenSetting& known : hn::golden_settings(function)) {
    if (known.name == setting) return *known.configuration;
  }
  throw std::logic_error(fmt::format("{} has no setting {}", function.id, setting));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv + 1, argv + argc);
  std::size_t count = 0;
  const std::string_view number = arguments.empty() ? "" : arguments.front();
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
  if (error != std::errc() || end != number.data() + number.size() || count == 0) {
    std::fputs("hn-frozen COUNT [FUNCTION...]: COUNT is a number of points from 1 on\n", stderr);
    return 2;
  }
  const auto wanted = std::span(arguments).subspan(1);
  for (const std::string_view id : wanted) {
    if (std::ranges::find(hn::exact_sets(), id, &hn::ExactSet::function) == hn::exact_sets().end()) {
      fmt::print(stderr, "hn-frozen: {} has no exact values, or there is no such function\n", id);
      return 2;
    }
  }
  for (const hn::ExactSet& set : hn::exact_sets()) {
    if (!wanted.empty() && std::ranges::find(wanted, set.function) == wanted.end()) continue;
    const hn::Function& function = hn::find_function(set.function);
    const hn::Configuration& configuration = configuration_of(function, set.setting);
    const auto points = frozen_points(function, hn::defined_extremes(configuration), count);
    const auto values = hn::evaluate_twin(function, configuration, points);
    fmt::print("{},{},{:08x},{:08x}\n", set.function, set.setting,
               checksum(points, hn::kInputWords, function.inputs.size()),
               checksum(values, hn::kOutputWords, function.outputs.size()));
    std::fflush(stdout);
  }
  return 0;
}
