// Integers of HN_FIXED that count something, and exact floats beside them.
//
// A number is lazy where the hashes of several points meet in it, or a step has rounded: a node records its step, and
// which numbers the result can be. In the end it is written as a sum (linear.hpp).
#pragma once

#include "tables.hpp"

namespace hn::prover {

inline Interval range_of(int n) {
  const Node& x = nodes[n];
  if (!x.lazy) {
    Interval range = x.forms[0].range;
    for (const Form& f : x.forms) range = hull(range, f.range);
    return range;
  }
  if (x.leaf < 0) return x.forms[0].range;
  const double scale = std::ldexp(1.0, x.shift);
  if (x.made == '>') {
    const Interval of = range_of(x.left);
    return {std::floor(of.lo / scale), std::floor(of.hi / scale)};
  }
  if (x.made == '&') {
    const Interval of = range_of(x.left);
    const double from = std::floor(of.lo / scale) * scale;
    return of.hi < from + scale ? of - point(from) : Interval{0, scale - 1};
  }
  if (x.made == '*' && nodes[x.right].leaf == -1) return range_of(x.left) * range_of(x.right);
  return table(n).whole;
}

// Its range is not computed if it is made of one integer: that has a table.
template <typename Range>
Float lazily(char how, int a, int b, int shift, int grid, const Range& range) {
  Form f;
  f.grid = grid, f.bits = 99;
  const int n = node(0, {f});
  Node& x = nodes[n];
  x.lazy = true, x.made = how, x.left = a, x.right = b, x.shift = shift;
  if (b >= 0)
    only_leaf(n, {a, b});
  else
    only_leaf(n, {a});
  if (nodes[n].leaf < 0) {
    const Interval found = range();
    nodes[n].forms[0].range = nodes[n].forms[0].mid = found;
  }
  return Float::at(n);
}
inline bool of_one(int n) { return nodes[n].leaf >= 0; }
inline bool is_known(int n) {
  return nodes[n].word == 0 && !nodes[n].lazy && nodes[n].leaf == -1 && nodes[n].forms[0].terms.empty();
}
inline bool of_a_choice(int n) {
  for (const Term& t : nodes[n].forms[0].terms) {
    if (symbols[t.symbol].kind == kChoice) return true;
  }
  return false;
}
// A form of places alone, which are several or come from floats.
inline bool is_of_places(int n) {
  const Node& x = nodes[n];
  return x.word == 0 && !x.lazy && x.leaf < 0 && !of_a_choice(n);
}
inline int grid_of(int n) {
  int grid = nodes[n].forms[0].grid;
  for (const Form& f : nodes[n].forms) grid = std::min(grid, f.grid);
  return grid;
}
inline bool is_counted(Float a, Float b, char how) {
  if constexpr (!kFixed) return false;
  const Node &x = nodes[a.n], &y = nodes[b.n];
  if (x.lazy || y.lazy || (x.word != 0 && y.word != 0 && x.word != y.word)) return true;
  if (how != '*' || is_known(a.n) || is_known(b.n)) return false;
  if ((x.word != 0 || y.word != 0) && (x.forms[0].rounds() || y.forms[0].rounds())) return true;
  return (of_one(a.n) && of_one(b.n)) || of_a_choice(a.n) || of_a_choice(b.n);
}

// (d >> p) (t >> q) + (d >> (p + q)) (t & (2^q - 1)) is d t / 2^(p + q), less the bits that the shifts of d leave out:
// with d = 2^p d_1 + u = 2^(p + q) d_2 + v and t = 2^q t_1 + t_2 it is the quotient less u t_1 / 2^p + v t_2 / 2^(p +
// q).
inline bool product_in_halves(Float a, Float b, Float* out) {
  const Node x = nodes[a.n], y = nodes[b.n];
  if (x.made != '*' || y.made != '*') return false;
  const Node t1 = nodes[x.right], d2 = nodes[y.left], t2 = nodes[y.right];
  const Node d1 = nodes[x.left];
  if (t1.made != '>' || d2.made != '>' || t2.made != '&' || t1.left != t2.left || t1.shift != t2.shift) return false;
  const int q = t1.shift, p = d2.shift - q;
  if (p == 0 ? x.left != d2.left : d1.made != '>' || d1.left != d2.left || d1.shift != p) return false;
  const double bias = nodes[d2.left].bias * 2;
  if ((bias != 0 && (bias == std::ldexp(1.0, p) || bias == std::ldexp(1.0, p + q))) ||
      nodes[t1.left].bias * 2 == std::ldexp(1.0, q))
    return false;
  const int grid = grid_of(d2.left);
  const auto left_out = [&](int k) { return grid >= k ? Interval{} : Interval{-(1 - std::ldexp(1.0, grid - k)), 0}; };
  const Interval off = left_out(p) * range_of(x.right) + left_out(p + q) * range_of(y.right);
  const double scale = std::ldexp(1.0, -p - q);
  *out = lazily('p', d2.left, t1.left, p + q, 0,
                [&] { return range_of(d2.left) * range_of(t1.left) * point(scale) + off; });
  nodes[out->n].off = off;
  return true;
}
// a 2^k + t (b - a) / 2^s: an interpolation by t / 2^(s + k), and between its ends.
inline bool interpolation(Float a, Float b, Float* out) {
  const Node product = nodes[b.n];
  if ((product.made != 'p' && product.made != '*') || nodes[product.left].made != '-') return false;
  const int other = nodes[product.left].right, left = nodes[product.left].left;
  double scale = 1;
  if (other != a.n &&
      (nodes[a.n].made != '*' || nodes[a.n].left != other || !is_constant(Float::at(nodes[a.n].right), &scale)))
    return false;
  const Interval s = point(scale), per = point(std::ldexp(1.0, -product.shift)), t = range_of(product.right) * per;
  const auto at = [&](double x) { return range_of(other) * (s - point(x)) + range_of(left) * point(x); };
  *out = lazily('l', a.n, b.n, 0, std::min(grid_of(a.n), grid_of(b.n)),
                [&] { return hull(at(t.lo), at(t.hi)) + product.off; });
  nodes[out->n].other = other;
  return true;
}
inline Float exact_sum(Float a, Float b, double sign);
inline Float exact_product(Float a, Float b);
inline Float shifted(Float a, int k);
// (g >> k) x + (((g & (2^k - 1)) x) >> k) is (g x) >> k: the first product is whole.
inline bool product_by_low_bits(Float a, Float b, Float* out) {
  const Node high = nodes[a.n], y = nodes[b.n];
  if (high.made != '*' || y.made != '>' || nodes[y.left].made != '*') return false;
  const Node low = nodes[y.left], g = nodes[high.left], rest = nodes[low.left];
  if (g.made != '>' || rest.made != '&' || g.left != rest.left || g.shift != rest.shift || g.shift != y.shift ||
      high.right != low.right || nodes[y.left].bias != 0 || nodes[g.left].bias != 0)
    return false;
  *out = shifted(exact_product(Float::at(g.left), Float::at(high.right)), g.shift);
  return true;
}
inline Float counted_sum(Float a, Float b, double sign) {
  Float found(0.0f);
  if (sign > 0 && (product_in_halves(a, b, &found) || product_by_low_bits(a, b, &found) ||
                   interpolation(a, b, &found) || interpolation(b, a, &found)))
    return found;
  for (int swap = 0; swap < 2 && sign > 0; ++swap, std::swap(a, b)) {
    const Node x = nodes[a.n];
    if (x.made != '+' && x.made != 'l') continue;
    if (product_in_halves(Float::at(x.right), b, &found)) return exact_sum(Float::at(x.left), found, 1);
    if (x.made == '+' && is_known(x.right) && interpolation(Float::at(x.left), b, &found))
      return exact_sum(found, Float::at(x.right), 1);
  }
  found = lazily(sign > 0 ? '+' : '-', a.n, b.n, 0, std::min(grid_of(a.n), grid_of(b.n)),
                 [&] { return range_of(a.n) + range_of(b.n) * point(sign); });
  double bias = 0;
  if (sign > 0 && (is_constant(b, &bias) || is_constant(a, &bias))) nodes[found.n].bias = bias;
  return found;
}
inline Float counted_product(Float a, Float b) {
  double x;
  if (is_constant(a, &x)) std::swap(a, b);
  return lazily('*', a.n, b.n, 0, grid_of(a.n) + grid_of(b.n), [&] { return range_of(a.n) * range_of(b.n); });
}
// A float that was made exactly.
inline Float exactly(Float f) {
  if (!of_one(f.n) && range_of(f.n).size() > std::ldexp(1.0, grid_of(f.n) + 24)) throw TooLarge{"a float that rounds"};
  return f;
}

// --- Steps of integers -----------------------------------------------------------------------------------------------

inline Float exact_sum(Float a, Float b, double sign) {
  if (a.n == b.n && sign > 0 && !nodes[a.n].lazy) return exact_product(a, Float(2.0f));  // which is even
  if (is_counted(a, b, '+')) return counted_sum(a, b, sign);
  Float f = made(each(a, b,
                      [&](const Form& x, const Form& y) {
                        Form g = plus(x, y, sign);
                        g.tighten();
                        return g;
                      }),
                 sign > 0 ? '+' : '-', a, b);
  if (sign > 0) is_constant(b, &nodes[f.n].bias) || is_constant(a, &nodes[f.n].bias) || (nodes[f.n].bias = 0);
  return f;
}
// A factor, as the number that it stands for.
inline Form meant(const Form& x) {
  const double computed = x.range.lo;
  if (!kFixed || !x.terms.empty()) return x;
  const Interval exact = meaning(computed);
  if (exact.lo == exact.hi) return x;
  Form f = x;
  f.mid = exact, f.range = hull(x.range, exact);
  add_error(f, point(computed) - exact);
  return f;
}
inline Float exact_product(Float a, Float b) {
  if (is_counted(a, b, '*')) return counted_product(a, b);
  return made(each(a, b,
                   [](const Form& x, const Form& y) {
                     Form f = times(meant(x), meant(y));
                     f.tighten();
                     return f;
                   }),
              '*', a, b);
}
inline Float shifted(Float a, int k) {
  for (const auto& [by, n] : nodes[a.n].shifted) {
    if (by == k) return Float::at(n);
  }
  const double scale = std::ldexp(1.0, -k);
  const int grid = grid_of(a.n);
  Float f(0.0f);
  const double half = kFixed && nodes[a.n].bias * scale == 0.5 ? 0.5 : 0;
  if (!kFixed || is_of_places(a.n)) {  // by class of a word
    f = made(each(a,
                  [&](const Form& x) {
                    Form g = plus(times(x, constant(scale)), constant(half), -1);
                    const Interval exact = g.range, sum = x.range * point(scale);
                    if (kFixed && x.terms.empty() && exact.lo == exact.hi && exact.lo == std::floor(sum.lo))
                      return constant(exact.lo);
                    if (x.grid < k) add_error(g, {half + std::ldexp(1.0, x.grid - k) - 1, half});
                    g.range = meet(g.range, hull(exact, {std::floor(sum.lo), std::floor(sum.hi)}));
                    g.grid = std::max(0, x.grid - k);
                    return g;
                  }),
             '>', a);
    nodes[f.n].shift = k;
  } else if (!nodes[a.n].lazy && grid >= k) {
    f = exact_product(a, Float(static_cast<float>(scale)));
    nodes[f.n].made = '>', nodes[f.n].left = a.n, nodes[f.n].right = -1, nodes[f.n].shift = k;
  } else {
    f = lazily('>', a.n, -1, k, std::max(0, grid - k), [&] {
      const Interval of = range_of(a.n) * point(scale);
      return Interval{std::floor(of.lo), std::floor(of.hi)};
    });
    nodes[f.n].off = {half - (grid < k ? 1 - std::ldexp(1.0, grid - k) : 0), half};
    if (half == 0 && grid >= k) nodes[f.n].off = {};
  }
  nodes[a.n].shifted.push_back({k, f.n});
  return f;
}
inline Float quotient(Float a, Float b) {
  double by;
  if (!of_one(a.n) || !is_constant(b, &by) || by <= 0) refuse("a quotient of integers");
  return lazily('/', a.n, b.n, 0, 0, [] { return Interval{}; });
}
inline bool is_of_one(Float a, Float b) {  // and nothing but steps of that
  if (of_one(a.n) && of_one(b.n)) return nodes[a.n].leaf == nodes[b.n].leaf;
  return (of_one(a.n) && is_known(b.n)) || (of_one(b.n) && is_known(a.n));
}
// A step that rounds saturates, which is no step in exact arithmetic: so the sum with half is handed on.
inline Float least_of_one(Float a, Float b) {
  const Float f = lazily('m', a.n, b.n, 0, 0, [] { return Interval{}; });
  if (is_known(b.n)) nodes[f.n].bias = nodes[a.n].bias;
  return f;
}
// The less of a number of places and a constant. After a sum that rounds it is no step, and takes 1 at most.
inline Float least_of_places(Float a, Float b) {
  const Node& of = nodes[a.n];
  const Form &x = of.forms[0], &y = nodes[b.n].forms[0];
  const double most = y.range.hi;
  if (x.range.hi <= most) return a;
  if (of.made == '>' && nodes[of.left].bias * 2 == std::ldexp(1.0, of.shift)) {
    if (x.range.hi > most + 1) throw TooLarge{"a number that saturates"};
    Form f = x;
    f.terms.push_back({symbol(kError, {-1, 0}), {1, 1}});
    f.range.lo = std::min(f.range.lo, most);
    return Float::of(f);
  }
  if (x.range.lo >= most) return b;
  return Float::of(
      either(x, y, {std::min(x.range.lo, most), most}, {std::min(x.mid.lo, most), std::min(x.mid.hi, most)}));
}
inline Float low_bits(Float a, int k) {
  return lazily('&', a.n, -1, k, std::min(grid_of(a.n), k), [&] { return Interval{0, std::ldexp(1.0, k) - 1}; });
}
// A float of a binade, as its bits: they count up with it.
inline Float as_bits(Float a) {
  const Interval range = range_of(a.n);
  const double low = std::ldexp(1.0, std::ilogb(range.lo));
  if (range.lo <= 0 || range.hi > 2 * low) throw TooLarge{"the bits of floats of two binades"};
  const float per = static_cast<float>(0x1p23 / low);
  return exact_sum(exact_product(exact_sum(a, Float(static_cast<float>(low)), -1), Float(per)),
                   Float(static_cast<float>(std::bit_cast<std::uint32_t>(static_cast<float>(low)))), 1);
}

}  // namespace hn::prover
