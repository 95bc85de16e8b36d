#include "twin.hpp"

#include <algorithm>

#include "grid/functions.hpp"
#include "grid/plan.hpp"
#include "twin_of_arithmetic.hpp"

namespace hashnoise::twin {

bool has_period(const Settings& settings, int dimensions) {
  return std::any_of(settings.period.begin(), settings.period.begin() + dimensions, [](int p) { return p > 0; });
}

template <int D>
Function<D> function(const Settings& settings) {
  switch (settings.arithmetic) {
    case Arithmetic::kFast:
      return function_of<D, Arithmetic::kFast>(settings);
    case Arithmetic::kPrecise:
      return function_of<D, Arithmetic::kPrecise>(settings);
    case Arithmetic::kFixed:
      break;
  }
  return function_of<D, Arithmetic::kFixed>(settings);
}
template Function<1> function<1>(const Settings&);
template Function<2> function<2>(const Settings&);
template Function<3> function<3>(const Settings&);
template Function<4> function<4>(const Settings&);

std::vector<Noise> noises(int dimensions) {
  std::vector<Noise> all;
  for (const grid::NoiseRow& row : grid::kNoiseRows) {
    if (dimensions < row.first_dimension || row.last_dimension < dimensions) continue;
    all.push_back({std::string(row.name), grid::components_of(row.shape, dimensions)});
  }
  return all;
}

std::vector<std::string> sums(int dimensions) {
  std::vector<std::string> all;
  for (const grid::SumRow& row : grid::kSumRows) {
    if (row.first_dimension <= dimensions && dimensions <= row.last_dimension) all.emplace_back(row.name);
  }
  return all;
}

std::vector<std::string> noises_of(const std::string& sum, int dimensions) {
  if (!grid::sum_row(sum).takes_noise()) return {""};
  const grid::Shape shape = grid::sum_row(sum).of;
  std::vector<std::string> names;
  for (const Noise& noise : noises(dimensions)) {
    if (grid::kNoiseRows[grid::noise_named(noise.name)].shape == shape) names.push_back(noise.name);
  }
  return names;
}

std::string noise_below(const std::string& sum) {
  const grid::SumRow& row = grid::sum_row(sum);
  return row.takes_noise() ? std::string(grid::kNoiseRows[row.usual_noise].name) : "";
}

float strength_of(const Settings& s) { return s.strength.value_or(grid::sum_row(s.fractal).usual_strength); }

}  // namespace hashnoise::twin
