// Golden files, of the function that they name, if there is such.
#include "expected/golden.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz.hpp"
#include "library/functions.hpp"

namespace hn::fuzz {
namespace {

constexpr std::string_view kPath = "file.golden";

// "file.golden:12: something"
bool has_place(std::string_view message) {
  const std::string start = fmt::format("{}:", kPath);
  if (!message.starts_with(start)) return false;
  const auto after = message.find_first_not_of("0123456789", start.size());
  return after > start.size() && after != std::string_view::npos && message.substr(after).starts_with(": ") &&
         message.size() > after + 2;
}

std::string list(const std::vector<std::uint32_t>& numbers) { return fmt::format("{}", fmt::join(numbers, ",")); }

std::string hex(std::uint64_t word, WordType type) {
  return type == WordType::f64 ? fmt::format("{:016x}", word) : fmt::format("{:08x}", word);
}

// The text of a file with each setting of the function, as tools/make golden writes it.
std::string written(const std::vector<Golden>& all, const Function& function) {
  std::string settings = "settings";
  std::size_t rows = 0;
  const Golden* longest = nullptr;
  for (const GoldenSetting& setting : golden_settings(function)) settings += " " + setting.name;
  for (const Golden& golden : all) {
    if (golden.rows.size() > rows) longest = &golden;
    rows = std::max(rows, golden.rows.size());
  }
  std::string text = fmt::format("hashnoise golden 2\nfunction {}\ncalls {}\nbits 0\ncolumns {}\n{}\nrows {}\n",
                                 function.id, longest->calls, columns_of(function), settings, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    std::vector<std::string> words;
    for (std::size_t j = 0; j < function.inputs.size(); ++j) {
      words.push_back(hex(longest->rows[i].inputs[j], function.inputs[j].type));
    }
    for (const Golden& golden : all) {
      words.push_back("=");
      if (i >= golden.rows.size()) words.push_back("-");
      for (std::size_t j = 0; i < golden.rows.size() && j < function.outputs.size(); ++j) {
        words.push_back(hex(golden.rows[i].values[j], function.outputs[j].type));
      }
    }
    text += fmt::format("{}\n", fmt::join(words, " "));
  }
  const std::vector<GoldenSetting> names = golden_settings(function);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].digest) continue;
    const GoldenDigest& digest = *all[i].digest;
    text += fmt::format("digest {} origin={} size={} seed={} fnv1a64={:016x}\n",
                        names[i].name.substr(0, names[i].name.find(':')), list(digest.origin), list(digest.size),
                        digest.seed, digest.fnv1a64);
  }
  return text;
}

// The values of a text with each setting, or nothing and the error, which is the same for all settings.
std::vector<Golden> parse_all(std::string_view text, const Function& function, std::string& error) {
  std::vector<Golden> all;
  for (const GoldenSetting& setting : golden_settings(function)) {
    auto golden = parse_golden(text, kPath, function, *setting.configuration);
    if (golden) {
      require(error.empty(), "a file is right for all settings or for none", error);
      all.push_back(std::move(*golden));
    } else {
      require(error.empty() || error == golden.error().message, "it has one error", golden.error().message);
      require(all.empty(), "a file is right for all settings or for none", golden.error().message);
      error = golden.error().message;
    }
  }
  return all;
}

void check(const Golden& golden, const Function& function) {
  for (const GoldenRow& row : golden.rows) {
    require(row.inputs.size() == function.inputs.size() && row.values.size() == function.outputs.size(),
            "a row has a word per column");
  }
  if (golden.digest) {
    constexpr std::size_t kMostPoints = 1u << 20;  // in one draw of a driver
    const std::size_t points = golden.digest->points();
    require(points >= 1 && points <= kMostPoints, "a digest has at least one point and at most so many");
    // Large ones are slow, and no different.
    if (points <= 4096) {
      require(golden.digest->inputs().size() == points * kInputWords, "a digest gives the inputs of its points");
    }
  }
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  const std::string_view text = fuzz::text_of(data, size);
  const Function* function = &all_functions().back();
  for (const Function& other : all_functions()) {
    if (text.find(fmt::format("\nfunction {}\n", other.id)) != text.npos) function = &other;
  }
  std::string error;
  const std::vector<Golden> all = fuzz::parse_all(text, *function, error);
  if (all.empty()) {
    fuzz::require(fuzz::has_place(error), "an error names the line", error);
    return 0;
  }
  for (const Golden& golden : all) fuzz::check(golden, *function);
  const std::string file = fuzz::written(all, *function);
  const std::vector<Golden> again = fuzz::parse_all(file, *function, error);
  fuzz::require(error.empty(), "what was read can be written and read again", file);
  fuzz::require(fuzz::written(again, *function) == file, "it is the same then", file);
  return 0;
}
