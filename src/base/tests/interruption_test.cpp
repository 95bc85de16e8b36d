#include "base/interruption.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

namespace hn {
namespace {

using namespace std::chrono_literals;

// The status of a process that does this, as in waitpid. It sends signals to itself.
template <typename Work>
int end_of(Work work) {
  const pid_t pid = fork();
  if (pid == 0) {
    work();
    _exit(EXIT_SUCCESS);
  }
  int status = 0;
  waitpid(pid, &status, 0);
  return status;
}

// Ends with the signal as its status, and with 99 if it is the second one.
void exit_with_farewell(int signal, bool again) { _exit(again ? 99 : signal); }

bool becomes_readable(int fd) {
  pollfd waiting{fd, POLLIN, 0};
  return poll(&waiting, 1, 5000) > 0;
}

TEST(Interruption, ASignalEndsTheProgramAfterAFarewell) {
  for (const int signal : kEndingSignals) {
    const int status = end_of([&] {
      const Interruption interruption(exit_with_farewell);
      kill(getpid(), signal);
      sleep(60);
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), signal);
  }
}

TEST(Interruption, WhoStartedTheProgramSeesTheSignal) {
  const int status = end_of([] {
    const Interruption interruption([](int, bool) {});
    kill(getpid(), SIGTERM);
    sleep(60);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
}

TEST(Interruption, TheFirstIsNotedAndTheSecondEndsTheProgram) {
  const int status = end_of([] {
    Interruption interruption(exit_with_farewell);
    interruption.note_the_first();
    pollfd waiting{interruption.fd(), POLLIN, 0};
    if (interruption.signal() != 0 || poll(&waiting, 1, 0) > 0) _exit(50);
    kill(getpid(), SIGINT);
    if (!becomes_readable(interruption.fd()) || interruption.signal() != SIGINT) _exit(51);
    kill(getpid(), SIGINT);  // at once: timeout and its like send it to the group as well
    usleep(500000);
    kill(getpid(), SIGINT);
    sleep(60);
  });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 99);
}

TEST(Interruption, WhatWasIgnoredStaysIgnored) {
  const int status = end_of([] {
    signal(SIGHUP, SIG_IGN);
    const Interruption interruption(exit_with_farewell);
    kill(getpid(), SIGHUP);
    usleep(200000);
  });
  EXPECT_EQ(status, 0);
}

TEST(Interruption, AfterwardsSignalsDoWhatTheyDidBefore) {
  const int status = end_of([] {
    { const Interruption interruption(exit_with_farewell); }
    kill(getpid(), SIGINT);
    sleep(60);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGINT);
}

}  // namespace
}  // namespace hn
