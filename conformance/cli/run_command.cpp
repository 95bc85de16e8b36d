// hn-conform drivers, run and merge
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/utsname.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "base/worker.hpp"
#include "cases/deal.hpp"
#include "cli/command.hpp"
#include "expected/golden.hpp"
#include "fault/faults.hpp"
#include "gpu/spirv.hpp"
#include "report/report.hpp"
#include "run/expectation.hpp"
#include "run/journal.hpp"
#include "run/merge.hpp"
#include "run/scheduler.hpp"
#include "run/selection.hpp"
#include "web/suite.hpp"

namespace hn {
namespace {

constexpr int kNotWritten = -1;  // of conclude, and no exit status

constexpr std::chrono::milliseconds kDescribeLimit{60000};

// Asks a driver in a process of its own, since its libraries could crash. It ends once stop_fd can be read.
Result<nlohmann::json> ask(Task task, const std::string& driver, int stop_fd, const WayOptions& way = {}) {
  const TemporaryFolder scratch;
  Job job{.task = task, .driver = driver, .suite = {}, .ids = {}};
  job.suite.way = way;
  return report_of(job, scratch.path(), kDescribeLimit, stop_fd);
}

struct Devices {
  DeviceCounts counts;
  std::vector<std::string> problems;  // why EGL or Vulkan does not list them
};

Devices find_devices(int stop_fd) {
  Devices devices;
  const auto count = [&](Task task, std::string_view what) {
    const auto report = ask(task, "", stop_fd);
    if (report) return report->value("devices", 0);
    devices.problems.push_back(fmt::format("{} does not list its devices: {}", what, report.error().text()));
    return 0;
  };
  devices.counts.egl = count(Task::devices, "EGL");
  devices.counts.vulkan = count(Task::vulkan, "Vulkan");
  return devices;
}

// The profiles of the cases that drivers run behind a way, each once.
std::vector<std::string> profiles_of(const Selection& chosen) {
  std::set<std::string> names;
  for (const Case& test : chosen.cases) {
    if (test.needs_driver() && (chosen.thorough || test.is_covered())) names.insert(test.name.profile);
  }
  return {names.begin(), names.end()};
}

// Finds the ways to the drivers. A driver to which there is none is an error if it was named, and else absent.
Result<void> find_ways(const WayOptions& options, DriverChoice& choice) {
  if (options.through.empty() && options.takes.empty() && options.gives.empty()) return {};
  choice.way = options;
  for (const std::string& name : choice.names) {
    const std::vector<Form> takes = find_driver(name)->takes();
    if (takes.empty() && !choice.named.contains(name)) continue;
    auto way = takes.empty() ? fail("it takes no shader from a translator; all but browsers and glslang do")
                             : find_way(options, takes);
    if (way) {
      choice.ways.emplace(name, *way);
    } else if (choice.named.contains(name)) {
      return fail(fmt::format("--through, to the driver {}: {}", name, way.error().text()));
    } else {
      Run& run = choice.absent.emplace_back();
      run.driver = name;
      run.absent = way.error().text();
    }
  }
  std::erase_if(choice.names, [&](const std::string& name) { return !choice.ways.contains(name); });
  if (choice.names.empty() && !choice.absent.empty()) return fail(choice.absent.front().absent);
  return {};
}

}  // namespace

Result<DriverChoice> choose_drivers(const std::vector<std::string>& wanted, const WayOptions& way, int stop_fd) {
  DriverChoice choice;
  const auto add = [&](const std::string& name) {
    if (std::find(choice.names.begin(), choice.names.end(), name) == choice.names.end()) choice.names.push_back(name);
  };
  for (std::string name : wanted) {
    if (name == "vulkan") name += ":0";
    if (name.ends_with("-es")) name.insert(name.size() - 2, "gl");
    if (find_driver(name)) {
      add(name);
      choice.named.insert(name);
      continue;
    }
    const std::string glob = name == "all" ? "*" : name;
    const bool is_glob = glob.find_first_of("*?[") != std::string::npos;
    const Devices devices = is_glob ? find_devices(stop_fd) : Devices{};
    choice.problems.insert(choice.problems.end(), devices.problems.begin(), devices.problems.end());
    bool found = false;
    for (const Driver& driver : is_glob ? all_drivers(devices.counts) : std::vector<Driver>{}) {
      if (!matches_glob(driver.name, glob)) continue;
      add(driver.name);
      found = true;
    }
    if (!found)
      return fail(
          fmt::format("there is no driver \"{}\"; there are: {}, and all", name, driver_names(DriverKind::any)));
  }
  HN_DO(find_ways(way, choice));
  return choice;
}

namespace {

// How many cases a driver gets where a compiler of CPUs gets four, as a case costs there, at first: softpipe interprets
// shaders, and zink has each compiled once more behind its own compiler.
int turns_of(std::string_view renderer) {
  if (renderer.starts_with("softpipe")) return 1;
  if (renderer.starts_with("zink")) return 2;
  return 4;
}

// The driver's support and renderer, as far as the driver reports them; else nothing.
std::optional<DealtDriver> describe_for_deal(const std::string& name, const WayOptions& way, int stop_fd) {
  const auto report = ask(Task::describe, name, stop_fd, way);
  if (!report || !report->contains("ready")) return std::nullopt;
  const std::string renderer = context_info_from(report->at("ready")).renderer;
  if (const Browser* browser = find_driver(name)->browser) {
    return DealtDriver{[browser](const Case& test) { return unsupported_in_browser(test, browser->platform).empty(); },
                       renderer, turns_of(renderer)};
  }
  const LanguageSupport languages = report->at("languages").get<LanguageSupport>();
  const auto can_run = [=](const Case& test) {
    const Profile& profile = profile_named(test.name.profile);
    const bool only_compiled = test.is<CompilationKind>();
    const auto reason = only_compiled ? unsupported_reason(profile, languages) : unsupported_to_run(profile, languages);
    return reason.empty() && languages.has_stage(test.name.stage);
  };
  return DealtDriver{can_run, renderer, turns_of(renderer)};
}

using Profiles = std::set<std::string, std::less<>>;

// The profiles in which a driver may run shaders: the sources of the way to it, or all of its platform.
Profiles profiles_for(const Driver& driver, const DriverChoice& choice) {
  Profiles names;
  if (const auto way = choice.ways.find(driver.name); way != choice.ways.end()) {
    for (const std::string& name : way->second.sources()) names.insert(name);
    return names;
  }
  for (const auto profiles : {all_profiles(), other_languages(), refused_profiles()}) {
    for (const Profile& profile : profiles) {
      if (profile.platform() == driver.platform && !profile.by_translator) names.emplace(profile.name);
    }
  }
  return names;
}

// The cases in these profiles. es_alone: of a driver without a desktop version.
std::vector<Case> cases_for(const Profiles& profiles, bool thorough, bool es_alone, const std::vector<Case>& all) {
  std::vector<Case> cases;
  std::copy_if(all.begin(), all.end(), std::back_inserter(cases), [&](const Case& test) {
    return profiles.contains(test.name.profile) && (thorough || test.is_covered(es_alone));
  });
  return cases;
}

// The part of a driver, of cases that are all for it or not.
DriverPlan plan_of(const std::string& driver, const std::vector<Case>& cases, const Shard& shard) {
  DriverPlan plan{.driver = driver, .ids = {}, .whole = cases.size()};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (shard.has(i)) plan.ids.push_back(cases[i].id);
  }
  return plan;
}

// A driver that does not report its support gets every case, and its run reports why it is not here.
void deal_among(std::vector<DriverPlan>& plans, const std::vector<std::string>& names, const std::vector<Case>& cases,
                const WayOptions& way, int stop_fd) {
  std::vector<DealtDriver> drivers;
  std::vector<std::size_t> dealt_to;  // of the drivers, places in plans
  for (const std::string& name : names) {
    plans.push_back(plan_of(name, cases, Shard{}));
    if (auto described = describe_for_deal(name, way, stop_fd)) {
      drivers.push_back(std::move(*described));
      dealt_to.push_back(plans.size() - 1);
    }
  }
  const auto dealt = deal(cases, drivers);
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    DriverPlan& plan = plans[dealt_to[i]];
    plan = {.driver = plan.driver, .ids = {}, .whole = dealt[i].size(), .dealt = true};
    for (const std::size_t place : dealt[i]) plan.ids.push_back(cases[place].id);
  }
}

// The drivers of a platform, or behind ways of the same sources, deal their cases among themselves.
std::vector<DriverPlan> deal_plans(const DriverChoice& choice, const std::vector<std::string>& names,
                                   const std::vector<Case>& cases, bool thorough, int stop_fd) {
  std::vector<DriverPlan> plans;
  std::map<Profiles, std::vector<std::string>> by_profiles;
  for (const std::string& name : names) by_profiles[profiles_for(*find_driver(name), choice)].push_back(name);
  for (const auto& [profiles, some] : by_profiles)
    deal_among(plans, some, cases_for(profiles, thorough, false, cases), choice.way, stop_fd);
  return plans;
}

// Plans the work of every driver: the cases that need one; and of glslang, which runs unless there are ways, the
// others.
std::vector<DriverPlan> plan_drivers(const DriverChoice& choice, std::vector<Case> cases, const Shard& shard,
                                     bool dealt, bool thorough, int stop_fd) {
  std::vector<std::string> names = choice.names;
  std::erase(names, std::string(kReferenceCompiler));
  const auto of_drivers =
      std::stable_partition(cases.begin(), cases.end(), [](const Case& test) { return !test.needs_driver(); });
  const std::vector<Case> for_drivers(of_drivers, cases.end());
  cases.erase(of_drivers, cases.end());
  std::vector<DriverPlan> plans;
  if (dealt) {
    plans = deal_plans(choice, names, for_drivers, thorough, stop_fd);
  } else {
    for (const std::string& name : names) {
      const Driver driver = *find_driver(name);
      const Profiles profiles = profiles_for(driver, choice);
      const bool es_alone = driver.es_alone() && choice.ways.empty();
      plans.push_back(plan_of(name, cases_for(profiles, thorough, es_alone, for_drivers), shard));
    }
  }
  if (choice.ways.empty()) plans.push_back(plan_of(std::string(kReferenceCompiler), cases, shard));
  std::erase_if(plans, [](const DriverPlan& plan) { return plan.ids.empty(); });
  return plans;
}

Result<Journal> open_journal(const RunOutput& output, const nlohmann::json& plan) {
  if (output.resume && Journal::exists(output.out)) return Journal::reopen(output.out, plan);
  if (output.resume) complain(fmt::format("nothing to resume in {}, so this is a new run", output.out));
  if (Journal::exists(output.out)) {
    complain(fmt::format("a new run: what an earlier run left in {} for --resume is removed",
                         (std::filesystem::path(output.out) / kJournalFile).string()));
  }
  return Journal::create(output.out, plan);
}

// "Linux", "macOS": without a version.
std::string system_name() {
  utsname names{};
  if (uname(&names) != 0) return "";
  const std::string name = names.sysname;
  return name == "Darwin" ? "macOS" : name;
}

// Whether a run has the cases that everybody has who gives no options, so that its results can be compared.
bool has_default_cases(const RunSelection& selection, const SuiteOptions& suite) {
  const SuiteOptions usual;
  return selection.filters.empty() && !selection.thorough && !selection.deal && suite.glsl.empty() &&
         suite.inject.empty() && suite.points == usual.points && suite.seed == usual.seed && suite.way.through.empty();
}

// Writes and prints the results of the runs, and returns the exit status. problems: faults beside the cases.
int conclude(const std::vector<Run>& runs, const std::string& out, std::vector<std::string> problems) {
  if (problems.empty() && nothing_passed(runs)) {
    problems.push_back("no case passed: all that ran are excused or unsupported, which is no verdict on a driver");
  }
  const auto written = write_results(out, runs, problems);
  for (const Run& run : runs) say(printable(summary(run)));
  say(printable(edited_libraries(runs)));
  for (const std::string& problem : problems) complain(problem);
  if (!written) {
    complain(written.error().text());
    return kNotWritten;
  }
  const bool good = problems.empty() && all_as_expected(runs);
  const std::string_view verdict = good                    ? "All as expected"
                                   : only_unfinished(runs) ? "NOT THE WHOLE RUN"
                                                           : "NOT AS EXPECTED";
  say(fmt::format("{}: {}\n", verdict, (std::filesystem::path(out) / kPageFile).string()));
  return good ? 0 : kNotAsExpected;
}

bool is_here(const Run& run) { return run.absent.empty() && run.driver != kReferenceCompiler; }

// Why there can be no verdict: drivers that were named are not here, or none is.
std::vector<std::string> missing_drivers(const std::vector<Run>& runs, const std::set<std::string>& named) {
  std::vector<std::string> missing;
  bool any = false;
  for (const Run& run : runs) {
    if (run.absent.empty()) continue;
    any = true;
    if (named.contains(run.driver)) {
      missing.push_back(fmt::format("the driver {} is not here: {}", run.driver, run.absent));
    }
  }
  if (!missing.empty() || !any || std::any_of(runs.begin(), runs.end(), is_here)) return missing;
  return {"none of the drivers is here"};
}

// Adds the problem of a run that ended early, and returns whether it did. why: a part of a sentence, or empty where a
// case gives the reason.
bool note_what_was_not_run(const RunPlan& plan, const std::vector<Run>& runs, const std::string& why,
                           std::vector<std::string>& problems) {
  std::size_t planned = 0;
  std::size_t done = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    // Who is not here leaves nothing out, unless others rely on it.
    if (!runs[i].absent.empty() && !plan.drivers[i].dealt) continue;
    planned += plan.drivers[i].ids.size();
    done += runs[i].cases.size();
  }
  if (done == planned) return false;
  problems.push_back(fmt::format("{}{} of {} cases were not run", why, planned - done, planned));
  return true;
}

Result<std::vector<Expectation>> load_expectations(const std::string& directory) {
  HN_TRY(auto expectations, read_expectations(directory));
  // All cases take longer to list than most expectations need: a thorough run has those of a default run, too.
  if (!check_expectations(expectations, ids_of(all_cases(Scope::covered)))) {
    HN_DO(check_expectations(expectations, ids_of(all_cases())));
  }
  return expectations;
}

// The files that a run reads before it starts drivers.
struct RunInputs {
  Selection chosen;
  SourceSet sources;
  std::vector<Expectation> expectations;
  std::string golden;  // the checksum of the golden files, if the run is one whose results can be compared
};

Result<RunInputs> read_inputs(const RunSelection& selection, const RunExecution& execution) {
  HN_TRY(auto chosen, select_cases(selection.filters, selection.thorough));
  HN_TRY(auto sources, suite_sources(execution.suite));
  const std::string& golden = execution.suite.golden;
  HN_DO(check_golden_folder(golden));
  HN_TRY(auto expectations, load_expectations(execution.expect));
  return RunInputs{std::move(chosen), std::move(sources), std::move(expectations),
                   has_default_cases(selection, execution.suite) ? golden_checksum(golden) : ""};
}

Result<RunPlan> make_plan(const RunSelection& selection, const RunExecution& execution, const DriverChoice& choice,
                          const RunInputs& inputs, int stop_fd) {
  HN_TRY(auto shard, parse_shard(selection.shard));
  if (selection.deal && !selection.shard.empty()) {
    return fail("--deal and --shard cannot be combined: each machine would deal to its own drivers");
  }
  RunPlan plan{
      .drivers = plan_drivers(choice, inputs.chosen.cases, shard, selection.deal, inputs.chosen.thorough, stop_fd),
      .suite = execution.suite,
      .ways = choice.ways,
      .shard = selection.shard,
      .jobs = execution.jobs,
      .limit = std::chrono::milliseconds(static_cast<std::int64_t>(execution.timeout * 1000.0)),
      .expectations = inputs.expectations,
      .fail_fast = execution.fail_fast,
      .stop_fd = stop_fd};
  plan.suite.thorough = selection.thorough;
  if (plan.drivers.empty()) {
    return fail("there is nothing to do: no case is for one of these drivers, or it needs --thorough");
  }
  plan.content = suite_digest(plan.suite, inputs.sources);
  return plan;
}

// Why a run may have ended too early, as the beginning of a sentence. Nothing if there is no reason but a case.
std::string reason_to_end(const Journal& journal, int signal) {
  if (signal != 0) return fmt::format("{} ended the run; ", name_of_signal(signal));
  return journal.problem().empty() ? "" : journal.problem() + "; ";
}

// Puts the inputs of faulty steps into the results, so that their page has it wherever it is made.
void keep_inputs(Run& run, const std::filesystem::path& out) {
  constexpr std::size_t kMostOfOne = 20'000;
  constexpr std::size_t kMostOfAll = 2'000'000;
  std::size_t all = 0;
  for (CaseResult& result : run.cases) {
    if (!result.outcome.step || result.outcome.step->input.empty() || all > kMostOfAll) continue;
    FaultyStep& step = *result.outcome.step;
    const auto bytes = read_file(out / step.input);
    if (bytes) {
      step.text = clean_text(shortened(spirv_text(*bytes).value_or(*bytes), kMostOfOne));
      all += step.text.size();
    } else {
      step.input.clear();  // of a step that never works, the shader of the first case is kept alone
    }
  }
}

// The cases, their results, and the exit status.
int run_to_the_end(const RunPlan& plan, const RunOutput& output, const RunInputs& inputs, const DriverChoice& choice,
                   Journal& journal, const Interruption& interruption) {
  auto [runs, problems] = run_plan(plan, output.out, journal, stderr);
  for (Run& run : runs) keep_inputs(run, output.out);
  for (Run& run : runs) {
    if (run.info.system.empty()) run.info.system = system_name();
    if (!run.is_reference()) run.golden = inputs.golden;
    run.date = now();
    run.library = inputs.sources.edited();
    run.commands = {output.line};
    if (const GivenFunction& given = plan.suite.given; !given.id.empty()) {
      run.checked = {given.text, given.expected_from, given.expected_right};
    }
    apply_expectations(plan.expectations, run);
  }
  const auto missing = missing_drivers(runs, choice.named);
  problems.insert(problems.end(), missing.begin(), missing.end());
  problems.insert(problems.end(), choice.problems.begin(), choice.problems.end());
  const int signal = interruption.signal();
  const std::string reason = reason_to_end(journal, signal);
  const bool whole = !note_what_was_not_run(plan, runs, reason, problems);
  runs.insert(runs.end(), choice.absent.begin(), choice.absent.end());
  const int status = conclude(runs, output.out, problems);
  const bool ended_early = !whole && !reason.empty();
  if (ended_early || status == kNotWritten) {
    complain(fmt::format("what was found is kept in {}; the same command with --resume goes on from there",
                         (std::filesystem::path(output.out) / kJournalFile).string()));
    return ended_early && signal != 0 ? kSignalled + signal : kNotAsExpected;
  }
  journal.remove();
  return missing.empty() ? status : kNoDriver;
}

int ended_before_results(const Interruption& interruption) {
  complain(farewell(interruption.signal()));
  return kSignalled + interruption.signal();
}

}  // namespace

int run(const DriversCommand&, Interruption& interruption) {
  interruption.note_the_first();
  const int stop_fd = interruption.fd();
  bool usable = false;
  const Devices devices = find_devices(stop_fd);
  if (interruption.signal() != 0) return ended_before_results(interruption);
  for (const std::string& problem : devices.problems) complain(problem);
  for (const Driver& driver : all_drivers(devices.counts)) {
    fmt::print("{:<18} {}\n", driver.name, driver.description);
    const auto report = ask(Task::describe, driver.name, stop_fd);
    if (interruption.signal() != 0) return ended_before_results(interruption);
    if (report && report->contains("ready")) {
      const ContextInfo info = context_info_from(report->at("ready"));
      usable = usable || !driver.is_reference_compiler();
      fmt::print("{:<18} {}; {}{}{}\n", "", info.renderer, info.gl_version, info.glsl_version.empty() ? "" : "; GLSL ",
                 info.glsl_version);
    } else {
      fmt::print("{:<18} not here: {}\n", "", report ? "it does not state what it is" : report.error().text());
    }
  }
  fmt::print("\nTranslators, for run --through:\n");
  for (const KnownTranslator& one : known_translators()) {
    fmt::print("{:<18} {}\n{:<18} {}\n", one.name, one.forms, "",
               one.version ? fmt::format("{} {}", one.program, one.version->empty() ? "version unknown" : *one.version)
                           : fmt::format("not here: {}", one.version.error().text()));
  }
  return usable ? 0 : kNoDriver;
}

int run(const RunCommand& command, Interruption& interruption) {
  auto [selection, execution, output] = command;
  if (execution.suite.inject == "list") {
    fmt::print("{}", fault_list());
    return 0;
  }
  const auto inputs = read_inputs(selection, execution);
  if (!inputs) return usage_error(inputs.error().text());
  interruption.note_the_first();
  const int stop_fd = interruption.fd();
  execution.suite.way.profiles = profiles_of(inputs->chosen);
  const auto choice = choose_drivers(selection.drivers, execution.suite.way, stop_fd);
  if (!choice) return usage_error(choice.error().text());
  const auto plan = make_plan(selection, execution, *choice, *inputs, stop_fd);
  if (interruption.signal() != 0) return ended_before_results(interruption);
  if (!plan) return usage_error(plan.error().text());
  const auto folder = prepare_results(output.out);
  if (!folder) return usage_error(folder.error().text());
  auto journal = open_journal(output, to_json(*plan));
  if (!journal) return usage_error(journal.error().text());
  return run_to_the_end(*plan, output, *inputs, *choice, *journal, interruption);
}

int run(const MergeCommand& options, Interruption& interruption) {
  const auto expectations = load_expectations(options.expect);
  if (!expectations) return usage_error(expectations.error().text());
  auto merged = merge_files(options.inputs, ids_of(all_cases()));
  if (!merged) return usage_error(merged.error().text());
  interruption.note_the_first();
  const auto folder = prepare_results(options.out);
  if (!folder) return usage_error(folder.error().text());
  for (Run& run : merged->runs) apply_expectations(*expectations, run);
  std::vector<std::string> problems = merged->gaps;
  const auto missing = missing_drivers(merged->runs, {});
  problems.insert(problems.end(), missing.begin(), missing.end());
  const int status = conclude(merged->runs, options.out, problems);
  if (status == kNotWritten) return kNotAsExpected;
  return missing.empty() ? status : kNoDriver;
}

}  // namespace hn
