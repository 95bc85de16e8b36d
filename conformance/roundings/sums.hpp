// How far octave sums are apart that round otherwise: the text of the library, 16 times at a place (floats.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "roundings/ways.hpp"

namespace hn::roundings {

using Words = std::array<std::array<std::uint32_t, kLanes>, 16>;  // of each lane
using Results = std::array<std::array<std::uint32_t, kLanes>, 4>;

// The results of a sum of the suite's table for the words of each lane, in the ways of a seed, with the default hash.
Results of_octahedral(std::string_view id, const Words& words, std::uint32_t seed);
Results of_sine(std::string_view id, const Words& words, std::uint32_t seed);

}  // namespace hn::roundings
