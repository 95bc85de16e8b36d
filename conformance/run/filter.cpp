#include "run/filter.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <unistd.h>

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

Progress::Progress(std::FILE* out, std::size_t total) : out_(out), terminal_(isatty(fileno(out)) != 0), total_(total) {}

Progress::~Progress() {
  if (terminal_) fmt::print(out_, "\r\033[K");
  std::fflush(out_);
}

void Progress::show(std::size_t done, std::size_t failed, const std::string& current) {
  const std::string line = fmt::format("[{}/{}] {} failed  {}", done, total_, failed, current);
  if (terminal_) {
    fmt::print(out_, "\r\033[K{:.110}", line);
  } else if (const std::size_t tenth = done * 10 / std::max<std::size_t>(total_, 1); tenth > last_tenth_) {
    last_tenth_ = tenth;
    fmt::print(out_, "{}\n", line);
  }
  std::fflush(out_);
}

}  // namespace hn
