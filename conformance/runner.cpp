#include "runner.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>

namespace hn {
namespace {

// A case must not end the run, whatever happens in it.
Outcome run_guarded(Session& session, const Case& test) {
  try {
    return test.run(session);
  } catch (const std::exception& exception) {
    return outcome_with(Status::error, {fmt::format("exception: {}", exception.what()), {}});
  }
}

}  // namespace

bool matches_any(const std::string& id, const std::vector<std::string>& globs) {
  return globs.empty() || std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
           return fnmatch(glob.c_str(), id.c_str(), 0) == 0;
         });
}

std::vector<Case> filter_cases(std::vector<Case> cases, const std::vector<std::string>& globs) {
  std::erase_if(cases, [&](const Case& test) { return !matches_any(test.id, globs); });
  return cases;
}

Progress::Progress(std::FILE* out, std::size_t total) : out_(out), terminal_(isatty(fileno(out)) != 0), total_(total) {}

Progress::~Progress() {
  if (terminal_) fmt::print(out_, "\r\033[K");
  std::fflush(out_);
}

void Progress::show(std::size_t done, std::size_t failed, const std::string& current) {
  const std::string line = fmt::format("[{}/{}] {} failed  {}", done, total_, failed, current);
  if (terminal_) {
    fmt::print(out_, "\r\033[K{:.100}", line);
  } else if (const std::size_t tenth = done * 10 / std::max<std::size_t>(total_, 1); tenth > last_tenth_) {
    last_tenth_ = tenth;
    fmt::print(out_, "{}\n", line);
  }
  std::fflush(out_);
}

std::vector<CaseResult> run_cases(Session& session, const std::vector<Case>& cases, const RunOptions& options,
                                  Progress& progress) {
  std::vector<CaseResult> results;
  std::size_t failed = 0;
  for (const Case& test : cases) {
    progress.show(results.size(), failed, test.id);
    const auto start = std::chrono::steady_clock::now();
    CaseResult result{test.id, run_guarded(session, test), 0.0};
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool bad = result.outcome.status == Status::fail || result.outcome.status == Status::error;
    results.push_back(std::move(result));
    if (bad) ++failed;
    if (bad && options.fail_fast) break;
  }
  return results;
}

}  // namespace hn
