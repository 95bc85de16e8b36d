// How the operations of floats.hpp round: for each operation a word for each of its 16 lanes.
#pragma once

#include <cstdint>

namespace hn::roundings {

constexpr std::uint32_t kLanes = 16, kOperations = 2048;  // then they begin anew
struct Ways {
  const std::uint32_t* words = nullptr;  // kOperations * kLanes
  std::uint32_t operation = 0;           // the next one
};
inline thread_local Ways ways;

}  // namespace hn::roundings
