// The parts of search.cpp: the text over lanes of floats (lanes.cpp), and in doubles (proof/bounds/rounded.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roundings/ways.hpp"

constexpr std::uint32_t kInputs = 16, kOutputs = 4, kOperations = 8192;  // the most that have ways of their own
using Words = std::array<std::array<std::uint32_t, hn::roundings::kLanes>, kInputs>;
using Results = std::array<std::array<std::uint32_t, hn::roundings::kLanes>, kOutputs>;

// The results of each lane, and how many operations took a way.
std::uint32_t run_lanes(int function, const std::uint32_t* ways, const Words& words, Results& results);

extern "C" void evaluate(std::int32_t function, std::int32_t mode, std::uint32_t seed, double fuse, std::int32_t count,
                         const std::uint32_t* in, const double* in_exactly, std::uint32_t* out, double* out_exactly);

// The operands of roots and the divisors of the last evaluation in doubles, in their order: where one is 0 the text is
// singular.
extern std::vector<double> singular;
