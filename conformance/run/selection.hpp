// Choosing cases: by globs, and a part of them for one of several machines.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cases/case.hpp"

namespace hn {

// As in a shell: * ? [...]
bool matches_glob(const std::string& text, const std::string& glob);
// Whether an id matches one of the globs, or there are no globs.
bool matches_any(const std::string& id, const std::vector<std::string>& globs);

// The cases whose id matches_any of the globs.
std::vector<Case> filter_cases(std::vector<Case> cases, const std::vector<std::string>& globs);

// Every count-th case, from the index-th on.
struct Shard {
  std::size_t index = 1;  // from 1
  std::size_t count = 1;

  bool has(std::size_t number) const { return number % count == index - 1; }
};

// The shard of "2/3". An empty text means the whole.
Result<Shard> parse_shard(const std::string& text);

}  // namespace hn
