#include "expected/cellular.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#pragma GCC diagnostic error "-Wswitch"  // a metric that is added compiles only when the search has it

namespace hn {
namespace {

using Word = std::uint32_t;
using Coordinates = std::array<std::int64_t, 3>;
using Vector = std::array<double, 3>;

// --- Input ---

struct Place {
  std::size_t axes;
  bool fixed;  // then `cell` and `units` are as fixed arithmetic has them
  Coordinates cell;
  Vector fraction;
  Coordinates units;  // of the fraction: 2^-20
  Coordinates period;
  double jitter;
  std::int64_t jitter_units;
  Metric metric;
  Word seed;
  bool pcg;
  bool moves;                      // its points go round; the rest is how far
  Word angle;                      // in units of 2^-32 turns
  std::array<Vector, 3> rotation;  // of fixed arithmetic, in units of 2^-16: the rows that rotate the place backwards
};

constexpr double kUnits = 0x1p20;
constexpr double kLargestCell = 2147483520.0;  // the largest float below 2^31

void put_position(Place& place, std::size_t axis, double p) {
  if (!place.fixed) {
    place.cell[axis] = static_cast<std::int64_t>(std::clamp(std::floor(p), -2147483648.0, kLargestCell));
    place.fraction[axis] = p - std::floor(p);
    return;
  }
  const double whole = std::trunc(p);
  const auto rest = static_cast<std::int64_t>(std::trunc((p - whole) * kUnits));
  place.cell[axis] = static_cast<std::int64_t>(std::clamp(whole, -2147483648.0, kLargestCell)) + (rest >> 20);
  place.units[axis] = rest & 0xFFFFF;
}

void put_in_cell(Place& place, std::size_t axis, std::int64_t cell, double f) {
  place.cell[axis] = cell;
  place.fraction[axis] = f;
  place.units[axis] = static_cast<std::int64_t>(std::trunc(std::clamp(f, 0.0, 1.0) * kUnits));
}

// The sine of an angle by fixed arithmetic, section 8, in units of 2^-16.
std::int64_t fixed_sine(Word angle) {
  const std::uint64_t half = angle & 0x7FFFFFFFu;
  const std::uint64_t quarter = std::min<std::uint64_t>(half, 0x80000000u - half);
  const std::uint64_t x = std::min<std::uint64_t>((quarter + 8192) >> 14, 65535);
  const std::uint64_t u = (x * x) >> 16;
  const std::uint64_t y = 102943 - ((u * (42328 - ((u * (5208 - ((u * 288) >> 16))) >> 16))) >> 16);
  const auto g = static_cast<std::int64_t>((x * (y >> 1) + 16384) >> 15);
  return angle >> 31 ? -g : g;
}

// Multiplies two sines.
std::int64_t fixed_product(std::int64_t a, std::int64_t b) { return ((a >> 1) * b + 16384) >> 15; }

// Points that go round: how far they are, and how near to the centres of their cells.
void put_phase(Place& place, float phase) {
  place.moves = true;
  const float part = phase - std::trunc(phase);
  place.angle = static_cast<Word>(static_cast<std::int64_t>(std::trunc(part * 0x1p30f))) * 4u;
  const std::int64_t k = place.axes == 2 ? 28 : 25;
  place.jitter *= static_cast<double>(k) / 32.0;
  place.jitter_units = place.jitter_units * k >> 5;
  const std::int64_t c = fixed_sine(place.angle + 0x40000000u);
  const std::int64_t s = fixed_sine(place.angle);
  const auto vector = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return Vector{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  if (place.axes == 2) {
    place.rotation = {vector(c, s, 0), vector(-s, c, 0), Vector{}};
  } else {
    const std::int64_t both = fixed_product(s, c);
    place.rotation = {vector(c, s, 0), vector(-both, fixed_product(c, c), s), vector(fixed_product(s, s), -both, c)};
  }
}

Place place_of(const Function& function, const Configuration& configuration, std::span<const Word> inputs) {
  const auto word = [&](int column) { return inputs[static_cast<std::size_t>(column)]; };
  const auto number = [&](int column) { return static_cast<double>(std::bit_cast<float>(word(column))); };
  const auto whole = [&](int column) { return std::int64_t{static_cast<std::int32_t>(word(column))}; };
  Place place{};
  place.axes = static_cast<std::size_t>(function.axes);
  place.fixed = configuration.arithmetic == Arithmetic::fixed;
  for (int axis = 0; axis < function.axes; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    if (function.takes_cell()) {
      put_in_cell(place, at, whole(axis), number(function.axes + axis));
    } else {
      put_position(place, at, number(axis));
    }
    if (function.takes_period()) place.period[at] = std::max<std::int64_t>(whole(function.period_word() + axis), 0);
  }
  place.jitter = function.takes_jitter() ? std::clamp(number(function.input("jitter")), 0.0, 1.0) : 1.0;
  place.jitter_units = static_cast<std::int64_t>(place.jitter * kUnits);
  const std::int64_t metric = function.input("metric") >= 0 ? whole(function.input("metric")) : 1;
  place.metric = metric >= 1 && metric <= kMetrics ? static_cast<Metric>(metric) : Metric::euclidean;
  place.seed = word(function.seed_word());
  place.pcg = configuration.hash == "PCG";
  if (function.takes_phase()) put_phase(place, std::bit_cast<float>(word(function.input("phase"))));
  return place;
}

// --- Words, section 3 ---

Word mix(Word k) {
  k = (k ^ (k >> 15)) * 0x2C1B3C6Du;
  k = (k ^ (k >> 12)) * 0x297A2D39u;
  return k ^ (k >> 15);
}

Word pcg(Word k) {
  const Word s = k * 747796405u + 2891336453u;
  const Word w = ((s >> ((s >> 28) + 4u)) ^ s) * 277803737u;
  return (w >> 22) ^ w;
}

Word word_at(const Place& place, const Coordinates& cell) {
  constexpr std::array<Word, 3> kPrimes = {0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du};
  constexpr std::array<Word, 3> kShifts = {12u, 11u, 10u};
  constexpr std::array<Word, 3> kFactors = {1u, 0xE6133Eu, 0x913FDCu};
  Word added = mix(place.seed);
  Word joined = added >> 8;
  for (std::size_t axis = 0; axis < place.axes; ++axis) {
    std::int64_t c = cell[axis];
    const std::int64_t period = place.period[axis];
    if (period > 0) c = (c % period + period) % period;
    const Word spread = static_cast<Word>(c) * kPrimes[axis] + (axis == 0 ? 0x165667B1u : 0u);
    joined ^= spread >> kShifts[axis];
    added += (spread % 0x1000000u) * kFactors[axis];
  }
  const Word odd = (2u * added + 1u) * 4097u % 0x1000000u;
  if (!place.pcg) return joined * odd;
  const Word product = pcg(joined) * odd + joined;
  return product ^ (product >> 9);
}

// --- Directions, section 4 ---

Vector direction_of(Word h, std::size_t axes) {
  const auto field = [&](Word shift, Word count) {
    return (2.0 * static_cast<double>((h >> shift) & (count - 1u)) + 1.0) / static_cast<double>(count) - 1.0;
  };
  const double sign = h >> 31 ? -1.0 : 1.0;
  if (axes == 2) {
    const double a = field(14, 512);
    return {a, sign * (1.0 - std::fabs(a)), 0.0};
  }
  const double p = field(23, 256);
  const double q = field(15, 256);
  return {(p + q) / 2.0, (p - q) / 2.0, sign * (1.0 - std::max(std::fabs(p), std::fabs(q)))};
}

// --- Distances, section 16 ---

// A point, seen from the place. In fixed arithmetic the offset has units of 2^-20, and the rank is the number that is
// compared.
struct VisiblePoint {
  Coordinates from_cell;
  Vector offset;  // of the place from the point; of fixed arithmetic, where points go round, rotated backwards
  double square;  // in cells, or in units of 2^-28: `N`
  double rank;
};

double floor_of(double value) { return std::floor(value); }

// Numbers of fixed arithmetic are whole and below 2^53 up to where they are rounded down, so doubles hold them.
double square_of(const Vector& offset, bool fixed) {
  double sum = 0.0;
  for (const double d : offset) sum += d * d;
  return fixed ? floor_of(sum / 0x1p12) : sum;
}

double rank_of(const VisiblePoint& seen, Metric metric, bool fixed) {
  double sum = 0.0;
  double largest = 0.0;
  for (const double d : seen.offset) {
    sum += std::fabs(d);
    largest = std::max(largest, std::fabs(d));
  }
  switch (metric) {
    case Metric::manhattan:
      return sum;
    case Metric::chebyshev:
      return largest;
    case Metric::hybrid:
      return sum + (fixed ? floor_of(seen.square / 0x1p8) : seen.square);
    case Metric::euclidean:
    case Metric::squared:
      return seen.square;
  }
  throw std::logic_error("the search has no such metric");
}

// The root of 2^8 times a number, rounded down.
double root_of(double number) {
  const auto n = static_cast<std::uint64_t>(number) << 8;
  auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n)));
  while (root * root > n) --root;
  while ((root + 1) * (root + 1) <= n) ++root;
  return static_cast<double>(root);
}

double distance_of(double rank, Metric metric, bool fixed) {
  switch (metric) {
    case Metric::euclidean:
      return fixed ? root_of(rank) * 0x1p-18 : std::sqrt(rank);
    case Metric::squared:
      return fixed ? floor_of(rank / 0x1p8) * 0x1p-20 : rank;
    case Metric::manhattan:
    case Metric::chebyshev:
    case Metric::hybrid:
      return fixed ? rank * 0x1p-20 : rank;
  }
  throw std::logic_error("the search has no such metric");
}

// Where a direction has gone.
Vector moved(const Place& place, Vector u) {
  if (!place.moves) return u;
  const double a = static_cast<double>(place.angle) * 0x1p-32 * 2.0 * std::numbers::pi;
  const double c = std::cos(a);
  const double s = std::sin(a);
  if (place.axes == 3) u = {u[0], u[1] * c - u[2] * s, u[1] * s + u[2] * c};
  return {u[0] * c - u[1] * s, u[0] * s + u[1] * c, u[2]};
}

// An offset times a sine, in units of 2^-20.
double rotated(double offset, double sine) {
  const double high = floor_of(offset / 0x1p8);
  return floor_of(high * sine / 0x1p8) + floor_of((offset - high * 0x1p8) * sine / 0x1p16);
}

// The offset of a place from the centre of a cell, along an axis, rotated backwards.
double rotated_from(const Place& place, const Coordinates& step, std::size_t row) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < place.axes; ++axis) {
    const double b = place.rotation[row][axis];
    sum += rotated(static_cast<double>(place.units[axis] - 0x80000), b) - 16.0 * static_cast<double>(step[axis]) * b;
  }
  return sum;
}

// The offset of a place from a point, rotated forwards again.
Vector offset_of(const Place& place, const VisiblePoint& seen) {
  if (!place.moves || !place.fixed) return seen.offset;
  Vector offset{};
  for (std::size_t axis = 0; axis < place.axes; ++axis) {
    for (std::size_t row = 0; row < place.axes; ++row)
      offset[axis] += rotated(seen.offset[row], place.rotation[row][axis]);
  }
  return offset;
}

VisiblePoint seen_from(const Place& place, const Coordinates& step) {
  Coordinates cell{};
  for (std::size_t axis = 0; axis < place.axes; ++axis) cell[axis] = place.cell[axis] + step[axis];
  const Vector direction = direction_of(word_at(place, cell), place.axes);
  const Vector u = place.fixed ? direction : moved(place, direction);
  VisiblePoint seen{step, {}, 0.0, 0.0};
  for (std::size_t axis = 0; axis < place.axes; ++axis) {
    if (place.fixed) {
      const double centre = place.moves ? rotated_from(place, step, axis)
                                        : static_cast<double>(place.units[axis] - step[axis] * 0x100000 - 0x80000);
      seen.offset[axis] = centre - floor_of(512.0 * u[axis] * static_cast<double>(place.jitter_units) / 0x1p10);
    } else {
      seen.offset[axis] = place.fraction[axis] - static_cast<double>(step[axis]) - 0.5 - place.jitter / 2.0 * u[axis];
    }
  }
  seen.square = square_of(seen.offset, place.fixed);
  seen.rank = rank_of(seen, place.metric, place.fixed);
  return seen;
}

// By z, then by y, then by x: of points at the same distance the first counts.
std::vector<VisiblePoint> all_seen(const Place& place, int reach) {
  std::vector<VisiblePoint> all;
  const int depth = place.axes == 3 ? reach : 0;
  for (int z = -depth; z <= depth; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) all.push_back(seen_from(place, {x, y, z}));
    }
  }
  return all;
}

// Where points are at the same distance, those of the place's cell and of its neighbours come first.
bool is_nearer(const VisiblePoint& one, const VisiblePoint& other) {
  const auto beside = [](const VisiblePoint& seen) {
    return std::all_of(seen.from_cell.begin(), seen.from_cell.end(), [](std::int64_t c) { return c >= -1 && c <= 1; });
  };
  return one.rank < other.rank || (one.rank == other.rank && beside(one) && !beside(other));
}

// The three nearest, which come first.
std::array<const VisiblePoint*, 3> nearest_of(const std::vector<VisiblePoint>& all) {
  std::array<const VisiblePoint*, 3> nearest{};
  for (const VisiblePoint& seen : all) {
    const VisiblePoint* one = &seen;
    for (const VisiblePoint*& other : nearest) {
      if (other == nullptr || is_nearer(*one, *other)) std::swap(one, other);
      if (one == nullptr) break;
    }
  }
  return nearest;
}

// --- Output ---

double smooth_of(const std::vector<VisiblePoint>& all, bool fixed) {
  double weights = 0.0;
  for (const VisiblePoint& seen : all) {
    if (fixed) {
      const double t = std::min(floor_of(std::max(0x1p18 - root_of(seen.square), 0.0) / 4.0), 65535.0);
      const double q = floor_of(t * t / 0x1p16);
      weights += floor_of(q * q / 4.0);
    } else {
      weights += std::pow(std::max(0.0, 1.0 - std::sqrt(seen.square)), 4.0);
    }
  }
  if (fixed) return (0x1p19 - root_of(root_of(weights + 0x1p18) * 0x1p11)) * 0x1p-19;
  return 1.0 - std::pow(weights + 1.0 / 4096.0, 0.25);
}

double border_of(const std::vector<VisiblePoint>& all, const VisiblePoint& nearest, bool fixed) {
  double border = HUGE_VAL;
  for (const VisiblePoint& seen : all) {
    if (seen.from_cell == nearest.from_cell) continue;
    Vector apart{};
    for (std::size_t axis = 0; axis < apart.size(); ++axis) {
      apart[axis] = seen.offset[axis] - nearest.offset[axis];
      if (fixed) apart[axis] = floor_of(apart[axis] / 2.0);
    }
    const double gap = seen.square - nearest.square;
    const double square = square_of(apart, fixed);
    border =
        std::min(border, fixed ? floor_of(16.0 * gap / root_of(square)) * 0x1p-16 : gap / (2.0 * std::sqrt(square)));
  }
  return border;
}

double without_sign_of_zero(double value) { return value == 0.0 ? 0.0 : value; }

Vector derivatives_of(const VisiblePoint& nearest, bool fixed) {
  Vector slope{};
  if (!fixed) {
    const double distance = std::sqrt(nearest.square);
    for (std::size_t axis = 0; axis < slope.size() && distance > 0.0; ++axis) {
      slope[axis] = nearest.offset[axis] / distance;
    }
    return slope;
  }
  double m = 0.0;
  for (const double d : nearest.offset) m = std::max(m, std::fabs(d));
  const double a = m < 1024.0 ? 1024.0 : 1.0;
  const double b = m * a < 32768.0 ? 32.0 * a : a;
  const double k = m * b < 131072.0 ? 4.0 * b : b;
  Vector longer = nearest.offset;
  for (double& d : longer) d *= k;
  const double r = std::max(root_of(square_of(longer, true)), 1.0);
  for (std::size_t axis = 0; axis < slope.size(); ++axis) {
    const double size = floor_of(std::fabs(longer[axis]) * 0x1p19 / r) * 0x1p-21;
    slope[axis] = without_sign_of_zero(std::copysign(size, longer[axis]));
  }
  return slope;
}

FeaturePoint point_of(const Place& place, const VisiblePoint& seen) {
  FeaturePoint point{{}, seen.from_cell};
  const Vector offset = offset_of(place, seen);
  for (std::size_t axis = 0; axis < place.axes; ++axis) {
    const double unit = place.fixed ? 1.0 / kUnits : 1.0;
    const double fraction = place.fixed ? static_cast<double>(place.units[axis]) / kUnits : place.fraction[axis];
    point.at[axis] = fraction - offset[axis] * unit;
  }
  return point;
}

// The name of a cell: its coordinates as words, where a period replaces them.
double name_of(const Place& place, const VisiblePoint& seen, std::size_t axis) {
  const std::int64_t c = place.cell[axis] + seen.from_cell[axis];
  const std::int64_t period = place.period[axis];
  if (period > 0) return static_cast<double>((c % period + period) % period);
  return static_cast<double>(static_cast<std::int32_t>(static_cast<Word>(c)));
}

}  // namespace

CellularValue searched(const Function& function, const Configuration& configuration, std::span<const Word> inputs,
                       int reach) {
  const Place place = place_of(function, configuration, inputs);
  const std::vector<VisiblePoint> all = all_seen(place, reach);
  const auto sorted = nearest_of(all);
  const auto distance = [&](std::size_t i) { return distance_of(sorted[i]->rank, place.metric, place.fixed); };
  const VisiblePoint& nearest = *sorted[0];
  CellularValue result{
      {}, distance(0), distance(1), distance(2), point_of(place, nearest), point_of(place, *sorted[1])};
  const Vector slope = derivatives_of(nearest, place.fixed);
  for (std::size_t i = 0; i < function.outputs.size(); ++i) {
    const std::string_view name = function.outputs[i].name;
    const std::size_t axis = name.back() == 'z' ? 2 : name.back() == 'y' ? 1 : 0;
    double& value = result.values[i];
    if (function.bound == "cellular_smooth") {
      value = smooth_of(all, place.fixed);
    } else if (name.front() == 'n') {
      value = name_of(place, nearest, axis);
    } else if (name.front() == 'o') {
      value = without_sign_of_zero(-offset_of(place, nearest)[axis] * (place.fixed ? 1.0 / kUnits : 1.0));
    } else if (function.bound == "cell_border") {
      value = border_of(all, nearest, place.fixed);
    } else {
      value = function.is_slope(i) ? slope[axis] : distance(i);
    }
  }
  return result;
}

std::vector<FeaturePoint> feature_points(const Function& function, const Configuration& configuration,
                                         std::span<const Word> inputs) {
  const Place place = place_of(function, configuration, inputs);
  std::vector<FeaturePoint> points;
  for (const VisiblePoint& seen : all_seen(place, kSearchReach)) points.push_back(point_of(place, seen));
  return points;
}

namespace {

// The first and the second distance. The cell and its neighbours have both points; if they had not, other points would
// be left out, and none that is wrong would be right.
std::array<double, 2> two_distances(const Function& function, const Configuration& configuration,
                                    std::span<const Word> inputs) {
  const Place place = place_of(function, configuration, inputs);
  const std::vector<VisiblePoint> all = all_seen(place, 1);
  const auto nearest = nearest_of(all);
  return {distance_of(nearest[0]->rank, place.metric, place.fixed),
          distance_of(nearest[1]->rank, place.metric, place.fixed)};
}

}  // namespace

bool is_undecided(const Function& function, const Configuration& configuration, std::span<const Word> inputs) {
  if (!function.jumps() || has_same_bits(function, configuration)) return false;
  const auto [first, second] = two_distances(function, configuration, inputs);
  return second - first < kClearMargin;
}

double nearest_distance(const Function& function, const Configuration& configuration, std::span<const Word> inputs) {
  return two_distances(function, configuration, inputs)[0];
}

}  // namespace hn
