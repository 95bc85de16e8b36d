// The search for feature points.
#include "expected/cellular.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {}  // namespace
}  // namespace hn
