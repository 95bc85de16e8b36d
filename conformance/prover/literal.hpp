// Literals of the text with their decimals, which a float need not hold.
#pragma once

#include <cmath>

namespace hn::prover {

// A literal, or a result of literals alone, such as 1.0f / 6.0f.
struct Literal {
  long double exact;
  double off;  // at most how far the float is off that a compiler makes of it

  static constexpr Literal rounded(long double exact, double off) {
    if (off == 0 && static_cast<float>(exact) == exact) return {exact, 0};
    const double size = static_cast<double>(exact < 0 ? -exact : exact) + off;
    double ulp = 0x1p-149;
    while (ulp * 0x1p24 <= size) ulp *= 2;
    return {exact, off + ulp};
  }
  friend constexpr Literal operator-(Literal a) { return {-a.exact, a.off}; }
  friend constexpr Literal operator+(Literal a, Literal b) { return rounded(a.exact + b.exact, a.off + b.off); }
  friend constexpr Literal operator-(Literal a, Literal b) { return a + -b; }
  friend constexpr Literal operator*(Literal a, Literal b) {
    return rounded(a.exact * b.exact, a.size() * b.off + b.size() * a.off + a.off * b.off);
  }
  friend constexpr Literal operator/(Literal a, Literal b) {
    const double quotient = a.size() / b.size();
    return rounded(a.exact / b.exact, a.off + b.off == 0 ? 0 : (a.off + quotient * b.off) / (b.size() - b.off) * 1.001);
  }

 private:
  constexpr double size() const { return static_cast<double>(exact < 0 ? -exact : exact) * (1 + 0x1p-40); }
};
consteval Literal operator""_f(long double x) { return Literal::rounded(x, 0); }

}  // namespace hn::prover
