#include "expected/exact_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/file.hpp"
#include "expected/golden.hpp"
#include "output/checksum.hpp"

namespace hn {
namespace {

std::vector<ExactSet> make_exact_sets() {
  std::vector<const Function*> functions;
  for (const Function& function : all_functions()) functions.push_back(&function);
  std::ranges::sort(functions, {}, &Function::id);
  std::vector<ExactSet> sets;
  for (const Function* function : functions) {
    for (const GoldenSetting& setting : golden_settings(*function)) {
      if (has_exact_values(*function, *setting.configuration)) sets.push_back({function->id, setting.name});
    }
  }
  return sets;
}

std::optional<std::size_t> number_of(std::string_view function, const std::string& setting) {
  static const std::map<std::pair<std::string_view, std::string>, std::size_t> kNumbers = [] {
    std::map<std::pair<std::string_view, std::string>, std::size_t> numbers;
    for (const ExactSet& set : exact_sets()) numbers.emplace(std::pair(set.function, set.setting), numbers.size());
    return numbers;
  }();
  const auto found = kNumbers.find({function, setting});
  return found == kNumbers.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

const std::vector<ExactSet>& exact_sets() {
  static const std::vector<ExactSet> kSets = make_exact_sets();
  return kSets;
}

std::optional<std::size_t> exact_set(const Function& function, const Configuration& configuration) {
  if (!has_exact_values(function, configuration)) return std::nullopt;
  return number_of(function.id, golden_setting(function, configuration));
}

std::optional<std::size_t> exact_set(std::string_view function, std::string_view configuration,
                                     std::string_view arithmetic) {
  if (arithmetic == "exact") return number_of(function, fmt::format("{}:exact", configuration));
  return number_of(function, fmt::format("{}+{}:{}", configuration, arithmetic, arithmetic));
}

std::string golden_checksum(const std::filesystem::path& directory) {
  std::set<std::string> names;
  std::error_code none;  // a folder that is missing is an error of each case
  for (const auto& entry : std::filesystem::directory_iterator(directory, none)) {
    if (entry.path().extension() == ".golden") names.insert(entry.path().filename().string());
  }
  std::uint32_t checksum = 0;
  for (const std::string& name : names) checksum = crc32_of(read_file(directory / name).value_or(""), checksum);
  return fmt::format("{:08x}", checksum);
}

}  // namespace hn
