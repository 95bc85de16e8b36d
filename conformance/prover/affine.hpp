// Functions of the place in a box, for HN_FIXED: numbers that have no hash, and their errors (linear.hpp).
#pragma once

#include "roots.hpp"

namespace hn::prover {

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
struct Derivative {
  int symbol;
  Affine d;
};
struct Weight {
  Affine exact;
  std::vector<Derivative> errors;  // by symbol
  Affine anywhere() const {        // exact, computed and between
    Affine a = exact;
    for (const auto& [k, d] : errors) a.r += d.size() * symbols[k].range.size();
    return a;
  }
};
inline Weight constant_weight(double v) { return {Affine(v), {}}; }
// The derivatives by each symbol of a or b.
template <typename Step>
std::vector<Derivative> merged(const Weight& a, const Weight& b, const Step& step) {
  const Affine zero;
  return merged(a.errors, b.errors,
                [&](const Affine* x, const Affine* y) { return step(x ? *x : zero, y ? *y : zero); });
}
inline Weight plus(const Weight& a, const Weight& b, double sign) {
  return {plus(a.exact, b.exact, sign),
          merged(a, b, [&](const Affine& x, const Affine& y) { return plus(x, y, sign); })};
}
inline Weight times(const Weight& a, const Weight& b) {
  const Affine p = a.anywhere(), q = b.anywhere();
  return {times(a.exact, b.exact),
          merged(a, b, [&](const Affine& x, const Affine& y) { return plus(times(x, q), times(y, p), 1); })};
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

}  // namespace hn::prover
