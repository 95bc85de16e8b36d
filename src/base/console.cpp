#include "base/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/text.hpp"

namespace hn {

void complain(std::string_view program, std::string_view message) {
  std::fputs(fmt::format("{}: {}\n", program, printable(message)).c_str(), stderr);
}

int status_once_printed(std::string_view program, int status) {
  if (std::fflush(stdout) == 0) {
    if (std::ferror(stdout) == 0) return status;
    // Something before failed, and why is forgotten. It will fail again.
    std::clearerr(stdout);
    errno = std::fputc('\n', stdout) == EOF || std::fflush(stdout) != 0 ? errno : EIO;
  }
  complain(program, fmt::format("cannot write the standard output: {}", std::strerror(errno)));
  return status == 0 ? EXIT_FAILURE : status;
}

Progress::Progress(std::FILE* out, std::size_t total) : out_(out), terminal_(isatty(fileno(out)) != 0), total_(total) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\033[K", out_);
  std::fflush(out_);
}

namespace {

std::string time_of(double seconds) {
  const auto whole = static_cast<long>(std::max(seconds, 0.0) + 0.5);
  return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

}  // namespace

// The task goes on even if nobody reads: fmt::print would throw.
void Progress::show(std::size_t done, std::size_t failed, const std::string& current,
                    std::optional<double> seconds_left) {
  const std::string left = seconds_left && done < total_ ? fmt::format(", {} left", time_of(*seconds_left)) : "";
  const std::string line = fmt::format("[{}/{}] {} failed{}  {}", done, total_, failed, left, current);
  const auto now = std::chrono::steady_clock::now();
  if (terminal_) {
    std::fputs(fmt::format("\r\033[K{:.110}", line).c_str(), out_);
  } else if (now >= next_line_ || (done == total_ && !ended_)) {
    constexpr auto kBetweenLines = std::chrono::seconds(10);
    next_line_ = now + kBetweenLines;
    ended_ = done == total_;
    std::fputs((line + "\n").c_str(), out_);
  }
  std::fflush(out_);
}

}  // namespace hn
