#include "base/worker.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>

#include "base/file.hpp"
#include "base/json.hpp"

namespace hn {

Result<Worker> Worker::start(const nlohmann::json& job, const Launch& launch) {
  HN_DO(write_file(launch.job, job.dump()));
  HN_TRY(auto process, start_process({.program = launch.program.string(),
                                      .name = "hn-conform",
                                      .arguments = {launch.command, launch.job.string()},
                                      .output = launch.log}));
  Worker worker;
  worker.launch_ = launch;
  worker.process_ = std::move(process);
  worker.deadline_ = SteadyClock::now() + launch.limit;
  return worker;
}

Worker::~Worker() {
  if (process_.pid == 0 || end_) return;  // moved from, or over
  finish(true);
}

void Worker::finish(bool timed_out) {
  if (timed_out) kill(process_.pid, SIGKILL);
  int status = 0;
  while (waitpid(process_.pid, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string text = timed_out ? fmt::format("was killed, because it gave no answer for {} s",
                                                   std::chrono::duration<double>(launch_.limit).count())
                                     : describe_end(status);
  end_ = End{timed_out, status, text};
  std::error_code ignored;
  std::filesystem::remove(launch_.job, ignored);
}

std::vector<nlohmann::json> Worker::read() {
  std::array<char, 65536> bytes;
  bool closed = false;
  while (!closed && can_be_read(fd())) {
    const ssize_t count = ::read(fd(), bytes.data(), bytes.size());
    closed = count == 0 || (count < 0 && errno != EINTR);
    if (count > 0) unfinished_line_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  std::vector<nlohmann::json> reports;
  std::size_t begin = 0;
  for (auto end = unfinished_line_.find('\n'); end != std::string::npos; end = unfinished_line_.find('\n', begin)) {
    auto report = nlohmann::json::parse(unfinished_line_.substr(begin, end - begin), nullptr, false);
    if (report.is_object()) reports.push_back(std::move(report));
    begin = end + 1;
  }
  unfinished_line_.erase(0, begin);
  if (!reports.empty()) deadline_ = SteadyClock::now() + launch_.limit;
  if (closed) {
    finish(false);
  } else if (SteadyClock::now() >= deadline_) {
    finish(true);
  }
  return reports;
}

std::vector<nlohmann::json> Worker::wait(int other_fd) {
  std::array<pollfd, 2> waiting = {{{fd(), POLLIN, 0}, {other_fd, POLLIN, 0}}};  // poll passes over -1
  poll(waiting.data(), waiting.size(), milliseconds_until(deadline_));
  return read();
}

bool can_be_read(int fd) {
  pollfd waiting{fd, POLLIN, 0};
  return poll(&waiting, 1, 0) > 0;
}

int milliseconds_until(SteadyClock::time_point deadline) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - SteadyClock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(left, 0)) + 1;
}

void report(const nlohmann::ordered_json& json) {
  const std::string line = dump(json) + "\n";
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = write(kReportFd, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(EXIT_FAILURE);  // nobody listens
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace hn
