// Words as far as they are known: their bits, for each class of words of a hash; and conditions.
#pragma once

#include <bit>
#include <cstdint>
#include <unordered_map>

#include "places.hpp"
#include "seams.hpp"

namespace hn::prover {

// --- Words. An integer is known, or any, or for each class of words of a hash some of its bits are known. -----------

struct Bits {
  std::uint32_t known = 0, value = 0, lo = 0, hi = 0xFFFFFFFFu;
};
// How each word is divided into classes: by these bits and at these thresholds. The text wants them: a step that
// needs a bit which is not known adds it, and the proof starts again. Words have the same numbers then; where they have
// not, one is divided more than it needs.
struct Division {
  std::uint32_t bits = 0;
  std::vector<std::uint32_t> thresholds;
  Vector<Bits> classes;
};
inline std::vector<Division> divisions;   // by the number of the word
inline std::uint32_t bits_of_chosen = 0;  // divide the words that a path makes of what it chooses: from last_common on
inline Division& division(int word) {
  const auto is_chosen = [](std::size_t i) { return last_common > 0 && i > static_cast<std::size_t>(last_common); };
  while (divisions.size() <= static_cast<std::size_t>(word))
    divisions.push_back({is_chosen(divisions.size()) ? bits_of_chosen : 0, {}, {}});
  return divisions[word];
}
constexpr int kSpread = 5;  // so many of the highest bits of a number that bends
inline int split = 0;       // so many of the highest bits of each number that a hash makes divide words, too
constexpr int kMostSplit = 3;
inline bool may_split = false;  // a number of more bits was made
struct Again {};

inline const Vector<Bits>& classes(int word) {
  Division& of = division(word);
  if (!of.classes.empty()) return of.classes;
  std::vector<std::uint32_t> starts{0};
  for (std::uint32_t t : of.thresholds) starts.push_back(t);
  std::sort(starts.begin(), starts.end());
  for (size_t i = 0; i < starts.size(); ++i) {
    const std::uint32_t lo = starts[i], hi = i + 1 < starts.size() ? starts[i + 1] - 1 : 0xFFFFFFFFu;
    const std::uint32_t differ = lo ^ hi;
    const std::uint32_t common = differ == 0 ? ~0u : ~(~0u >> std::countl_zero(differ));
    for (std::uint32_t set = 0;; set = (set - of.bits) & of.bits) {
      if (((set ^ lo) & of.bits & common) == 0) of.classes.push_back({common | of.bits, (lo & common) | set, lo, hi});
      if (set == of.bits) break;
    }
  }
  return of.classes;
}
[[noreturn]] inline void want_bits(int word, std::uint32_t bits) {
  Division& of = division(word);
  if ((bits & ~of.bits) == 0) refuse("bits that are known");
  if (std::popcount(bits | of.bits) > 10) refuse("too many bits of a hash decide");
  of.bits |= bits;
  of.classes.clear();
  if (last_common > 0 && word > last_common) {
    bits_of_chosen |= bits;
    divisions.resize(last_common + 1);
  }
  throw Again{};
}
// Divides all words that are divided: one after another each would start the proof again.
[[noreturn]] inline void want_bits_of_all(std::uint32_t bits) {
  for (Division& of : divisions) {
    if (of.bits != 0) of.bits |= bits, of.classes.clear();
  }
  throw Again{};
}
[[noreturn]] inline void want_threshold(int word, std::uint32_t t) {
  division(word).thresholds.push_back(t);
  division(word).classes.clear();
  throw Again{};
}

inline std::unordered_map<std::uint64_t, int> same;  // steps that were taken before: the node, or the decision
inline std::uint64_t step_key(char op, int a, int b) {
  return std::uint64_t(op) << 56 | std::uint64_t(a) << 28 | std::uint64_t(b);
}

struct Mask {
  int step = -1;           // that made it, if a word decides
  int zero = -1;           // a node that is compared with 0
  bool rounds = false;     // rounding may change it
  std::uint64_t open = 0;  // a step that makes no path until a branch needs it; it is exact
  bool flips = false;
  int word = 0;
  Vector<signed char> v{0};  // 0, 1
  explicit operator bool() const {
    if (word != 0) refuse("a branch by a hash");
    if (open != 0) {
      const auto [known, is_new] = same.try_emplace(open, 0);
      if (is_new) known->second = taken(2);
      return (known->second != 0) != flips;
    }
    if (v[0] < 0) throw TooLarge{"a branch by an unknown number"};
    return v[0] != 0;
  }
  static Mask make(int word, Vector<signed char> v) {
    Mask m;
    m.word = word, m.v = std::move(v);
    return m;
  }
  static Mask of(bool b) { return make(0, {static_cast<signed char>(b)}); }
  static Mask unknown(bool rounds = false) {
    Mask m = make(0, {-1});
    m.rounds = rounds;
    return m;
  }
  static Mask either(std::uint64_t key) {
    Mask m = unknown();
    m.open = key;
    return m;
  }
  friend Mask operator&&(Mask a, Mask b) { return of(bool(a) && bool(b)); }
  friend Mask operator||(Mask a, Mask b) { return of(bool(a) || bool(b)); }
  friend Mask operator!(Mask a) {
    if (a.open == 0) return of(!bool(a));
    a.flips = !a.flips;
    return a;
  }
};

template <bool Signed>
struct Integer;

}  // namespace hn::prover
