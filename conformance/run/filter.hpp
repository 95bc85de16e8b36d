// Choosing cases.
#pragma once

#include <string>
#include <vector>

#include "cases/case.hpp"

namespace hn {

// As in a shell: * ? [...]
bool matches_glob(const std::string& text, const std::string& glob);
// Whether an id matches one of the globs, or there are no globs.
bool matches_any(const std::string& id, const std::vector<std::string>& globs);

// The cases whose id matches_any of the globs.
std::vector<Case> filter_cases(std::vector<Case> cases, const std::vector<std::string>& globs);

}  // namespace hn
