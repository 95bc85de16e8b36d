#include "run/filter.hpp"

#include <fnmatch.h>

#include <algorithm>

namespace hn {
bool matches_glob(const std::string& text, const std::string& glob) {
  return fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

bool matches_any(const std::string& id, const std::vector<std::string>& globs) {
  return globs.empty() ||
         std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) { return matches_glob(id, glob); });
}

std::vector<Case> filter_cases(std::vector<Case> cases, const std::vector<std::string>& globs) {
  std::erase_if(cases, [&](const Case& test) { return !matches_any(test.id, globs); });
  return cases;
}

}  // namespace hn
