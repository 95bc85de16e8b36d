// A process that does a job: its reports, line by line, and its end.
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/process.hpp"

namespace hn {

using SteadyClock = std::chrono::steady_clock;

// How a process is started.
struct Launch {
  std::filesystem::path program;
  std::string command;              // The program answers "COMMAND JOB".
  std::filesystem::path job;        // the file of the process's job
  std::filesystem::path log;        // what it prints
  std::chrono::milliseconds limit;  // it has so long to make each report, or is killed
};

// The parent's side.
class Worker {
 public:
  static Result<Worker> start(const nlohmann::json& job, const Launch& launch);
  Worker(Worker&&) noexcept = default;
  Worker& operator=(Worker&&) noexcept = default;
  ~Worker();  // kills it if it runs

  int fd() const { return process_.reports.get(); }
  SteadyClock::time_point deadline() const { return deadline_; }
  void postpone_deadline(SteadyClock::duration by) { deadline_ += by; }

  // The reports that have arrived. Call it when fd() can be read, or the deadline has passed.
  std::vector<nlohmann::json> read();
  // Waits for that, or until something can be read from another file as well, and reads.
  std::vector<nlohmann::json> wait(int other_fd = -1);

  // Set once the process has ended and all of its reports were read.
  struct End {
    bool timed_out = false;  // it was killed by us
    int status = 0;          // as in waitpid
    std::string text;        // "ended by signal 11 (Segmentation fault)"
  };
  const std::optional<End>& end() const { return end_; }

 private:
  Worker() = default;
  void finish(bool timed_out);

  Launch launch_;
  Process process_;
  SteadyClock::time_point deadline_;
  std::string unfinished_line_;
  std::optional<End> end_;
};

// Whether something can be read from a file now; false for -1.
bool can_be_read(int fd);

// The milliseconds until then, as poll takes them.
int milliseconds_until(SteadyClock::time_point deadline);

// The child's side. It writes each line in one call, so that the parent reads whole lines even if the child dies next.
void report(const nlohmann::ordered_json& json);

}  // namespace hn
