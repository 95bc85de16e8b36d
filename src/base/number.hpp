// Numbers as people read them.
#pragma once

#include <string>

namespace hn {

// With three significant digits, zeros at the end included: "2.00", "14.0", "527", "0.00123".
std::string three_digits(double value);

// With a fixed number of decimals, and no minus sign before a zero.
std::string decimals(double value, int count);

}  // namespace hn
