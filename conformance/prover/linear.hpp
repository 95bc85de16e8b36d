// A lazy number of HN_FIXED (counts.hpp) is written in the end as a sum
//
//   w_0 + sum of w_l n_l        n_l numbers of a hash, w_l numbers without one
//
// and each error of w_l, which others share, has a derivative that is an Affine of the place. So the size of the
// result's error, for each class of each hash, is convex along each axis and in each such error: it is largest at
// ends.
#pragma once

#include <memory>

#include "counts.hpp"

namespace hn::prover {

// A sum of numbers of hashes times weights: a weight for each number of one word, by its node, and each choice, by its
// symbol.
struct Linear {
  Weight base;
  std::map<int, Weight> of_node, of_choice;
  Interval off;  // roundings
};
inline std::vector<std::unique_ptr<Linear>> linears;
inline Linear plus(const Linear& a, const Linear& b, double sign) {
  Linear c = a;
  const Weight zero;
  c.base = plus(a.base, b.base, sign);
  for (const auto& [n, w] : b.of_node) c.of_node[n] = plus(c.of_node[n], w, sign);
  for (const auto& [n, w] : b.of_choice) c.of_choice[n] = plus(c.of_choice[n], w, sign);
  c.off = a.off + b.off * point(sign);
  return c;
}
inline Linear times(const Linear& a, const Weight& w) {
  Linear c;
  c.base = times(a.base, w);
  for (const auto& [n, x] : a.of_node) c.of_node[n] = times(x, w);
  for (const auto& [n, x] : a.of_choice) c.of_choice[n] = times(x, w);
  c.off = a.off * w.anywhere().range();
  return c;
}
constexpr size_t kMostErrors = 4;  // of a number: more of them become one
inline const Linear& linear(int n);
// For a number without a hash that has not rounded.
inline const Weight& weight(int n) {
  const Linear& l = linear(n);
  if (!l.of_node.empty() || !l.of_choice.empty()) refuse("a product of two numbers of hashes");
  if (l.off.lo != 0 || l.off.hi != 0) refuse("a factor that was rounded");
  return l.base;
}
inline Linear new_linear(int n) {
  const Node x = nodes[n];
  Linear l;
  if (!x.lazy) {
    if (x.word != 0) {
      l.of_node[n] = constant_weight(1);
      return l;
    }
    const Form& f = x.forms[0];
    l.base.exact = affine(f.mid);
    for (const Term& t : f.terms) {
      switch (symbols[t.symbol].kind) {
        case kPlace:
          if (place_step() > 1) refuse("a place that is not rounded");
          add_place(l.base.exact, t);
          break;
        case kChoice:
          l.of_choice[t.symbol].exact = affine(t.d);
          break;
        case kError:
          l.base.errors.push_back({t.symbol, affine(t.d)});
      }
    }
    if (l.base.errors.size() > kMostErrors) l.base.errors = {{symbol(kError, f.error()), Affine(1)}};
    return l;
  }
  const bool sums = x.made == '+' || x.made == '-' || (x.made == '*' && (is_known(x.left) || is_known(x.right)));
  if (x.leaf >= 0 && !sums) {
    const Table& t = table(n);
    Affine& a = l.base.exact = affine(point(t.sum) + t.rest);
    const int axis = nodes[x.leaf].forms[0].terms.empty() ? 0 : nodes[x.leaf].forms[0].terms[0].symbol;
    add_along(a, axis, t.difference);
    const auto key = mixed(shape(n), x.leaf);
    if (!same.count(key)) same[key] = symbol(kError, t.off);
    Affine tilted(1);
    add_along(tilted, axis, t.tilt);
    if (t.off.size() > 0) l.base.errors.push_back({same[key], tilted});
    return l;
  }
  const auto scaled = [&](const Linear& of, double by) { return times(of, constant_weight(by)); };
  switch (x.made) {
    case '+':
      return plus(linear(x.left), linear(x.right), 1);
    case '-':
      return plus(linear(x.left), linear(x.right), -1);
    case '*': {
      const Linear& a = linear(x.left);
      const bool hash = !a.of_node.empty() || !a.of_choice.empty() || a.off.size() > 0;
      return hash ? times(a, weight(x.right)) : times(linear(x.right), weight(x.left));
    }
    case '>':
      l = scaled(linear(x.left), std::ldexp(1.0, -x.shift));
      if (x.off.hi > 0) l.base.exact = plus(l.base.exact, Affine(x.off.hi), -1);
      break;
    case 'p':
      l = times(scaled(linear(x.left), std::ldexp(1.0, -x.shift)), weight(x.right));
      break;
    case 'l': {
      const Node product = nodes[x.right];
      double scale = 1;
      if (x.left != x.other) is_constant(Float::at(nodes[x.left].right), &scale);
      const Weight t = times(weight(product.right), constant_weight(std::ldexp(1.0, -product.shift)));
      const Linear &from = linear(x.other), &to = linear(nodes[product.left].left);
      l = plus(times(from, plus(constant_weight(scale), t, -1)), times(to, t), 1);
      const Interval part = t.anywhere().range();
      const auto at = [&](double t) { return from.off * (point(scale) - point(t)) + to.off * point(t); };
      l.off = hull(at(part.lo), at(part.hi)) + product.off;  // linear in t
      return l;
    }
    default:
      refuse("a step of a number of several");
  }
  l.off = l.off + x.off;
  return l;
}
inline const Linear& linear(int n) {
  if (nodes[n].linear < 0) {
    auto l = std::make_unique<Linear>(new_linear(n));
    nodes[n].linear = static_cast<int>(linears.size());
    linears.push_back(std::move(l));
  }
  return *linears[nodes[n].linear];
}

enum Of { kExactly, kOff, kComputed };  // the exact number, how far the computed one is off it, or the computed one
constexpr int kExact = -1;              // in place of an error: 1
inline std::vector<Derivative> terms_of(const Weight& w, Of of) {
  std::vector<Derivative> found;
  if (of != kOff) found.push_back({kExact, w.exact});
  if (of != kExactly) found.insert(found.end(), w.errors.begin(), w.errors.end());
  return found;
}
inline Interval range_of_error(int k, Of of) {
  return k == kExact ? point(1) : of == kComputed && symbols[k].stays ? Interval{} : symbols[k].range;
}
// A sum of groups: one is without a hash, and the others are of a choice or of a word, with their alternatives.
struct Alternative {
  std::vector<Affine> by;  // derivatives, by the errors
  double rest = 0;
};
struct Groups {
  std::map<int, int> errors;  // by symbol: its group, or kSeveral
  static constexpr int kBase = 0, kSeveral = -1;
  std::vector<std::vector<Alternative>> of;
  void note(const Weight& w, int group, Of of) {
    for (const auto& [k, d] : terms_of(w, of)) {
      int& known = errors.try_emplace(k, group).first->second;
      if (known != group) known = kSeveral;
    }
  }
  void add(Alternative& a, const Weight& w, const Affine& by, Of of) const {
    a.by.resize(errors.size());
    for (const auto& [k, d] : terms_of(w, of)) {
      Affine& sum = a.by[size_t(std::distance(errors.begin(), errors.find(k)))];
      sum = plus(sum, times(d, by), 1);
    }
  }
};
inline Affine number_of_hash(const Form& f) {
  Affine at = affine(f.mid);
  for (const Term& t : f.terms) {
    if (symbols[t.symbol].kind == kError) refuse("a number of a hash that was rounded");
    if (symbols[t.symbol].kind == kPlace)
      add_place(at, t);
    else
      at.r += t.d.size() * symbols[t.symbol].range.size();
  }
  return at;
}
inline Groups groups_of(const Linear& l, Of of) {
  Groups groups;
  int last = Groups::kBase;
  std::map<int, int> words;
  groups.note(l.base, last, of);
  for (const auto& [k, w] : l.of_choice) groups.note(w, ++last, of);
  for (const auto& [n, w] : l.of_node) {
    int& group = words[nodes[n].word];
    group = group != 0 ? group : ++last;
    groups.note(w, group, of);
  }
  groups.of.resize(last + 1);
  groups.of[0].resize(1);
  groups.add(groups.of[0][0], l.base, Affine(1), of);
  int number = 0;
  for (const auto& [k, w] : l.of_choice) {
    auto& group = groups.of[++number];
    group.resize(2);
    groups.add(group[0], w, Affine(symbols[k].range.lo), of);
    groups.add(group[1], w, Affine(symbols[k].range.hi), of);
  }
  for (const auto& [n, w] : l.of_node) {
    auto& group = groups.of[words[nodes[n].word]];
    group.resize(nodes[n].forms.size());
    for (size_t i = 0; i < group.size(); ++i) groups.add(group[i], w, number_of_hash(nodes[n].forms[i]), of);
  }
  for (auto& group : groups.of) {
    for (Alternative& a : group) {
      size_t i = 0;  // the sums of ends_of round, too
      for (const auto& [k, known] : groups.errors) {
        const Affine& d = a.by[i++];
        a.rest += (d.r + 0x1p-40 * d.size()) * range_of_error(k, of).size();
      }
    }
  }
  return groups;
}
// Errors that groups share are at either end of their ranges; each alternative has the worst of its own ones.
inline Interval ends_of(const Linear& l, Of of) {
  const Groups groups = groups_of(l, of);
  std::vector<std::pair<size_t, Interval>> shared, own;  // numbers of errors, and their ranges
  for (size_t i = 0; const auto& [k, group] : groups.errors)
    (k != kExact && group == Groups::kSeveral ? shared : own).push_back({i++, range_of_error(k, of)});
  const size_t count = shared.size();
  if (count > 10) refuse("more than ten errors that numbers share");
  size_t total = 0;
  for (const auto& group : groups.of) total += group.size();
  std::vector<double> step(total * count), best(total), worst(total);
  double most = -INFINITY, least = INFINITY;
  for (int corner = 0; corner < corners; ++corner) {
    size_t at = 0;
    for (const auto& group : groups.of) {
      for (const Alternative& a : group) {
        Interval sum{-a.rest, a.rest};
        for (const auto& [i, e] : own) sum = sum + point(a.by[i].at[corner]) * e;
        for (size_t k = 0; k < count; ++k) {
          const double d = a.by[shared[k].first].at[corner];
          const Interval e = shared[k].second;
          sum = sum + point(d * e.lo);
          step[k * total + at] = d * (e.hi - e.lo);
        }
        best[at] = sum.hi, worst[at++] = sum.lo;
      }
    }
    for (unsigned i = 0, ends = 0; i < 1u << count; ++i) {
      if (i != 0) {  // one error goes to its other end
        const int k = std::countr_zero(i);
        const double sign = ends >> k & 1 ? -1 : 1;
        ends ^= 1u << k;
        for (size_t j = 0; j < total; ++j)
          best[j] += sign * step[k * total + j], worst[j] += sign * step[k * total + j];
      }
      double up = 0, down = 0;
      for (auto first = 0u; const auto& group : groups.of) {
        const auto last = first + unsigned(group.size());
        up += *std::max_element(&best[first], &best[0] + last),
            down += *std::min_element(&worst[first], &worst[0] + last);
        first = last;
      }
      most = std::max(most, up), least = std::min(least, down);
    }
  }
  return {-std::max(-least, -least * kSafe), std::max(most, most * kSafe)};
}

inline bool wants_range = false;  // of the result, and not its error
// The range of a lazy number, from its sum.
inline Interval narrowed(int n) {
  const Linear& l = linear(n);
  return nodes[n].forms[0].range = meet(range_of(n), ends_of(l, kComputed) + l.off);
}
// For a step that does not know lazy numbers: one that can be anything in its range, and is off by its error.
inline int settled(int n) {
  if (nodes[n].joined >= 0) return nodes[n].joined;
  const Linear& l = linear(n);
  const Interval exact = ends_of(l, kExactly), error = ends_of(l, kOff) + l.off;
  Form f;
  f.mid = point(middle(exact));
  const double half = reach(exact, f.mid.lo);
  f.range = hull(meet(wants_range ? narrowed(n) : range_of(n), exact + error), exact);
  f.grid = grid_of(n);
  f.terms.push_back({symbol(kChoice, {-half, half}), {1, 1}});
  f.terms.push_back({symbol(kError, error), {1, 1}});
  const int settled = node(0, {f});
  nodes[n].joined = settled;
  return settled;
}

}  // namespace hn::prover
