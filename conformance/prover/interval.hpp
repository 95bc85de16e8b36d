// Intervals of doubles whose ends are rounded outward. The processor rounds up while a Proving lives, and a lower end
// is the negative of an upper one; units are compiled with -frounding-math.
#pragma once

#include <algorithm>
#include <cfenv>
#include <cmath>

namespace hn::prover {

// The rounding of the thread is up as long as it lives.
class Proving {
 public:
  Proving() : before_(std::fegetround()) { std::fesetround(FE_UPWARD); }
  ~Proving() { std::fesetround(before_); }
  Proving(const Proving&) = delete;
  Proving& operator=(const Proving&) = delete;

 private:
  int before_;
};

struct Interval {
  double lo = 0, hi = 0;
  double size() const { return std::max(std::fabs(lo), std::fabs(hi)); }
  bool contains(double x) const { return lo <= x && x <= hi; }
};
inline Interval point(double x) { return {x, x}; }
inline double middle(Interval a) { return a.lo + (a.hi - a.lo) / 2; }  // nearly
// How far it reaches from there.
inline double reach(Interval a, double from) { return std::max(a.hi - from, from - a.lo); }
inline Interval operator+(Interval a, Interval b) { return {-(-a.lo - b.lo), a.hi + b.hi}; }
inline Interval operator-(Interval a) { return {-a.hi, -a.lo}; }
inline Interval operator-(Interval a, Interval b) { return a + -b; }
inline Interval operator*(Interval a, Interval b) {
  const double lo = std::max(std::max(-a.lo * b.lo, -a.lo * b.hi), std::max(-a.hi * b.lo, -a.hi * b.hi));
  const double hi = std::max(std::max(a.lo * b.lo, a.lo * b.hi), std::max(a.hi * b.lo, a.hi * b.hi));
  return {-lo, hi};
}
inline Interval hull(Interval a, Interval b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }
inline bool is_in(Interval a, Interval b) { return b.lo <= a.lo && a.hi <= b.hi; }
inline Interval meet(Interval a, Interval b) { return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)}; }

}  // namespace hn::prover
