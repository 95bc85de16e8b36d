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
#include "bench_cpu/aims.hpp"
#include "bench_cpu/fast_noise.hpp"
#include "bench_cpu/subjects.hpp"

namespace hn {

// A sample of each per round, in turns. Each is done once before its sample, untimed, and as often in a sample as makes
// it some milliseconds long.
std::vector<Timing> measure(std::span<const std::function<void()>> works, int rounds);

// The quotient of speeds of two that were timed in the same rounds.
Ratio speed(const Timing& first, const Timing& second);

// A subject with a set of instructions.
struct Measurement {
  Subject subject;
  hashnoise::InstructionSet set;
  std::map<Comparison, Ratio> ratios;               // those that could be measured
  std::map<std::string, double> millions_a_second;  // "fast", "fixed", ..., "FastNoise2": medians
};

// The sets of a subject, the narrowest first: all in the same rounds. Two threads are timed with the widest.
Result<std::vector<Measurement>> measure_subject(const Subject& subject, const FastNoise* other, int rounds);

// Where the points of a list are: those of the grid.
std::vector<std::vector<float>> positions_of_grid(int dimensions);

}  // namespace hn
