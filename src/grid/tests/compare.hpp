// Whether a field is right, and if not, where it differs first.
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <iosfwd>
#include <span>
#include <string>

#include "hashnoise/field.hpp"

namespace hashnoise {

// How gtest prints them.
std::ostream& operator<<(std::ostream& out, const Range& range);
std::ostream& operator<<(std::ostream& out, const Settings& settings);

namespace twin {

// Every bit of every plane, with so many points in each. NaN is nowhere right.
testing::AssertionResult same_bits(std::span<const float> got, std::span<const float> expected, std::size_t points);

// Within a bound that may depend on the component and the point. Infinity is a bound that nothing is compared for.
using Bound = std::function<double(std::size_t component, std::size_t point)>;
testing::AssertionResult within(std::span<const float> got, std::span<const float> expected, std::size_t points,
                                const Bound& bound);

}  // namespace twin
}  // namespace hashnoise
