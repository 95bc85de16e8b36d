#include "run/selection.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace hn {

bool matches_glob(const std::string& text, const std::string& glob) {
  return fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

bool matches_any(const std::string& id, const std::vector<std::string>& globs) {
  return globs.empty() ||
         std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) { return matches_glob(id, glob); });
}

std::vector<Case> filter_cases(std::vector<Case> cases, const std::vector<std::string>& globs) {
  std::erase_if(cases, [&](const Case& test) { return !matches_any(test.id, globs); });
  return cases;
}

namespace {

constexpr std::size_t kMostShards = 10000;  // more than there are cases

// The whole of text as a number from 1 on, or 0.
std::size_t number_of(std::string_view text) {
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && stop == text.data() + text.size() && number <= kMostShards ? number : 0;
}

}  // namespace

Result<Shard> parse_shard(const std::string& text) {
  if (text.empty()) return Shard{};
  const auto slash = text.find('/');
  const std::string_view whole = text;
  if (slash != std::string::npos) {
    const Shard shard{number_of(whole.substr(0, slash)), number_of(whole.substr(slash + 1))};
    if (shard.index >= 1 && shard.index <= shard.count) return shard;
  }
  return fail(fmt::format("\"{}\" is not a shard: write I/N with 1 <= I <= N <= {}; 2/3 is the second of three", text,
                          kMostShards));
}

}  // namespace hn
