// What the suite says of octave sums (conformance/expected/sum_bounds.cpp), for tools/bounds: it answers each line
//
//   value|slope SUM   largest coordinate, octaves, lacunarity, gain, exact positions, strength, footprint (-1: none),
//                     turns, from a cell, is a detail, amplitude
//                     axes, cell error, error, lipschitz, limit of the noise, and the same of its derivative
//
// with a number.
#include <cstdio>
#include <iostream>
#include <string>

#include "expected/sum_bounds.cpp"

namespace {

struct Sum {
  const char* name;
  hn::SumRule rule;
};
constexpr Sum kSums[] = {
#define OCTAVE_SUM(name, noise, most, least, greatest, bounded, step, mean) \
  {#name, {hn::SumStep::step, hn::SumMean::mean, most}},
#include "library/facts.inc"
};

std::istream& operator>>(std::istream& in, hn::FloatBounds& bounds) {
  return in >> bounds.axes >> bounds.cell_error >> bounds.error >> bounds.lipschitz >> bounds.limit;
}

}  // namespace

int main() {
  std::string what;
  std::string name;
  while (std::cin >> what >> name) {
    hn::OctaveArguments arguments{};
    double footprint = 0.0;
    hn::FloatBounds noise{};
    hn::FloatBounds slope{};
    std::cin >> arguments.largest_coordinate >> arguments.octaves >> arguments.lacunarity >> arguments.gain >>
        arguments.exact_positions >> arguments.strength >> footprint >> arguments.turns >> arguments.from_cell >>
        arguments.is_detail >> arguments.amplitude >> noise >> slope;
    const auto* const sum = std::ranges::find(kSums, name, &Sum::name);
    if (!std::cin || sum == std::end(kSums)) return 1;
    if (footprint >= 0.0) arguments.footprint = footprint;
    const double tolerance = what == "slope" ? hn::octave_slope_tolerance(arguments, noise, slope)
                                             : hn::octave_tolerance(sum->rule, arguments, noise, slope);
    std::printf("%.17g\n", tolerance);
    std::fflush(stdout);
  }
  return 0;
}
