// The tables of what is expected to fail.
#include <fmt/format.h>

#include "fuzz.hpp"
#include "run/expectation.hpp"

namespace hn::fuzz {
namespace {

const std::string kPath = "table.csv";

std::string quoted(const std::string& field) {
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string text_of(const std::vector<Expectation>& expectations) {
  std::string text = "driver,renderer,case,status,reason\n";
  for (const Expectation& e : expectations) {
    text += fmt::format("{},{},{},{},{}\n", quoted(e.driver), quoted(e.renderer), quoted(e.id), name_of(e.status),
                        quoted(e.reason));
  }
  return text;
}

void check(const std::vector<Expectation>& expectations) {
  for (const Expectation& e : expectations) {
    require(!e.driver.empty() && !e.renderer.empty() && !e.id.empty() && !e.reason.empty() && is_bad(e.status),
            "every field is there", e.place);
    require(e.place.starts_with(kPath + ":"), "an expectation has a place", e.place);
  }
  const std::string text = text_of(expectations);
  const auto again = parse_expectations(text, kPath);
  require(again.has_value(), "what was read can be written and read again", text);
  require(text_of(*again) == text, "it is the same then", text);
}

// The globs are what a user wrote, too. They must not take for ever.
void match(const std::vector<Expectation>& expectations) {
  Run run;
  run.driver = "egl-device:0-gles";
  run.info.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  for (const Status status : kStatuses) {
    CaseResult result;
    result.id = "noise2d.perlin_cell.partial_jenkins+sine.fast.fragment.es300.golden";
    result.outcome.status = status;
    run.cases.push_back(std::move(result));
  }
  apply_expectations(expectations, run);
  require(run.cases.size() == kStatuses.size(), "expectations leave the cases as they are");
  for (const CaseResult& result : run.cases) {
    require(result.excuse.empty() || result.outcome.status != Status::unsupported, "what cannot run needs no excuse");
  }
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  const auto expectations = parse_expectations(fuzz::text_of(data, size), fuzz::kPath);
  if (expectations) {
    fuzz::check(*expectations);
    fuzz::match(*expectations);
  } else {
    const std::string& message = expectations.error().message;
    fuzz::require(message.find(fuzz::kPath) != std::string::npos, "an error names the file", message);
  }
  return 0;
}
