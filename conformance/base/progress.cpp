#include "base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace hn {

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
