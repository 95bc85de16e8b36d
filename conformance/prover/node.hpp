// Numbers of the text, as nodes of a graph: how each was made, and a form of it. A number that depends on one unknown
// word has a form for each class of words (alternatives). Numbers of different words are joined first: to one form,
// with a choice symbol for the middle, and one error symbol.
#pragma once

#include <unordered_map>

#include "form.hpp"

namespace hn::prover {

struct Node {
  int word;  // 0: none
  Vector<Form> forms;
  char made = 0;  // by an operator, of these nodes
  int left = -1, right = -1, shift = 0, step = -1;
  int other = -1;  // of 'l': that at 0
  int leaf = -1;   // the only integer that it is made of, if there is one; -2: there are several
  // For HN_FIXED (tables.hpp to linear.hpp).
  bool lazy = false;        // its form has only its range
  char type = 0;            // of an integer: signed 'i' or not 'u'
  Interval off;             // the step's rounding
  std::uint64_t shape = 0;  // of the steps from its leaf
  int linear = -1;          // its sum
  double bias = 0;          // that was added, perhaps to round
  int joined = -1;
  std::vector<std::pair<int, int>> shifted;  // by so many bits: the node
  std::vector<int> candidates;               // of 'k': it is the kth smallest of these
  int kth = 0;
  // A sum of w x^power of the nodes x, to this part of the power; so many of its roundings, one after another, are
  // relative to it.
  struct Powers {
    std::vector<std::pair<int, double>> of;
    int power = 0, roundings = 0;
    double part = 1;
  } powers;
  struct Alternative {
    Interval range, error;
  };
  std::vector<Alternative> alternatives;
  double by_length = INFINITY;  // of a component of a direction: its error times the length of the vector
};
inline std::vector<Node> nodes;
inline int node(int word, Vector<Form> forms) {
  if (nodes.size() >> 28) refuse("too many steps");  // step_key
  nodes.push_back({word, std::move(forms)});
  return static_cast<int>(nodes.size()) - 1;
}
constexpr bool kFixed = HN_ARITHMETIC == HN_FIXED;
#ifdef PROVER_EXACT_SINES
constexpr bool kExactSines = true;
#else
constexpr bool kExactSines = false;
#endif
int settled(int n);

// The paths of a box share nodes: a step that was taken before, of the same nodes, has the same node. But a step that
// rounds may round otherwise each time that a run takes it: so it has a node for each time.
struct Taken {
  std::vector<int> nodes;
  int run = 0;
  size_t times = 0;
  bool rounds = false;
};
struct Operation {
  int of[4];
  bool operator==(const Operation&) const = default;
  struct Hash {
    size_t operator()(const Operation& x) const {
      std::uint64_t h = 0;
      for (int part : x.of) h = (h ^ std::uint32_t(part)) * 0x9E3779B97F4A7C15u, h ^= h >> 32;
      return h;
    }
  };
};
inline std::unordered_map<Operation, Taken, Operation::Hash> all_taken;  // in the box
inline int run = 0;                                                      // of the box: a path
template <typename Make>
int once(int op, int a, int b, int c, const Make& make) {
  Taken& taken = all_taken[{op, a, b, c}];
  if (taken.run != run) taken.run = run, taken.times = 0;
  if (taken.times == taken.nodes.size()) {
    const size_t before = symbols.size();
    taken.nodes.push_back(make());
    taken.rounds = symbols.size() != before;
  }
  const int n = taken.nodes[taken.times];
  if (taken.rounds) ++taken.times;
  return n;
}

inline int joined_node(int n) {
  if (kFixed && nodes[n].lazy) return settled(n);
  if (nodes[n].word == 0) return n;
  if (nodes[n].joined < 0) {
    const int j = node(0, {joined(nodes[n].forms)});
    nodes[j].made = 'J', nodes[j].left = n;
    nodes[n].joined = j;
  }
  return nodes[n].joined;
}

}  // namespace hn::prover
