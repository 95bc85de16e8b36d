#include "base/worker.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "base/file.hpp"

namespace hn {

Result<Worker> Worker::start(const Job& job, const Launch& launch) {
  HN_DO(write_file(launch.job, to_json(job).dump()));
  HN_TRY(auto process, start_process({.program = launch.program.string(),
                                      .name = "hn-conform",
                                      .arguments = {"child", launch.job.string()},
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
  end_ = End{timed_out, status, describe_end(status)};
  std::error_code ignored;
  std::filesystem::remove(launch_.job, ignored);
}

std::vector<nlohmann::json> Worker::read() {
  std::array<char, 65536> bytes;
  pollfd waiting{fd(), POLLIN, 0};
  bool closed = false;
  while (!closed && poll(&waiting, 1, 0) > 0) {
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

Result<nlohmann::json> report_of(const Job& job, const std::filesystem::path& directory,
                                 std::chrono::milliseconds limit) {
  HN_TRY(auto worker, Worker::start(job, {own_program(), directory / "job.json", "/dev/null", limit}));
  while (!worker.end()) {
    pollfd waiting{worker.fd(), POLLIN, 0};
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(worker.deadline() - SteadyClock::now()).count();
    poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left, 0)) + 1);
    for (const nlohmann::json& report : worker.read()) {
      for (const char* wrong : {"absent", "error"}) {
        if (report.contains(wrong)) return fail(report.at(wrong).get<std::string>());
      }
      return report;
    }
  }
  if (worker.end()->timed_out) {
    return fail(fmt::format("its process did not answer in {} s", std::chrono::duration<double>(limit).count()));
  }
  return fail(fmt::format("its process {}", worker.end()->text));
}

}  // namespace hn
