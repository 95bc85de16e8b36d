#include "expected/exact_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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

}  // namespace

const std::vector<ExactSet>& exact_sets() {
  static const std::vector<ExactSet> kSets = make_exact_sets();
  return kSets;
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
