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
      if (x.left != x.less[0]) is_constant(Float::at(nodes[x.left].right), &scale);
      const Weight t = times(weight(product.right), constant_weight(std::ldexp(1.0, -product.shift)));
      const Linear &from = linear(x.less[0]), &to = linear(nodes[product.left].left);
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

// The errors of a class of a word, by the symbols that numbers share; or its exact number.
struct Alternative {
  std::vector<Affine> by;
  double rest = 0;
};
constexpr int kExact = -1;
inline Interval ends_of(const Linear& l, bool exact) {
  std::vector<int> shared;
  const auto terms = [&](const Weight& w) { return exact ? std::vector<Derivative>{{kExact, w.exact}} : w.errors; };
  const auto range = [](int k) { return k == kExact ? point(1) : symbols[k].range; };
  const auto note = [&](const Weight& w) {
    for (const auto& [k, d] : terms(w)) shared.push_back(k);
  };
  note(l.base);
  for (const auto& [n, w] : l.of_node) note(w);
  for (const auto& [n, w] : l.of_choice) note(w);
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  const size_t count = shared.size();
  if (count > 10) refuse("more than ten errors that numbers share");
  const auto add = [&](Alternative& a, const Weight& w, const Affine& by) {
    for (const auto& [k, d] : terms(w)) {
      Affine& at = a.by[std::lower_bound(shared.begin(), shared.end(), k) - shared.begin()];
      at = plus(at, times(d, by), 1);
    }
  };
  std::vector<std::vector<Alternative>> groups;
  const Alternative none{std::vector<Affine>(count), 0};
  groups.push_back({none});
  add(groups[0][0], l.base, Affine(1));
  for (const auto& [k, w] : l.of_choice) {
    groups.push_back({none, none});
    add(groups.back()[0], w, Affine(symbols[k].range.lo));
    add(groups.back()[1], w, Affine(symbols[k].range.hi));
  }
  std::map<int, std::vector<Alternative>> words;
  for (const auto& [n, w] : l.of_node) {
    const Vector<Form>& forms = nodes[n].forms;
    std::vector<Alternative>& of_word = words[nodes[n].word];
    of_word.resize(forms.size(), none);
    for (size_t i = 0; i < forms.size(); ++i) {
      Affine at = affine(forms[i].mid);
      for (const Term& t : forms[i].terms) {
        if (symbols[t.symbol].kind == kError) refuse("a number of a hash that was rounded");
        if (symbols[t.symbol].kind == kPlace)
          add_place(at, t);
        else
          at.r += t.d.size() * symbols[t.symbol].range.size();
      }
      add(of_word[i], w, at);
    }
  }
  for (auto& [word, of_word] : words) groups.push_back(std::move(of_word));
  size_t total = 0;
  for (auto& group : groups) {
    for (Alternative& a : group) {
      for (size_t k = 0; k < count; ++k)
        a.rest += (a.by[k].r + 0x1p-40 * a.by[k].size()) * range(shared[k]).size();  // the sums below round, too
    }
    total += group.size();
  }
  std::vector<double> low(total), step(total * count);
  double most = -INFINITY, least = INFINITY;
  for (int corner = 0; corner < corners; ++corner) {
    size_t at = 0;
    for (const auto& group : groups) {
      for (const Alternative& a : group) {
        double sum = 0;
        for (size_t k = 0; k < count; ++k) {
          const double d = a.by[k].at[corner];
          const Interval e = range(shared[k]);
          sum += d * e.lo;
          step[k * total + at] = d * (e.hi - e.lo);
        }
        low[at++] = sum;
      }
    }
    std::vector<double> value = low;
    for (unsigned i = 0, ends = 0; i < 1u << count; ++i) {
      if (i != 0) {  // one error goes to its other end
        const int k = std::countr_zero(i);
        const double sign = ends >> k & 1 ? -1 : 1;
        ends ^= 1u << k;
        for (size_t j = 0; j < total; ++j) value[j] += sign * step[k * total + j];
      }
      double up = 0, down = 0;
      size_t j = 0;
      for (const auto& group : groups) {
        double best = -INFINITY, worst = INFINITY;
        for (const Alternative& a : group) {
          best = std::max(best, value[j] + a.rest), worst = std::min(worst, value[j] - a.rest);
          ++j;
        }
        up += best, down += worst;
      }
      most = std::max(most, up), least = std::min(least, down);
    }
  }
  return {-std::max(-least, -least * kSafe), std::max(most, most * kSafe)};
}

// For a step that does not know lazy numbers: one that can be anything in its range, and is off by its error.
inline int settled(int n) {
  if (nodes[n].joined >= 0) return nodes[n].joined;
  const Linear& l = linear(n);
  const Interval exact = ends_of(l, true), error = ends_of(l, false) + l.off;
  Form f;
  f.mid = point(middle(exact));
  const double half = reach(exact, f.mid.lo);
  f.range = hull(meet(range_of(n), exact + error), exact);
  f.grid = grid_of(n);
  f.terms.push_back({symbol(kChoice, {-half, half}), {1, 1}});
  f.terms.push_back({symbol(kError, error), {1, 1}});
  const int settled = node(0, {f});
  nodes[n].joined = settled;
  return settled;
}

}  // namespace hn::prover
