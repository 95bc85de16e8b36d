// Times that were taken in the same rounds, and their quotients.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace hn {

// Seconds of a piece of work, a sample per round.
struct Timing {
  std::vector<double> samples;

  double median() const;
  double spread() const;  // half the distance between the quartiles
};

// A quotient, and half the distance between the quartiles of its samples. NaN where it is unknown.
struct Ratio {
  double value = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();

  bool known() const { return value == value; }
};
// "1.23 ± 0.04"
std::string text_of(const Ratio& ratio);

// The time of some work over that of the reference, round by round, after the time of what is empty is taken off both.
Ratio ratio(const Timing& timing, const Timing& reference, const Timing& empty);

}  // namespace hn
