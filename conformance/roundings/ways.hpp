// How the operations of floats.hpp round: for each operation a word for each of its 16 lanes.
#pragma once

#include <cstdint>

namespace hn::roundings {

constexpr std::uint32_t kLanes = 16, kOperations = 2048, kWays = kOperations * kLanes;
struct Ways {
  const std::uint32_t* words = nullptr;  // kWays, and kLanes more if they are chosen by value
  std::uint32_t operation = 0;           // the next one, where they follow one another, and begin anew at the end
  std::uint32_t end = kOperations;
  // Compilers compute arguments in different orders. By value the words of an operation follow from what it takes.
  bool by_value = false;
  std::uint32_t seed = 0;

  const std::uint32_t* of_next(std::uint32_t a, std::uint32_t b) {
    if (!by_value) return words + kLanes * (operation++ % end);
    std::uint32_t hash = (a ^ seed) * 0x9E3779B1u;
    hash = (hash ^ hash >> 15u ^ b) * 0x85EBCA77u;
    return words + (hash >> 8u) % kWays;
  }
};
inline thread_local Ways ways;

}  // namespace hn::roundings
