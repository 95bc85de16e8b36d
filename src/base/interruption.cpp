#include "base/interruption.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace hn {
namespace {

constexpr auto kSameSignal = std::chrono::milliseconds(300);

sigset_t signals_to_take() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : kEndingSignals) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&set, signal);
  }
  return set;
}

FileDescriptor checked(int fd, const char* what) {
  if (fd < 0) throw std::system_error(errno, std::generic_category(), what);
  return FileDescriptor(fd);
}

void make_readable(const FileDescriptor& event) { eventfd_write(event.get(), 1); }

}  // namespace

std::string_view name_of_signal(int signal) {
  switch (signal) {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    default:
      return "a signal";
  }
}

Interruption::Interruption(Farewell farewell) : farewell_(std::move(farewell)) {
  const sigset_t taken = signals_to_take();
  signals_ = checked(signalfd(-1, &taken, SFD_CLOEXEC), "signalfd");
  readable_ = checked(eventfd(0, EFD_CLOEXEC), "eventfd");
  over_ = checked(eventfd(0, EFD_CLOEXEC), "eventfd");
  pthread_sigmask(SIG_BLOCK, &taken, &earlier_);
  thread_ = std::thread([this] { wait(); });
}

Interruption::~Interruption() {
  make_readable(over_);
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &earlier_, nullptr);
}

void Interruption::wait() {
  while (true) {
    std::array<pollfd, 2> waiting = {{{signals_.get(), POLLIN, 0}, {over_.get(), POLLIN, 0}}};
    if (poll(waiting.data(), waiting.size(), -1) < 0) continue;
    if (waiting[1].revents != 0) return;
    signalfd_siginfo info{};
    if (read(signals_.get(), &info, sizeof info) != sizeof info) continue;
    take(static_cast<int>(info.ssi_signo));
  }
}

void Interruption::take(int signal) {
  const auto now = std::chrono::steady_clock::now();
  const bool again = noted_ != 0;
  if (again && now - noted_at_ < kSameSignal) return;
  if (!noting_ || again) {
    farewell_(signal, again);
    end_by(signal);
  }
  noted_ = signal;
  noted_at_ = now;
  make_readable(readable_);
}

void Interruption::end_by(int signal) {
  ::signal(signal, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  ::kill(getpid(), signal);
  _exit(128 + signal);  // the first process of a container survives it
}

}  // namespace hn
