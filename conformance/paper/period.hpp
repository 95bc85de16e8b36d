// The period of a sequence.
#pragma once

#include <cstdint>
#include <span>

namespace hn {

// The smallest d that divides the number of words such that going round by d leaves every word in place; the number of
// words if nothing shorter does. 0 for none.
std::size_t shortest_cyclic_repeat(std::span<const std::uint32_t> words);

}  // namespace hn
