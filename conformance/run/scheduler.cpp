#include "run/scheduler.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/console.hpp"
#include "base/file.hpp"
#include "base/worker.hpp"
#include "library/source.hpp"

namespace hn {
namespace {

// A driver is given up after so many processes in a row have ended before they were ready. Once could be chance; and
// each that hangs costs a whole time limit.
constexpr int kMostFutileStarts = 2;
// After so many cases of a function in a row have ended their process, its other cases are taken to do the same; and
// after so many such functions in a row, all other functions are.
constexpr int kMostCrashesInARow = 10;
constexpr int kMostFunctionsInARow = 3;
constexpr std::size_t kLogEnd = 2000;
// We wake up so late only if we were stopped.
constexpr auto kLate = std::chrono::milliseconds(500);

// The cases of a driver, or a part of them: what is done, what is not, and its process.
class Lane {
 public:
  // name: of its files.
  Lane(const DriverPlan& plan, const RunPlan& whole, std::string name, std::filesystem::path directory)
      : plan_(plan),
        whole_(whole),
        name_(std::move(name)),
        directory_(std::move(directory)),
        pending_(plan.ids.begin(), plan.ids.end()) {
    std::error_code ignored;
    std::filesystem::remove(launch().log, ignored);
  }

  const std::string& driver() const { return plan_.driver; }
  bool over() const { return pending_.empty() || !absent_.empty(); }
  bool is_absent() const { return !absent_.empty(); }
  const std::string& problem() const { return problem_; }
  // To another process it was there.
  void deny_absence() {
    abandon(Status::crash,
            fmt::format("the driver cannot be used by a second process: {}", std::exchange(absent_, "")));
  }
  Worker* worker() { return worker_ ? &*worker_ : nullptr; }
  std::size_t done() const { return results_.size(); }
  std::size_t bad() const { return bad_; }
  // There will be more about the last case.
  bool examining() const { return worker_ && examining_; }
  // The case that runs, or runs next.
  std::string current() {
    while (next_ < plan_.ids.size() && !is_pending(plan_.ids[next_])) ++next_;
    return next_ < plan_.ids.size() ? plan_.ids[next_] : std::string();
  }

  void start() {
    Job job{.task = Task::cases,
            .driver = plan_.driver,
            .suite = whole_.suite,
            .ids = {},
            .examined = examined_,
            .kept = directory_ / kWaysFolder,
            .step_limit = whole_.limit.count() / 2};
    std::copy_if(plan_.ids.begin(), plan_.ids.end(), std::back_inserter(job.ids),
                 [&](const std::string& id) { return is_pending(id); });
    ready_ = lost_ = examining_ = false;
    refusal_.clear();
    std::error_code none;
    const auto size = std::filesystem::file_size(launch().log, none);
    log_begin_ = none ? 0 : size;
    auto worker = Worker::start(job, launch());
    if (worker) {
      worker_.emplace(std::move(*worker));
    } else {
      abandon(Status::error, worker.error().text());
    }
  }

  void stop() {
    if (!worker_) return;
    worker_.reset();
    remove_empty_log();
  }

  // Takes a report of the process, from now or from an earlier run.
  void take(const nlohmann::json& report) {
    if (report.contains("absent")) {
      take_absence(report.at("absent").get<std::string>());
    } else if (report.contains("ready")) {
      ready_ = true;
      info_ = context_info_from(report.at("ready"));
    } else if (report.contains("lost")) {
      lost_ = true;
    } else if (report.contains("result")) {
      take_result(report);
    } else if (report.contains("evidence")) {
      examining_ = false;
      take_evidence(report);
    } else if (report.contains("error")) {
      abandon(Status::error, report.at("error").get<std::string>());
    }
  }

  // The process ended. Returns what is to be recorded of it.
  std::optional<CaseResult> take_end() {
    const Worker::End end = *worker_->end();
    worker_.reset();
    if (over()) {
      if (absent_.empty() && (end.timed_out || end.status != 0)) {
        problem_ = fmt::format("{}: after its last case the driver's process {}{}", plan_.driver, end.text, log_end());
      }
      remove_empty_log();
      return std::nullopt;
    }
    if (lost_ || examining_) return std::nullopt;  // of a case that has its verdict
    const Status status = end.timed_out ? Status::timeout : Status::crash;
    const std::string text = fmt::format("the driver's process {}", end.text);
    const std::string when = ready_ ? "" : fmt::format("the driver does not start: {}", refusal_);
    CaseResult result{.id = current(), .outcome = outcome_with(status, {when + text + log_end(), {}})};
    add(result);
    futile_starts_ = ready_ ? 0 : futile_starts_ + 1;
    if (futile_starts_ >= kMostFutileStarts) {
      abandon(status, fmt::format("not run, since the driver does not start: {}", text));
    } else if (++crashes_in_a_row_ >= kMostCrashesInARow) {
      const bool all = ++functions_in_a_row_ >= kMostFunctionsInARow;
      const std::string_view function = all ? std::string_view() : function_of(result.id);
      abandon(status, fmt::format("not run, after {} cases in a row ended like this: {}", crashes_in_a_row_, text),
              function);
      crashes_in_a_row_ = 0;
    }
    return result;
  }

  Run take_run() {
    Run run{.driver = plan_.driver,
            .absent = absent_,
            .way = way(),
            .info = info_.value_or(ContextInfo{}),
            .seed = whole_.suite.seed,
            .content = whole_.content,
            .injected = whole_.suite.inject,
            .shard = whole_.shard,
            .whole = plan_.whole,
            .not_run = absent_.empty() ? pending_.size() : 0,
            .cases = {}};
    for (const std::string& id : plan_.ids) {
      if (const auto found = results_.find(id); found != results_.end()) run.cases.push_back(std::move(found->second));
    }
    return run;
  }

 private:
  Way way() const {
    const auto found = whole_.ways.find(plan_.driver);
    return found == whole_.ways.end() ? Way{} : found->second;
  }
  Launch launch() const {
    return {whole_.program, kChildCommand, directory_ / (name_ + ".job"), directory_ / (name_ + ".log"), whole_.limit};
  }
  bool is_pending(const std::string& id) const { return pending_.contains(id); }

  void add(CaseResult result) {
    const std::string renderer = info_ ? info_->renderer : "";
    const bool excused = !excuse_for(whole_.expectations, plan_.driver, renderer, result).empty();
    if (is_bad(result.outcome.status) && !excused) ++bad_;
    pending_.erase(result.id);
    results_.emplace(result.id, std::move(result));
  }

  void take_result(const nlohmann::json& report) {
    CaseResult result = case_result_from(report.at("result"));
    if (!is_pending(result.id)) return;
    crashes_in_a_row_ = functions_in_a_row_ = 0;
    examining_ = report.contains("examined");
    if (examining_) examined_.push_back(result.id);
    add(std::move(result));
  }

  void take_evidence(const nlohmann::json& report) {
    const auto found = results_.find(report.at("id").get<std::string>());
    if (found == results_.end() || !report.at("evidence").is_object()) return;
    found->second.evidence = evidence_from(report.at("evidence"));
  }

  void take_absence(const std::string& why) {
    if (results_.empty() && !info_) {
      absent_ = why;
    } else {  // it was there before, so this is a start that failed
      refusal_ = why + "; ";
    }
  }

  // Every case that is left ends so; those of a function, if one is named.
  void abandon(Status status, const std::string& why, std::string_view function = {}) {
    for (const std::string& id : std::set<std::string>(pending_)) {
      if (!function.empty() && function_of(id) != function) continue;
      add({.id = id, .outcome = outcome_with(status, {why, {}})});
    }
  }

  // The last output of this process, which may show why it ended.
  std::string log_end() const {
    const std::string text = end_of_log(launch().log, kLogEnd, log_begin_);
    return text.empty() ? text : "; it printed:\n" + text;
  }

  void remove_empty_log() const {
    std::error_code error;
    if (std::filesystem::file_size(launch().log, error) == 0 && !error) std::filesystem::remove(launch().log, error);
  }

  const DriverPlan& plan_;
  const RunPlan& whole_;
  std::string name_;
  std::filesystem::path directory_;
  std::set<std::string> pending_;
  std::map<std::string, CaseResult> results_;
  std::optional<ContextInfo> info_;
  std::string absent_;
  std::optional<Worker> worker_;
  std::size_t bad_ = 0;
  std::size_t next_ = 0;               // all before it are done
  bool ready_ = false;                 // this process
  bool examining_ = false;             // this process makes the evidence of the last case
  std::vector<std::string> examined_;  // by any process
  bool lost_ = false;                  // this process ends because its context is lost
  std::string refusal_;                // why this process has no driver
  std::string problem_;
  std::size_t log_begin_ = 0;  // of this process
  int futile_starts_ = 0;
  int crashes_in_a_row_ = 0;
  int functions_in_a_row_ = 0;
};

class Scheduler {
 public:
  Scheduler(const RunPlan& plan, const std::filesystem::path& directory, Journal& journal, std::FILE* progress)
      : plan_(plan), journal_(journal), progress_(progress, total(plan)) {
    for (const DriverPlan& driver : plan.drivers) add_parts(driver);
    std::map<std::string, int> counts;
    for (const DriverPlan& part : parts_) {
      const int number = ++counts[part.driver];
      lanes_.emplace_back(part, plan, number == 1 ? part.driver : fmt::format("{}-{}", part.driver, number), directory);
    }
    for (const Journal::Entry& entry : journal.earlier()) {
      for (Lane& lane : lanes_) {
        // A driver that was absent may be here now.
        if (lane.driver() == entry.driver && !entry.report.contains("absent")) lane.take(entry.report);
      }
    }
  }

  PlanResult run() {
    while (start_lanes()) {
      wait();
      for (Lane& lane : lanes_) serve(lane);
      show_progress();
      if (stopping_ || found_enough() || !journal_.problem().empty()) break;
    }
    std::vector<Run> runs;
    std::vector<std::string> problems;
    for (Lane& lane : lanes_) {
      lane.stop();
      if (!lane.problem().empty()) problems.push_back(lane.problem());
      if (lane.is_absent() && is_here(lane.driver())) lane.deny_absence();
      Run run = lane.take_run();
      if (runs.empty() || runs.back().driver != run.driver) {
        runs.push_back(std::move(run));
      } else {
        if (runs.back().info.renderer.empty()) runs.back().info = run.info;
        runs.back().not_run += run.not_run;
        std::move(run.cases.begin(), run.cases.end(), std::back_inserter(runs.back().cases));
      }
    }
    for (Run& run : runs) sort_as_planned(run);
    return {std::move(runs), std::move(problems)};
  }

 private:
  // If there are fewer drivers than processes may run, the functions of each are dealt to several parts in turn. So a
  // part takes about as long as another, no core waits long for the last one, and cases that ran stand for the others.
  void add_parts(const DriverPlan& driver) {
    const auto draws = [](const DriverPlan& one) { return one.driver != kReferenceCompiler; };
    const auto drivers = static_cast<std::size_t>(std::ranges::count_if(plan_.drivers, draws));
    constexpr std::size_t kPartsOfAProcess = 6;
    constexpr std::size_t kLeast = 60;  // cases, which take a few times as long as loading a driver
    const std::size_t most = drivers < plan_.jobs ? kPartsOfAProcess * plan_.jobs : 1;
    const std::size_t count = std::clamp<std::size_t>(driver.ids.size() / kLeast, 1, most);
    std::vector<DriverPlan> parts(count, {.driver = driver.driver, .ids = {}, .whole = driver.whole});
    std::size_t function = 0;
    for (std::size_t i = 0; i < driver.ids.size(); ++i) {
      if (i > 0 && function_of(driver.ids[i]) != function_of(driver.ids[i - 1])) ++function;
      parts[function % count].ids.push_back(driver.ids[i]);
    }
    std::erase_if(parts, [](const DriverPlan& part) { return part.ids.empty(); });
    std::move(parts.begin(), parts.end(), std::back_inserter(parts_));
  }

  void sort_as_planned(Run& run) const {
    std::map<std::string_view, std::size_t> places;
    for (const DriverPlan& plan : plan_.drivers) {
      if (plan.driver != run.driver) continue;
      for (const std::string& id : plan.ids) places.emplace(id, places.size());
    }
    std::ranges::sort(run.cases, {}, [&](const CaseResult& result) { return places.at(result.id); });
  }

  static std::size_t total(const RunPlan& plan) {
    std::size_t count = 0;
    for (const DriverPlan& driver : plan.drivers) count += driver.ids.size();
    return count;
  }

  // To one of its processes at least.
  bool is_here(const std::string& driver) const {
    return std::any_of(lanes_.begin(), lanes_.end(),
                       [&](const Lane& lane) { return lane.driver() == driver && !lane.is_absent(); });
  }

  // Whether any process runs.
  bool start_lanes() {
    std::size_t running = 0;
    for (Lane& lane : lanes_) running += lane.worker() ? 1 : 0;
    for (Lane& lane : lanes_) {
      if (running >= plan_.jobs) break;
      if (lane.worker() || lane.over()) continue;
      lane.start();
      if (lane.worker()) ++running;
    }
    return running > 0;
  }

  void wait() {
    std::vector<pollfd> waiting = {{plan_.stop_fd, POLLIN, 0}};  // poll passes over -1
    excuse_absence(looked_at_);
    SteadyClock::time_point deadline = looked_at_ + std::chrono::seconds(1);
    for (Lane& lane : lanes_) {
      if (!lane.worker()) continue;
      waiting.push_back({lane.worker()->fd(), POLLIN, 0});
      deadline = std::min(deadline, lane.worker()->deadline());
    }
    poll(waiting.data(), waiting.size(), milliseconds_until(deadline));
    stopping_ = waiting.front().revents != 0;
    excuse_absence(deadline);
  }

  // Ctrl-Z stops the drivers as well as this process, so that time does not count for their limits.
  void excuse_absence(SteadyClock::time_point expected) {
    const SteadyClock::time_point now = SteadyClock::now();
    for (Lane& lane : lanes_) {
      if (now - expected >= kLate && lane.worker()) lane.worker()->postpone_deadline(now - looked_at_);
    }
    looked_at_ = now;
  }

  void serve(Lane& lane) {
    if (!lane.worker()) return;
    for (const nlohmann::json& report : lane.worker()->read()) {
      if (found_enough()) return;
      if (report.contains("alive")) continue;  // that it was read is all
      lane.take(report);
      journal_.add(lane.driver(), report);
    }
    if (!lane.worker()->end()) return;
    if (stopping_) return;  // who stops us may have ended it
    if (const auto result = lane.take_end()) journal_.add(lane.driver(), {{"result", to_json(*result)}});
  }

  // With fail_fast: a bad case, and all that there is to report about it.
  bool found_enough() const {
    const auto examining = [](const Lane& lane) { return lane.examining(); };
    return plan_.fail_fast && bad() > 0 && std::none_of(lanes_.begin(), lanes_.end(), examining);
  }

  std::size_t bad() const {
    std::size_t count = 0;
    for (const Lane& lane : lanes_) count += lane.bad();
    return count;
  }

  // As long for each case as for those that ran here.
  std::optional<double> seconds_left(std::size_t done) {
    if (!begin_done_) begin_done_ = done;  // of an earlier run
    const auto here = static_cast<double>(done - *begin_done_);
    const double elapsed = std::chrono::duration<double>(SteadyClock::now() - begin_).count();
    constexpr double kEnough = 2.0;  // before that it would jump
    if (here == 0.0 || elapsed <= kEnough) return std::nullopt;
    return static_cast<double>(total(plan_) - done) * elapsed / here;
  }

  void show_progress() {
    std::size_t done = 0;
    std::string current;
    for (Lane& lane : lanes_) {
      done += lane.done();
      if (lane.worker()) current += fmt::format("{}{} {}", current.empty() ? "" : " | ", lane.driver(), lane.current());
    }
    progress_.show(done, bad(), current, seconds_left(done));
  }

  const RunPlan& plan_;
  std::vector<DriverPlan> parts_;
  Journal& journal_;
  Progress progress_;
  std::optional<std::size_t> begin_done_;
  const SteadyClock::time_point begin_ = SteadyClock::now();
  std::vector<Lane> lanes_;
  bool stopping_ = false;
  SteadyClock::time_point looked_at_ = SteadyClock::now();
};

}  // namespace

nlohmann::json to_json(const RunPlan& plan) {
  nlohmann::json drivers = nlohmann::json::object();
  for (const DriverPlan& driver : plan.drivers) drivers[driver.driver] = driver.ids;
  nlohmann::json ways = nlohmann::json::object();
  for (const auto& [driver, way] : plan.ways) ways[driver] = to_json(way);
  return {{"version", library_version()}, {"drivers", std::move(drivers)}, {"ways", std::move(ways)},
          {"suite", plan.suite},          {"content", plan.content},       {"shard", plan.shard}};
}

PlanResult run_plan(const RunPlan& plan, const std::filesystem::path& directory, Journal& journal,
                    std::FILE* progress) {
  return Scheduler(plan, directory, journal, progress).run();
}

}  // namespace hn
