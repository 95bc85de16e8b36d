#include "gpu/driver/xvfb.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

#include "base/process.hpp"

namespace hn {
namespace {

constexpr int kStartLimit = 20000;  // milliseconds; it takes about 300 where nothing else runs

// Xvfb writes its number and a line feed to -displayfd once it takes clients.
std::string read_number(int fd) {
  std::string number;
  pollfd waiting{fd, POLLIN, 0};
  while (number.empty() || number.back() != '\n') {
    std::array<char, 16> bytes;
    if (poll(&waiting, 1, kStartLimit) != 1) return {};
    const ssize_t count = read(fd, bytes.data(), bytes.size());
    if (count <= 0) return {};
    number.append(bytes.data(), static_cast<std::size_t>(count));
  }
  number.pop_back();
  return number;
}

}  // namespace

Result<Xvfb> Xvfb::where_no_display() {
#ifdef __APPLE__
  return Xvfb();
#else
  if (const char* display = getenv("DISPLAY"); display && *display) return Xvfb();
  auto server = start_process(
      {.program = "Xvfb",
       .arguments = {"-displayfd", std::to_string(kReportFd), "-screen", "0", "640x480x24", "-nolisten", "tcp"},
       .is_server = true});
  if (!server) return fail("there is no display (DISPLAY is not set), and no Xvfb to make one", server.error().text());
  Xvfb started(server->pid);
  const std::string number = read_number(server->reports.get());
  if (number.empty()) return fail("there is no display, and Xvfb does not start");
  setenv("DISPLAY", fmt::format(":{}", number).c_str(), 1);
  return started;
#endif
}

Xvfb::~Xvfb() {
  if (pid_ == 0) return;
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
}

}  // namespace hn
