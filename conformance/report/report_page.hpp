// The report for people: one HTML page that needs nothing else.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "run/results.hpp"

namespace hn {

constexpr std::string_view kPageFile = "index.html";

// problems: the reasons besides its cases that the run is not as expected, a sentence each.
Result<std::string> report_page(const std::vector<Run>& runs, const std::vector<std::string>& problems = {});

// The parts of the page that show single cases (report_failures.cpp). However much is wrong, the page stays small
// enough to open and to send: each part is cut, and shows how much it leaves out.
nlohmann::json page_failures(const std::vector<Run>& runs);  // wrong values and refused shaders, by driver and function
nlohmann::json page_breakdowns(const std::vector<Run>& runs);  // crashes, timeouts, errors, by driver and message
nlohmann::json page_warnings(const std::vector<Run>& runs);
nlohmann::json page_unneeded(const std::vector<Run>& runs);     // excuses
nlohmann::json page_excused(const std::vector<Run>& runs);      // by reason
nlohmann::json page_unsupported(const std::vector<Run>& runs);  // by reason

}  // namespace hn
