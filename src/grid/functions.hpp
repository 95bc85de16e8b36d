// The functions that a field can be: their names, in which dimensions they are, and which settings they take.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "kernel.hpp"
#include "rules.hpp"

namespace hashnoise::grid {

// What the numbers at a point are.
enum class Shape {
  kValue,         // a value
  kWithSlopes,    // a value and a derivative along each axis
  kTwoDistances,  // f1, f2
  kThreeDistances,
  kDistanceWithSlopes,
  kVector,  // a component along each axis
};

struct NoiseRow {
  std::string_view name;
  int first_dimension, last_dimension;
  Shape shape;
  bool has_phase;  // in 2D and 3D
  bool has_jitter;
  bool has_metric;
};

// The noise that a sum takes has the shape `of`.
struct SumRow {
  std::string_view name;
  int first_dimension, last_dimension;
  Shape shape;
  Shape of;
  std::string_view strength;  // what it calls that parameter, or nothing
  float usual_strength;
  float most_strength;
};

// By NoiseId and SumId.
constexpr std::array<NoiseRow, kNoises> kNoiseRows = {{
    {"value", 1, 4, Shape::kValue, false, false, false},
    {"value_d", 1, 4, Shape::kWithSlopes, false, false, false},
    {"value_cubic", 1, 3, Shape::kValue, false, false, false},
    {"perlin", 1, 4, Shape::kValue, true, false, false},
    {"perlin_d", 1, 4, Shape::kWithSlopes, true, false, false},
    {"simplex", 2, 4, Shape::kValue, true, false, false},
    {"simplex_d", 2, 4, Shape::kWithSlopes, true, false, false},
    {"simplex_smooth", 2, 3, Shape::kValue, false, false, false},
    {"cellular", 2, 3, Shape::kTwoDistances, false, true, true},
    {"cellular_three", 2, 3, Shape::kThreeDistances, false, true, true},
    {"cellular_d", 2, 3, Shape::kDistanceWithSlopes, false, true, false},
    {"cellular_smooth", 2, 3, Shape::kValue, false, true, false},
    {"cell_border", 2, 3, Shape::kValue, false, true, false},
    {"curl", 2, 3, Shape::kVector, false, false, false},
}};
constexpr std::array<SumRow, kNamedSums> kSumRows = {{
    {"fbm", 1, 4, Shape::kValue, Shape::kValue, "", 0, 0},
    {"turbulence", 1, 4, Shape::kValue, Shape::kValue, "", 0, 0},
    {"clouds", 1, 4, Shape::kValue, Shape::kValue, "", 0, 0},
    {"billow", 1, 4, Shape::kValue, Shape::kValue, "", 0, 0},
    {"ridged", 1, 4, Shape::kValue, Shape::kValue, "", 0, 0},
    {"ping_pong", 1, 4, Shape::kValue, Shape::kValue, "strength", 2, 64},
    {"weighted", 1, 4, Shape::kValue, Shape::kValue, "strength", 1, 1},
    {"fbm_d", 2, 3, Shape::kWithSlopes, Shape::kWithSlopes, "", 0, 0},
    {"eroded", 2, 3, Shape::kValue, Shape::kWithSlopes, "strength", 1, 16},
    {"warp", 2, 3, Shape::kVector, Shape::kValue, "amplitude", 1, 64},
    {"warp_progressive", 2, 3, Shape::kVector, Shape::kValue, "amplitude", 1, 64},
}};

constexpr Rule strength_rule(const SumRow& sum) {
  return {sum.strength, false, 0, static_cast<double>(sum.most_strength), static_cast<double>(sum.usual_strength)};
}

}  // namespace hashnoise::grid
