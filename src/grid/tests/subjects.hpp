// The subjects of the tests: every noise and sum, with settings, grids and lists drawn by chance.
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "grid/functions.hpp"
#include "hashnoise/field.hpp"
#include "twin.hpp"

namespace hashnoise::twin {

inline bool can_have_phase(const std::string& noise, int dimensions) {
  return (dimensions == 2 || dimensions == 3) && row_of(noise).has_phase();
}

// A setting by its name; a period along x, unless another axis is behind it, and the next component of a wave.
inline void set(Settings& s, const std::string& name, double value) {
  const auto whole = static_cast<int>(value);
  const auto number = static_cast<float>(value);
  const std::map<std::string, std::optional<float>*> numbers = {
      {"phase", &s.phase},   {"jitter", &s.jitter},      {"lacunarity", &s.lacunarity},
      {"gain", &s.gain},     {"strength", &s.strength},  {"amplitude", &s.amplitude},
      {"detail", &s.detail}, {"footprint", &s.footprint}};
  if (numbers.contains(name)) {
    *numbers.at(name) = number;
  } else if (name.starts_with("period")) {
    s.period.at(name == "period_z" ? 2 : name == "period_y" ? 1 : 0) = whole;
  } else if (name == "wave") {
    s.wave.push_back(number);
  } else if (name == "octaves") {
    s.octaves = whole;
  } else if (name == "metric") {
    s.metric = static_cast<Metric>(whole);
  } else if (name == "instruction_set") {
    s.instruction_set = static_cast<InstructionSet>(whole);
  } else if (name == "arithmetic") {
    s.arithmetic = static_cast<Arithmetic>(whole);
  } else {
    throw std::logic_error("there is no setting " + name);
  }
}

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  std::uint32_t word() { return static_cast<std::uint32_t>(engine_()); }
  int whole(int from, int to) { return std::uniform_int_distribution(from, to)(engine_); }
  bool one_in(int n) { return whole(1, n) == 1; }
  float between(float from, float to) { return std::uniform_real_distribution(from, to)(engine_); }

  template <typename T, std::size_t N>
  T of(const T (&choices)[N]) {
    return choices[whole(0, static_cast<int>(N) - 1)];
  }

 private:
  std::mt19937_64 engine_;
};

// Every noise, with a phase where it can have one, and every sum over every noise. The rest is as Settings has it.
inline std::vector<Settings> noise_subjects(int dimensions) {
  std::vector<Settings> subjects;
  for (const std::string& noise : noises(dimensions)) {
    Settings settings;
    settings.noise = noise;
    subjects.push_back(settings);
    if (!can_have_phase(noise, dimensions)) continue;
    settings.phase = 0.0f;
    subjects.push_back(settings);
  }
  return subjects;
}

inline std::vector<Settings> sum_subjects(int dimensions) {
  std::vector<Settings> subjects;
  for (const std::string& sum : sums(dimensions)) {
    for (const std::string& noise : noises_of(sum, dimensions)) {
      Settings settings;
      settings.noise = noise;
      settings.fractal = sum;
      subjects.push_back(settings);
      if (!grid::sum_row(sum).has_phase) continue;
      settings.phase = 0.0f;
      subjects.push_back(settings);
    }
  }
  return subjects;
}

// Draws what a subject takes: a seed, the settings of its noise and of its sum, and with `tiled` a period. `tame` stays
// where the documents bound the error of floats.
enum class Draw { kTame, kWild };
inline void draw_settings(Settings& s, int dimensions, bool tiled, Draw draw, Chance& chance) {
  const bool wild = draw == Draw::kWild;
  s.seed = chance.one_in(4) ? 0u : chance.word();
  s.period = {};
  if (tiled) {
    for (int axis = 0; axis < dimensions; ++axis) {
      s.period[static_cast<std::size_t>(axis)] =
          chance.of({0, 1, 2, 3, 5, 7, 64, 100, 256, 1000003, 1 << 30, std::numeric_limits<std::int32_t>::max()});
    }
    if (!has_period(s, dimensions)) s.period[0] = 6;
  }
  if (s.phase) s.phase = chance.of({0.0f, 0.25f, 1.0f / 3.0f, -0.7f, 12345.625f, chance.between(-2.0f, 2.0f)});
  if (s.fractal.empty()) {
    if (row_of(s.noise).has_jitter()) s.jitter = chance.of({1.0f, 1.0f, 0.0f, 0.5f, chance.between(0.0f, 1.0f)});
    if (row_of(s.noise).has_metric() && !s.phase) {
      s.metric = static_cast<Metric>(chance.whole(1, static_cast<int>(std::size(grid::kMetricNames))));
    }
    s.wave.clear();
    if (row_of(s.noise).has_wave() && !chance.one_in(5)) {
      for (int axis = 0; axis < dimensions; ++axis) {
        s.wave.push_back(chance.of({0.0f, 16.0f, -16.0f, 2.5f, chance.between(-16.0f, 16.0f)}));
      }
    }
    return;
  }
  const bool has_jacobians = s.fractal == "fbm_d" || s.fractal == "eroded" || s.fractal == "warp_progressive";
  s.octaves = wild ? chance.of({1, 2, 3, 5, 6, 8, 12, 32}) : chance.whole(1, 6);
  s.lacunarity = wild ? chance.of({2.0f, 2.0f, 1.97f, 3.0f, 2.5f, 1.0f, 0.5f, 0.0f}) : chance.of({2.0f, 1.9f});
  s.gain = wild ? chance.of({0.5f, 0.5f, 0.7f, 0.25f, 1.0f, 0.0f, 1.5f}) : chance.of({0.5f, 0.4f});
  // Beyond these there is an error of a field.
  if (tiled) s.lacunarity = std::max(1.0f, std::trunc(*s.lacunarity));
  if (s.arithmetic == Arithmetic::kFixed) s.gain = std::min(*s.gain, 1.0f);
  if (s.octaves == 32) s.gain = 0.5f;  // so that no power of the gain leaves what HN_PRECISE is defined for
  if (has_jacobians) {                 // nor do Jacobians leave what HN_FIXED is defined for
    s.octaves = std::min(*s.octaves, 8);
    s.gain = std::min(*s.gain, 0.5f);
  }
  s.strength.reset();
  const grid::SumRow& sum = grid::sum_row(s.fractal);
  if (sum.strength == "strength" && !chance.one_in(3)) {
    s.strength = chance.between(0.0f, std::min(2.5f * sum.usual_strength, sum.most_strength));
  }
  if (sum.strength == "amplitude") s.amplitude = chance.of({0.5f, 1.0f, 0.25f});
  if (s.detail) {
    s.octaves.reset();
    s.detail = chance.of({0.0f, 1.0f, 3.5f, 6.0f, chance.between(0.0f, 7.0f)});
  }
  if (s.footprint) s.footprint = chance.of({0.0f, 0.0625f, 0.75f, 3.0f, chance.between(0.0f, 1.0f)});
}

// Sizes whose product is at most `most`: 1, primes, powers of two, and others.
template <int D>
std::array<int, D> draw_size(int most, Chance& chance) {
  std::array<int, D> size{};
  // Another axis in front each time, so that each gets the room.
  const int first = chance.whole(0, D - 1);
  for (int i = 0; i < D; ++i) {
    int& points = size[static_cast<std::size_t>((first + i) % D)];
    points = std::min(most, chance.of({1, 2, 3, 4, 5, 7, 8, 11, 13, 16, 17, 31, 32, 37, 61, 64, 127}));
    most /= points;
  }
  return size;
}

// Wild coordinates are far out, tiny, whole, or on the walls of cells. `largest` is the largest that is drawn.
inline float draw_coordinate(float largest, Draw draw, Chance& chance) {
  if (draw == Draw::kTame) return chance.between(-largest, largest);
  switch (chance.whole(0, 9)) {
    case 0:
      return chance.between(-largest, largest);
    case 1:
      return static_cast<float>(chance.whole(-1000, 1000));
    case 2:
      return static_cast<float>(chance.whole(-1000, 1000)) + 0.5f;
    case 3:
      return chance.between(-1000.0f, 1000.0f);
    case 4:  // p - floor(p) rounds to 1 for some
      return chance.of({0.0f, -0.0f, 1e-40f, -1e-40f, 0x1p-33f, -0x1p-33f, 0x1p-31f, -0x1p-31f, -1e-9f, 0x1p-20f});
    default:
      return chance.between(-4.0f, 4.0f);
  }
}

template <int D>
Grid<D> draw_grid(int most, float largest, Draw draw, Chance& chance) {
  Grid<D> grid;
  grid.size = draw_size<D>(most, chance);
  for (std::size_t axis = 0; axis < D; ++axis) {
    grid.origin[axis] = draw_coordinate(largest, draw, chance);
    grid.step[axis] = draw == Draw::kTame
                          ? chance.of({0.0371f, -0.0371f, 0.01f})
                          : chance.of({1e-6f, 0.0371f, -0.0371f, 0.0f, 1.0f, 0.125f, 2.75f, -3.1f, 0.141421356f});
    grid.first[axis] = draw == Draw::kTame ? 0 : chance.of({0, 0, 1, 63, 100003});
  }
  return grid;
}

template <int D>
CellGrid<D> draw_cell_grid(int most, Chance& chance) {
  CellGrid<D> grid;
  grid.size = draw_size<D>(most, chance);
  for (std::size_t axis = 0; axis < D; ++axis) {
    grid.cell[axis] = chance.one_in(2) ? static_cast<std::int32_t>(chance.word()) : chance.whole(-100, 100);
    grid.f[axis] = chance.of({0.0f, 0.5f, 1.0f, chance.between(0.0f, 1.0f)});
    grid.step[axis] = chance.of({1e-9, 0x1p-32, 0.0371, -0.0371, 0.0, 1.0, 0.125, 2.75, -3.1, 0.14142135623730951,
                                 -1.0 / 3.0, 1e6 / 3.0, 2147483646.7});
    grid.first[axis] = chance.of({0, 0, 1, 63, 100003, (1 << 29) - 1 - grid.size[axis]});
  }
  return grid;
}

// Lists that own their items.
template <int D>
struct PointList {
  std::array<std::vector<float>, D> p;
  operator Points<D>() const {
    Points<D> points;
    std::ranges::copy(p, points.p.begin());
    return points;
  }
};
template <int D>
struct CellPointList {
  std::array<std::vector<std::int32_t>, D> cell;
  std::array<std::vector<float>, D> f;
  operator CellPoints<D>() const {
    CellPoints<D> points;
    std::ranges::copy(cell, points.cell.begin());
    std::ranges::copy(f, points.f.begin());
    return points;
  }
};

template <int D>
PointList<D> draw_points(int count, float largest, Draw draw, Chance& chance) {
  PointList<D> list;
  for (auto& axis : list.p) {
    for (int i = 0; i < count; ++i) axis.push_back(draw_coordinate(largest, draw, chance));
  }
  return list;
}

template <int D>
CellPointList<D> draw_cell_points(int count, Chance& chance) {
  using Limits = std::numeric_limits<std::int32_t>;
  CellPointList<D> list;
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (int i = 0; i < count; ++i) {
      list.cell[axis].push_back(chance.one_in(3) ? chance.whole(-100, 100) : static_cast<std::int32_t>(chance.word()));
      if (chance.one_in(16)) list.cell[axis].back() = chance.of({Limits::min(), Limits::max(), 0, -1});
      list.f[axis].push_back(chance.between(0.0f, 1.0f));
      if (chance.one_in(8)) list.f[axis].back() = chance.of({0.0f, 0.5f, 1.0f, 1.0f - 0x1p-24f, 0x1p-24f, 1e-12f});
    }
  }
  return list;
}

}  // namespace hashnoise::twin
