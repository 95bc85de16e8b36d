#include "base/console.hpp"

#include <fmt/format.h>

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

}  // namespace hn
