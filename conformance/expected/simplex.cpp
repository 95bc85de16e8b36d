#include "expected/simplex.hpp"

#include <algorithm>
#include <cmath>

namespace hn {
namespace {

// Of docs/contract.md, section 13: the noise is scale * sum of w(t) (g . d) with t = r - m |d|^2, d in steps, and
// w = cubic * t^3 + quartic * t^4. At most so many lattice points are nearer than the radius at any place. `longest` is
// the length of the longest gradient, rounded up.
struct Kernel {
  double r;
  double m;
  double cubic;
  double quartic;
  double scale;
  double steps;  // per cell
  int points;
  double longest;
};

Kernel kernel_of(int axes) {
  if (axes == 2) return {819.0 / 1024.0, 1.0, 65.0 / 8.0, -8.0, 1653.0 / 1024.0, 2.0, 3, 1.0};
  if (axes == 3) return {1.0, 2.0, 0.0, 1.0, 6570.0 / 1024.0, 1.0, 4, 1.07};
  return {1.0, 2.0, 1.0, 0.0, 4298.0 / 1024.0, 1.0, 4, 1.4143};
}

// With u = d along the axis, R = g . d, t' = -2 m u and t'' = -2 m, the third derivative of w(t) R is
//   (w''' t'^3 + 3 w'' t' t'') R + 3 (w'' t'^2 + w' t'') R'
// and |R| <= longest * |d|, |R'| <= longest.
double third(const Kernel& kernel, double u, double distance) {
  const double t = kernel.r - kernel.m * distance * distance;
  const double t1 = -2.0 * kernel.m * u;
  const double t2 = -2.0 * kernel.m;
  const double w1 = 3.0 * kernel.cubic * t * t + 4.0 * kernel.quartic * t * t * t;
  const double w2 = 6.0 * kernel.cubic * t + 12.0 * kernel.quartic * t * t;
  const double w3 = 6.0 * kernel.cubic + 24.0 * kernel.quartic * t;
  return kernel.longest * (std::fabs(w3 * t1 * t1 * t1 + 3.0 * w2 * t1 * t2) * distance +
                           3.0 * std::fabs(w2 * t1 * t1 + w1 * t2));
}

}  // namespace

double simplex_third_derivative(int axes) {
  const Kernel kernel = kernel_of(axes);
  const double radius = std::sqrt(kernel.r / kernel.m);
  // On a grid. Between its points `third` changes by less than a hundredth of its maximum.
  constexpr int kSteps = 256;
  double largest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double distance = radius * i / kSteps;
    for (int k = 0; k <= kSteps; ++k) largest = std::max(largest, third(kernel, distance * k / kSteps, distance));
  }
  return 1.01 * largest * kernel.points * kernel.scale * std::pow(kernel.steps, 3.0);
}

}  // namespace hn
