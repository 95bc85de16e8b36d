#include "paper/period.hpp"

#include <vector>

namespace hn {

std::size_t shortest_cyclic_repeat(std::span<const std::uint32_t> words) {
  // border[i]: the longest proper prefix of the first i + 1 words that also ends them (Knuth, Morris, Pratt). The words
  // before the longest border of the whole are its shortest period, which is cyclic if it divides the length.
  const std::size_t size = words.size();
  if (size == 0) return 0;
  std::vector<std::size_t> border(size, 0);
  for (std::size_t i = 1, length = 0; i < size; ++i) {
    while (length > 0 && words[i] != words[length]) length = border[length - 1];
    if (words[i] == words[length]) ++length;
    border[i] = length;
  }
  const std::size_t period = size - border.back();
  return size % period == 0 ? period : size;
}

}  // namespace hn
