// A mean-value form: all that a step of the text can compute, in any rounding mode, products fused or not, over
// a box of places and for all hashes. Symbols s_k with known ranges around 0 are places (0 in the middle of the box),
// choices (a hash decides them), cells (whole numbers that are unknown, see places.hpp), and errors (0 in exact
// arithmetic). A form is right for a number of the text, which
// is x as it is computed and x* in exact arithmetic, if for each place, hash and rounding there are m in `mid` and
// d_k in [lo, hi] with
//
//   x* = m + sum over places and choices of d_k s_k,   x = x* + sum over errors of d_k s_k,
//
// and both are in `range`. The d_k of places are the derivatives of x* anywhere in the box, too. So the error of a
// result is the sum of its error terms, with no second order left out. Each rule below is algebra with such m and d_k;
// they are not unique: an intersection of two enclosures of d_k is wrong.
#pragma once

#ifdef PROVER_TRACE
#include <execinfo.h>
#endif
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "interval.hpp"
#include "pool.hpp"

namespace hn::prover {

enum Kind : char { kPlace, kChoice, kCell, kError };
struct Symbol {
  Kind kind;
  Interval range;
  int copy = -1;  // of the rounding of a product, in a sum
  // An error that leaves a number in the range of its choice: so another choice, without the error, makes it, too.
  bool stays = false;
};
inline Vector<Symbol> symbols;  // of the box

// The calls on the way to the last step that was not seen through, if they are wanted.
inline std::vector<void*> frames;
inline bool traced() {
#ifdef PROVER_TRACE
  frames.resize(256);
  frames.resize(static_cast<std::size_t>(backtrace(frames.data(), 256)));
#endif
  return true;
}
inline std::vector<std::vector<void*>> origins;  // of symbols, likewise
inline bool explains = false;

inline int symbol(Kind kind, Interval range) {
  symbols.push_back({kind, hull(range, {})});
  if (explains && traced()) origins.resize(symbols.size()), origins.back() = frames;
  return static_cast<int>(symbols.size()) - 1;
}

constexpr double kTiny = 0x1p-126;  // results below may become 0
constexpr double kLargest = 0x1.fffffep127;
constexpr int kNoGrid = -300;

struct TooLarge {  // a box
  const char* why;
  bool is_traced = traced();
};
// A step that the prover cannot see through, whatever the box is.
struct Unseen {
  std::string step;
  bool is_traced = traced();
};
[[noreturn]] inline void refuse(const char* step) { throw Unseen{step}; }

struct Term {
  int symbol;
  Interval d;
};
struct Form {
  Interval range, mid;
  Vector<Term> terms;  // by symbol
  int grid = kNoGrid;  // the computed number is a multiple of 2^grid
  int bits = 24;       // and has so many significant bits at most
  int fused = -1;      // the symbol of a product's rounding, which a sum may leave out
  // Where no choice and one place at most is in it: the exact number where that is least and where it is most.
  static constexpr int kNone = -1, kSeveral = -2;
  int place = kSeveral;
  Interval ends[2];

  Interval error() const {
    Interval e;
    for (const Term& t : terms) {
      if (symbols[t.symbol].kind == kError) e = e + t.d * symbols[t.symbol].range;
    }
    return e;
  }
  Interval exact() const {  // the range in exact arithmetic
    Interval x = mid;
    for (const Term& t : terms) {
      if (symbols[t.symbol].kind != kError) x = x + t.d * symbols[t.symbol].range;
    }
    return x;
  }
  double moved() const {  // by a place that is off by 1 along each axis
    double sum = 0;
    for (const Term& t : terms) {
      if (symbols[t.symbol].kind == kPlace) sum += t.d.size();
    }
    return sum;
  }
  // A place of no size has the slope of a number that keeps nothing else of places.
  void add_slope(double most) { terms.push_back({symbol(kPlace, {0, 0}), {-most, most}}); }
  bool rounds() const {
    const Interval e = error();
    return e.lo < 0 || e.hi > 0;
  }
  // x* by the mean, and x.
  void tighten() {
    Interval r = mid, rest, slope;
    for (const Term& t : terms) {
      const Interval x = t.d * symbols[t.symbol].range;
      r = r + x;
      t.symbol == place ? slope = t.d : rest = rest + x;
    }
    range = meet(range, r);
    if (place >= 0) {
      const Interval at = symbols[place].range;
      const double width = at.hi - at.lo;
      range = meet(range, Interval{-highest(-ends[0].lo, -ends[1].lo, -slope, width),
                                   highest(ends[0].hi, ends[1].hi, slope, width)} +
                              rest);
    }
  }
  // The most that a function from `from` to `to` can be, by its slope: lines from both ends are above it, and meet.
  static double highest(double from, double to, Interval slope, double width) {
    if (slope.lo >= 0) return to;
    if (slope.hi <= 0) return from;
    const double meeting = std::clamp((to - from - slope.lo * width) / (slope.hi - slope.lo), 0.0, width);
    return std::max(from + slope.hi * meeting, to + -slope.lo * (width - meeting));
  }
  // The ends of a number that a step makes of a and b.
  template <typename Step>
  void along(const Form& a, const Form& b, const Step& step) {
    if (a.place == kNone || a.place == b.place || b.place == kNone) {
      place = std::max(a.place, b.place);
      if (std::min(a.place, b.place) == kSeveral) place = kSeveral;
      for (int i = 0; i < 2 && place != kSeveral; ++i) ends[i] = step(a.ends[i], b.ends[i]);
    }
  }
};

inline Form constant(double x) {
  Form f;
  f.range = f.mid = f.ends[0] = f.ends[1] = {x, x};
  f.place = Form::kNone;
  int e;
  double m = std::frexp(x, &e);
  f.bits = 0;
  while (m != 0) {
    m *= 2;
    m -= std::trunc(m);
    ++f.bits;
  }
  f.grid = x == 0 ? 0 : e - f.bits;
  return f;
}

// It is the same in exact arithmetic, and at all places.
inline bool decided_by_hash(const Form& f) {
  return std::all_of(f.terms.begin(), f.terms.end(), [](const Term& t) { return symbols[t.symbol].kind == kChoice; });
}

// The step applied to both derivatives by each symbol, or of one where the other has none.
template <typename Terms, typename Step>
Terms merged(const Terms& a, const Terms& b, const Step& step) {
  Terms out;
  out.reserve(a.size() + b.size() + 1);
  auto i = a.begin(), j = b.begin();
  while (i != a.end() || j != b.end()) {
    const bool of_a = i != a.end() && (j == b.end() || i->symbol <= j->symbol);
    const bool of_b = j != b.end() && (i == a.end() || j->symbol <= i->symbol);
    const auto d = step(of_a ? &i->d : nullptr, of_b ? &j->d : nullptr);
    if (d.size() > 0) out.push_back({of_a ? i->symbol : j->symbol, d});
    i += of_a, j += of_b;
  }
  return out;
}
// a's terms times p, and b's times q.
inline Vector<Term> combined(const Form& a, Interval p, const Form& b, Interval q) {
  return merged(a.terms, b.terms, [&](const Interval* x, const Interval* y) {
    return x && y ? *x * p + *y * q : x ? *x * p : *y * q;
  });
}

// The distance of two floats around a number up to this one: a power of two is a float.
inline double ulp(double magnitude) {
  int e;
  return std::frexp(magnitude, &e) == 0.5 ? std::ldexp(1.0, e - 25) : std::ldexp(1.0, e - 24);
}

inline void add_error(Form& f, Interval e) {
  f.terms.push_back({symbol(kError, e), {1, 1}});
  f.range = f.range + hull(e, {});
}

inline double float_above(double x) { return static_cast<float>(x); }  // as this rounds up
// A float that is made of f: nothing happens if f is one. All n 2^grid with |n| <= 2^24 are floats, and so are numbers
// of 24 bits; the others move by less than the distance of floats, and to a coarser grid, if that is known: a product
// that is fused does not move. Numbers below 2^-126 may become 0. No rounding crosses a float.
inline void round(Form& f, bool may_fuse) {
  f.tighten();
  const double size = f.range.size();
  if (!(size <= kLargest)) throw TooLarge{"a number beyond floats"};
  const bool small = f.grid < -126 && f.range.lo < kTiny && f.range.hi > -kTiny && size > 0;
  const bool exact = size <= std::ldexp(1.0, f.grid + 24) || f.bits <= 24;
  if (exact && f.terms.empty() && f.range.lo == f.range.hi) {
    f = constant(f.range.lo);
    return;
  }
  double u = small ? kTiny : 0;
  if (!exact) {
    u += ulp(size);
    const double least = f.range.lo > 0 ? f.range.lo : f.range.hi < 0 ? -f.range.hi : 0;
    if (!may_fuse && least > 0) f.grid = std::max(f.grid, std::ilogb(least) - 23);
  }
  f.bits = std::min(f.bits, 24);
  const Interval floats{-float_above(-f.range.lo), float_above(f.range.hi)};
  if (u > 0) add_error(f, {-u, u});
  f.range = meet(f.range, small ? hull(floats, {}) : floats);
  if (u > 0 && may_fuse) f.fused = f.terms.back().symbol;
}

// In a sum the rounding of a product is another than elsewhere: there it may be fused.
inline const Form& in_sum(const Form& a, Form& copy) {
  const auto rounding =
      std::find_if(a.terms.begin(), a.terms.end(), [&](const Term& t) { return t.symbol == a.fused; });
  if (rounding == a.terms.end()) return a;
  copy = a;
  copy.terms.erase(copy.terms.begin() + (rounding - a.terms.begin()));
  copy.terms.push_back({symbol(kError, symbols[a.fused].range), rounding->d});
  symbols.back().copy = a.fused;
  return copy;
}
inline Form plus(const Form& a, const Form& b, double sign) {
  const Interval s{sign, sign};
  Form f, of_a, of_b;
  f.range = a.range + b.range * s;
  f.mid = a.mid + b.mid * s;
  f.terms = combined(in_sum(a, of_a), {1, 1}, in_sum(b, of_b), s);
  f.along(a, b, [&](Interval x, Interval y) { return x + y * s; });
  f.grid = std::min(a.grid, b.grid);
  f.bits = 99;
  return f;
}
// x y - x* y* = (x - x*) y + x* (y - y*), and x* y* = m_x m_y + m_x (y* - m_y) + (x* - m_x) y*. The grid: floats are
// multiples of 2^-149.
inline Form times(const Form& a, const Form& b) {
  Form f;
  f.range = a.range * b.range;
  f.mid = a.mid * b.mid;
  f.terms = combined(a, b.range, b, hull(a.range, a.mid));
  f.along(a, b, [](Interval x, Interval y) { return x * y; });
  f.grid = std::max(a.grid + b.grid, kNoGrid);
  f.bits = a.bits <= 1 ? b.bits : b.bits <= 1 ? a.bits : a.bits + b.bits;
  return f;
}
inline Form negative(const Form& a) {
  Form f = a;
  f.range = -a.range, f.mid = -a.mid;
  for (Interval& end : f.ends) end = -end;
  for (Term& t : f.terms) t.d = -t.d;
  return f;
}
// max, min and abs where they are undecided. While the symbols go from 0 to their values, in a line, those that err
// last, both sides are linear, and a largest of two linear functions rises in all by a mean of their derivatives.
inline Form either(const Form& a, const Form& b, Interval range, Interval mid) {
  Form f;
  f.range = range, f.mid = mid;
  f.grid = std::min(a.grid, b.grid);
  f.terms = merged(a.terms, b.terms,
                   [](const Interval* x, const Interval* y) { return hull(x ? *x : Interval{}, y ? *y : Interval{}); });
  return f;
}

// The box is cut along an axis, behind a float: so it decides what one place decides.
struct Place {
  int symbol;
  std::size_t axis;
  double middle, lo, hi;
};
inline std::vector<Place> places;
struct Cut {
  std::size_t axis;
  float last;
};
// Where this, in exact arithmetic and in floats, is less than 0.
inline void cut(const Form& less) {
  const Term* of = nullptr;
  for (const Term& t : less.terms) {
    if (t.d.size() == 0) continue;
    if (of || symbols[t.symbol].kind != kPlace || t.d.lo != t.d.hi) return;
    of = &t;
  }
  if (!of || less.mid.lo != less.mid.hi) return;
  const auto found = std::find_if(places.begin(), places.end(), [&](const Place& p) { return p.symbol == of->symbol; });
  if (found == places.end()) return;
  const Place& place = *found;
  const double at = place.middle - less.mid.lo / of->d.lo;
  float last = static_cast<float>(at);
  if (of->d.lo > 0 ? last >= at : last > at) last = std::nextafterf(last, -INFINITY);
  if (last >= place.lo && std::nextafterf(last, INFINITY) <= place.hi) throw Cut{place.axis, last};
}

// A choice by a number that rounding or the box leaves open: each side is a path of its own. Where the number has
// roundings, exact arithmetic may take another path: see seams.hpp.
struct Decision {
  int taken, count;
  Form number;                    // whether it is less than 0 decides
  bool rounds = number.rounds();  // as long as its symbols are known
};
inline std::vector<Decision> path;
inline size_t decided = 0;
inline bool given = false;  // rounding changes no decision
// After so many, those that have no roundings are left open (Mask::open): ties of n numbers would make 2^n paths.
constexpr size_t kMostDecisions = 2;
inline int taken(int count, Form number = {}) {
  if (decided == path.size()) path.push_back({0, count, std::move(number)});
  return path[decided++].taken;
}
inline bool next_path() {
  while (!path.empty() && path.back().taken + 1 == path.back().count) path.pop_back();
  if (path.empty()) return false;
  ++path.back().taken;
  return true;
}

inline void choose(Form& f, double half) {
  f.place = Form::kSeveral;
  f.terms.push_back({symbol(kChoice, {-half, half}), {1, 1}});
}

// So do max and min, with one error: max(x, y) - max(x*, y*) is between x - x* and y - y*, since it is at most
// the one of these that is larger in x, y, and at least the one that is larger in x*, y*.
inline Form with_error(Form f, Interval error) {
  std::erase_if(f.terms, [](const Term& t) { return symbols[t.symbol].kind == kError; });
  f.fused = -1;
  if (error.size() > 0) f.terms.push_back({symbol(kError, error), {1, 1}});
  return f;
}
inline Form either_off(const Form& a, const Form& b, Interval range, Interval mid) {
  return with_error(either(a, b, range, mid), hull(a.error(), b.error()));
}

// One form for all alternatives; a hash takes one: the choice is how far its m is from the middle.
inline Form joined(const Vector<Form>& alternatives) {
  Form f = alternatives[0];
  Interval mid = f.mid, error;
  bool may_fuse = false;
  for (const Form& a : alternatives) {
    mid = hull(mid, a.mid);
    error = hull(error, a.error());
    const int bits = std::max(f.bits, a.bits);
    f = either(f, a, hull(f.range, a.range), mid);
    f.bits = bits;
    may_fuse |= a.fused >= 0;
  }
  f.mid = point(middle(mid));
  if (const double half = reach(mid, f.mid.lo); half > 0) choose(f, half);
  f = with_error(std::move(f), error);
  if (may_fuse && error.size() > 0) f.fused = f.terms.back().symbol;
  return f;
}

// a + t (b - a), with roundings e of the difference and the product, as (1 - m) a + m b + (t - m) (b - a) + e, where m
// is t's: so by the symbols that a and b share it goes as a mean of both. Terms of only a or only b become one symbol,
// for choices and for errors: with A and B the sums of these terms, it is (1 - m) A + m B for choices, and with t for
// m, (x - x*) = (1 - t) (a - a*) + t (b - b*) + (t - t*) (b* - a*), for errors. This is linear in t, so it is largest
// at an end of t's range. Terms that are in none of a, b and t are roundings of the difference and of the product;
// those of the difference that t depends on, too, are added. If a is a product, each of its two uses may be fused: so
// its rounding counts once or not, with either sign.
inline Form between(const Form& a, const Form& b, const Form& t, const Form& difference, const Form& product) {
  const Interval part = hull(t.range, t.mid), away = point(1) - part, apart = difference.range;
  Form f = plus(a, product, 1);
  f.place = Form::kSeveral;
  const auto mixed = [&](Interval x, Interval y) {
    const auto at = [&](double t) { return x * (point(1) - point(t)) + y * point(t); };
    return hull(at(part.lo), at(part.hi));
  };
  const auto by = [](const Form& g, int symbol) {
    const auto i =
        std::lower_bound(g.terms.begin(), g.terms.end(), symbol, [](const Term& x, int y) { return x.symbol < y; });
    return i != g.terms.end() && i->symbol == symbol ? &i->d : nullptr;
  };
  Interval range = mixed(a.range, b.range), roundings, of_a[4], of_b[4], uses;
  Vector<Term> terms;
  for (const Term& x : f.terms) {
    const Interval *da = by(a, x.symbol), *db = by(b, x.symbol), *dt = by(t, x.symbol);
    const Symbol of = symbols[x.symbol];
    if (a.fused >= 0 && of.copy == a.fused && !dt) {
      uses = uses + hull(x.d, {});
    } else if (!da && !db && !dt) {
      range = range + x.d * of.range;
      roundings = roundings + x.d * of.range;
    } else if ((of.kind == kChoice || of.kind == kError) && !dt && !(da && db)) {
      Interval& sum = da ? of_a[of.kind] : of_b[of.kind];
      sum = sum + *(da ? da : db) * of.range;
    } else {
      const Interval zero, *of_difference = da || db ? nullptr : by(difference, x.symbol);
      const Interval* const dd = db ? db : of_difference;
      if (of_difference) range = range + part * *dd * of.range;
      terms.push_back({x.symbol, away * (da ? *da : zero) + part * (dd ? *dd : zero) + apart * (dt ? *dt : zero)});
    }
  }
  if (a.fused >= 0) {
    const Interval of_product = uses * symbols[a.fused].range;
    range = range + of_product, roundings = roundings + of_product;
  }
  f.terms = std::move(terms);
  f.range = meet(f.range, range);
  const Interval choices = mixed(of_a[kChoice], of_b[kChoice]);
  const Interval errors = mixed(of_a[kError], of_b[kError]) + roundings;
  if (choices.size() > 0) f.terms.push_back({symbol(kChoice, choices), {1, 1}});
  if (errors.size() > 0) f.terms.push_back({symbol(kError, errors), {1, 1}});
  return f;
}

}  // namespace hn::prover
