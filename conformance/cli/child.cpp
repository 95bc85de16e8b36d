#include "run/job.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/command.hpp"
#include "base/embedded.hpp"
#include "cases/evidence.hpp"
#include "fault/faults.hpp"
#include "base/process.hpp"
#include "run/results.hpp"
#include "bench/timings.hpp"
#include "web/browser.hpp"

namespace hn {
namespace {

// One line in one write, so that the parent reads whole lines and has them whatever happens next.
void report(const nlohmann::ordered_json& json) {
  const std::string line = dump(json) + "\n";
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = write(kReportFd, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(EXIT_FAILURE);  // nobody listens
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool context_is_lost(const Context& context) {
  const GladGLContext& gl = context.gl();
  if (gl.GetGraphicsResetStatus && gl.GetGraphicsResetStatus() != GL_NO_ERROR) return true;
  constexpr GLenum kContextLost = 0x0507;  // of OpenGL 4.5 and of KHR_robustness
  for (GLenum error = gl.GetError(); error != GL_NO_ERROR; error = gl.GetError()) {
    if (error == kContextLost) return true;
  }
  return false;
}

// The cases of the job, in its order.
std::vector<const Case*> cases_of(const Job& job, const std::vector<Case>& all) {
  std::map<std::string_view, const Case*> by_id;
  for (const Case& test : all) by_id[test.id] = &test;
  std::vector<const Case*> cases;
  for (const std::string& id : job.ids) cases.push_back(by_id.at(id));
  return cases;
}

void run_reference_cases(const Suite& suite, const std::vector<const Case*>& cases) {
  report({{"ready", to_json(ContextInfo{"Khronos", "glslang", reference_compiler_version(), "", {}})}});
  for (const Case* test : cases) {
    report({{"result", to_json(run_case(suite, *test))}});
  }
}

// A lost context costs the process.
void end_if(bool lost) {
  if (!lost) return;
  report({{"lost", true}});
  _exit(EXIT_SUCCESS);  // to destroy what is lost could hang
}

// After the result, so that the verdict is known whatever comes of this.
void report_evidence(Session& session, const Case& test, const Outcome& outcome) {
  const auto evidence = make_evidence(session, test, outcome);
  report({{"evidence", evidence ? to_json(*evidence) : nlohmann::ordered_json()}, {"id", test.id}});
}

void run_driver_cases(const Suite& suite, const Context& context, const Driver& driver, const Job& job,
                      const std::vector<const Case*>& cases) {
  Session session(suite, context, driver.most_points);
  session.still_alive = [] { report({{"alive", true}}); };
  EvidenceBudget budget(job.examined);
  report({{"ready", to_json(session.info)}});
  for (const Case* test : cases) {
    CaseResult result = run_case(session, *test);
    const bool lost = context_is_lost(context);
    if (lost) result.outcome = outcome_with(Status::crash, {"the context was lost", {}});
    const bool examined = result.outcome.status == Status::fail && test->evaluation && budget.take(test->id);
    nlohmann::ordered_json line = {{"result", to_json(result)}};
    if (examined) line["examined"] = true;
    report(line);
    end_if(lost);
    if (!examined) continue;
    report_evidence(session, *test, result.outcome);
    end_if(context_is_lost(context));
  }
}

// A browser that ends has crashed in the case that ran, as this process does.
int run_browser_cases(const Job& job, const Browser& browser, const SourceSet& sources) {
  bool absent = false;
  const CaseEvents events = {.ready =
                                 [](const ContextInfo& info) {
                                   report({{"ready", to_json(info)}});
                                 },
                             .started = [](const std::string&) {},
                             .finished =
                                 [](const CaseResult& result) {
                                   report({{"result", to_json(result)}});
                                 },
                             .absent =
                                 [&](const std::string& why) {
                                   absent = true;
                                   report({{"absent", why}});
                                 }};
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

int run_on_driver(const Job& job, const Driver& driver) {
  const auto sources = suite_sources(job.suite);
  if (!sources) {
    report({{"error", sources.error().text()}});
    return EXIT_FAILURE;
  }
  if (driver.browser && job.task == Task::describe) return describe_in_browser(*driver.browser);
  if (driver.browser && job.task == Task::cases) return run_browser_cases(job, *driver.browser, *sources);
  const ReferenceCompiler reference;
  const Suite suite{*sources, reference, job.suite.golden, job.suite.seed, job.suite.points};
  const std::vector<Case> all = job.task == Task::describe ? std::vector<Case>{} : all_cases();
  const std::vector<const Case*> cases = cases_of(job, all);
  if (driver.is_reference_compiler()) {
    run_reference_cases(suite, cases);
    return EXIT_SUCCESS;
  }
  const auto context = create_context(driver);
  if (!context) {
    report({{"absent", context.error().text()}});
    return EXIT_SUCCESS;
  }
  if (job.task == Task::timings) {
    report(timings_report(**context, *sources, reference, job.ids));
  } else {
    run_driver_cases(suite, **context, driver, job, cases);
  }
  return EXIT_SUCCESS;
}

constexpr std::array<std::string_view, 4> kTasks = {"describe", "cases", "timings", "devices"};

}  // namespace

Result<SourceSet> suite_sources(const SuiteOptions& options) {
  auto sources = library_sources(options.glsl);
  if (!sources || options.inject.empty()) return sources;
  if (const auto done = inject_into(*sources, options.inject); !done) return tl::unexpected(done.error());
  return sources;
}

std::string suite_digest(const SuiteOptions& options, const SourceSet& sources) {
  std::uint64_t digest = 0xCBF29CE484222325u;  // FNV-1a, 64 bit
  const auto add = [&](std::string_view text) {
    for (const char c : text) digest = (digest ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  };
  for (const EmbeddedFile& file : kEmbeddedFiles) add(sources.find(file.name)->text);
  std::set<std::filesystem::path> golden;
  std::error_code none;  // a folder that is missing is an error of each case
  for (const auto& entry : std::filesystem::directory_iterator(options.golden, none)) golden.insert(entry.path());
  for (const std::filesystem::path& path : golden) {
    std::ifstream in(path, std::ios::binary);
    add(path.filename().string());
    add(std::string(std::istreambuf_iterator<char>(in), {}));
  }
  return fmt::format("{:016x}", digest);
}

nlohmann::json to_json(const SuiteOptions& options) {
  return {{"glsl", options.glsl},
          {"golden", options.golden},
          {"inject", options.inject},
          {"seed", options.seed},
          {"points", options.points}};
}

nlohmann::json to_json(const Job& job) {
  return {{"task", kTasks[static_cast<std::size_t>(job.task)]},
          {"driver", job.driver},
          {"suite", to_json(job.suite)},
          {"ids", job.ids},
          {"examined", job.examined}};
}

Job job_from(const nlohmann::json& json) {
  const auto task = std::find(kTasks.begin(), kTasks.end(), json.at("task").get<std::string>());
  const auto& suite = json.at("suite");
  return {.task = static_cast<Task>(task - kTasks.begin()),
          .driver = json.at("driver").get<std::string>(),
          .suite = {.glsl = suite.at("glsl").get<std::string>(),
                    .golden = suite.at("golden").get<std::string>(),
                    .inject = suite.at("inject").get<std::string>(),
                    .seed = suite.at("seed").get<std::uint64_t>(),
                    .points = suite.at("points").get<std::uint64_t>()},
          .ids = json.at("ids").get<std::vector<std::string>>(),
          .examined = json.at("examined").get<std::vector<std::string>>()};
}

int child_command(const std::filesystem::path& path) {
  // What this process starts must not hold the pipe open when this process is gone.
  if (fcntl(kReportFd, F_SETFD, FD_CLOEXEC) != 0) return usage_error("child is called by hn-conform itself only");
  std::ifstream in(path);
  const Job job = job_from(nlohmann::json::parse(in));
  if (job.task == Task::devices) {
    report({{"devices", egl_device_count()}});
    return EXIT_SUCCESS;
  }
  const auto driver = find_driver(job.driver);
  if (!driver) return unknown_driver(job.driver);
  return run_on_driver(job, *driver);
}

}  // namespace hn
