// Ctrl-C, and the other signals that ask a program to end.
#pragma once

#include <signal.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <string_view>
#include <thread>

#include "base/file.hpp"

namespace hn {

inline constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP};
std::string_view name_of_signal(int signal);  // "SIGINT"

// While such an object exists, a thread waits for the signals that end a program. It prints a farewell and ends the
// program by the signal. Once the program handles this itself, the first signal is only noted. Ignored signals stay
// ignored (for example by nohup).
//
// Make it before any other thread: they must hold the signals back as well.
class Interruption {
 public:
  // farewell(signal, again) is called before the program ends, in another thread; again: one was noted before.
  using Farewell = std::function<void(int signal, bool again)>;
  explicit Interruption(Farewell farewell);
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  // From now on the first signal is noted, and the second ends the program. Signals that follow at once count as the
  // first: timeout and many others send it to a process and to its group.
  void note_the_first() { noting_ = true; }
  int signal() const { return noted_; }       // that was noted, or 0
  int fd() const { return readable_.get(); }  // can be read once one was noted

  // Ends the program as the signal does without a handler, so that the process that started us sees why.
  [[noreturn]] static void end_by(int signal);

 private:
  void wait();
  void take(int signal);

  Farewell farewell_;
  sigset_t earlier_;         // held back before
  FileDescriptor signals_;   // where those arrive
  FileDescriptor readable_;  // fd()
  FileDescriptor over_;      // ends the thread
  std::atomic<bool> noting_ = false;
  std::atomic<int> noted_ = 0;
  std::chrono::steady_clock::time_point noted_at_;
  std::thread thread_;
};

}  // namespace hn
