// The results of runs: writes and reads results.json.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "expected/verdict.hpp"
#include "gpu/context_info.hpp"
#include "gpu/way/way.hpp"
#include "library/source.hpp"

namespace hn {

// This stands in place of an OpenGL driver for the cases that ask only glslang.
inline constexpr std::string_view kReferenceCompiler = "glslang";

// Somebody's own function, which hn-conform check ran in place of the suite.
struct CheckedFunction {
  std::string function;        // as the command named it: "noise.glsl:snoise(p)"
  std::string expected;        // the origin of its values: "values.csv", "osmesa in gl330"
  bool expected_right = true;  // they were given as the right ones; else another driver returned them

  bool operator==(const CheckedFunction&) const = default;
};

struct Run {
  std::string driver;
  std::string absent;  // why the driver cannot be used here; then it has no cases
  Way way = {};        // the translators before the driver; mostly no step
  ContextInfo info;
  std::uint64_t seed = 0;
  std::string content;                        // a digest of the library and the golden files
  std::optional<EditedLibrary> library = {};  // what is under test in place of the program's own
  std::string injected;                       // the fault that the driver was made to have, if there is one
  std::string shard;                          // "2/3", or empty for the whole
  std::size_t whole = 0;                      // how many cases all shards have
  std::size_t not_run = 0;                    // how many the run did not come to, since it was ended before
  std::size_t missing = 0;                    // how many are in shards that were not merged
  std::vector<CaseResult> cases;
  std::string date = {};                // when it ended: UTC, ISO 8601
  std::set<std::string> commands = {};  // that made it: several if it was merged
  // Only of a run of all cases that there are by default, without an option that changes what they do: the checksum of
  // the golden files.
  std::string golden = {};
  std::optional<CheckedFunction> checked = {};

  // Whether its values are held against right ones.
  bool has_right_values() const { return !checked || checked->expected_right; }
  std::string_view wrong() const { return has_right_values() ? "are wrong" : "differ"; }
  std::string measure(const Outcome& outcome) const;  // measure_of, in these words
  std::string name() const;                           // "vulkan:0 through spirv-opt 2023.1"
  bool is_reference() const { return driver == kReferenceCompiler; }
  std::size_t count(Status status) const;
  // No case was left out at the end of the run, or with a shard.
  bool is_complete() const { return not_run == 0 && missing == 0; }
  // Everything that could run ran, and was right or is excused; at least one case passed, with or without a
  // warning.
  bool as_expected() const;
};

// Whether every case was run, every case of every driver is as expected, and at least one driver is as expected. On the
// others a filter may leave only unsupported cases, and some drivers may be absent.
bool all_as_expected(const std::vector<Run>& runs);

// Whether every case was run, and is as expected, and none passed: all are excused or unsupported.
bool nothing_passed(const std::vector<Run>& runs);

// Whether some cases were not run, and those that were run are right: the run is incomplete, but shows no fault.
bool only_unfinished(const std::vector<Run>& runs);

constexpr std::string_view kResultsFile = "results.json";
constexpr std::string_view kWaysFolder = "ways";  // beside it: inputs of steps, of cases that they get wrong

// The text of results.json; docs/reference/formats.md describes it.
std::string results_text(const std::vector<Run>& runs);
// An error describes the fault, and its place in the file.
Result<std::vector<Run>> parse_results(std::string_view text);

nlohmann::ordered_json to_json(const CaseResult& result);
nlohmann::ordered_json to_json(const Way& way);
nlohmann::ordered_json to_json(const ContextInfo& info);
nlohmann::ordered_json to_json(const Evidence& evidence);
// These throw nlohmann::json::exception or std::invalid_argument for anything else.
CaseResult case_result_from(const nlohmann::json& json);
ContextInfo context_info_from(const nlohmann::json& json);
Evidence evidence_from(const nlohmann::json& json);

}  // namespace hn
