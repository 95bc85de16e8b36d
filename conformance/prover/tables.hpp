// Tables of numbers of HN_FIXED that are made of one integer: all of its values are evaluated.
//
// The exact number of a step: a shift by k divides by 2^k, and after a sum with half of that it rounds, so the half
// does not count; the low bits that it leaves are 0, and a mask of bits that are 0 anyway is no step; a minimum with a
// constant after such a sum is no step. All else is as written.
#pragma once

#include <array>
#include <map>

#include "affine.hpp"

namespace hn::prover {

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
    for (int m : {x.left, x.right, x.other}) h = mixed(h, m < 0 ? 3 : shape(m));
  }
  return nodes[n].shape = h;
}

// Places are multiples of 2^-place_bits. If that is coarser than a fraction, the text must round it to that.
inline int place_bits = 20;
// The exact number that a constant stands for: the spline's is 2/3 in units of 2^-30, and half of what is cut off; a
// rotation by sixths of a turn has 4 (2 / sqrt(3) - 1) in units of 2^-15.
inline Interval meaning(double constant) {
  constexpr double kTwoThirds = 0x1p30 * 2 / 3, kOfSixths = 0x1p17 * 0.15470053837925152902;
  const auto about = [](double x) { return Interval{std::nextafter(x, 0), std::nextafter(x, 0x1p30)}; };
  return constant == 715829931 ? about(kTwoThirds) : constant == 20277 ? about(kOfSixths) : point(constant);
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
    if (x.forms[0].range.lo != x.forms[0].range.hi) refuse("a step of an integer and of others");
    std::fill(c.whole.begin(), c.whole.end(), x.forms[0].range.lo);
    std::fill(c.real.begin(), c.real.end(), meaning(x.forms[0].range.lo));
  } else {
    for (int m : {x.left, x.right}) {
      if (m >= 0) fill(m, first, count, known);
    }
    const Column &a = known[x.left], &b = known[x.right >= 0 ? x.right : x.left];
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

}  // namespace hn::prover
