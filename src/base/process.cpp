#include "base/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/interruption.hpp"
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace hn {
namespace {

struct Pipe {
  FileDescriptor read;
  FileDescriptor write;
};

Result<Pipe> make_pipe() {
  std::array<int, 2> ends;
  if (pipe(ends.data()) != 0) return fail(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  // Above kReportFd, so that the child's copy does not land on the other end.
  Pipe made;
  for (int& end : ends) {
    const int moved = fcntl(end, F_DUPFD_CLOEXEC, kReportFd + 1);
    close(end);
    end = moved;
  }
  made.read = FileDescriptor(ends[0]);
  made.write = FileDescriptor(ends[1]);
  if (ends[0] < 0 || ends[1] < 0) return fail(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  return made;
}

// In the child, between fork and exec, where only async-signal-safe functions may be called. Returns where it failed.
void become(const char* program, char* const* arguments, char** environment, const char* output, int reports, int input,
            bool is_server, bool own_group, pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, is_server ? SIGTERM : SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);  // it ended before the line above
#endif
  // A server takes signals as it likes, so it is where a terminal's do not come. The others stay in our group: what
  // stops us (Ctrl-Z) stops them.
  if (is_server || own_group) setpgid(0, 0);
  for (const int signal : kEndingSignals) ::signal(signal, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);  // ours may hold signals back
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);  // a crash is what we look for, its dump is of no use
  const int in = input < 0 ? open("/dev/null", O_RDONLY) : input;
  const int out = open(output, O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (in < 0 || out < 0) return;
  if (dup2(in, STDIN_FILENO) < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(out, STDERR_FILENO) < 0) return;
  if (dup2(reports, kReportFd) < 0) return;
  if (environment) environ = environment;
  execvp(program, arguments);
}

}  // namespace

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

Result<Process> start_process(const ProcessOptions& options) {
  HN_TRY(Pipe reports, make_pipe());
  HN_TRY(Pipe failure, make_pipe());  // closed by exec, else it brings errno
  std::vector<std::string> arguments = {options.name.empty() ? options.program : options.name};
  arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
  std::vector<std::string> environment = options.environment.value_or(std::vector<std::string>{});
  const std::vector<char*> argument_pointers = pointers_to(arguments);
  std::vector<char*> environment_pointers = pointers_to(environment);
  const std::string output = options.output.string();
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) return fail(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (pid == 0) {
    become(options.program.c_str(), argument_pointers.data(),
           options.environment ? environment_pointers.data() : nullptr, output.c_str(), reports.write.get(),
           options.input, options.is_server, options.own_group, parent);
    const int error = errno;
    [[maybe_unused]] const auto written = write(failure.write.get(), &error, sizeof error);
    _exit(EXIT_FAILURE);
  }
  failure.write = FileDescriptor();
  int error = 0;
  if (read(failure.read.get(), &error, sizeof error) == sizeof error) {
    waitpid(pid, nullptr, 0);
    return fail(fmt::format("cannot start {}: {}", options.program, std::strerror(error)));
  }
  return Process{pid, std::move(reports.read)};
}

Result<void> run_process(const ProcessOptions& options) {
  HN_TRY(const Process process, start_process(options));
  int status = 0;
  while (waitpid(process.pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) return {};
  return fail(fmt::format("{} {}", options.program, describe_end(status)), read_file(options.output).value_or(""));
}

Result<std::optional<int>> run_within(std::chrono::milliseconds limit, ProcessOptions options) {
  options.own_group = true;
  HN_TRY(const Process process, start_process(options));
  int status = 0;
  // Counted in naps, since we may be stopped (Ctrl-Z) while it runs.
  constexpr std::chrono::milliseconds kNap{1};
  for (auto slept = kNap; waitpid(process.pid, &status, WNOHANG) == 0; slept += kNap) {
    if (slept > limit) {
      kill(-process.pid, SIGKILL);
      waitpid(process.pid, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(kNap);
  }
  return status;
}

Result<std::string> output_of(const std::string& program, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const auto output = folder.path() / "output";
  HN_DO(run_process({.program = program, .arguments = arguments, .output = output}));
  return read_file(output);
}

std::vector<std::string> environment_without(std::span<const std::string_view> beginnings) {
  std::vector<std::string> kept;
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view text = *variable;
    const auto begins = [&](std::string_view beginning) { return text.starts_with(beginning); };
    if (std::none_of(beginnings.begin(), beginnings.end(), begins)) kept.emplace_back(text);
  }
  return kept;
}

std::filesystem::path own_program() { return "/proc/self/exe"; }

std::string describe_end(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("ended with status {}", WEXITSTATUS(status));
}

}  // namespace hn
