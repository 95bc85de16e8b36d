// Positions in any cell: a whole number that is unknown, and a place in that cell.
#pragma once

#include "node.hpp"

namespace hn::prover {

// The coordinate c + f with f in [lo, hi), a part of [0, 1], and whole c, first <= c <= last. All of it is exact.
inline Form position(double first, double last, double lo, double hi) {
  const double middle = std::floor((first + last) / 2);
  Form f;
  f.range = {first + lo, last + hi};
  f.mid = Interval{middle, middle} + Interval{lo, lo} + point((hi - lo) / 2);
  f.terms = {{symbol(kCell, {first - middle, last - middle}), {1, 1}}};
  if (hi > lo) f.terms.push_back({symbol(kPlace, {-(hi - lo) / 2, (hi - lo) / 2}), {1, 1}});
  return f;
}

// The part of a number that whole numbers of cells make, if there is one; the rest is in [lo, hi).
inline bool in_cells(const Form& f, Form* cells, Interval* rest) {
  *cells = Form{};
  *rest = f.mid;
  bool ends = true;  // whether the upper end of the rest is not reached
  for (const Term& t : f.terms) {
    const Symbol& s = symbols[t.symbol];
    if (s.kind == kCell) {
      if (t.d.lo != t.d.hi || t.d.lo != std::floor(t.d.lo))
        refuse("a whole part of a number that has a part of a cell");
      cells->terms.push_back(t);
      cells->range = cells->range + t.d * s.range;
    } else {
      ends &= s.kind == kPlace && t.d.lo == t.d.hi && t.d.lo > 0;
      *rest = *rest + t.d * s.range;
    }
  }
  if (ends && f.mid.lo == f.mid.hi && rest->hi == std::floor(rest->hi) && rest->hi > rest->lo)
    rest->hi = std::nextafter(rest->hi, -INFINITY);
  cells->grid = 0;
  return !cells->terms.empty();
}
inline bool is_of_cells(const Form& f) {
  bool only = !f.terms.empty();
  for (const Term& t : f.terms) only &= symbols[t.symbol].kind == kCell;
  return only;
}

}  // namespace hn::prover
