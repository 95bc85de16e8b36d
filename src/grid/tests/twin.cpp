#include "twin.hpp"

#include <algorithm>

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
  std::vector<Noise> all = {{"value", 1}, {"value_d", 1 + dimensions}, {"perlin", 1}, {"perlin_d", 1 + dimensions}};
  if (dimensions <= 3) all.push_back({"value_cubic", 1});
  if (dimensions >= 2) {
    all.push_back({"simplex", 1});
    all.push_back({"simplex_d", 1 + dimensions});
  }
  if (dimensions == 2 || dimensions == 3) {
    all.push_back({"simplex_smooth", 1});
    all.push_back({"cellular", 2});
    all.push_back({"cellular_three", 3});
    all.push_back({"cellular_d", 1 + dimensions});
    all.push_back({"cellular_smooth", 1});
    all.push_back({"cell_border", 1});
    all.push_back({"curl", dimensions});
  }
  return all;
}

std::vector<std::string> sums(int dimensions) {
  std::vector<std::string> all = {"fbm", "turbulence", "clouds", "billow", "ridged", "ping_pong", "weighted"};
  if (dimensions == 2 || dimensions == 3) all.insert(all.end(), {"fbm_d", "eroded", "warp", "warp_progressive"});
  return all;
}

std::vector<std::string> noises_of(const std::string& sum, int dimensions) {
  if (sum == "fbm_d" || sum == "eroded") return {"value_d", "perlin_d", "simplex_d"};
  std::vector<std::string> names;
  for (const Noise& noise : noises(dimensions)) {
    if (noise.components == 1) names.push_back(noise.name);
  }
  return names;
}

}  // namespace hashnoise::twin
