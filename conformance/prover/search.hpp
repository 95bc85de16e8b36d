// Branch and bound over boxes of a function's arguments.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "text.hpp"

namespace hn::prover {

// One of the 16 words that a row of the table takes.
struct Argument {
  enum Is { kAny, kWord, kFloat, kBox, kPosition } is = kAny;
  std::uint32_t word = 0;
  double lo = 0, hi = 0;  // kFloat: lo; kBox: a place, which is a float; kPosition: a place in a cell from lo to hi
};

using Body = uvec4 (*)(uvec4, uvec4, uvec4, uvec4);

enum Measure { kLargestError, kMost, kLeast, kExactMost, kExactLeast, kSlope, kErrorByLength };

struct Job {
  Body function = nullptr;
  std::array<Argument, 16> arguments;
  unsigned outputs = 1;  // bits: which of the four
  Measure measure = kLargestError;
  std::size_t most = 25'000;  // boxes
  double tolerance = 0.003;   // relative
  double target = -INFINITY;  // a bound that is small enough
  int bits = 20;              // of a place in HN_FIXED
  bool given = false;         // decisions come out as in exact arithmetic
  double longest = INFINITY;  // is the k-th smallest length, and a vector if a result is its direction
  double unit = 1;            // is a length of the text in the result and in `longest`
  double seconds = INFINITY;
};

struct Proven {
  double bound = 0;     // infinite if something was not seen
  double at_point = 0;  // of the worst box, its middle: no bound can be less
  std::size_t boxes = 0;
  std::string problem;
  std::vector<Interval> box;                                 // the worst
  std::vector<void*> frames;                                 // the calls on the way to the problem
  std::vector<std::pair<double, std::vector<void*>>> parts;  // of the bound, likewise
};

Proven prove(const Job& job);

}  // namespace hn::prover
