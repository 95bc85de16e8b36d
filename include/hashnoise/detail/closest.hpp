// The known name that a user probably meant by an unknown word. The compiled library, the programs and the suite ask it.
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace hashnoise::detail {

constexpr std::size_t kLongestWord = 64;  // no name of ours comes near it, and the work grows with its length

// How many typing errors turn the word into the name: a letter too many, too few, wrong, or two exchanged.
inline std::size_t slips_between(std::string_view word, std::string_view name) {
  using Row = std::array<std::size_t, kLongestWord + 1>;
  Row before{}, last{}, row{};  // row[j]: from the first i letters of the word to the first j of the name
  for (std::size_t i = 0; i <= word.size(); ++i) {
    for (std::size_t j = 0; j <= name.size(); ++j) {
      if (i == 0 || j == 0) {
        row[j] = i + j;
        continue;
      }
      const std::size_t changed = last[j - 1] + (word[i - 1] == name[j - 1] ? 0 : 1);
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && word[i - 1] == name[j - 2] && word[i - 2] == name[j - 1];
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[name.size()];
}

// The name that a few typing errors turn into the word. Empty if that takes more errors than a third of the letters, or
// if a word is longer than kLongestWord. `names` is a range of texts.
template <typename Names>
std::string closest(std::string_view word, const Names& names) {
  std::string best;
  std::size_t fewest = std::max<std::size_t>(word.size() / 3, 1) + 1;
  if (word.size() > kLongestWord) return best;
  for (const std::string_view name : names) {
    if (name.size() > kLongestWord) continue;
    const std::size_t slips = slips_between(word, name);
    if (slips >= fewest) continue;
    fewest = slips;
    best = name;
  }
  return best;
}

// " (did you mean perlin?)", or nothing.
template <typename Names>
std::string suggestion(std::string_view word, const Names& names) {
  const std::string meant = closest(word, names);
  return meant.empty() ? meant : " (did you mean " + meant + "?)";
}

}  // namespace hashnoise::detail
