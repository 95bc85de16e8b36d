// The process that runs the cases of one driver.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "base/worker.hpp"
#include "cases/evidence.hpp"
#include "cli/command.hpp"
#include "gpu/vulkan/device.hpp"
#include "gpu/way/evaluator.hpp"
#include "run/job.hpp"
#include "run/results.hpp"
#include "web/browser.hpp"
#include "web/wgsl.hpp"

namespace hn {
namespace {

void run_reference_cases(const Suite& suite, const std::vector<Case>& cases) {
  report({{"ready", to_json(ContextInfo{"Khronos", "glslang", reference_compiler_version(), "", {}})}});
  for (const Case& test : cases) report({{"result", to_json(run_case(suite, test))}});
}

// A lost context costs the process.
void end_if(bool lost) {
  if (!lost) return;
  report({{"lost", true}});
  _exit(EXIT_SUCCESS);  // to destroy a lost one could hang
}

// After the result, so that the verdict is known whatever comes of this.
void report_evidence(Session& session, const Case& test, const Outcome& outcome) {
  const auto evidence = make_evidence(session, test, outcome);
  report({{"evidence", evidence ? to_json(*evidence) : nlohmann::ordered_json()}, {"id", test.id}});
}

void run_driver_cases(const Suite& suite, std::unique_ptr<Evaluator> evaluator, const Driver& driver,
                      const std::vector<Case>& cases, const std::vector<Case>& examined_before) {
  Session session(suite, std::move(evaluator), driver.most_points);
  session.still_alive = [] { report({{"alive", true}}); };
  EvidenceBudget budget;
  for (const Case& test : examined_before) budget.take(test.name);
  report({{"ready", to_json(session.info())}, {"languages", nlohmann::json(session.info().languages)}});
  for (const Case& test : cases) {
    CaseResult result = run_case(session, test);
    const bool lost = session.evaluator->is_lost();
    if (lost) {
      const char* const what = session.evaluator->context() ? "the context was lost" : "the device was lost";
      result.outcome = outcome_with(Status::crash, {what, result.outcome.message});
    }
    const bool has_values = test.evaluation() != nullptr || test.is<BugKind>();
    const bool examined = result.outcome.status == Status::fail && has_values && budget.take(test.name);
    nlohmann::ordered_json line = {{"result", to_json(result)}};
    if (examined) line["examined"] = true;
    report(line);
    end_if(lost);
    if (!examined) continue;
    report_evidence(session, test, result.outcome);
    end_if(session.evaluator->is_lost());
  }
}

// In the first of the given function's profiles that the driver has.
int report_values(const Suite& suite, std::unique_ptr<Evaluator> evaluator, const Driver& driver) {
  Session session(suite, std::move(evaluator), driver.most_points);
  const Bug& function = all_bugs().back();
  std::string why;
  for (const std::string_view profile : split(function.profiles, ' ')) {
    const auto outputs = outputs_of(session, function, profile_named(profile));
    if (!outputs) {
      why += fmt::format("{}{}: {}", why.empty() ? "" : "; ", profile, outputs.error().message);
      continue;
    }
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < outputs->size(); i += kOutputWords) {
      const auto* const words = &(*outputs)[i];
      values.push_back(std::vector(words, words + function.function.outputs.size()));
    }
    report({{"values", std::move(values)}, {"profile", profile}, {"info", to_json(session.info())}});
    return EXIT_SUCCESS;
  }
  report({{"error", why}});
  return EXIT_SUCCESS;
}

// A browser that ends has crashed in the case that ran, as this process does.
int run_browser_cases(const Job& job, const Browser& browser, const SourceSet& sources) {
  bool absent = false;
  const auto told = [](const char* name, nlohmann::ordered_json value) { report({{name, std::move(value)}}); };
  const CaseEvents events = {.ready = [&](const ContextInfo& info) { told("ready", to_json(info)); },
                             .started = [](const std::string&) {},
                             .finished = [&](const CaseResult& result) { told("result", to_json(result)); },
                             .absent = [&](const std::string& why) { told("absent", why), absent = true; }};
  const auto done = run_in_browser(browser, sources, job.suite.golden, job.ids, events);
  if (done || absent) return EXIT_SUCCESS;
  fmt::print(stderr, "{}\n", done.error().text());
  return EXIT_FAILURE;
}

int describe_in_browser(const Browser& browser) {
  const auto info = describe_browser(browser);
  report(info ? nlohmann::ordered_json{{"ready", to_json(*info)}}
              : nlohmann::ordered_json{{"absent", info.error().text()}});
  return EXIT_SUCCESS;
}

// The evaluator, behind the way to its driver. An error: this one, unlike others of its kind, takes no such shader.
Result<std::unique_ptr<Evaluator>> through_way(const Job& job, const Driver& driver,
                                               std::unique_ptr<Evaluator> evaluator,
                                               const ReferenceCompiler& reference) {
  HN_TRY(auto way, find_way(job.suite.way, driver.takes()));
  const Form last = way.steps.back().gives;
  if (std::ranges::count(evaluator->takes(), last) == 0) {
    return fail(fmt::format("{}, {} takes no {}, which comes out of {}", evaluator->info().renderer,
                            evaluator->info().gl_version, name_of(last), way.text()));
  }
  return evaluator_through(std::move(way), std::move(evaluator), reference, wgsl_text,
                           {std::chrono::milliseconds(job.step_limit), job.kept});
}

int run_on_driver(const Job& job, const Driver& driver) {
  const auto sources = suite_sources(job.suite);
  if (!sources) {
    report({{"error", sources.error().text()}});
    return EXIT_FAILURE;
  }
  if (!job.suite.given.id.empty()) give(job.suite.given);
  if (driver.browser && job.task == Task::describe) return describe_in_browser(*driver.browser);
  if (driver.browser && job.task == Task::cases) return run_browser_cases(job, *driver.browser, *sources);
  const ReferenceCompiler reference;
  const auto pick = data_folder_of(own_program()) / "pick";
  const Suite suite{*sources, reference, job.suite.golden, job.suite.seed, job.suite.points, job.suite.thorough, pick};
  const auto cases = cases_with(job.ids);
  const auto examined = cases_with(job.examined);
  if (!cases || !examined) {
    report({{"error", (cases ? examined : cases).error().text()}});
    return EXIT_FAILURE;
  }
  if (driver.is_reference_compiler()) {
    run_reference_cases(suite, *cases);
    return EXIT_SUCCESS;
  }
  auto evaluator = create_evaluator(driver, reference);
  if (!evaluator) {
    report({{"absent", evaluator.error().text()}});
    return EXIT_SUCCESS;
  }
  if (!job.suite.way.through.empty()) evaluator = through_way(job, driver, std::move(*evaluator), reference);
  if (!evaluator) {
    report({{"absent", evaluator.error().text()}});
    return EXIT_SUCCESS;
  }
  if (job.task == Task::values) return report_values(suite, std::move(*evaluator), driver);
  run_driver_cases(suite, std::move(*evaluator), driver, *cases, *examined);
  return EXIT_SUCCESS;
}

}  // namespace

int child_command(const std::filesystem::path& path) {
  // Programs that this process starts must not hold the pipe open when this process is gone.
  if (fcntl(kReportFd, F_SETFD, FD_CLOEXEC) != 0) return usage_error("child is called by hn-conform itself only");
  const auto text = read_file(path);
  if (!text) return usage_error(text.error().text());
  const auto job = nlohmann::json::parse(*text).get<Job>();
  if (job.task == Task::devices) {
    report({{"devices", egl_device_count()}});
    return EXIT_SUCCESS;
  }
  if (job.task == Task::vulkan) {
    prepare_vulkan();
    report({{"devices", vulkan_device_count()}});
    return EXIT_SUCCESS;
  }
  const auto driver = find_driver(job.driver);
  if (!driver) return unknown_driver(job.driver);
  return run_on_driver(job, *driver);
}

}  // namespace hn
