// The parts of the report that show single cases.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "cases/facets.hpp"
#include "library/shaders.hpp"
#include "report/report.hpp"
#include "run/failures.hpp"

namespace hn {
namespace {

using Json = nlohmann::json;

// So that the page keeps below 5 MB: cases take about 3 kB each, pictures and shaders have a budget of their own.
constexpr std::size_t kMostCasesPerFunction = 3;
constexpr std::size_t kMostCases = 400;
constexpr std::size_t kMostEvidenceBytes = 2'500'000;
constexpr std::size_t kMostExamples = 4;
constexpr std::size_t kMostOfMessage = 3000;
constexpr std::size_t kMostOfInput = 6000;  // of the shader that a step got
constexpr std::size_t kMostGroups = 100;
constexpr std::size_t kMostIds = 10;
constexpr std::size_t kMostOfTitle = 200;
constexpr std::size_t kMostWarnings = 300;
// A page with more than these open is hard to find one's way in.
constexpr std::size_t kMostOpen = 6;

// Text, and whether there is any, since Mustache cannot ask.
Json more(std::size_t count, std::string_view what) {
  return count == 0 ? Json(false) : Json({{"text", fmt::format("{} more {}", count, what)}});
}

std::string cleaned(std::string_view text, std::size_t most = kMostOfMessage) {
  return clean_text(shortened(text, most));
}

Json examples_of(const Run& run, const Outcome& outcome) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < std::min(outcome.examples.size(), kMostExamples); ++i) {
    const Mismatch& mismatch = outcome.examples[i];
    rows.push_back(
        {{"place", run.checked ? fmt::format("{}", mismatch.point + 1)
                               : fmt::format("{}, {}", mismatch.point % kGridSide, mismatch.point / kGridSide)},
         {"inputs", clean_text(mismatch.inputs)},
         {"got", clean_text(mismatch.got)},
         {"expected", clean_text(mismatch.expected)}});
  }
  return rows;
}

Json evidence_of(const Evidence& evidence) {
  Json pictures = false;
  if (!evidence.got.empty()) {
    pictures = {{"got", evidence.got},
                {"reference", evidence.reference},
                {"difference", evidence.difference},
                {"factor", fmt::format("{:.3g}", evidence.factor)}};
  }
  return {{"note", cleaned(evidence.note)}, {"pictures", std::move(pictures)}};
}

// The step of the run's way at which a case goes wrong. Null if there is none.
const Step* faulty_step(const Run& run, const CaseResult& result) {
  const std::size_t number = result.outcome.step ? result.outcome.step->number : 0;
  return number != 0 && number <= run.way.steps.size() ? &run.way.steps[number - 1] : nullptr;
}

std::string_view fault_of_step(const Run& run, const Outcome& outcome) {
  if (outcome.status == Status::crash) return "crashes";
  if (outcome.status == Status::timeout) return "does not end in time";
  if (outcome.mismatches == 0) return "refuses a valid shader, or writes an invalid one";
  return run.has_right_values() ? "makes a right shader wrong" : "changes values";
}

// The rule that a case breaks, the place and the values.
std::string findings_of(const Run& run, const CaseResult& result) {
  const Outcome& outcome = result.outcome;
  const std::string rule = outcome.mismatches == 0 ? "" : rule_of(result.id);
  std::string text = rule.empty() ? "" : fmt::format("rule      {}\n", rule);
  for (const Mismatch& wrong : outcome.examples) {
    text += fmt::format("at        {}\ngot       {}\nexpected  {}\n", wrong.inputs, wrong.got, wrong.expected);
    if (&wrong - outcome.examples.data() + 1 == kMostExamples) break;
  }
  if (outcome.samples != 0) text += fmt::format("\n{}.\n", run.measure(outcome));
  if (outcome.examples.empty()) text += fmt::format("{}\n", shortened(outcome.message, kMostOfMessage));
  return text;
}

// The command of a step, as one who has its kept input can call it.
std::string command_of(const Step& step, const FaultyStep& fault) {
  const auto words = step.command_for(std::filesystem::path(fault.input.empty() ? "in" : fault.input).filename(),
                                      fmt::format("out{}", ending_of(step.gives)));
  return step.spec.find("{in}") == std::string::npos ? command_line(words) : words.back();
}

// The command that runs a case again: steps as a run takes them, with the program that it found.
std::string rerun_of(const Run& run, const CaseResult& result) {
  const bool is_given = result.id.starts_with("check.") && !run.commands.empty();
  if (is_given) return *run.commands.begin();
  std::vector<std::string> words = {"hn-conform", "run", "--driver", run.driver};
  for (const Step& step : run.way.steps) {
    words.insert(words.end(), {"--through", step.spec});
    if (step.spec.find("{in}") == std::string::npos) continue;
    words.insert(words.end(),
                 {"--takes", std::string(name_of(step.takes)), "--gives", std::string(name_of(step.gives))});
  }
  words.insert(words.end(), {"--filter", result.id});
  return command_line(words);
}

std::string renderer_of(const ContextInfo& info) {
  return fmt::format("{}, {}{} ({})", info.renderer, info.gl_version,
                     info.glsl_version.empty() ? "" : ", GLSL " + info.glsl_version, info.vendor);
}

// One text for those who make the translator.
std::string report_of_step(const Run& run, const CaseResult& result, const Step& step) {
  const FaultyStep& fault = *result.outcome.step;
  std::string text = fmt::format("{} {}.\n\ncommand   {}\nrun on    {}\n{}\nTo see it: {}, of {}.\n", step.text(),
                                 fault_of_step(run, result.outcome), command_of(step, fault), renderer_of(run.info),
                                 findings_of(run, result), rerun_of(run, result), library_text(run.library));
  const std::string& message = result.outcome.message;
  const auto lines = message.find('\n');  // of a known bug the message has its few lines
  if (result.id.starts_with("bugs.") && lines != message.npos) {
    text += fmt::format("\nThe lines that go wrong, as the suite has them:\n{}\n", message.substr(lines + 1));
  }
  if (fault.input.empty()) return text;
  text += fmt::format("\nThe shader that it got is {}.", fault.input);
  if (!result.outcome.examples.empty()) {
    text += fmt::format(
        " It writes {} words for each point to the buffer at binding 0, of {} words of the one at binding 1; the first "
        "here:\n{:08x}",
        kOutputWords, kInputWords, fmt::join(result.outcome.examples.front().words, " "));
  }
  return text + fmt::format("\n\n{}\n", shortened(fault.text, kMostOfInput));
}

// One text for those who write the driver: a shader that stands alone begins with all of it.
std::string report_of(const Run& run, const CaseResult& result, bool with_shader) {
  if (with_shader && !result.evidence->shader.empty()) return result.evidence->shader;
  return fmt::format("{}\n{} on {}.\n\n{}\nTo see it: {}, of {}.\n", result.id,
                     run.has_right_values() ? "fails" : "differs", renderer_of(run.info), findings_of(run, result),
                     rerun_of(run, result), library_text(run.library));
}

std::size_t bytes_of(const Evidence& evidence) {
  return evidence.shader.size() + evidence.got.size() + evidence.reference.size() + evidence.difference.size();
}

// How much of it all is shown so far.
struct PageBudget {
  std::size_t cases = 0;
  std::size_t evidence_bytes = 0;
  std::size_t open = 0;
};

Json page_case(const Run& run, const CaseResult& result, PageBudget& shown) {
  const Outcome& outcome = result.outcome;
  const Step* const faulty = faulty_step(run, result);
  Json step = false;
  if (faulty) {
    step = {{"text", clean_text(fmt::format("Step {} of the chain, {},", outcome.step->number, faulty->text()))},
            {"fault", fault_of_step(run, outcome)},
            {"command", clean_text(command_of(*faulty, *outcome.step))},
            {"input", outcome.step->input.empty() ? Json(false) : Json({{"file", clean_text(outcome.step->input)}})}};
  }
  Json evidence = false;
  std::string left_out;
  if (result.evidence) {
    const std::size_t bytes = bytes_of(*result.evidence);
    if (shown.evidence_bytes + bytes <= kMostEvidenceBytes) {
      shown.evidence_bytes += bytes;
      evidence = evidence_of(*result.evidence);
    } else {
      left_out = "Its pictures and its shader are in results.json only, since this page shows only a limited number.";
    }
  }
  const Json examples = examples_of(run, outcome);
  // With examples the message only repeats the first of them, or also states that the driver is wrong without a way.
  const bool without_way = !run.way.empty() && !faulty;
  // No specification states what a driver should return that differs from another one.
  const bool for_readers = run.has_right_values() || outcome.mismatches == 0;
  const bool has_shader = !faulty && evidence.is_object() && !result.evidence->shader.empty();
  const std::string readers = faulty ? "the makers of " + clean_text(faulty->name) : "the vendor";
  return {{"id", result.id},
          {"measure", outcome.samples == 0 ? "" : run.measure(outcome) + "."},
          {"message", examples.empty() || without_way ? Json({{"text", cleaned(outcome.message)}}) : Json(false)},
          {"has_examples", !examples.empty()},
          {"examples", examples},
          {"step", std::move(step)},
          {"place_name", run.checked ? "point" : "pixel"},
          {"readers", for_readers ? Json({{"text", readers}}) : Json(false)},
          {"details", fmt::format("{}{}", for_readers ? "The report" : "The values",
                                  has_shader ? ": a shader that shows it alone" : "")},
          {"report",
           clean_text(faulty ? report_of_step(run, result, *faulty) : report_of(run, result, evidence.is_object()))},
          {"evidence", std::move(evidence)},
          {"left_out", left_out}};
}

Json page_group(const Run& run, const FailureGroup& group, PageBudget& shown) {
  std::vector<const CaseResult*> failed = group.cases;
  std::stable_sort(failed.begin(), failed.end(), [](const CaseResult* a, const CaseResult* b) {
    return a->evidence.has_value() > b->evidence.has_value();
  });
  Json cases = Json::array();
  // Equal texts are shown once.
  const std::size_t most = group.of_function() ? kMostCasesPerFunction : 1;
  for (const CaseResult* result : failed) {
    if (cases.size() >= most || shown.cases >= kMostCases) break;
    ++shown.cases;
    cases.push_back(page_case(run, *result, shown));
  }
  const std::size_t left = failed.size() - cases.size();
  const std::string count = group.of_function()
                                ? fmt::format("{} of {} cases fail", failed.size(), group.ran)
                                : fmt::format("{} {}", failed.size(), failed.size() == 1 ? "case" : "cases");
  return {
      {"title", cleaned(group.title, kMostOfTitle)},
      {"count", group.only.empty() ? count : fmt::format("{}, {}", count, group.only)},
      {"open", !cases.empty() && shown.open++ < kMostOpen},
      {"cases", std::move(cases)},
      {"more", more(left, group.of_function() ? "of this function, in results.json" : "of the kind, in results.json")}};
}

Json page_run(const Run& run, const Failures& failures, PageBudget& shown) {
  Json groups = Json::array();
  std::size_t left = 0;
  for (const FailureGroup& group : failures.groups) {
    const bool of_step = faulty_step(run, *group.cases.front()) != nullptr;
    if (group.status != Status::fail && !of_step) continue;  // page_breakdowns has it
    if (groups.size() < kMostGroups) {
      groups.push_back(page_group(run, group, shown));
    } else {
      ++left;
    }
  }
  std::vector<std::string> common = failures.common;
  if (run.library)
    common.insert(common.begin(), "The library is edited: its text may be at fault, and not the driver.");
  return {{"driver", clean_text(run.name())},
          {"renderer", clean_text(run.info.renderer)},
          {"gl_version", clean_text(run.info.gl_version)},
          {"here", run.library       ? "the edited library"
                   : run.way.empty() ? "this driver"
                                     : "this chain"},
          {"common", std::move(common)},
          {"functions", std::move(groups)},
          {"left_out", more(left, "such groups, in results.json")}};
}

// Cases of a driver that belong together, with how many there are and the first of them.
struct Group {
  std::string driver;
  std::string heading;
  std::string text;
  std::vector<std::string> ids;
};

// The group of a case that is no failure. A group of excused cases has the excuse as its text.
std::optional<Remarks> remarks_with(const CaseResult& result) {
  const Status status = result.outcome.status;
  if (status == Status::unsupported) return Remarks::unsupported;
  if (!is_bad(status)) return as_expected(result) ? std::nullopt : std::optional(Remarks::unneeded);
  if (!result.excuse.empty()) return Remarks::excused;
  return status == Status::fail || result.outcome.step ? std::nullopt : std::optional(Remarks::breakdowns);
}

}  // namespace

Json page_groups(const std::vector<Run>& runs, Remarks remarks) {
  const bool of_excuse = remarks == Remarks::unneeded || remarks == Remarks::excused;
  std::vector<Group> groups;  // in the order of their first case
  std::map<std::string, std::size_t> places;
  for (const Run& run : runs) {
    for (const CaseResult& result : run.cases) {
      if (remarks_with(result) != remarks) continue;
      const std::string heading(name_of(result.outcome.status));
      const std::string& text = of_excuse ? result.excuse : result.outcome.message;
      const std::string key = fmt::format("{}\n{}\n{}", run.name(), heading, text);
      const auto [place, is_new] = places.try_emplace(key, groups.size());
      if (is_new) groups.push_back({clean_text(run.name()), heading, text, {}});
      groups[place->second].ids.push_back(result.id);
    }
  }
  Json list = Json::array();
  for (const Group& group : groups) {
    if (list.size() == kMostGroups) break;
    const std::size_t shown = std::min(group.ids.size(), kMostIds);
    list.push_back(
        {{"driver", group.driver},
         {"heading", group.heading},
         {"count", fmt::format("{} {}", group.ids.size(), group.ids.size() == 1 ? "case" : "cases")},
         {"text", cleaned(group.text)},
         {"ids", std::vector<std::string>(group.ids.begin(), group.ids.begin() + static_cast<std::ptrdiff_t>(shown))},
         {"more", more(group.ids.size() - shown, "in results.json")}});
  }
  const std::size_t left = groups.size() - list.size();
  return {{"any", !groups.empty()}, {"groups", std::move(list)}, {"more", more(left, "such groups, in results.json")}};
}

Json page_failures(const std::vector<Run>& runs) {
  Json drivers = Json::array();
  PageBudget shown;
  for (const Run& run : runs) {
    const Failures failures = failures_of(run);
    if (failures.failed != 0) drivers.push_back(page_run(run, failures, shown));
  }
  return {{"any", !drivers.empty()}, {"drivers", std::move(drivers)}};
}

Json page_warnings(const std::vector<Run>& runs) {
  Json list = Json::array();
  std::size_t all = 0;
  for (const Run& run : runs) {
    for (const CaseResult& result : run.cases) {
      if (result.outcome.status != Status::warning || all++ >= kMostWarnings) continue;
      list.push_back(
          {{"driver", clean_text(run.name())}, {"id", result.id}, {"text", cleaned(result.outcome.message)}});
    }
  }
  const std::size_t left = all - list.size();
  return {{"any", all != 0}, {"list", std::move(list)}, {"more", more(left, "warnings, in results.json")}};
}

}  // namespace hn
