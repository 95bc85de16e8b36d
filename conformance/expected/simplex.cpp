#include "expected/simplex.hpp"

#include <algorithm>
#include <cmath>

namespace hn {
namespace {

// Of docs/contract.md, section 13: the noise is scale * sum of W^3 (g . d) with W = r - m |d|^2, d in steps. At most
// so many lattice points are nearer than the radius at any place. `longest` is the length of the longest gradient.
struct Kernel {
  double r;
  double m;
  double scale;
  double steps;  // per cell
  int points;
  double longest;
};

Kernel kernel_of(int axes) {
  if (axes == 2) return {819.0 / 1024.0, 1.0, 6155.0 / 1024.0, 2.0, 3, 1.07};
  if (axes == 3) return {1.0, 2.0, 5036.0 / 1024.0, 1.0, 4, 1.07};
  return {1.0, 2.0, 4298.0 / 1024.0, 1.0, 4, 1.4143};
}

// With u = d along the axis, R = g . d, W' = -2 m u and W'' = -2 m, the third derivative of W^3 R is
//   (6 W'^3 + 18 W W' W'') R + (18 W W'^2 + 9 W^2 W'') R'
// and |R| <= longest * |d|, |R'| <= longest. Both factors are polynomials in u and |d|, of which `third` is the value.
double third(const Kernel& kernel, double u, double distance) {
  const double w = kernel.r - kernel.m * distance * distance;
  const double w1 = -2.0 * kernel.m * u;
  const double w2 = -2.0 * kernel.m;
  return kernel.longest * (std::fabs(6.0 * w1 * w1 * w1 + 18.0 * w * w1 * w2) * distance +
                           std::fabs(18.0 * w * w1 * w1 + 9.0 * w * w * w2));
}

}  // namespace

double simplex_third_derivative(int axes) {
  const Kernel kernel = kernel_of(axes);
  const double radius = std::sqrt(kernel.r / kernel.m);
  // On a grid. The maximum lies at the end of it: at the radius, along the axis.
  constexpr int kSteps = 128;
  double largest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double distance = radius * i / kSteps;
    for (int k = 0; k <= kSteps; ++k) largest = std::max(largest, third(kernel, distance * k / kSteps, distance));
  }
  return largest * kernel.points * kernel.scale * std::pow(kernel.steps, 3.0);
}

}  // namespace hn
