// Seams: where rounding may change a decision.
//
// A decision that a box leaves open makes paths of the whole text. The run in floats may take another path than exact
// arithmetic does. They part at the first decision in which their paths differ. Before it both have made the same
// decisions, so that its numbers are the same up to rounding: it is a decision about numbers with roundings. On the
// path A of the floats, and E of exact arithmetic,
//
//   |rounded A - exact E| <= |rounded A - exact A| + |exact A - exact E|.
//
// The forms of both paths hold in the whole box, so the first is the error of A's form. For the second, numbers are
// compared as the sums they are in exact arithmetic: multiples of atoms, which are places, and products and so on of
// other such sums. Both paths give equal sums equal numbers, and these cancel, in any order; the range of each other
// atom counts. Words are sums modulo 2^32. So the same point of a lattice has the same hash, wherever it is counted
// from.
//
// They part on the seam alone: where c, the number that decides, is no farther from 0 than it errs. There a number
// f + sum of d s is f - l c + sum of (d - l c') s, and l times the error of c, for any l. The prover takes the l of the
// steepest symbol: with it the number hardly depends on how far the box reaches across the seam.
#pragma once

#include <array>
#include <map>

#include "node.hpp"

namespace hn::prover {

// How a word was made: by an operation on others, which are such steps. '#' is a constant, 'N' the number of a node,
// and 'A' and 'X' are others.
struct Step {
  int op;
  int of[3];
  int word = 0;  // its number
};
inline int last_word = 0, last_common = 0;         // of all paths
inline std::vector<Step> steps{{'#', {0, 0, 0}}};  // of a box; the first one is 0
inline int new_step(int op, int a, int b = 0, int c = 0) {
  const auto make = [&] {
    steps.push_back({op, {a, b, c}});
    return static_cast<int>(steps.size()) - 1;
  };
  return op == 'X' ? make() : once(op | 1 << 16, a, b, c, make);
}

template <typename Number>
struct Sum {
  Number constant{};
  std::vector<std::pair<int, Number>> terms{};  // atoms and their factors, by atom
};

class Numbering {
 public:
  void clear() { ids_.clear(), floats_.clear(), words_.clear(), node_of_.clear(); }

  Sum<double> of(int n) {
    if (const auto found = floats_.find(n); found != floats_.end()) return found->second;
    const Node& x = nodes[n];
    const Form& f = x.forms[0];
    Sum<double> sum;
    if (x.word == 0 && f.terms.empty() && f.range.lo == f.range.hi)
      sum.constant = f.range.lo + 0.0;  // -0 is 0
    else if (x.made == 'J')
      sum = of(x.left);
    else if (!(x.made == '+' && added(of(x.left), of(x.right), 1.0, sum)) &&
             !(x.made == '-' && added(of(x.left), of(x.right), -1.0, sum)) &&
             !(x.made == '~' && added({}, of(x.left), -1.0, sum)) &&
             !(x.made == '*' && (scaled(of(x.left), of(x.right), sum) || scaled(of(x.right), of(x.left), sum))))
      sum.terms = {{atom(n), 1.0}};
    return floats_[n] = sum;
  }
  // How far the numbers of two nodes are apart on the seam where c decides.
  double apart(int a, int b, const Form& c) {
    Ranges known;
    const double size = apart(of(a), of(b), c, known).size();
    return size < INFINITY ? size : INFINITY;
  }

 private:
  using Key = std::vector<std::uint64_t>;
  using Ranges = std::unordered_map<int, Interval>;    // of nodes on a seam
  std::map<Key, int> ids_;                             // of sums and of atoms in a box
  std::unordered_map<int, int> node_of_;               // of atoms
  std::unordered_map<int, Sum<double>> floats_;        // of nodes
  std::unordered_map<int, Sum<std::uint32_t>> words_;  // of steps

  Interval apart(const Sum<double>& a, const Sum<double>& b, const Form& c, Ranges& known) {
    Interval off = point(a.constant) - point(b.constant);
    std::map<int, Interval> factors;
    for (const auto& [atom, factor] : a.terms) factors[atom] = point(factor);
    for (const auto& [atom, factor] : b.terms) factors[atom] = factors[atom] - point(factor);
    for (auto i = factors.begin(); i != factors.end(); ++i) {
      const Interval factor = std::exchange(i->second, {});
      if (factor.size() == 0) continue;
      Interval range = on_seam(c, node_of_.at(i->first), known);
      for (auto j = std::next(i); j != factors.end(); ++j) {  // of products that share a number what else they have
        const auto [shared, x, y] = shared_factor(node_of_.at(i->first), node_of_.at(j->first));
        if (shared < 0 || (factor + j->second).size() != 0) continue;
        range = on_seam(c, shared, known) * apart(of(x), of(y), c, known);
        j->second = {};
        break;
      }
      off = off + factor * range;
    }
    return off;
  }
  // The node that two products share, and the other factors of both.
  std::array<int, 3> shared_factor(int a, int b) {
    if (nodes[a].made != '*' || nodes[b].made != '*') return {-1, -1, -1};
    for (const auto [x, more] : {std::pair(nodes[a].left, nodes[a].right), std::pair(nodes[a].right, nodes[a].left)}) {
      for (const auto [y, other] :
           {std::pair(nodes[b].left, nodes[b].right), std::pair(nodes[b].right, nodes[b].left)}) {
        if (id(of(x)) == id(of(y))) return {x, more, other};
      }
    }
    return {-1, -1, -1};
  }
  static Interval on_seam(const Form& c, const Form& f) {
    const auto steepest = std::max_element(c.terms.begin(), c.terms.end(), [](const Term& x, const Term& y) {
      const auto reach = [](const Term& t) {
        return symbols[t.symbol].kind == kPlace ? t.d.size() * symbols[t.symbol].range.size() : -1;
      };
      return reach(x) < reach(y);
    });
    double l = 0;
    for (const Term& t : f.terms) {
      if (t.symbol == steepest->symbol) l = (t.d.lo + t.d.hi) / (steepest->d.lo + steepest->d.hi);
    }
    if (!(std::fabs(l) < INFINITY)) l = 0;
    Interval range = f.mid - point(l) * (c.mid + c.error());
    for (const Term& t : combined(f, point(1), c, point(-l))) {
      if (symbols[t.symbol].kind != kError) range = range + t.d * symbols[t.symbol].range;
    }
    range = meet(range, f.range);
    return range.lo <= range.hi ? range : f.range;
  }
  static Interval on_seam(const Form& c, int n, Ranges& known) {
    if (const auto found = known.find(n); found != known.end()) return found->second;
    const Node& x = nodes[n];
    Interval range = on_seam(c, x.forms[0]);
    for (const Form& f : x.forms) range = hull(range, on_seam(c, f));
    const auto left = [&] { return on_seam(c, x.left, known); };
    const auto right = [&] { return on_seam(c, x.right, known); };
    Interval made = range;
    if (x.made == '+') made = left() + right();
    if (x.made == '-') made = left() - right();
    if (x.made == '*') made = left() * right();
    if (x.made == '~') made = -left();
    if (x.made == 'J') made = left();
    if (x.made == 'M') made = {std::max(left().lo, right().lo), std::max(left().hi, right().hi)};
    made = meet(made, range);
    return known[n] = made.lo <= made.hi ? made : range;
  }

  int id(Key key) { return ids_.try_emplace(std::move(key), ids_.size()).first->second; }
  int unique() { return id({0, ids_.size()}); }
  template <typename Number>
  std::uint64_t id(const Sum<Number>& sum) {
    const auto bits = [](Number x) {
      return sizeof x == 8 ? std::bit_cast<std::uint64_t>(double(x)) : std::uint64_t(x);
    };
    Key key{sizeof(Number), bits(sum.constant)};
    for (const auto& [atom, factor] : sum.terms) key.insert(key.end(), {std::uint64_t(atom), bits(factor)});
    return id(std::move(key));
  }

  // False if doubles round.
  static bool multiply_add(double a, double b, double& sum) {
    const double product = a * b, up = product + sum;
    if (product != -(-a * b) || up != -(-product - sum)) return false;
    sum = up + 0.0;
    return true;
  }
  static bool multiply_add(std::uint32_t a, std::uint32_t b, std::uint32_t& sum) {
    sum += a * b;
    return true;
  }
  template <typename Number>
  static bool added(Sum<Number> a, const Sum<Number>& b, Number times, Sum<Number>& sum) {
    if (!multiply_add(b.constant, times, a.constant)) return false;
    std::map<int, Number> factors(a.terms.begin(), a.terms.end());
    for (const auto& [atom, factor] : b.terms) {
      if (!multiply_add(factor, times, factors[atom])) return false;
    }
    sum.constant = a.constant, sum.terms.clear();
    for (const auto& term : factors) {
      if (term.second != 0) sum.terms.push_back(term);
    }
    return true;
  }
  template <typename Number>
  static bool scaled(const Sum<Number>& a, const Sum<Number>& b, Sum<Number>& sum) {
    return b.terms.empty() && added({}, a, b.constant, sum);
  }

  int atom(int n) {
    const Node& x = nodes[n];
    int number = -1;
    switch (x.made) {
      case 'U':  // the float of a word, its number, or its sine
      case 'w':
      case 'B':
      case 'b':
        number = id({std::uint64_t(x.made), id(of_step(x.step))});
        break;
      case '*':
      case 'M':
      case 'n':
      case '+':
      case '-': {
        Key key{std::uint64_t(x.made), id(of(x.left)), id(of(x.right))};
        if (x.made != '-') std::sort(key.begin() + 1, key.end());
        number = id(std::move(key));
        break;
      }
      case 'a':
      case 'W':  // the sine of a quarter
      case '%':  // without its whole part
        number = id({std::uint64_t(x.made), id(of(x.left))});
        break;
      case '?':
        number = id({'?', id(of_step(x.step)), id(of(x.left)), id(of(x.right))});
        break;
      case '|':
      case '^':
        number = id({std::uint64_t(x.made), id(of_step(x.step)), id(of(x.left))});
        break;
      default:
        number = unique();
    }
    node_of_[number] = n;
    return number;
  }

  Sum<std::uint32_t> of_step(int s) {
    if (const auto found = words_.find(s); found != words_.end()) return found->second;
    const auto [op, of, _] = steps.at(s);
    Sum<std::uint32_t> sum;
    const std::uint32_t one = 1;
    if (op == '#') {
      sum.constant = of[0];
    } else if (op == 'N') {
      sum.terms = {{id({'N', id(this->of(of[0]))}), 1}};
    } else if (op == 'X' || op == 'A') {
      sum.terms = {{unique(), 1}};
    } else if (op == '?' && id(of_step(of[1])) == id(of_step(of[2]))) {
      sum = of_step(of[1]);
    } else {
      const Sum<std::uint32_t> a = of_step(of[0]), b = of_step(of[1]);
      if (op == '+' || op == '-') {
        added(a, b, op == '+' ? one : -one, sum);
      } else if (!(op == '*' && (scaled(a, b, sum) || scaled(b, a, sum)))) {
        Key key{std::uint64_t(op), id(a), id(b), id(of_step(of[2]))};
        if (op == '*' || op == '^' || op == '|' || op == '&') std::sort(key.begin() + 1, key.begin() + 3);
        sum.terms = {{id(std::move(key)), 1}};
      }
    }
    return words_[s] = sum;
  }
};
inline Numbering numbering;

}  // namespace hn::prover
