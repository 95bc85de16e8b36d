// The journal of a run, as --resume reads it. The plan is the one that the journal itself names, if it does.
#include "run/journal.hpp"

#include "base/json.hpp"
#include "fuzz.hpp"

namespace hn::fuzz {
namespace {

nlohmann::json plan_in(std::string_view text) {
  try {
    return parse_json(text.substr(0, text.find('\n'))).at("plan");
  } catch (const std::exception&) {
    return {{"version", "0"}, {"drivers", {"egl"}}};
  }
}

void check_error(const std::string& message) {
  const bool has_place = message.starts_with("its first line is not a plan") || message.starts_with("line ") ||
                         message.starts_with("it belongs to a run with other settings: \"");
  require(has_place && message.size() > 10, "an error names place and fault", message);
}

void check(const std::vector<Journal::Entry>& entries, const nlohmann::json& plan) {
  std::string text = nlohmann::json{{"plan", plan}}.dump() + "\n";
  for (const Journal::Entry& entry : entries) text += journal_line(entry.driver, entry.report) + "\n";
  const auto again = parse_journal(text, plan);
  require(again && again->size() == entries.size(), "what was read can be written and read again", text);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    require(again->at(i).driver == entries[i].driver && again->at(i).report == entries[i].report, "it is the same then",
            text);
    // The scheduler takes these without a check.
    const nlohmann::json& report = entries[i].report;
    if (report.contains("result")) case_result_from(report.at("result"));
    if (report.contains("ready")) context_info_from(report.at("ready"));
  }
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  const std::string_view text = fuzz::text_of(data, size);
  const nlohmann::json plan = fuzz::plan_in(text);
  const auto entries = parse_journal(text, plan);
  if (!entries) {
    fuzz::check_error(entries.error().message);
  } else if (plan.is_object()) {  // else its line is broken off, and no run would write it
    fuzz::check(*entries, plan);
  }
  // And as the journal of another run.
  if (const auto other = parse_journal(text, {{"version", "1"}}); !other) fuzz::check_error(other.error().message);
  return 0;
}
