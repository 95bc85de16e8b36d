// Child processes that end with this one, and their reports.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file.hpp"
#include "base/result.hpp"

namespace hn {

// Where a child writes its reports.
constexpr int kReportFd = 3;

struct ProcessOptions {
  std::string program;    // searched in PATH if it names no folder
  std::string name = {};  // as tools show it, if it is not to be the program's
  std::vector<std::string> arguments = {};
  std::optional<std::vector<std::string>> environment = {};  // NAME=VALUE; ours if there is none
  std::filesystem::path output = "/dev/null";                // of its standard output and error
  int input = -1;                                            // its standard input, as a file; -1 for none
  bool is_server = false;  // it cleans up at its end, so it gets SIGTERM when we end, and is not killed
  bool own_group = false;  // it leads a group, in which all are that it starts
};

struct Process {
  Process() = default;
  Process(pid_t pid_, FileDescriptor reports_) : pid(pid_), reports(std::move(reports_)) {}
  Process(Process&& other) noexcept : pid(std::exchange(other.pid, 0)), reports(std::move(other.reports)) {}
  Process& operator=(Process&& other) noexcept {
    std::swap(pid, other.pid);
    std::swap(reports, other.reports);
    return *this;
  }

  pid_t pid = 0;           // 0 for none
  FileDescriptor reports;  // what it writes to kReportFd
};

// The system kills the child when the thread that started it ends (on Linux), in whatever way. Ctrl-C and similar
// signals are meant for us: the child does not get them, or ignores them.
Result<Process> start_process(const ProcessOptions& options);

// Starts a process, which reports nothing, and waits for its end. An error has its status and its output; the file
// options.output, which must be new, holds the output until it is read.
Result<void> run_process(const ProcessOptions& options);
// The same in a group of its own. Returns its status, as in waitpid; nothing if it took longer, and all were killed.
Result<std::optional<int>> run_within(std::chrono::milliseconds limit, ProcessOptions options);
// The output of a program that prints little.
Result<std::string> output_of(const std::string& program, const std::vector<std::string>& arguments);

// The texts as exec takes them, for as long as they are; the last pointer is null.
std::vector<char*> pointers_to(std::vector<std::string>& texts);

// Our variables, as NAME=VALUE, less those that begin with any of these.
std::vector<std::string> environment_without(std::span<const std::string_view> beginnings);

// The file of this program, even while a newer one replaces it in the file system.
std::filesystem::path own_program();

// "ended by signal 9 (Killed)", "ended with status 1": by waitpid.
std::string describe_end(int status);

}  // namespace hn
