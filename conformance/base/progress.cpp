#include "base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace hn {

Progress::Progress(std::FILE* out, std::size_t total) : out_(out), terminal_(isatty(fileno(out)) != 0), total_(total) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\033[K", out_);
  std::fflush(out_);
}

// The task goes on even if nobody can be told: fmt::print would throw.
void Progress::show(std::size_t done, std::size_t failed, const std::string& current) {
  const std::string line = fmt::format("[{}/{}] {} failed  {}", done, total_, failed, current);
  if (terminal_) {
    std::fputs(fmt::format("\r\033[K{:.110}", line).c_str(), out_);
  } else if (const std::size_t tenth = done * 10 / std::max<std::size_t>(total_, 1); tenth > last_tenth_) {
    last_tenth_ = tenth;
    std::fputs((line + "\n").c_str(), out_);
  }
  std::fflush(out_);
}

}  // namespace hn
