// A program that does not outlive us, and leaves nothing behind.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/folder.hpp"
#include "base/result.hpp"

namespace hn {

// A program in a process group of its own. Between it and us stands a process that waits for either of us to end. When
// we end, even by SIGKILL, it kills the group and removes the folder.
class GuardedProcess {
 public:
  // command[0] is the program's path. Its output goes to folder/log.
  static Result<GuardedProcess> start(std::vector<std::string> command, std::vector<std::string> environment,
                                      TemporaryFolder folder);
  GuardedProcess(GuardedProcess&& other) noexcept;
  GuardedProcess& operator=(GuardedProcess&&) = delete;
  ~GuardedProcess();  // kills it

  // How it ended, in words; nothing while it runs.
  std::optional<std::string> ended() const;
  // The end of its output.
  std::string log() const;

 private:
  GuardedProcess(pid_t guard, int channel, TemporaryFolder folder)
      : guard_(guard), channel_(channel), folder_(std::move(folder)) {}

  pid_t guard_;
  int channel_;  // the guard sends how the program ended; when it closes, we are gone
  TemporaryFolder folder_;
};

}  // namespace hn
