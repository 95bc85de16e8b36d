// Quotients, roots, lengths, and the order of numbers.
//
// A LENGTH is Lipschitz: sqrt(sum of w x'^2) is off sqrt(sum of w x^2) by no more than the length of the errors x' - x
// is (the triangle inequality), wherever the vector is, at 0 too. The same holds of fourth powers and their fourth
// root. Each rounding of a square or of a sum of positive numbers is relative, so that n of them, one after another,
// move the p-th root by at most (1 + u)^(n/p) - 1 of it; one that goes to 0 takes less than 2^-126 from a summand.
//
// The K-TH SMALLEST of several numbers lies between L and K, the k-th smallest of their lower and of their upper ends.
// It is the same if each of them is clamped to [L, K] first, rounded or not. It changes by no more than one of them
// does: so its error is at most the worst number's, and of this only alternatives that meet [L, K] count. The
// text finds it by sorted insertions:
//
//   k-th of (C and r) = min(k-th of C, max((k-1)-th of C, r))
//
// and a root rises, so that the root of the k-th is the k-th of the roots.
#pragma once

#include "floats.hpp"

namespace hn::prover {

constexpr double kUnit = 0x1p-23 * (1 + 0x1p-10);  // a rounding, relative; products of roundings included
constexpr double kRootUlps = 6, kQuotientUlps = 3;
constexpr double kRoom = 1 + 0x1p-18;  // a computed number may be so much more
// How long, in exact arithmetic, the k-th smallest length is known to be at most, and so a vector if a result is its
// direction.
inline double longest = INFINITY;

inline Interval root_of(Interval x) {
  return {-(-std::sqrt(std::max(x.lo, 0.0)) * (1 - 0x1p-50)), std::sqrt(std::max(x.hi, 0.0))};
}
inline Interval reciprocal(Interval x) {
  if (x.lo <= 0 && x.hi >= 0) throw TooLarge{"a quotient by what may be 0"};
  return {-(-1 / x.hi), 1 / x.lo};
}
inline Form within(Form f, double ulps_off) {
  f.tighten();
  if (!(f.range.size() < kLargest / 2)) throw TooLarge{"a number beyond floats"};
  f.grid = kNoGrid, f.bits = 24;
  const double off = ulps_off * ulp(f.range.size()) + kTiny;
  add_error(f, {-off, off});
  return f;
}
inline Float ratio(Float a, Float b) {
  return each(a, b, [](const Form& x, const Form& y) {
    const Interval by = reciprocal(y.range), quotient = x.range * by;
    Form f;
    f.range = quotient, f.mid = x.mid * reciprocal(y.mid);
    f.terms = combined(x, by, y, -(hull(quotient, f.mid) * by));
    return within(std::move(f), kQuotientUlps);
  });
}

// --- Powers ---------------------------------------------------------------------------------------------------------

inline Float with_powers(Float f, char how, Float a, Float b) {
  const Node::Powers p = nodes[a.n].powers, q = nodes[b.n].powers;
  Node::Powers& out = nodes[f.n].powers;
  double scale = 0;
  if (how == '*' && a.n == b.n) {
    for (Form& x : nodes[f.n].forms) x.range.lo = std::max(x.range.lo, 0.0);
    if (p.power == 2 && p.of.size() == 1 && p.of[0].second == 1)
      out = {p.of, 4, 2 * p.roundings + 1};
    else
      out = {{{a.n, 1}}, 2, 1};
  } else if (how == '*' && p.power != 0 && p.part == 1 && is_constant(b, &scale) && scale > 0 &&
             std::ldexp(1.0, std::ilogb(scale)) == scale) {
    out = p;
    for (auto& [n, w] : out.of) w *= scale;
  } else if (how == '+' && p.power != 0 && p.part == 1) {
    out = p;
    if (q.power == p.power && q.part == 1) {
      out.of.insert(out.of.end(), q.of.begin(), q.of.end());
      out.roundings = std::max(p.roundings, q.roundings) + 1;
    } else if (is_constant(b, &scale) && scale == 0) {
    } else if (is_constant(b, &scale) && scale > 0) {
      out.of.push_back({b.n, -scale});
      ++out.roundings;
    } else {
      out = {};
    }
  } else if (how == '+' && q.power != 0) {
    double zero = 1;
    if (is_constant(a, &zero)) return with_powers(f, how, b, a);
  }
  return f;
}

// The largest error of an alternative of a number that is not negative, where that is at most `most`, exact as well as
// computed: then so is each number that it is the sum or the larger one of, and a number that is squared is at most the
// root.
inline double error_up_to(int n, int word, size_t i, double most) {
  const auto within = [word](int m) {
    return m >= 0 && nodes[m].word != 0 && nodes[m].word != word ? joined_node(m) : m;
  };
  const auto form = [i](int m) -> const Form& { return nodes[m].forms[nodes[m].word != 0 ? i : 0]; };
  const auto rounding = [](double size) { return ulp(size) + kTiny; };
  n = within(n);
  const double own = form(n).error().size();
  const char how = nodes[n].made;
  most = std::min(most, form(n).range.size());
  double found = own;
  const int of = how == 'Q' ? nodes[n].left : n;  // a root
  if (const Node::Powers p = nodes[of].powers; p.power == 2 && p.part >= 0.5) {
    const bool is_length = p.part == 0.5;
    const double length = is_length ? most : std::sqrt(most);
    double off = 0;
    for (const auto& [m, w] : p.of) {
      if (w <= 0) return own;
      const double e = error_up_to(m, word, i, length / std::sqrt(w) * kRoom);
      off += w * e * e;
    }
    off = std::sqrt(off);
    if (is_length)
      found = off + most * p.roundings * kUnit / 2 + std::sqrt(4 * p.of.size() * kTiny) +
              (how == 'Q' ? kRootUlps * ulp(most * kRoom) + kTiny : 0);
    else
      found = (2 * length + off) * off + most * p.roundings * kUnit + p.of.size() * kTiny;
  } else if (double scale = 0; how == '*' && is_constant(Float::at(nodes[n].right), &scale) && scale == 0.5) {
    found = error_up_to(nodes[n].left, word, i, 2 * most) / 2 + kTiny;
  } else if (how == 'a') {
    found = error_up_to(nodes[n].left, word, i, most);
  } else if (how == '+' || how == '-' || how == 'M') {
    const int left = within(nodes[n].left), right = within(nodes[n].right);
    const double x = form(left).range.lo, y = form(right).range.lo;
    double least = 0, from = 0;
    if (const Node& down = nodes[left]; how == 'M' && down.made == '-' && is_constant(Float::at(right), &least) &&
                                        is_constant(Float::at(down.left), &from) && least >= 0 && from >= least) {
      // max(from - x, least), of an x that is not negative: where it is larger, that is as good as the other end.
      const int other = within(down.right);
      if (form(other).range.lo < 0) return own;
      found = error_up_to(other, word, i, (from - least + own) * kRoom) + rounding(from);
    } else if (how == 'M') {
      if (x < 0 || y < 0) return own;
      found = std::max(error_up_to(left, word, i, most), error_up_to(right, word, i, most));
    } else if (how == '+' && x >= 0 && y >= 0) {
      found = error_up_to(left, word, i, std::max(most * kRoom - y, 0.0)) +
              error_up_to(right, word, i, std::max(most * kRoom - x, 0.0)) + rounding(most);
    } else {
      found = form(left).error().size() + form(right).error().size() + rounding(most);
    }
  }
  return std::min(own, found);
}

// The length as a form: its middle is its range, and all that it knows of symbols are a slope and an error.
inline Form length_of(const Node::Powers& powers, int word, size_t i) {
  const double p = powers.power;
  const auto pth = [p](double x) { return std::sqrt(p == 2 ? x : std::sqrt(x)); };
  double error = 0, slope = 0, lo = 0, hi = 0;
  for (const auto& [n, w] : powers.of) {
    const auto raised = [p](double x) { return p == 2 ? x * x : x * x * (x * x); };
    if (w < 0) {  // a constant, as it is
      lo = -(-lo + w), hi += -w;
      continue;
    }
    const bool is_other = nodes[n].word != 0 && nodes[n].word != word;  // then each of its alternatives may be
    const Form x = is_other ? nodes[joined_node(n)].forms[0] : nodes[n].forms[nodes[n].word != 0 ? i : 0];
    double off = is_other ? 0 : error_up_to(n, word, i, x.range.size());
    for (size_t j = 0; is_other && j < nodes[n].forms.size(); ++j)
      off = std::max(off, error_up_to(n, nodes[n].word, j, nodes[n].forms[j].range.size()));
    const double least = x.range.lo > 0 ? x.range.lo : x.range.hi < 0 ? -x.range.hi : 0;
    error += w * raised(off), slope += w * raised(x.moved());
    lo = -(-lo - w * raised(least) * (1 - 0x1p-48)), hi += w * raised(x.range.size());
  }
  error = pth(error);
  Form f;
  f.range = f.mid = {-(-pth(lo) * (1 - 0x1p-48)), pth(hi)};
  error += f.mid.hi * powers.roundings * kUnit / p + pth(4 * powers.of.size() * kTiny);
  f.add_slope(pth(slope));
  add_error(f, {-error, error});
  f.range.lo = std::max(f.range.lo, 0.0);
  return f;
}

// A component of a DIRECTION is one of a vector over its length, or over a least length. Let the vector be off by e, as
// a norm. If it is longer than that, it turns by an angle with a sine of e over the length at most; below a right angle
// a chord is at most sqrt(2) times the sine. So the error times the length is sqrt(2) e at most, and the part that the
// length and the quotient round by, relative to the length. If the vector is shorter, the component is off by 2 at
// most.
constexpr double kLeastLength = 0x1p-47;
inline const Node::Powers* vector_of(Float a, Float b) {
  if (nodes[b.n].made != 'Q') return nullptr;
  int n = nodes[b.n].left;
  if (nodes[n].made == 'M' && nodes[nodes[n].right].forms[0].range.hi < kLeastLength) n = nodes[n].left;
  const Node::Powers& p = nodes[n].powers;
  bool is_in = false, alike = p.power == 2 && p.part == 0.5;
  for (const auto& [m, w] : p.of) is_in |= m == a.n, alike &= w == 1 && nodes[m].word == nodes[a.n].word;
  return is_in && alike ? &p : nullptr;
}
inline Float operator/(Float a, Float b) {
  const Node::Powers* const vector = vector_of(a, b);
  if (!vector) return ratio(a, b);
  const Node::Powers p = *vector;
  const double steps = (p.roundings / 2.0 + kRootUlps + kQuotientUlps) * kUnit;
  double most = 0;
  Vector<Form> forms;
  for (size_t i = 0; i < nodes[a.n].forms.size(); ++i) {
    double e = 0, length = 0;
    for (const auto& [n, w] : p.of) {
      const double off = error_up_to(n, nodes[n].word, i, longest * kRoom), size = nodes[n].forms[i].exact().size();
      e += off * off, length += size * size;
    }
    e = std::sqrt(e) + 2 * kLeastLength;
    if (e > longest * (kRoom - 1)) throw TooLarge{"an error of a length"};
    most = std::max({most, std::sqrt(2) * e + steps * std::min(std::sqrt(length), longest), (2 + steps) * e});
    Form f;
    f.range = Interval{-1 - steps, 1 + steps}, f.mid = {-1, 1};
    f.add_slope(kLargest);
    add_error(f, {-2 - steps, 2 + steps});
    forms.push_back(std::move(f));
  }
  bool may_be_0 = false;
  for (const Form& f : nodes[b.n].forms) may_be_0 |= f.range.lo <= 0;
  const bool has_least = nodes[nodes[b.n].left].made == 'M';  // else 0 / 0 is no number
  const Float f = may_be_0 && has_least ? Float::at(node(nodes[a.n].word, std::move(forms))) : ratio(a, b);
  nodes[f.n].by_length = most;
  return f;
}

// --- Order ----------------------------------------------------------------------------------------------------------

// The range and the error of each alternative of a node, and the hull of all ranges.
inline const std::vector<Node::Alternative>& alternatives(int n) {
  std::vector<Node::Alternative>& known = nodes[n].alternatives;
  if (known.empty()) {
    known.push_back({nodes[n].forms[0].range, {}});
    for (const Form& f : nodes[n].forms) {
      known.push_back({f.range, f.error()});
      known[0].range = hull(known[0].range, f.range);
    }
  }
  return known;
}
inline Float ranked(std::vector<int> of, int kth, double most = INFINITY) {
  if (of.size() == 1) return Float::at(of[0]);
  std::vector<double> lows, highs;
  for (int n : of) {
    const Interval all = alternatives(n)[0].range;
    lows.push_back(all.lo), highs.push_back(all.hi);
  }
  std::nth_element(lows.begin(), lows.begin() + kth - 1, lows.end());
  std::nth_element(highs.begin(), highs.begin() + kth - 1, highs.end());
  const Interval range{lows[kth - 1], std::max(lows[kth - 1], std::min(highs[kth - 1], most))};
  const auto matters = [&](Interval x) { return x.hi >= range.lo && x.lo <= range.hi; };
  Interval error;
  double slope = 0;
  for (int n : of) {
    const auto some = alternatives(n);
    if (!matters(some[0].range)) continue;
    for (size_t i = 1; i < some.size(); ++i) {
      const Interval own = some[i].error;
      if (!matters(some[i].range)) continue;
      slope = std::max(slope, nodes[n].forms[i - 1].moved());
      if (own.lo >= error.lo && own.hi <= error.hi) continue;
      const double e = error_up_to(n, nodes[n].word, i - 1, some[i].range.lo < 0 ? INFINITY : range.hi + own.size());
      error = hull(error, meet(own, {-e, e}));
    }
  }
  Form f;
  f.range = f.mid = range;
  f.add_slope(slope);
  if (error.lo < 0 || error.hi > 0) f.terms.push_back({symbol(kError, error), {1, 1}});
  const Float out = Float::of(f);
  nodes[out.n].made = 'k', nodes[out.n].candidates = std::move(of), nodes[out.n].kth = kth;
  return out;
}
struct Rank {
  std::vector<int> of;
  int kth;
  bool is_last() const { return kth == static_cast<int>(of.size()); }
};
inline Rank rank_of(Float a) {
  const Node& n = nodes[a.n];
  return n.made == 'k' ? Rank{n.candidates, n.kth} : Rank{{a.n}, 1};
}
inline std::vector<int> united(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}
// Numbers of different hashes, or the k-th smallest of such. All are kept, though some may always be larger: so sets of
// them are the same.
inline bool are_ranks(Float a, Float b) {
  const Node &x = nodes[a.n], &y = nodes[b.n];
  const bool apart = x.word != 0 && y.word != 0 && x.word != y.word;
  const bool joined = x.word == 0 && y.word == 0 && x.powers.power != 0 && y.powers.power != 0;  // squares of several
  double at = 0;
  return (apart || joined || x.made == 'k' || y.made == 'k') && !is_constant(a, &at) && !is_constant(b, &at);
}
// The larger of both, if it is always the same one; else -1.
inline int always_larger(Float a, Float b) {
  const Interval x = alternatives(a.n)[0].range, y = alternatives(b.n)[0].range;
  return x.lo >= y.hi ? a.n : y.lo >= x.hi ? b.n : -1;
}
inline Float larger(Float a, Float b) {
  return each(a, b, [](const Form& x, const Form& y) {
    if (x.range.lo >= y.range.hi) return x;
    if (y.range.lo >= x.range.hi) return y;
    return either_off(x, y, {std::max(x.range.lo, y.range.lo), std::max(x.range.hi, y.range.hi)},
                      {std::max(x.mid.lo, y.mid.lo), std::max(x.mid.hi, y.mid.hi)});
  });
}
inline Float new_max(Float a, Float b) {
  if (are_ranks(a, b)) {
    const Rank x = rank_of(a), y = rank_of(b);
    std::vector<int> both = united(x.of, y.of);
    const int count = static_cast<int>(both.size());
    if (x.is_last() && y.is_last()) return ranked(std::move(both), count);
  } else if (const int n = always_larger(a, b); n >= 0) {
    return Float::at(n);
  }
  return made(larger(a, b), 'M', a, b);
}
inline Float max(Float a, Float b) {
  return Float::at(once('M', a.n, b.n, 0, [&] { return new_max(a, b).n; }));
}
inline Float new_min(Float a, Float b) {
  if (!are_ranks(a, b)) {
    if (const int n = always_larger(a, b); n >= 0) return n == a.n ? b : a;
    return made(-larger(-a, -b), 'n', a, b);
  }
  if (nodes[a.n].made == 'M') std::swap(a, b);
  const Rank x = rank_of(a), y = rank_of(b);
  if (nodes[b.n].made == 'M') {
    const Rank lower = rank_of(Float::at(nodes[b.n].left));
    std::vector<int> more = united(x.of, {nodes[b.n].right});
    if (lower.of == x.of && lower.kth + 1 == x.kth && more.size() > x.of.size()) return ranked(std::move(more), x.kth);
  } else if (x.kth == 1 && y.kth == 1) {
    return ranked(united(x.of, y.of), 1);
  }
  return made(-larger(-a, -b), 'n', a, b);
}

inline Float min(Float a, Float b) {
  return Float::at(once('n', a.n, b.n, 0, [&] { return new_min(a, b).n; }));
}

// --- Roots ----------------------------------------------------------------------------------------------------------

// The exact root of a number that was computed.
inline Float root(Float a) {
  const auto key = step_key('r', a.n, 0);
  if (const auto found = same.find(key); found != same.end()) return Float::at(found->second);
  const Node n = nodes[a.n];
  Float out = a;
  if (n.made == 'k') {
    std::vector<int> roots;
    for (int c : n.candidates) roots.push_back(root(Float::at(c)).n);
    std::sort(roots.begin(), roots.end());  // also one that is several's: each counts
    out = ranked(std::move(roots), n.kth, longest * kRoom);
    if (longest < INFINITY && out.form().error().size() > longest * (kRoom - 1)) throw TooLarge{"an error of a length"};
  } else if (n.made == 'M' || n.made == 'n') {
    const Float x = root(Float::at(n.left)), y = root(Float::at(n.right));
    out = n.made == 'M' ? max(x, y) : min(x, y);
  } else {
    Vector<Form> forms;
    for (size_t i = 0; i < n.forms.size(); ++i) {
      const Form& x = n.forms[i];
      if (n.powers.power * n.powers.part == 2) {
        forms.push_back(length_of(n.powers, n.word, i));
        continue;
      }
      if (x.range.lo <= 0) throw TooLarge{"a root of what may be 0"};
      Form f;
      f.range = root_of(x.range), f.mid = root_of(x.mid);
      const Interval d = reciprocal(hull(f.range, f.mid)) * point(0.5);
      for (const Term& t : x.terms) f.terms.push_back({t.symbol, t.d * d});
      forms.push_back(f);
    }
    out = Float::at(node(n.word, std::move(forms)));
    if (n.powers.power != 0) nodes[out.n].powers = n.powers, nodes[out.n].powers.part = n.powers.part / 2;
  }
  same[key] = out.n;
  return out;
}
inline Float new_sqrt(Float a) {
  const Float exact = root(a);
  const Float out = each(exact, [](const Form& x) { return within(x, kRootUlps); });
  nodes[out.n].made = 'Q', nodes[out.n].left = exact.n;
  if (nodes[exact.n].powers.part * nodes[exact.n].powers.power > 1) {
    nodes[out.n].powers = nodes[exact.n].powers;
    // 6 ulp of it are 12 of its square.
    nodes[out.n].powers.roundings += static_cast<int>(kRootUlps * 2);
  }
  return out;
}
inline Float sqrt(Float a) {
  return Float::at(once('Q', a.n, 0, 0, [&] { return new_sqrt(a).n; }));
}

}  // namespace hn::prover
