#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "base/text.hpp"
#include "library/source.hpp"
#include "report/report.hpp"

namespace hn {
namespace {

enum class Verdict { good, skipped, failure, error };

Verdict verdict_of(const CaseResult& result) {
  const Status status = result.outcome.status;
  if (!as_expected(result)) return status == Status::fail || !is_bad(status) ? Verdict::failure : Verdict::error;
  return status == Status::unsupported || is_bad(status) ? Verdict::skipped : Verdict::good;
}

struct Totals {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;
  double seconds = 0.0;

  Totals& operator+=(const Totals& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    skipped += other.skipped;
    seconds += other.seconds;
    return *this;
  }
};

Totals totals_of(const Run& run) {
  if (!run.absent.empty()) return {.tests = 1, .skipped = 1};
  Totals totals;
  for (const CaseResult& result : run.cases) {
    const Verdict verdict = verdict_of(result);
    totals += {.tests = 1,
               .failures = verdict == Verdict::failure ? 1u : 0u,
               .errors = verdict == Verdict::error ? 1u : 0u,
               .skipped = verdict == Verdict::skipped ? 1u : 0u,
               .seconds = result.seconds};
  }
  return totals;
}

void set(pugi::xml_node node, const char* name, std::string_view value) {
  node.append_attribute(name).set_value(clean_text(value).c_str());
}

void set_totals(pugi::xml_node node, const Totals& totals) {
  set(node, "tests", std::to_string(totals.tests));
  set(node, "failures", std::to_string(totals.failures));
  set(node, "errors", std::to_string(totals.errors));
  set(node, "skipped", std::to_string(totals.skipped));
  set(node, "time", fmt::format("{:.3f}", totals.seconds));
}

void add_properties(pugi::xml_node suite, const Run& run) {
  pugi::xml_node properties = suite.append_child("properties");
  const auto add = [&](const char* name, std::string_view value) {
    pugi::xml_node property = properties.append_child("property");
    set(property, "name", name);
    set(property, "value", value);
  };
  add("vendor", run.info.vendor);
  add("renderer", run.info.renderer);
  add("gl_version", run.info.gl_version);
  add("glsl_version", run.info.glsl_version);
  add("hashnoise", run.library ? library_text(run.library) : library_version());
  add("seed", std::to_string(run.seed));
  if (!run.injected.empty()) add("injected fault", run.injected);
}

// The first line is the headline, all of it the text.
void add_remark(pugi::xml_node test, const char* element, std::string_view type, const std::string& text) {
  pugi::xml_node remark = test.append_child(element);
  if (!type.empty()) set(remark, "type", type);
  set(remark, "message", text.substr(0, text.find('\n')));
  remark.text().set(clean_text(text).c_str());
}

std::string failure_text(const CaseResult& result) {
  const Outcome& outcome = result.outcome;
  if (!is_bad(outcome.status)) {
    return fmt::format("it is excused ({}) and needs no excuse: remove it from the expected failures", result.excuse);
  }
  std::string text = outcome.message;
  for (const Mismatch& mismatch : outcome.examples) {
    text += fmt::format("\npoint {}: {}: got {}, expected {}", mismatch.point, mismatch.inputs, mismatch.got,
                        mismatch.expected);
  }
  return text;
}

void add_case(pugi::xml_node suite, const CaseResult& result) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", function_of(result.id));
  set(test, "name", result.id);
  set(test, "time", fmt::format("{:.3f}", result.seconds));
  const Status status = result.outcome.status;
  switch (verdict_of(result)) {
    case Verdict::failure:
      add_remark(test, "failure", is_bad(status) ? name_of(status) : "unneeded excuse", failure_text(result));
      break;
    case Verdict::error:
      add_remark(test, "error", name_of(status), failure_text(result));
      break;
    case Verdict::skipped:
      add_remark(
          test, "skipped", "",
          is_bad(status) ? fmt::format("{}, excused: {}", name_of(status), result.excuse) : result.outcome.message);
      break;
    case Verdict::good:
      if (status == Status::warning) {
        test.append_child("system-out").text().set(clean_text("warning: " + result.outcome.message).c_str());
      }
      break;
  }
}

void add_suite(pugi::xml_node suites, const Run& run) {
  pugi::xml_node suite = suites.append_child("testsuite");
  set(suite, "name", run.name());
  set_totals(suite, totals_of(run));
  if (!run.absent.empty()) {
    pugi::xml_node test = suite.append_child("testcase");
    set(test, "classname", run.driver);
    set(test, "name", "absent");
    set(test, "time", "0.000");
    add_remark(test, "skipped", "", run.absent);
    return;
  }
  if (!run.date.empty()) set(suite, "timestamp", run.date);
  add_properties(suite, run);
  for (const CaseResult& result : run.cases) add_case(suite, result);
}

// Problems beside the cases, as a suite of its own.
Totals add_problems(pugi::xml_node suites, const std::vector<std::string>& problems) {
  Totals totals;
  if (problems.empty()) return totals;
  totals.tests = totals.errors = problems.size();
  pugi::xml_node suite = suites.append_child("testsuite");
  set(suite, "name", "hn-conform");
  set_totals(suite, totals);
  for (const std::string& problem : problems) {
    pugi::xml_node test = suite.append_child("testcase");
    set(test, "classname", "hn-conform");
    set(test, "name", "problem");
    set(test, "time", "0.000");
    add_remark(test, "error", "problem", problem);
  }
  return totals;
}

}  // namespace

std::string junit_text(const std::vector<Run>& runs, const std::vector<std::string>& problems) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  set(suites, "name", "hashnoise");
  Totals totals;
  for (const Run& run : runs) totals += totals_of(run);
  totals += add_problems(suites, problems);
  set_totals(suites, totals);
  for (const Run& run : runs) add_suite(suites, run);
  std::ostringstream out;
  document.save(out, " ");
  return out.str();
}

}  // namespace hn
