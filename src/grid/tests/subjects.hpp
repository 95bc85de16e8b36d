// The subjects of tests, and their places: every noise and every sum, with settings, grids and lists drawn by chance.
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hashnoise/field.hpp"

namespace hashnoise::twin {

bool has_jitter(const std::string& noise);
bool has_metric(const std::string& noise);
bool has_wave(const std::string& noise);
bool can_have_phase(const std::string& noise, int dimensions);

// Every noise, with a phase where it can have one, and every sum over every noise. The rest is as Settings has it.
std::vector<Settings> noise_subjects(int dimensions);
std::vector<Settings> sum_subjects(int dimensions);

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  std::uint32_t word() { return static_cast<std::uint32_t>(engine_()); }
  int whole(int from, int to) { return std::uniform_int_distribution(from, to)(engine_); }
  bool one_in(int n) { return whole(1, n) == 1; }
  float between(float from, float to);

  template <typename T, std::size_t N>
  T of(const T (&choices)[N]) {
    return choices[whole(0, static_cast<int>(N) - 1)];
  }

 private:
  std::mt19937_64 engine_;
};

// Draws what a subject takes: a seed, the settings of its noise and of its sum, and with `tiled` a period. `tame` stays
// where the documents bound the error of floats.
enum class Draw { kTame, kWild };
void draw_settings(Settings& settings, int dimensions, bool tiled, Draw draw, Chance& chance);

// Sizes whose product is at most `most`: 1, primes, powers of two, and others.
template <int D>
std::array<int, D> draw_size(int most, Chance& chance);

// Wild coordinates are far out, tiny, whole, or on the walls of cells. `largest` is the largest that is drawn.
float draw_coordinate(float largest, Draw draw, Chance& chance);

template <int D>
Grid<D> draw_grid(int most, float largest, Draw draw, Chance& chance);
template <int D>
CellGrid<D> draw_cell_grid(int most, Chance& chance);

// Lists that own their items.
template <int D>
struct PointList {
  std::array<std::vector<float>, D> p;
  operator Points<D>() const;
};
template <int D>
struct CellPointList {
  std::array<std::vector<std::int32_t>, D> cell;
  std::array<std::vector<float>, D> f;
  operator CellPoints<D>() const;
};
template <int D>
PointList<D> draw_points(int count, float largest, Draw draw, Chance& chance);
template <int D>
CellPointList<D> draw_cell_points(int count, Chance& chance);

}  // namespace hashnoise::twin
