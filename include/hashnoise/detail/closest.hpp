// The known name that a user probably meant by an unknown word. The compiled library, the packages, the programs and
// the suite ask it.
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "../glsl.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::detail {

constexpr std::size_t kLongestWord = 64;  // no name of ours comes near it, and the work grows with its length

// How many typing errors turn the word into the name: a letter too many, too few, wrong, or two exchanged.
inline std::size_t slips_between(std::string_view word, std::string_view name) {
  // From the first i letters of the word to the first j of the name.
  std::vector<std::vector<std::size_t>> at(word.size() + 1, std::vector<std::size_t>(name.size() + 1));
  for (std::size_t i = 0; i <= word.size(); ++i) {
    for (std::size_t j = 0; j <= name.size(); ++j) {
      at[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      at[i][j] = std::min({at[i - 1][j] + 1, at[i][j - 1] + 1, at[i - 1][j - 1] + (word[i - 1] != name[j - 1])});
      if (i > 1 && j > 1 && word[i - 1] == name[j - 2] && word[i - 2] == name[j - 1]) {
        at[i][j] = std::min(at[i][j], at[i - 2][j - 2] + 1);
      }
    }
  }
  return at.back().back();
}

// The name that a few typing errors turn into the word. Empty if that takes more errors than a third of the letters, or
// if a word is longer than kLongestWord. `names` is a range of texts.
template <typename Names>
std::string closest(std::string_view word, const Names& names) {
  std::string best;
  std::size_t fewest = std::max(word.size() / 3, std::size_t{1}) + 1;
  for (const std::string_view name : names) {
    if (std::max(word.size(), name.size()) > kLongestWord) continue;
    const std::size_t slips = slips_between(word, name);
    if (slips >= fewest) continue;
    fewest = slips;
    best = name;
  }
  return best;
}

// Noises by their names in other libraries, without the dimensions at their ends. index.js of npm has the same.
constexpr std::string_view kElsewhere[][2] = {
    {"snoise", "simplex"},   {"opensimplex", "simplex"}, {"opensimplex2s", "simplex_smooth"},
    {"pnoise", "perlin"},    {"cnoise", "perlin"},       {"worley", "cellular"},
    {"voronoi", "cellular"},
};

// " (did you mean perlin?)" or " (here it is cellular)", or nothing. It works for hn_perlin, too, if the names are
// without hn_, and for Perlin: no name of ours has capitals.
template <typename Names>
std::string suggestion(std::string_view written, const Names& names) {
  std::string word(written);
  for (char& letter : word) letter = 'A' <= letter && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  const std::string stem = word.substr(0, word.find_last_not_of("1234d") + 1);
  for (const auto& [theirs, ours] : kElsewhere) {
    if (stem != theirs) continue;
    for (const std::string_view name : names) {
      if (name == ours) return " (here it is " + std::string(ours) + ")";
    }
  }
  std::string meant = closest(word, names);
  if (meant.empty() && word.starts_with("hn_")) meant = closest(std::string_view(word).substr(3), names);
  return meant.empty() ? meant : " (did you mean " + meant + "?)";
}

}  // namespace hashnoise::detail
