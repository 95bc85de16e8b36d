// Measures what a call from Python costs beside one from C++.
#pragma once

#include <string>

#include "base/ratio.hpp"
#include "base/result.hpp"

namespace hn {

struct PythonMeasurement {
  Ratio new_array;  // speed over that of C++, where Python makes the array of the values
  Ratio own_array;  // where it is passed one
};

// hashnoise.perlin at a million points in 2D, by one thread each: a process of this Python per round, and C++ in turns
// with it. The error has Python's message.
Result<PythonMeasurement> measure_python(const std::string& python, int rounds);

}  // namespace hn
