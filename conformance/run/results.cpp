#include "run/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <hashnoise/hashnoise.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/json.hpp"
#include "library/source.hpp"

namespace hn {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 2;

Json examples_json(const std::vector<Mismatch>& examples) {
  Json list = Json::array();
  for (const Mismatch& mismatch : examples) {
    list.push_back({{"point", mismatch.point},
                    {"words", mismatch.words},
                    {"inputs", mismatch.inputs},
                    {"got", mismatch.got},
                    {"expected", mismatch.expected}});
  }
  return list;
}

Mismatch mismatch_from(const nlohmann::json& json) {
  return {whole_number_at(json, "point"), words_at(json, "words"), text_at(json, "inputs"), text_at(json, "got"),
          text_at(json, "expected")};
}

std::uint32_t checksum_from(std::string_view text) {
  std::uint32_t checksum = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), checksum, 16);
  if (error == std::errc() && stop == text.data() + text.size() && fmt::format("{:08x}", checksum) == text) {
    return checksum;
  }
  throw std::invalid_argument(fmt::format("\"{}\" is not a checksum of eight hexadecimal digits", text));
}

Step step_from(const nlohmann::json& json) {
  const auto form_at = [&](const char* member) {
    const auto name = text_at(json, member);
    const auto form = form_named(name);
    if (!form) throw std::invalid_argument(fmt::format("\"{}\" is not a form of shaders", name));
    return *form;
  };
  return {.name = text_at(json, "name"),
          .command = texts_at(json, "command"),
          .takes = form_at("takes"),
          .gives = form_at("gives"),
          .version = text_at(json, "version"),
          .spec = text_at(json, "through")};
}

Json to_json(const Run& run) {
  Json one = {{"driver", run.driver}};
  if (!run.absent.empty()) {
    one["absent"] = run.absent;
    return one;
  }
  one.update(to_json(run.info));
  if (!run.way.steps.empty()) one["way"] = hn::to_json(run.way);
  one["seed"] = run.seed;
  if (!run.content.empty()) one["content"] = run.content;
  if (run.library) one["library"] = hn::to_json(*run.library);
  if (!run.injected.empty()) one["injected"] = run.injected;
  if (!run.date.empty()) one["date"] = run.date;
  if (!run.commands.empty()) one["commands"] = run.commands;
  if (!run.golden.empty()) one["golden"] = run.golden;
  if (run.checked) {
    one["check"] = {{"function", run.checked->function},
                    {run.has_right_values() ? "right_values" : "other_driver", run.checked->expected}};
  }
  if (!run.shard.empty()) {
    one["shard"] = run.shard;
    one["whole"] = run.whole;
    if (run.missing != 0) one["missing"] = run.missing;
  }
  if (run.not_run != 0) one["not_run"] = run.not_run;
  Json& totals = one["totals"] = Json::object();
  for (const Status status : kStatuses) totals[std::string(name_of(status))] = run.count(status);
  one["as_expected"] = run.as_expected();
  Json& cases = one["cases"] = Json::array();
  for (const CaseResult& result : run.cases) cases.push_back(to_json(result));
  return one;
}

// Keeps in `where` the place that it reads, for messages.
Run run_from(const nlohmann::json& json, std::string& where) {
  const std::string here = where;
  Run run;
  run.driver = text_at(json, "driver");
  if (json.contains("absent")) {
    run.absent = text_at(json, "absent");
    if (run.absent.empty()) throw std::invalid_argument("\"absent\" gives no reason");
    return run;
  }
  run.info = context_info_from(json);
  if (json.contains("way")) {
    for (const nlohmann::json& step : list_at(json, "way")) run.way.steps.push_back(step_from(step));
  }
  run.seed = whole_number_at(json, "seed");
  if (json.contains("content")) run.content = text_at(json, "content");
  if (json.contains("library")) run.library = edited_library_from(json.at("library"));
  if (json.contains("injected")) run.injected = text_at(json, "injected");
  if (json.contains("date")) run.date = text_at(json, "date");
  if (json.contains("commands")) {
    const auto commands = texts_at(json, "commands");
    run.commands = {commands.begin(), commands.end()};
  }
  if (json.contains("golden")) run.golden = text_at(json, "golden");
  if (json.contains("check")) {
    const nlohmann::json& check = json.at("check");
    const bool right = check.is_object() && check.contains("right_values");
    run.checked = {text_at(check, "function"), text_at(check, right ? "right_values" : "other_driver"), right};
  }
  if (json.contains("shard")) {
    run.shard = text_at(json, "shard");
    run.whole = whole_number_at(json, "whole");
    if (json.contains("missing")) run.missing = whole_number_at(json, "missing");
  }
  if (json.contains("not_run")) run.not_run = whole_number_at(json, "not_run");
  for (const nlohmann::json& result : list_at(json, "cases")) {
    where = fmt::format("{}, case {}", here, run.cases.size() + 1);
    run.cases.push_back(case_result_from(result));
  }
  where = here;
  return run;
}

bool cases_are_right(const Run& run) {
  return std::all_of(run.cases.begin(), run.cases.end(),
                     [](const CaseResult& result) { return hn::as_expected(result); });
}

}  // namespace

std::string Run::name() const { return way.steps.empty() ? driver : fmt::format("{} through {}", driver, way.text()); }

std::string Run::measure(const Outcome& outcome) const {
  constexpr std::string_view kWrong = "are wrong";
  std::string text = measure_of(outcome);
  const auto at = text.find(kWrong);
  return at == text.npos ? text : text.replace(at, kWrong.size(), wrong());
}

std::size_t Run::count(Status status) const {
  return static_cast<std::size_t>(
      std::count_if(cases.begin(), cases.end(), [&](const CaseResult& c) { return c.outcome.status == status; }));
}

bool Run::as_expected() const {
  return is_complete() && count(Status::pass) + count(Status::warning) > 0 && cases_are_right(*this);
}

bool nothing_passed(const std::vector<Run>& runs) {
  return !all_as_expected(runs) && std::any_of(runs.begin(), runs.end(), [](const Run& run) {
    return run.absent.empty();
  }) && std::all_of(runs.begin(), runs.end(), [](const Run& run) { return run.is_complete() && cases_are_right(run); });
}

bool only_unfinished(const std::vector<Run>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.not_run != 0; }) &&
         std::all_of(runs.begin(), runs.end(), cases_are_right);
}

bool all_as_expected(const std::vector<Run>& runs) {
  // An error of glslang is not a verdict on a driver, unless only glslang ran.
  const bool only_reference = std::all_of(runs.begin(), runs.end(), [](const Run& run) { return run.is_reference(); });
  const auto decides = [&](const Run& run) { return run.as_expected() && (only_reference || !run.is_reference()); };
  return std::any_of(runs.begin(), runs.end(), decides) && std::all_of(runs.begin(), runs.end(), [&](const Run& run) {
           return run.is_complete() && cases_are_right(run);
         });
}

Json to_json(const Way& way) {
  Json steps = Json::array();
  for (const Step& step : way.steps) {
    steps.push_back({{"through", step.spec},
                     {"name", step.name},
                     {"version", step.version},
                     {"command", step.command},
                     {"takes", name_of(step.takes)},
                     {"gives", name_of(step.gives)}});
  }
  return steps;
}

Json to_json(const ContextInfo& info) {
  Json json = {{"vendor", info.vendor},
               {"renderer", info.renderer},
               {"gl_version", info.gl_version},
               {"glsl_version", info.glsl_version}};
  if (!info.system.empty()) json["system"] = info.system;
  if (!info.browser.empty()) json["browser"] = info.browser;
  return json;
}

ContextInfo context_info_from(const nlohmann::json& json) {
  ContextInfo info{text_at(json, "vendor"),
                   text_at(json, "renderer"),
                   text_at(json, "gl_version"),
                   text_at(json, "glsl_version"),
                   {}};
  if (json.contains("system")) info.system = text_at(json, "system");
  if (json.contains("browser")) info.browser = text_at(json, "browser");
  return info;
}

Json to_json(const Evidence& evidence) {
  return {{"shader", evidence.shader},         {"got", evidence.got},       {"reference", evidence.reference},
          {"difference", evidence.difference}, {"factor", evidence.factor}, {"note", evidence.note}};
}

Evidence evidence_from(const nlohmann::json& json) {
  return {.shader = text_at(json, "shader"),
          .got = text_at(json, "got"),
          .reference = text_at(json, "reference"),
          .difference = text_at(json, "difference"),
          .factor = number_at(json, "factor"),
          .note = text_at(json, "note")};
}

Json to_json(const CaseResult& result) {
  const Outcome& outcome = result.outcome;
  Json json = {{"id", result.id},
               {"status", name_of(outcome.status)},
               {"samples", outcome.samples},
               {"mismatches", outcome.mismatches},
               {"max_abs", outcome.max_abs},
               {"max_ulp", outcome.max_ulp},
               {"seconds", result.seconds},
               {"message", outcome.message}};
  if (result.processor_seconds > 0.0) json["processor_seconds"] = result.processor_seconds;
  if (outcome.allowed) json["allowed"] = *outcome.allowed;
  if (outcome.checksum) json["checksum"] = fmt::format("{:08x}", *outcome.checksum);
  if (outcome.step) {
    json["step"] = {{"number", outcome.step->number}, {"input", outcome.step->input}, {"text", outcome.step->text}};
  }
  if (!result.excuse.empty()) json["excuse"] = result.excuse;
  if (!outcome.examples.empty()) json["examples"] = examples_json(outcome.examples);
  if (result.evidence) json["evidence"] = to_json(*result.evidence);
  return json;
}

CaseResult case_result_from(const nlohmann::json& json) {
  CaseResult result;
  result.id = text_at(json, "id");
  const auto name = text_at(json, "status");
  const auto status = status_named(name);
  if (!status) throw std::invalid_argument(fmt::format("\"{}\" is not a status", name));
  result.outcome = {.status = *status,
                    .samples = whole_number_at(json, "samples"),
                    .mismatches = whole_number_at(json, "mismatches"),
                    .max_abs = number_at(json, "max_abs"),
                    .max_ulp = whole_number_at(json, "max_ulp"),
                    .message = text_at(json, "message"),
                    .examples = {}};
  result.seconds = number_at(json, "seconds");
  if (json.contains("processor_seconds")) result.processor_seconds = number_at(json, "processor_seconds");
  if (json.contains("allowed")) result.outcome.allowed = number_at(json, "allowed");
  if (json.contains("checksum")) result.outcome.checksum = checksum_from(text_at(json, "checksum"));
  if (json.contains("step")) {
    const nlohmann::json& step = json.at("step");
    result.outcome.step = {whole_number_at(step, "number"), text_at(step, "input"), text_at(step, "text")};
  }
  if (json.contains("excuse")) result.excuse = text_at(json, "excuse");
  if (json.contains("examples")) {
    for (const nlohmann::json& example : list_at(json, "examples"))
      result.outcome.examples.push_back(mismatch_from(example));
  }
  if (json.contains("evidence")) result.evidence = evidence_from(json.at("evidence"));
  return result;
}

std::string results_text(const std::vector<Run>& runs) {
  Json json = {{"schema", kSchema}, {"version", library_version()}, {"runs", Json::array()}};
  for (const Run& run : runs) json["runs"].push_back(to_json(run));
  return dump(json, 1) + "\n";
}

Result<std::vector<Run>> parse_results(std::string_view text) {
  std::string where = "the file";
  try {
    const auto json = parse_json(text);
    if (const auto schema = whole_number_at(json, "schema"); schema != kSchema) {
      return fail(fmt::format("its schema is {}, and this program knows schema {}", schema, kSchema));
    }
    if (const auto version = text_at(json, "version"); version != library_version()) {
      return fail(fmt::format("it was written by version {}, and this is version {}", version, library_version()));
    }
    std::vector<Run> runs;
    for (const nlohmann::json& run : list_at(json, "runs")) {
      where = fmt::format("run {}", runs.size() + 1);
      runs.push_back(run_from(run, where));
    }
    return runs;
  } catch (const std::invalid_argument& exception) {
    return fail(fmt::format("{} is not a results.json: {}", where, exception.what()));
  }
}

}  // namespace hn
