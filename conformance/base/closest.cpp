#include "base/closest.hpp"

#include <algorithm>
#include <vector>

namespace hn {
namespace {

constexpr std::size_t kLongestWord = 64;  // no name of ours comes near it, and the work grows with its length

std::size_t slips_between(std::string_view a, std::string_view b) {
  // rows[i][j]: from the first i letters of a to the first j of b
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        rows[i][j] = i + j;
        continue;
      }
      const std::size_t changed = rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      rows[i][j] = std::min({changed, rows[i - 1][j] + 1, rows[i][j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
    }
  }
  return rows[a.size()][b.size()];
}

}  // namespace

std::string closest(std::string_view word, std::span<const std::string> names) {
  std::string best;
  std::size_t fewest = std::max<std::size_t>(word.size() / 3, 1) + 1;
  if (word.size() > kLongestWord) return best;
  for (const std::string& name : names) {
    const std::size_t slips = slips_between(word, name);
    if (slips >= fewest) continue;
    fewest = slips;
    best = name;
  }
  return best;
}

}  // namespace hn
