// The bounds of octave sums (bounds.cpp, gullies.cpp), for tools/make bounds: it answers each line
//
//   value|slope SUM   largest coordinate, octaves, lacunarity, gain, exact positions, strength, footprint (-1: none),
//                     rotates, from a cell, is a detail, amplitude
//                     axes, cell error, error, lipschitz, limit of the noise, and the same of its derivative
//
// with a number, and
//
//   gullies gullies   the same up to the amplitude, then the length of the slope and the depth
//                     the numbers of GULLIES_BOUNDS
//
// with that of the height and that of a slope; where there is no proof, with a sentence.
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "sums/bounds.cpp"
#include "sums/errors.cpp"
#include "sums/gullies.cpp"

namespace {

struct Sum {
  const char* name;
  hn::SumRule rule;
};
constexpr Sum kSums[] = {
#define OCTAVE_SUM(name, noise, most, least, greatest, bounded, step, mean) \
  {#name, {hn::SumStep::step, hn::SumMean::mean, most}},
#include "library/sums.inc"
};

std::istream& operator>>(std::istream& in, hn::FloatBounds& bounds) {
  return in >> bounds.axes >> bounds.cell_error >> bounds.error >> bounds.lipschitz >> bounds.limit;
}

std::istream& operator>>(std::istream& in, hn::OctaveArguments& arguments) {
  double footprint = 0.0;
  in >> arguments.largest_coordinate >> arguments.octaves >> arguments.lacunarity >> arguments.gain >>
      arguments.exact_positions >> arguments.strength >> footprint >> arguments.rotates >> arguments.from_cell >>
      arguments.is_detail >> arguments.amplitude;
  if (footprint >= 0.0) arguments.footprint = footprint;
  return in;
}

std::istream& operator>>(std::istream& in, hn::GulliesBounds& bounds) {
  return in >> bounds.value >> bounds.lipschitz >> bounds.wave_rate >> bounds.slope >> bounds.slope_lipschitz >>
         bounds.slope_wave_rate >> bounds.steepest >> bounds.fixed_value >> bounds.fixed_slope;
}

bool answer_of_gullies() {
  hn::GulliesArguments arguments{};
  hn::GulliesBounds bounds{};
  std::cin >> arguments.octaves >> arguments.slope >> arguments.depth >> bounds;
  const hn::GulliesTolerance tolerance = hn::gullies_tolerance(arguments, bounds);
  std::printf("%.17g %.17g\n", tolerance.height, tolerance.slope);
  return static_cast<bool>(std::cin);
}

bool answer_of_sum(const std::string& what, const std::string& name) {
  hn::OctaveArguments arguments{};
  hn::FloatBounds noise{};
  hn::FloatBounds slope{};
  std::cin >> arguments >> noise >> slope;
  const auto* const sum = std::ranges::find(kSums, name, &Sum::name);
  if (!std::cin || sum == std::end(kSums)) return false;
  std::printf("%.17g\n", what == "slope" ? hn::octave_slope_tolerance(sum->rule, arguments, noise, slope)
                                         : hn::octave_tolerance(sum->rule, arguments, noise, slope));
  return true;
}

}  // namespace

int main() {
  std::string what;
  std::string name;
  while (std::cin >> what >> name) {
    try {
      if (!(what == "gullies" ? answer_of_gullies() : answer_of_sum(what, name))) return 1;
    } catch (const std::exception& error) {
      std::printf("%s\n", error.what());
    }
    std::fflush(stdout);
  }
  return 0;
}
