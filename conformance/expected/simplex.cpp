#include "expected/simplex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hn {
namespace {

using Place = std::array<double, 4>;

// See docs/reference/contract.md, section 13: the noise is scale * sum of w(t) (g . d) with t = r - m |d|^2, d in
// steps, and w = cubic * t^3 + quartic * t^4 + quintic * t^5. `longest` is the length of the longest gradient, rounded
// up.
struct Kernel {
  double r;
  double m;
  double cubic;
  double quartic;
  double quintic;
  double scale;
  double steps;  // per cell
  double longest;
};

Kernel kernel_of(int axes) {
  if (axes == 2) return {819.0 / 1024.0, 1.0, 3.0, -2.0, 0.0, 4099.0 / 1024.0, 2.0, 0.7906};
  if (axes == 3) return {1.0, 2.0, 0.0, 1.0, 0.0, 4918.0 / 1024.0, 1.0, 1.4143};
  return {1.0, 2.0, 1.0, 0.0, 0.0, 4298.0 / 1024.0, 1.0, 1.4143};
}

// Phasor noise has no gradients: its weight is t^3 (1 + 15 (1 - t)^2).
Kernel waves_of(int axes) {
  if (axes == 2) return {819.0 / 1024.0, 1.0, 16.0, -30.0, 15.0, 762.0 / 1024.0, 2.0, 1.0};
  return {1.0, 2.0, 16.0, -30.0, 15.0, 674.0 / 1024.0, 1.0, 1.0};
}

// The lattice points that count anywhere in the part of space that is searched, in steps: a square of one step on the
// plane, where two rows count; else the part of a cell that is nearest to one corner.
std::vector<Place> points_of(int axes) {
  if (axes == 2) return {{0.0, 0.0}, {1.0, 0.0}, {-0.5, 1.0}, {0.5, 1.0}, {1.5, 1.0}};
  std::vector<Place> points;
  for (unsigned corner = 0; corner < 1u << axes; ++corner) {
    Place at{};
    Place centre{};
    for (unsigned axis = 0; axis < static_cast<unsigned>(axes); ++axis) {
      at[axis] = (corner >> axis) & 1u;
      centre[axis] = at[axis] - 0.5;
    }
    points.push_back(at);
    points.push_back(centre);
  }
  return points;
}

// The weight and its derivatives along an axis, with u = d along that, t' = -2 m u and t'' = -2 m:
//   w    w' t'    w'' t'^2 + w' t''    w''' t'^3 + 3 w'' t' t''
using Derivatives = std::array<double, 4>;
Derivatives weight_at(const Kernel& kernel, double u, double distance) {
  const double t = std::max(kernel.r - kernel.m * distance * distance, 0.0);
  const double t1 = -2.0 * kernel.m * u;
  const double t2 = -2.0 * kernel.m;
  const double a = kernel.cubic;
  const double b = kernel.quartic;
  const double c = kernel.quintic;
  const double w = t * t * t * (a + t * (b + t * c));
  const double w1 = t * t * (3.0 * a + t * (4.0 * b + t * 5.0 * c));
  const double w2 = t * (6.0 * a + t * (12.0 * b + t * 20.0 * c));
  const double w3 = 6.0 * a + t * (24.0 * b + t * 60.0 * c);
  return {w, w1 * t1, w2 * t1 * t1 + w1 * t2, w3 * t1 * t1 * t1 + 3.0 * w2 * t1 * t2};
}

// The third derivative of w(t) R with R = g . d is w^(3) R + 3 w^(2) R', and |R| <= longest * |d|, |R'| <= longest.
double third(const Kernel& kernel, double u, double distance) {
  const Derivatives w = weight_at(kernel, u, distance);
  return kernel.longest * (std::fabs(w[3]) * distance + 3.0 * std::fabs(w[2]));
}

// The sum over the points. One that is a little beyond the radius counts as if it were there: the third derivative
// jumps at the radius, and the places are a grid's.
template <typename OfPoint>
double sum_at(const Kernel& kernel, const std::vector<Place>& points, const Place& place, std::size_t axis,
              double reach, const OfPoint& of_point) {
  double sum = 0.0;
  for (const Place& at : points) {
    double square = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i) square += (place[i] - at[i]) * (place[i] - at[i]);
    const double distance = std::sqrt(square);
    if (distance < std::sqrt(kernel.r / kernel.m) + reach) sum += of_point(kernel, place[axis] - at[axis], distance);
  }
  return sum;
}

// By numbers of places along an axis that make a grid of some thousands; the lattices of three and four dimensions are
// the same along each axis.
template <typename OfPoint>
double searched(const Kernel& kernel, int axes, const OfPoint& of_point) {
  const std::vector<Place> points = points_of(axes);
  const int places = axes == 2 ? 65 : axes == 3 ? 17 : 9;
  const double spacing = (axes == 2 ? 1.0 : 0.5) / (places - 1);
  double largest = 0.0;
  const int all = static_cast<int>(std::pow(places, axes));
  for (int number = 0; number < all; ++number) {
    Place place{};
    for (int axis = 0, rest = number; axis < axes; ++axis, rest /= places) {
      place[static_cast<std::size_t>(axis)] = spacing * (rest % places);
    }
    // No place is farther than this from one of the grid.
    const double reach = spacing * std::sqrt(axes) / 2.0;
    for (std::size_t axis = 0; axis < (axes == 2 ? 2u : 1u); ++axis) {
      largest = std::max(largest, sum_at(kernel, points, place, axis, reach, of_point));
    }
  }
  // Between the places of the grid it is larger by less than a tenth.
  return 1.1 * largest * kernel.scale;
}

double found_third(int axes) {
  const Kernel kernel = kernel_of(axes);
  return searched(kernel, axes, third) * std::pow(kernel.steps, 3.0);
}

// The derivatives of the sum of the weights, per cell, of each order.
Derivatives found_waves(int axes) {
  const Kernel kernel = waves_of(axes);
  Derivatives found{};
  for (std::size_t order = 0; order < found.size(); ++order) {
    const auto of_point = [order](const Kernel& of, double u, double distance) {
      return std::fabs(weight_at(of, u, distance)[order]);
    };
    found[order] = searched(kernel, axes, of_point) * std::pow(kernel.steps, static_cast<double>(order));
  }
  return found;
}

}  // namespace

double simplex_third_derivative(int axes) {
  static const std::array<double, 3> kFound = {found_third(2), found_third(3), found_third(4)};
  return kFound[static_cast<std::size_t>(axes - 2)];
}

// The waves are rotated by an angle whose derivative along the axis is 2 pi times their number.
double phasor_third_derivative(int axes, double waves) {
  static const std::array<Derivatives, 2> kFound = {found_waves(2), found_waves(3)};
  const Derivatives& w = kFound[static_cast<std::size_t>(axes - 2)];
  const double rate = 2.0 * std::numbers::pi * std::min(std::fabs(waves), 16.0);
  return w[3] + 3.0 * rate * w[2] + 3.0 * rate * rate * w[1] + rate * rate * rate * w[0];
}

}  // namespace hn
