// The part of the library that is compiled for one instruction set gives a table of kernels to the part that is
// compiled for all. These are plain types: an inline function here could be linked from the wrong part.
#pragma once

#include <cstdint>
#include <hashnoise/glsl.hpp>
#include <limits>

namespace hashnoise::inline HN_I_NAMESPACE::grid {

// The kinds of numbers at a point.
enum class Shape {
  kValue,         // a value
  kWithSlopes,    // a value and a derivative along each axis
  kTwoDistances,  // f1, f2
  kThreeDistances,
  kDistanceWithSlopes,
  kVector,  // a component along each axis
  kValueAndQuadrature,
};

// The inputs of a noise beside a seed and a period. A phase exists in 2D and 3D, and rules out a metric. A noise with a
// wave needs both a wave and a phase.
enum class Inputs { kNothing, kPhase, kJitter, kJitterAndMetric, kJitterAndMetricAndPhase, kBandwidthAndPhaseAndWave };

// The noises, and the functions that sum them, in the order of the catalog.
enum NoiseId {
#define HN_CATALOG_NOISE(Id, ...) k##Id,
#include "catalog.inc"
  kNoises
};
enum SumId {
#define HN_CATALOG_SUM(Id, ...) k##Id,
#include "catalog.inc"
  kNamedSums,
  kDetail = kNamedSums,  // fbm with a detail, and with a footprint
  kFootprint,
  kFlowsWithPhase,  // curl_fbm with a phase
  kSums
};

constexpr int kMostComponents = 5;  // a value and four derivatives

struct Batch;
struct Options;

// A noise that a sum calls, of lanes; its type is known to loops.hpp alone.
using Octave = void (*)();

using Kernel = void (*)(const Batch& batch, const Options& options, Octave octave);

// The kernels of a function; null where there is none.
struct Loops {
  Kernel points;
  // `points` itself if that is not faster:
  Kernel row;   // where only the coordinates along x differ
  Kernel line;  // of points that lie on a straight line, as far from each other as the batch has it
};
constexpr Loops always(Kernel kernel) { return {kernel, kernel, kernel}; }

// The arguments of a function beside the point.
struct Options {
  Loops noise;       // that a fractal adds up
  std::int32_t sum;  // SumId
  std::uint32_t seed;
  std::int32_t period[4];
  float phase;
  float wave[4];
  float bandwidth;
  float jitter;
  std::int32_t metric;
  std::int32_t octaves;
  float lacunarity;
  float gain;
  float strength;  // or amplitude
  float limit;     // detail or footprint
};

// `count` points, a multiple of the lanes of every instruction set (kMostLanes), in the order in which they are stored.
// Along an axis whose stride is 0 all points have one coordinate, which stands kMostLanes times in its array.
struct Batch {
  int count;
  const std::int32_t* cell[4];  // null at positions
  const float* place[4];        // in the cell, or the position
  int stride[4];
  // How far points are from each other, in cells, where they lie in a row of a grid, whose coordinates along other axes
  // have the stride 0, or on another straight line; and how much further a rounding may take some of them.
  double step = std::numeric_limits<double>::infinity();
  double rounding = 0.0;
  float* value[kMostComponents];
};
constexpr int kMostLanes = 16;

struct NoiseKernels {
  Loops plain;
  Loops full;   // with a period, jitter and metric
  Loops phase;  // with a period, too; of phasor noise, with a bandwidth
  Octave octave;
};
struct SumKernels {  // whose `line` nobody calls
  Loops at;          // at positions
  Loops in;          // in cells
  Loops tile;        // with a period, of both
};

struct Kernels {
  NoiseKernels noises[kNoises][4];  // by dimensions less 1
  SumKernels sums[kSums][4];
  // The cells of positions along an axis of a grid, and the places in them.
  void (*split)(const float* position, int count, std::int32_t* cell, float* place);
  bool (*are_finite)(const float* numbers, int count);
  // Widens kMostLanes ranges; each may take any of the numbers.
  void (*widen)(const float* value, int count, float* least, float* greatest);
};

// A function of each instruction set, each arithmetic, and noises and sums apart, which enters their kernels: in
// avx2_fast those of AVX2 and HN_FAST.
#define HASHNOISE_ENTER_TOKENS(part, table) void enter_##part##_##table([[maybe_unused]] Kernels& kernels)
#define HASHNOISE_ENTER(part, table) HASHNOISE_ENTER_TOKENS(part, table)

}  // namespace hashnoise::grid
