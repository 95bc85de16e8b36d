// Numbers of HN_FIXED: integers that count something, and exact floats beside them.
//
// A number is lazy where the hashes of several points meet in it, or a step has rounded: a node records its step, and
// which numbers the result can be. In the end such a number is written as a sum
//
//   w_0 + sum of w_l n_l        n_l numbers of a hash, w_l numbers without one
//
// and each error of w_l, which others share, has a derivative that is an Affine of the place. So the size of the
// result's error, for each class of each hash, is convex along each axis and in each such error: it is largest at ends.
//
// The exact number of a step: a shift by k divides by 2^k, after a sum with half of that it rounds, so
// the half does not count;
// the low bits that it leaves are 0, and a mask of bits that are 0 anyway is no step; a minimum with a constant
// after such a sum is no step. All else is as written.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "roots.hpp"

namespace hn::prover {

// --- Functions of the place in a box --------------------------------------------------------------------------------

constexpr int kAxes = 4;
constexpr double kSafe = 1 + 1e-12;
constexpr double kRounding = 0x1p-50;  // more than what two or three steps of doubles add, relative

inline int corners = 1;  // of the box: 2^axes

// A function that is affine along each axis is known by its values in the corners of the box; this is one, off by r at
// most. Along an axis it changes by twice `slope` at most, from one end to the other. All that counts along an axis,
// from -1 to 1, is the place, or else a function of it, its first table: so a noise is nearly affine in its fades.
struct Affine {
  double at[1 << kAxes], slope[kAxes] = {}, r = 0;
  explicit Affine(double v = 0) { std::fill_n(at, corners, v); }
  double size() const {
    double most = 0;
    for (int i = 0; i < corners; ++i) most = std::max(most, std::fabs(at[i]));
    return most + r;
  }
  Interval range() const {
    const auto [lo, hi] = std::minmax_element(at, at + corners);
    return {-(r - *lo), *hi + r};
  }
};
inline Affine plus(const Affine& a, const Affine& b, double sign) {
  Affine c;
  for (int i = 0; i < corners; ++i) c.at[i] = a.at[i] + sign * b.at[i];
  for (int i = 0; i < kAxes; ++i) c.slope[i] = a.slope[i] + b.slope[i];
  c.r = a.r + b.r + kRounding * (a.size() + b.size());
  return c;
}
// Along an axis (u + v x) (p + q x) is v q (1 - x^2) below the function that is affine there, and taking the one for
// the other along one axis after another, which is a mean, adds that up.
inline Affine times(const Affine& a, const Affine& b) {
  Affine c;
  const double p = a.size(), q = b.size();
  c.r = a.r * q + b.r * p + kRounding * p * q;
  for (int i = 0; i < corners; ++i) c.at[i] = a.at[i] * b.at[i];
  for (int i = 0; i < kAxes; ++i) {
    c.slope[i] = a.slope[i] * q + b.slope[i] * p;
    c.r += a.slope[i] * b.slope[i];
  }
  return c;
}

// A number without a hash: its exact value, and the derivatives by the errors that take it to the computed one,
// wherever these are.
struct Weight {
  Affine exact;
  std::vector<std::pair<int, Affine>> errors;  // by symbol
  Affine anywhere() const {                    // exact, computed and between
    Affine a = exact;
    for (const auto& [k, d] : errors) a.r += d.size() * symbols[k].range.size();
    return a;
  }
};
inline Weight constant_weight(double v) { return {Affine(v), {}}; }
template <typename Step>
Weight merged(const Weight& a, const Weight& b, const Step& step) {
  Weight c;
  const Affine zero;
  auto i = a.errors.begin(), j = b.errors.begin();
  while (i != a.errors.end() || j != b.errors.end()) {
    if (j == b.errors.end() || (i != a.errors.end() && i->first < j->first)) {
      c.errors.push_back({i->first, step(i->second, zero)});
      ++i;
    } else if (i == a.errors.end() || j->first < i->first) {
      c.errors.push_back({j->first, step(zero, j->second)});
      ++j;
    } else {
      c.errors.push_back({i->first, step(i->second, j->second)});
      ++i, ++j;
    }
  }
  return c;
}
inline Weight plus(const Weight& a, const Weight& b, double sign) {
  Weight c = merged(a, b, [&](const Affine& x, const Affine& y) { return plus(x, y, sign); });
  c.exact = plus(a.exact, b.exact, sign);
  return c;
}
inline Weight times(const Weight& a, const Weight& b) {
  const Affine p = a.anywhere(), q = b.anywhere();
  Weight c = merged(a, b, [&](const Affine& x, const Affine& y) { return plus(times(x, q), times(y, p), 1); });
  c.exact = times(a.exact, b.exact);
  return c;
}

// The interval of a derivative as its middle and half of its width.
inline Affine affine(Interval d) {
  Affine a(middle(d));
  a.r = reach(d, middle(d));
  return a;
}
struct Along {
  bool chosen = false;
  std::uint64_t shape = 0;  // of the table, if it is one
  double off = 0;           // how far it is from the place, in these units
  int node = -1;            // with that table
};
inline Along along[kAxes];
inline void add_along(Affine& a, int axis, double d) {
  for (int i = 0; i < corners; ++i) a.at[i] += i >> axis & 1 ? d : -d;
  a.slope[axis] += std::fabs(d);
  a.r += kRounding * (a.size() + std::fabs(d));
}
inline void add_place(Affine& a, const Term& t) {
  if (t.symbol >= kAxes) refuse("a place of more than four axes");
  along[t.symbol].chosen = true;
  const double half = symbols[t.symbol].range.size(), d = middle(t.d) * half;
  add_along(a, t.symbol, d);
  a.r += reach(t.d, middle(t.d)) * half + std::fabs(d) * along[t.symbol].off;
}

// --- Lazy numbers ---------------------------------------------------------------------------------------------------

inline std::uint64_t mixed(std::uint64_t a, std::uint64_t b) { return (a ^ b) * 0x9E3779B97F4A7C15u + (a >> 29) + 1; }
// Whether low bits are those that a shift leaves.
inline bool are_digits(const Node& low) {
  for (const auto& [by, n] : nodes[low.left].shifted) {
    if (by == low.shift) return true;
  }
  return false;
}
inline std::uint64_t shape(int n) {  // of numbers that are made of one integer: the same steps have the same
  if (nodes[n].shape != 0) return nodes[n].shape;
  const Node& x = nodes[n];
  std::uint64_t h;
  if (x.made == 'L') {
    h = mixed(1, std::uint64_t(x.shift));
  } else if (x.leaf == -1) {
    h = mixed(2, std::bit_cast<std::uint64_t>(x.forms[0].range.lo));
  } else {
    h = mixed(std::uint64_t(x.made), std::uint64_t(x.shift) + (x.made == '&' && are_digits(x) ? 64 : 0));
    for (int m : {x.left, x.right, x.less[0], x.less[1]}) h = mixed(h, m < 0 ? 3 : shape(m));
  }
  return nodes[n].shape = h;
}

// Places are multiples of 2^-place_bits. If that is coarser than a fraction, the text must round it to that.
inline int place_bits = 20;
// The exact number that a constant stands for: the spline's is 2/3 in units of 2^-30, and half of what is cut off.
inline Interval meaning(double constant) {
  constexpr double kTwoThirds = 0x1p30 * 2 / 3;
  return constant == 715829931 ? Interval{std::nextafter(kTwoThirds, 0), std::nextafter(kTwoThirds, 0x1p30)}
                               : point(constant);
}
// Fractions are integers up to this. One that is known is still a number: shifts of it round.
constexpr int kFraction = 1 << 20;
inline size_t place_step() { return size_t{1} << (20 - place_bits); }
inline bool is_fraction(const Form& f) { return f.grid >= 0 && f.range.lo >= 0 && f.range.hi <= kFraction; }

// All values of a number that is made of one integer: as computed, and in exact arithmetic.
struct Column {
  std::vector<double> whole;
  std::vector<Interval> real;
};
inline void fill(int n, double first, size_t count, std::map<int, Column>& known) {
  if (known.count(n)) return;
  const Node x = nodes[n];
  Column c;
  c.whole.resize(count), c.real.resize(count);
  if (x.made == 'L') {
    for (size_t i = 0; i < count; ++i) c.whole[i] = first + i, c.real[i] = point(first + i);
  } else if (x.leaf == -1) {
    std::fill(c.whole.begin(), c.whole.end(), x.forms[0].range.lo);
    std::fill(c.real.begin(), c.real.end(), meaning(x.forms[0].range.lo));
  } else {
    for (int m : {x.left, x.right, x.less[0], x.less[1]}) {
      if (m >= 0) fill(m, first, count, known);
    }
    const Column &a = known[x.left], &b = known[x.right >= 0 ? x.right : x.left];
    const Column &p = known[x.made == 's' ? x.less[0] : x.left], &q = known[x.made == 's' ? x.less[1] : x.left];
    const double scale = std::ldexp(1.0, x.shift), bias = nodes[x.left].bias;
    const Interval per = point(1 / scale);
    const bool digits = x.made == '&' && are_digits(x);
    for (size_t i = 0; i < count; ++i) {
      const double u = a.whole[i], v = b.whole[i];
      const Interval r = a.real[i], s = b.real[i];
      double& w = c.whole[i];
      switch (x.made) {
        case '+':
          w = u + v, c.real[i] = r + s;
          break;
        case '-':
          w = u - v, c.real[i] = r - s;
          break;
        case '*':
          w = u * v, c.real[i] = r * s;
          break;
        case '/':
          w = std::floor(u / v), c.real[i] = {-(-r.lo / s.lo), r.hi / s.lo};
          break;
        case 'm':
          w = std::min(u, v), c.real[i] = x.bias != 0 ? r : Interval{std::min(r.lo, s.lo), std::min(r.hi, s.hi)};
          break;
        case '>':
          w = std::floor(u / scale), c.real[i] = r * per - point(bias * 2 == scale ? 0.5 : 0);
          break;
        case '&':
          w = u - std::floor(u / scale) * scale, c.real[i] = digits ? Interval{} : r;
          if (!digits && (u != w || r.lo < 0 || r.hi >= scale)) refuse("a mask of bits that count");
          break;
        case 's': {
          const bool left = p.whole[i] < q.whole[i];
          w = left ? u : v, c.real[i] = left ? r : s;
          break;
        }
        default:
          refuse("a number that is made of one");
      }
      if (std::fabs(w) > 0x1p52) refuse("a product of integers beyond 52 bits");
      if (x.type != 0 && (w < (x.type == 'i' ? -0x1p31 : 0) || w >= (x.type == 'i' ? 0x1p31 : 0x1p32)))
        throw Unseen{"an integer beyond 32 bits"};
    }
  }
  known[n] = std::move(c);
}
// Where a box is small, or a place is known, few values are wanted: a column is filled in parts of so many values.
constexpr size_t kPart = 4096;
inline std::map<std::pair<std::uint64_t, size_t>, Column> parts_of_columns;
inline const Column& part_of_column(int n, size_t part) {
  const std::pair key{shape(n), part};
  if (const auto found = parts_of_columns.find(key); found != parts_of_columns.end()) return found->second;
  const size_t first = part * kPart, after = size_t(nodes[nodes[n].leaf].shift) + 1 - first, step = place_step();
  std::map<int, Column> known;
  fill(n, first, std::min(kPart + 1, after), known);  // one more, to which a place may be rounded
  Column& c = known[n];
  for (size_t i = 0; i < std::min(kPart, after) && step > 1; ++i) {
    if (c.whole[i] != c.whole[(i + step / 2) / step * step]) refuse("a place that is not rounded");
  }
  return parts_of_columns[key] = std::move(c);
}
inline Column column(int n, size_t lo, size_t hi) {
  Column c;
  for (size_t part = lo / kPart; part <= hi / kPart; ++part) {
    const Column& of = part_of_column(n, part);
    const size_t from = std::max(lo, part * kPart) % kPart, to = std::min(hi - part * kPart + 1, kPart);
    c.whole.insert(c.whole.end(), of.whole.begin() + from, of.whole.begin() + to);
    c.real.insert(c.real.end(), of.real.begin() + from, of.real.begin() + to);
  }
  return c;
}
// In a box: all values, and in exact arithmetic half of both ends' sum and difference, with all between. `bend` is
// of that as what counts along an axis. The values are off by `off` times 1 + tilt u, u what counts along the axis.
struct Table {
  Interval whole, off;
  double sum, difference, bend, tilt;
  Interval rest;
};
inline std::map<std::array<std::uint64_t, 4>, Table> tables;
inline const Table& table(int n) {
  const Form leaf = nodes[nodes[n].leaf].forms[0];
  const int symbol = leaf.terms.empty() ? 0 : leaf.terms[0].symbol;
  if (leaf.terms.size() > 1 || (leaf.terms.size() == 1 && symbols[symbol].kind != kPlace))
    refuse("a function of such an integer");
  Along& axis = along[symbol];
  const size_t lo = size_t(std::ceil(leaf.range.lo)), hi = size_t(leaf.range.hi);
  const auto in_box = [&](std::uint64_t by) {
    const std::array<std::uint64_t, 4> key{shape(n), by, lo, hi};
    const auto found = tables.find(key);
    if (found != tables.end()) return found;
    if (leaf.range.lo < 0 || hi > size_t(nodes[nodes[n].leaf].shift))
      refuse("an integer that is larger than others of its kind");
    const Column c = column(n, lo, hi), other = by != 0 && by != shape(n) ? column(axis.node, lo, hi) : Column{};
    const auto at = [&](const Column& c, size_t f) { return middle(c.real[f - lo]); };
    const auto part = [&](size_t f) {  // what counts along the axis
      if (lo == hi) return 0.0;
      if (by == 0) return (2.0 * double(f) - double(lo) - double(hi)) / double(hi - lo);
      const Column& b = other.real.empty() ? c : other;
      return (2 * at(b, f) - at(b, lo) - at(b, hi)) / (at(b, hi) - at(b, lo));
    };
    constexpr Interval kNothing{INFINITY, -INFINITY};
    Table t{kNothing, kNothing, (at(c, hi) + at(c, lo)) / 2, (at(c, hi) - at(c, lo)) / 2, 0, 0, kNothing};
    if (hi - lo >= 1 << 13) {
      double ends[2] = {};
      for (size_t f = 0; f <= (hi - lo) / 4; f += place_step()) {
        ends[0] = std::max(ends[0], (point(c.whole[f]) - c.real[f]).size());
        ends[1] = std::max(ends[1], (point(c.whole[hi - lo - f]) - c.real[hi - lo - f]).size());
      }
      t.tilt = std::clamp((ends[1] - ends[0]) / (0.75 * (ends[0] + ends[1]) + 1e-30), -0.9, 0.9);
    }
    for (size_t f = lo; f <= hi; f += place_step()) {
      const double u = part(f);
      const Interval whole = point(c.whole[f - lo]), real = c.real[f - lo];
      t.whole = hull(t.whole, whole);
      const double tilted = 1 / (1 + t.tilt * u);
      t.off = hull(t.off, (whole - real) * Interval{tilted / kSafe, tilted * kSafe});
      t.rest = hull(t.rest, real - point(t.sum) - point(t.difference) * point(u));
      const double bent = (at(c, f) - t.sum) / t.difference;
      t.bend = std::max(t.bend, std::fabs(bent) <= 1 ? std::fabs(bent - u) : INFINITY);
    }
    return tables.emplace(key, t).first;
  };
  if (!axis.chosen) {
    const Table& straight = in_box(0)->second;
    if (lo < hi && straight.difference != 0 && straight.bend <= 1)
      axis = {true, shape(n), straight.bend * kSafe + kRounding, n};
  }
  return in_box(axis.shape)->second;
}

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
inline int grid_of(int n) {
  int grid = nodes[n].forms[0].grid;
  for (const Form& f : nodes[n].forms) grid = std::min(grid, f.grid);
  return grid;
}
inline bool of_a_choice(int n) {
  for (const Term& t : nodes[n].forms[0].terms) {
    if (symbols[t.symbol].kind == kChoice) return true;
  }
  return false;
}
inline bool is_counted(Float a, Float b, char how) {
  if constexpr (!kFixed) return false;
  const Node &x = nodes[a.n], &y = nodes[b.n];
  if (x.lazy || y.lazy || (x.word != 0 && y.word != 0 && x.word != y.word)) return true;
  if (how != '*' || is_known(a.n) || is_known(b.n)) return false;
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
  nodes[out->n].less[0] = other;
  return true;
}
inline Float exact_sum(Float a, Float b, double sign);
inline Float counted_sum(Float a, Float b, double sign) {
  Float found(0.0f);
  if (sign > 0 && (product_in_halves(a, b, &found) || interpolation(a, b, &found) || interpolation(b, a, &found)))
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
inline Float exact_product(Float a, Float b) {
  if (is_counted(a, b, '*')) return counted_product(a, b);
  return made(each(a, b,
                   [](const Form& x, const Form& y) {
                     Form f = times(x, y);
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
  if (!kFixed) {  // by class of a word
    f = made(each(a,
                  [&](const Form& x) {
                    Form g = times(x, constant(scale));
                    const double least = std::floor(g.range.lo);
                    if (x.grid < k) add_error(g, {std::ldexp(1.0, x.grid - k) - 1, 0});
                    g.range.lo = std::max(g.range.lo, least);
                    g.grid = std::max(0, x.grid - k);
                    return g;
                  }),
             '>', a);
    nodes[f.n].shift = k;
  } else if (!nodes[a.n].lazy && grid >= k) {
    f = exact_product(a, Float(static_cast<float>(scale)));
    nodes[f.n].made = '>', nodes[f.n].left = a.n, nodes[f.n].right = -1, nodes[f.n].shift = k;
  } else {
    const double half = nodes[a.n].bias * scale == 0.5 ? 0.5 : 0;
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
  return (of_one(a.n) || is_known(a.n)) && (of_one(b.n) || is_known(b.n)) && (of_one(a.n) || of_one(b.n));
}
// A step that rounds saturates, which is no step in exact arithmetic: so the sum with half is handed on.
inline Float least_of_one(Float a, Float b) {
  const Float f = lazily('m', a.n, b.n, 0, 0, [] { return Interval{}; });
  if (is_known(b.n)) nodes[f.n].bias = nodes[a.n].bias;
  return f;
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

// --- In the end
// -------------------------------------------------------------------------------------------------------

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
  const auto terms = [&](const Weight& w) {
    return exact ? std::vector<std::pair<int, Affine>>{{kExact, w.exact}} : w.errors;
  };
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
