// Runs the cases of several drivers, each in its own process, and survives their crashes.
#pragma once

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "run/expectation.hpp"
#include "run/job.hpp"
#include "run/journal.hpp"
#include "run/results.hpp"

namespace hn {

struct DriverPlan {
  std::string driver;
  std::vector<std::string> ids;  // of its cases, in their order
  std::size_t whole = 0;         // how many there are in all shards
  bool dealt = false;            // whether some are no other driver's
};

struct RunPlan {
  std::vector<DriverPlan> drivers;
  SuiteOptions suite;
  std::map<std::string, Way> ways = {};  // to the drivers, with --through
  std::string content = {};              // a digest of the library and the golden files
  std::string shard = {};                // "2/3", or empty
  // Options that do not change the results:
  std::size_t jobs = 1;                        // processes at a time
  std::chrono::milliseconds limit{60000};      // for a case, and for a driver to start
  std::vector<Expectation> expectations = {};  // what does not count for fail_fast
  bool fail_fast = false;                      // end with the first case that is bad
  int stop_fd = -1;                            // end once something can be read from this file
  std::filesystem::path program = own_program();
};

// The part of a plan that a journal has to agree with.
nlohmann::json to_json(const RunPlan& plan);

// The results, in the order of the plan. Some are missing if the run ended early: because of fail_fast, because it was
// stopped, or because the journal could not be written, so that more results could be lost. A case in which the process
// ends is a crash, one that takes longer than the limit a timeout; the cases after it are run by another process. What
// the journal has from an earlier run is not run again. Logs of the processes, where they print something, are left as
// DRIVER.log in the directory.
struct PlanResult {
  std::vector<Run> runs;
  std::vector<std::string> problems;  // what is wrong beside the cases, such as a driver that crashes when it is left
};
PlanResult run_plan(const RunPlan& plan, const std::filesystem::path& directory, Journal& journal, std::FILE* progress);

}  // namespace hn
