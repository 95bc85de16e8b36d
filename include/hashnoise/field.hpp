// Noises and fractals that are chosen at run time, over grids and lists of points, with the widest instructions that
// the processor has. This is the header of the compiled library: link hashnoise::grid.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/field.hpp>
//
//   hashnoise::Settings settings;
//   settings.noise = "simplex";
//   settings.fractal = "fbm";
//   const hashnoise::Field<2> field(settings);
//   std::vector<float> heights(1024 * 1024);
//   const hashnoise::Range range = field.fill(hashnoise::Grid<2>{{0, 0}, {0.01f, 0.01f}, {1024, 1024}}, heights);
//
// The hash and the gradient are the defaults of the library. With Arithmetic::kFixed and kPrecise the bits are those of
// the scalar functions of hashnoise.hpp and of the shader, with any instructions. With Arithmetic::kFast they may
// differ by instruction set, within the error that the function states. Nothing depends on the number of threads.

#pragma once

#include "points.hpp"

// clang-format off
#include "../../glsl/hashnoise/detail/macros_begin.h"
// clang-format on

#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Exports the public part of a shared library; the rest stays inside.
#if defined(__GNUC__) && !defined(_WIN32)
#define HN_I_OFFERED __attribute__((visibility("default")))
#else
#define HN_I_OFFERED
#endif

namespace hashnoise::inline HN_I_LIBRARY {

enum class Arithmetic { kFast = 1, kPrecise = 2, kFixed = 3 };  // HN_FAST, HN_PRECISE, HN_FIXED

// The values are those of HN_METRIC_EUCLIDEAN and so on.
enum class Metric { kEuclidean = 1, kSquared = 2, kManhattan = 3, kChebyshev = 4, kHybrid = 5 };

enum class InstructionSet { kSse41, kAvx2, kAvx512, kNeon, kGeneric };

// A whole number that may be left out. std::optional<int> would take a float, too, and drop its fraction.
struct OptionalInt : std::optional<int> {
  OptionalInt() = default;
  OptionalInt(std::nullopt_t) {}
  OptionalInt(const std::optional<int>& value) : std::optional<int>(value) {}
  OptionalInt(int value) : std::optional<int>(value) {}
  template <std::floating_point T>
  OptionalInt(T) = delete;
};

// Describes a field. The names are those of the functions in GLSL without hn_ and without the forms: cellular with a
// phase is hn_cellular_phase. The numbers are the parameters of the functions. A setting that the function does not
// have, or a number outside of its range, is an error of Field's constructor. The octaves of a fractal rotate unless it
// has a period. In a major version this struct stays as it is, because programs pass it to a shared library: a setting
// of a later version is a member of another struct, which another constructor of Field takes beside this one.
struct Settings {
  // "value", "simplex_d", ...: see noises(dimensions); if empty "perlin", or what the fractal takes in GLSL. The
  // fractal perlin_worley has noises of its own, and takes none.
  std::string noise{};
  // The fractal type: "fbm", "ridged", "warp", ...: see fractals(dimensions); the noise itself if empty.
  std::string fractal{};
  Arithmetic arithmetic = Arithmetic::kFast;
  std::uint32_t seed = 0;
  // In cells, along each axis, not negative; 0 is none, so {8} repeats along x alone. For axes that the field does not
  // have the numbers do not count.
  std::array<std::int32_t, 4> period{};

  // For noises.
  // In turns; perlin, perlin_d, simplex, simplex_d, cellular and phasor in 2D and 3D. In 3D and for cellular a phase of
  // 0 is not the noise without a phase.
  std::optional<float> phase{};
  std::optional<float> jitter{};   // in [0, 1], and 1 if it is left out; cellular noises
  std::optional<Metric> metric{};  // the distance function, and kEuclidean if it is left out; cellular, cellular_three
  // A number for each axis, in [-16, 16]: the direction in which waves run, times the waves per cell. 3 along x if it
  // is empty; phasor.
  std::vector<float> wave{};

  // For fractals.
  OptionalInt octaves{};  // from 1 to 32, and 6 if it is left out
  // 2 if it is left out. With a period whole, from 1 to 255; in cells and with kFixed from 0 to 255.
  std::optional<float> lacunarity{};
  std::optional<float> gain{};  // not negative, and with kFixed at most 1; 0.5 if it is left out
  // For ping_pong in [0, 64], 2 if it is left out; for weighted in [0, 1], 1; for eroded in [0, 16], 1.
  std::optional<float> strength{};
  std::optional<float> amplitude{};  // in [0, 64], and 1 if it is left out; warp, warp_progressive
  std::optional<float> detail{};     // in [0, 32]; fbm without a period: octaves as a float, in place of `octaves`
  std::optional<float> footprint{};  // not negative; fbm without a period

  // The widest that this processor and the library have, if it is left out.
  std::optional<InstructionSet> instruction_set{};
};

// Settings since version 1.1.
struct MoreSettings {
  // In [0, 16], and 0 if it is left out: how far the wave of each lattice point is from `wave`, in waves per cell;
  // phasor.
  std::optional<float> bandwidth{};
};

// Runs task(0) to task(count - 1), in any order, and returns when all are done.
using Executor = std::function<void(int count, const std::function<void(int)>& task)>;

// An executor of that many threads, this one included; 0 for as many as the processor has. It starts the others anew in
// each call, so for many small grids pass an executor over your own threads.
HN_I_OFFERED Executor threads(int count = 0);

// A field in D dimensions, 1 to 4. It has no state that changes: many threads may use one at once. One that was moved
// from may only be assigned to, or destroyed.
template <int D>
class HN_I_OFFERED Field {
  static_assert(1 <= D && D <= 4, "hashnoise: a field has 1 to 4 dimensions");

 public:
  // Throws std::invalid_argument, which names the wrong value and the right ones. It does so for all settings where
  // instruction_sets() is empty.
  explicit Field(const Settings& settings);
  Field(const Settings& settings, const MoreSettings& more);
  ~Field();
  Field(Field&&) noexcept;
  Field& operator=(Field&&) noexcept;

  // How many numbers the field has at a point. Each is a plane of its own in what `fill` writes: first all values, then
  // all derivatives along x, and so on.
  int component_count() const;

  // The names of the numbers: "value", "dx", "x", "f1", ... of each component.
  std::vector<std::string> components() const;

  InstructionSet instruction_set() const;

  // Writes component_count() * points numbers, and returns the least and the greatest of them (of the first component).
  // Throws std::invalid_argument if `values` has another size, or if a number of a grid is not finite or out of range.
  // Where a coordinate of a list of points is NaN or infinite, all numbers of that point are NaN.
  Range fill(const Grid<D>& grid, std::span<float> values, const Executor& executor = {}) const;
  Range fill(const CellGrid<D>& grid, std::span<float> values, const Executor& executor = {}) const;
  Range fill(const Points<D>& points, std::span<float> values, const Executor& executor = {}) const;
  Range fill(const CellPoints<D>& points, std::span<float> values, const Executor& executor = {}) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

extern template class Field<1>;
extern template class Field<2>;
extern template class Field<3>;
extern template class Field<4>;

// The noises and the fractals that there are in so many dimensions, in the order of the documents.
HN_I_OFFERED std::vector<std::string_view> noises(int dimensions);
HN_I_OFFERED std::vector<std::string_view> fractals(int dimensions);

// The instruction sets of both this processor and the library, the widest first. A library for x86 has nothing for
// processors without SSE4.1; CMake's HASHNOISE_INSTRUCTION_SETS chooses its sets.
HN_I_OFFERED std::vector<InstructionSet> instruction_sets();
HN_I_OFFERED std::string_view name(InstructionSet set);  // "sse4.1", "avx2", "avx512", "neon", "generic"

}  // namespace hashnoise

#include "../../glsl/hashnoise/detail/macros_end.h"
