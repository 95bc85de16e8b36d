#include "web/guarded_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/file.hpp"
#include "base/process.hpp"

namespace hn {
namespace {

constexpr int kPollMilliseconds = 50;
// A message has so much of a log: about ten lines.
constexpr std::size_t kMostOfLog = 2000;

// The guard's arguments; made before we fork, since another thread may hold a lock then.
struct Plan {
  std::vector<char*> command;
  std::vector<char*> environment;
  std::string log;
  const std::filesystem::path& folder;  // to be removed
};

[[noreturn]] void become_program(const Plan& plan) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // should the guard be killed
  const int nothing = open("/dev/null", O_RDONLY);
  const int log = open(plan.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0u, 0);
  execve(plan.command[0], plan.command.data(), plan.environment.data());
  _exit(127);
}

// Ends every process that the program has left: those in its group, and those that have moved elsewhere, which are the
// guard's children by now.
void end_all(pid_t program) {
  kill(-program, SIGKILL);
  while (true) {
    std::ifstream children("/proc/thread-self/children");
    pid_t child = 0;
    while (children >> child) kill(child, SIGKILL);
    const pid_t gone = waitpid(-1, nullptr, 0);
    if (gone < 0 && errno != EINTR) return;
  }
}

[[noreturn]] void guard(const Plan& plan, int channel) {
  setsid();  // neither a terminal's signals nor those to our group are meant for it
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  dup2(channel, STDIN_FILENO);
  const int nothing = open("/dev/null", O_WRONLY);
  dup2(nothing, STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0u, 0);  // somebody may wait for the end of what we have open
  const pid_t program = fork();
  if (program == 0) become_program(plan);
  setpgid(program, program);  // here as well: whoever comes first
  bool reported = false;
  while (true) {
    pollfd us = {STDIN_FILENO, POLLIN, 0};
    if (poll(&us, 1, kPollMilliseconds) > 0) break;  // nobody sends anything: it is closed
    int status = 0;
    if (reported || waitpid(program, &status, WNOHANG) == 0) continue;
    reported = true;
    send(STDIN_FILENO, &status, sizeof status, MSG_NOSIGNAL);
  }
  end_all(program);
  std::error_code ignored;
  std::filesystem::remove_all(plan.folder, ignored);
  _exit(0);
}

}  // namespace

Result<GuardedProcess> GuardedProcess::start(std::vector<std::string> command, std::vector<std::string> environment,
                                             TemporaryFolder folder) {
  const Plan plan = {pointers_to(command), pointers_to(environment), (folder.path() / "log").string(), folder.path()};
  std::array<int, 2> channel{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel.data()) != 0) {
    return fail(fmt::format("cannot make a socket: {}", std::strerror(errno)));
  }
  const pid_t pid = fork();
  if (pid == 0) guard(plan, channel[1]);
  close(channel[1]);
  if (pid > 0) return GuardedProcess(pid, channel[0], std::move(folder));
  close(channel[0]);
  return fail(fmt::format("cannot make a process: {}", std::strerror(errno)));
}

GuardedProcess::GuardedProcess(GuardedProcess&& other) noexcept
    : guard_(other.guard_), channel_(std::exchange(other.channel_, -1)), folder_(std::move(other.folder_)) {}

GuardedProcess::~GuardedProcess() {
  if (channel_ < 0) return;
  close(channel_);
  while (waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<std::string> GuardedProcess::ended() const {
  int status = 0;
  const ssize_t size = recv(channel_, &status, sizeof status, MSG_DONTWAIT | MSG_PEEK);
  if (size < 0) return std::nullopt;
  if (size == 0) return "was lost: its guard is gone";
  return describe_end(status);
}

std::string GuardedProcess::log() const { return end_of_log(folder_.path() / "log", kMostOfLog); }

}  // namespace hn
