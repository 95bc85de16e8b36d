#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text.hpp"
#include "output/files.hpp"
#include "output/page.hpp"
#include "report/files.hpp"
#include "report/report.hpp"

namespace hn {
namespace {

using Json = nlohmann::json;

std::vector<const Run*> runs_here(const std::vector<Run>& runs) {
  std::vector<const Run*> here;
  for (const Run& run : runs) {
    if (run.absent.empty()) here.push_back(&run);
  }
  return here;
}

std::size_t unexpected_in(const Run& run) {
  return static_cast<std::size_t>(
      std::count_if(run.cases.begin(), run.cases.end(), [](const CaseResult& result) { return !as_expected(result); }));
}

std::string plural(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// The libraries under test. Runs of several machines may be of several copies.
std::string libraries_of(const std::vector<const Run*>& here) {
  std::set<std::string> libraries;
  for (const Run* run : here) libraries.insert(library_text(run->library));
  if (libraries.empty()) libraries.insert(library_text({}));
  return fmt::format("{}", fmt::join(libraries, "; "));
}

std::string verdict_of(const std::vector<const Run*>& here, bool good) {
  std::size_t cases = 0;
  std::size_t unexpected = 0;
  std::size_t drivers = 0;
  std::size_t not_run = 0;
  for (const Run* run : here) {
    const std::size_t here_unexpected = unexpected_in(*run);
    cases += run->cases.size();
    not_run += run->not_run;
    unexpected += here_unexpected;
    drivers += here_unexpected != 0 ? 1 : 0;
  }
  const std::string all = fmt::format("{} on {}", plural(cases, "case"), plural(here.size(), "driver"));
  if (good) return fmt::format("All as expected: {}", all);
  if (unexpected == 0 && not_run != 0) {
    return fmt::format("Not the whole run: {} of {} on {}", cases, plural(cases + not_run, "case"),
                       plural(here.size(), "driver"));
  }
  if (unexpected == 0) return fmt::format("Not as expected, though no case is wrong: {}", all);
  return fmt::format("Not as expected: {} of {} on {} of {}", unexpected, plural(cases, "case"), drivers,
                     plural(here.size(), "driver"));
}

// --- Drivers ---------------------------------------------------------------------------------------------------------

// The columns of the table of drivers: of a check, those in which some driver has a number.
std::vector<Status> statuses_of(const std::vector<const Run*>& here, bool is_check) {
  std::vector<Status> statuses(kStatuses.begin(), kStatuses.end());
  std::erase_if(statuses, [&](Status status) {
    return is_check && std::ranges::all_of(here, [&](const Run* run) { return run->count(status) == 0; });
  });
  return statuses;
}

Json page_driver(const Run& run, const std::vector<Status>& statuses) {
  double seconds = 0.0;
  std::size_t excused = 0;
  for (const CaseResult& result : run.cases) {
    seconds += result.seconds;
    excused += is_bad(result.outcome.status) && !result.excuse.empty() ? 1 : 0;
  }
  Json counts = Json::array();
  for (const Status status : statuses) {
    const std::size_t count = run.count(status);
    counts.push_back({{"text", std::to_string(count)},
                      {"label", name_of(status)},
                      {"class", count == 0       ? "faint"
                                : is_bad(status) ? "bad"
                                                 : ""}});
  }
  if (!run.checked) {
    counts.push_back({{"text", std::to_string(excused)}, {"label", "excused"}, {"class", excused == 0 ? "faint" : ""}});
  }
  const std::size_t unexpected = unexpected_in(run);
  const bool nothing = unexpected == 0 && run.is_complete() && !run.as_expected();
  return {{"driver", run.driver},
          {"way", run.way.empty() ? Json(false) : Json({{"text", clean_text(run.way.text())}})},
          {"verdict", unexpected != 0    ? fmt::format("{} not as expected", unexpected)
                      : run.not_run != 0 ? fmt::format("{} not run", run.not_run)
                      : run.missing != 0 ? fmt::format("{} missing", run.missing)
                      : nothing          ? "nothing passed"
                                         : "as expected"},
          {"class", unexpected != 0 || !run.is_complete() ? "bad"
                    : nothing                             ? "faint"
                                                          : "good"},
          {"renderer", clean_text(run.injected.empty()
                                      ? run.info.renderer
                                      : fmt::format("{}, made to have the fault {}", run.info.renderer, run.injected))},
          {"version", clean_text(run.info.gl_version) +
                          (run.info.glsl_version.empty() ? "" : ", GLSL " + clean_text(run.info.glsl_version))},
          {"counts", std::move(counts)},
          {"seconds", fmt::format("{:.1f} s", seconds)}};
}

Json page_absent(const std::vector<Run>& runs) {
  Json list = Json::array();
  for (const Run& run : runs) {
    if (!run.absent.empty()) list.push_back({{"driver", run.driver}, {"reason", clean_text(run.absent)}});
  }
  return {{"any", !list.empty()}, {"list", list}};
}

Json names_of(const std::vector<const Run*>& runs) {
  Json names = Json::array();
  for (const Run* run : runs) names.push_back(clean_text(run->name()));
  return names;
}

// The largest differences from the golden values, of functions that are not exact ones.
Json page_errors(const std::vector<const Run*>& here) {
  std::vector<const Run*> measured;                         // runs that have any
  std::map<std::string_view, std::vector<double>> largest;  // by function: of each such run
  for (const Run* run : here) {
    for (const CaseResult& result : run->cases) {
      if (result.outcome.max_abs == 0.0 || !result.id.ends_with(".golden")) continue;
      if (measured.empty() || measured.back() != run) measured.push_back(run);
      auto& values = largest[function_of(result.id)];
      values.resize(measured.size(), 0.0);
      values.back() = std::max(values.back(), result.outcome.max_abs);
    }
  }
  Json rows = Json::array();
  for (auto& [function, values] : largest) {
    values.resize(measured.size(), 0.0);
    Json cells = Json::array();
    for (const double value : values) cells.push_back(value == 0.0 ? "" : fmt::format("{:.1e}", value));
    rows.push_back({{"function", function}, {"cells", std::move(cells)}});
  }
  return {{"any", !rows.empty()}, {"drivers", names_of(measured)}, {"rows", rows}};
}

Json page_check(const CheckedFunction& checked) {
  constexpr std::string_view kOther =
      "The values are compared with those of {}, which may be wrong itself. GLSL promises the bits of integers, and of "
      "few functions of floats; --expect compares with values that are right.";
  const std::string expected = clean_text(checked.expected);
  return {
      {"function", clean_text(checked.function)},
      {"compared", checked.expected_right ? fmt::format("The values are compared with the right ones in {}.", expected)
                                          : fmt::format(kOther, expected)}};
}

// --- Counts ----------------------------------------------------------------------------------------------------------

using Counts = std::map<Status, std::size_t>;

Json page_count(const Counts& counts) {
  std::string text;
  bool bad = false;
  for (const auto& [status, count] : counts) {
    if (!text.empty()) text += ", ";
    text += status == Status::pass ? std::to_string(count) : fmt::format("{} {}", count, name_of(status));
    bad = bad || is_bad(status);
  }
  const bool passed = counts.contains(Status::pass);
  return {{"text", text}, {"class", bad ? "bad" : passed ? "" : "faint"}};
}

// How many cases ended how, by function and check.
Json page_counts(const std::vector<const Run*>& here) {
  std::map<std::pair<std::string_view, std::string_view>, std::vector<Counts>> table;
  for (std::size_t i = 0; i < here.size(); ++i) {
    for (const CaseResult& result : here[i]->cases) {
      const std::string_view id = result.id;
      auto& cells = table[{function_of(id), id.substr(id.rfind('.') + 1)}];
      cells.resize(here.size());
      ++cells[i][result.outcome.status];
    }
  }
  Json rows = Json::array();
  for (const auto& [name, cells] : table) {
    Json row = Json::array();
    for (const Counts& counts : cells) row.push_back(page_count(counts));
    rows.push_back({{"function", name.first}, {"check", name.second}, {"cells", std::move(row)}});
  }
  return {{"drivers", names_of(here)}, {"rows", rows}};
}

// --- To see it again -------------------------------------------------------------------------------------------------

Json page_origin(const Run& run) {
  std::vector<std::string> commands;
  for (const std::string& command : run.commands) commands.push_back(clean_text(command));
  return {{"driver", clean_text(run.name())},
          {"date", run.date},
          {"seed", run.seed},
          {"shard",
           run.shard.empty() ? std::string("the whole") : fmt::format("{}; {} cases in all", run.shard, run.whole)},
          {"vendor", clean_text(run.info.vendor)},
          {"commands", std::move(commands)}};
}

}  // namespace

Result<std::string> report_page(const std::vector<Run>& runs, const std::vector<std::string>& problems) {
  const auto here = runs_here(runs);
  const bool good = problems.empty() && all_as_expected(runs);
  const auto* const checked = !here.empty() && here.front()->checked ? &*here.front()->checked : nullptr;
  const std::vector<Status> shown = statuses_of(here, checked != nullptr);
  Json drivers = Json::array();
  Json origins = Json::array();
  for (const Run* run : here) {
    drivers.push_back(page_driver(*run, shown));
    origins.push_back(page_origin(*run));
  }
  Json statuses = Json::array();
  for (const Status status : shown) statuses.push_back(name_of(status));
  if (!checked) statuses.push_back("excused");
  Json clean_problems = Json::array();
  for (const std::string& problem : problems) clean_problems.push_back(clean_text(problem));
  const Json data = {{"style", text_of(kOutputFiles, "style.mustache")},
                     {"library", clean_text(libraries_of(here))},
                     {"subject", checked ? clean_text(checked->function) : "hashnoise"},
                     {"check", checked ? page_check(*checked) : Json(false)},
                     {"class", good ? "good" : "bad"},
                     {"verdict", verdict_of(here, good)},
                     {"problems", clean_problems},
                     {"statuses", statuses},
                     {"any_driver", !here.empty()},
                     {"drivers", drivers},
                     {"absent", page_absent(runs)},
                     {"errors", page_errors(here)},
                     {"failures", page_failures(runs)},
                     {"breakdowns", page_groups(runs, Remarks::breakdowns)},
                     {"unneeded", page_groups(runs, Remarks::unneeded)},
                     {"warnings", page_warnings(runs)},
                     {"excused", page_groups(runs, Remarks::excused)},
                     {"unsupported", page_groups(runs, Remarks::unsupported)},
                     {"counts", page_counts(here)},
                     {"origins", origins}};
  return render_page(text_of(kReportFiles, "report.mustache"), data);
}

}  // namespace hn
