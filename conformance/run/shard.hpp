// A part of the cases, for one of several machines.
#pragma once

#include <cstddef>
#include <string>

#include "base/result.hpp"

namespace hn {

// Every count-th case, from the index-th on.
struct Shard {
  std::size_t index = 1;  // from 1
  std::size_t count = 1;

  bool has(std::size_t number) const { return number % count == index - 1; }
};

// The shard of "2/3". An empty text means the whole.
Result<Shard> parse_shard(const std::string& text);

}  // namespace hn
