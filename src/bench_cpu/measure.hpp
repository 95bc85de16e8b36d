// Times fields against each other: in rounds, so that what slows the machine down for a while slows all of them.
#pragma once

#include <array>
#include <functional>
#include <hashnoise/field.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/ratio.hpp"
#include "base/result.hpp"
#include "bench_cpu/fast_noise.hpp"
#include "bench_cpu/subjects.hpp"

namespace hn {

// A sample of each per round, in turns. Each is done once before its sample, untimed, and as often in a sample as makes
// it some milliseconds long.
std::vector<Timing> measure(std::span<const std::function<void()>> works, int rounds);

// The quotient of speeds of two that were timed in the same rounds.
Ratio speed(const Timing& first, const Timing& second);

// The comparisons. Every number is a quotient of speeds: how many times as fast the first is as the second.
inline constexpr std::array kComparisons = {
    "grids",           // ours over FastNoise2's
    "points",          // the same at a list of points
    "octaves",         // ours over FastNoise2's, where the octaves of ours are grids that are not turned
    "strict fixed",    // a grid with HN_FIXED over one of FastNoise2 whose sets of instructions agree
    "strict precise",  // the same with HN_PRECISE
    "fixed",           // HN_FIXED over HN_FAST
    "precise",         // HN_PRECISE over HN_FAST
    "tiles",           // with a period over without
    "lists",           // at points over on a grid
    "threads",         // by two threads over by one
};
// The fills, in millions of points a second.
inline constexpr std::array kFills = {"fast",
                                      "fixed",
                                      "precise",
                                      "tiles",
                                      "points",
                                      "two threads",
                                      "FastNoise2",
                                      "FastNoise2 points",
                                      "FastNoise2 strict"};

// A subject with a set of instructions.
struct Measurement {
  Subject subject;
  hashnoise::InstructionSet set;
  std::map<std::string, Ratio> ratios;              // of kComparisons, those that could be measured
  std::map<std::string, double> millions_a_second;  // of kFills: medians
};

// The sets of a subject, the narrowest first: all in the same rounds. Two threads are timed with the widest.
Result<std::vector<Measurement>> measure_subject(const Subject& subject, const FastNoise* other,
                                                 const FastNoise* strict, int rounds);

// Where the points of a list are: those of the grid.
std::vector<std::vector<float>> positions_of_grid(int dimensions);

}  // namespace hn
