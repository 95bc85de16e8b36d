// Writes what a run leaves behind: results.json, junit.xml, index.html, and what a person reads in a terminal.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/folder.hpp"
#include "run/results.hpp"

namespace hn {

constexpr std::string_view kJunitFile = "junit.xml";

// A suite per driver, a test per case. Failures are values that are wrong and excuses that are not needed; errors are
// crashes, timeouts and what the suite could not do. Unsupported and excused cases are skipped, with the reason. A
// driver that is not here is a suite with one skipped test.
std::string junit_text(const std::vector<Run>& runs, const std::vector<std::string>& problems = {});

constexpr std::string_view kPageFile = "index.html";

// problems: the reasons besides its cases that the run is not as expected, a sentence each.
Result<std::string> report_page(const std::vector<Run>& runs, const std::vector<std::string>& problems = {});

// The parts of the page that show single cases (report_failures.cpp). However much is wrong, the page stays small
// enough to open and to send: each part is cut, and shows how much it leaves out.
nlohmann::json page_failures(const std::vector<Run>& runs);  // wrong values and refused shaders, by driver and function
nlohmann::json page_warnings(const std::vector<Run>& runs);
// Crashes, timeouts and errors; excuses that are not needed, and those that are; what is unsupported. By driver and
// text.
enum class Remarks { breakdowns, unneeded, excused, unsupported };
nlohmann::json page_groups(const std::vector<Run>& runs, Remarks remarks);

// All three files. problems: as for report_page.
Result<void> write_results(const std::filesystem::path& directory, const std::vector<Run>& runs,
                           const std::vector<std::string>& problems = {});
// Makes sure that the files can be written, and removes what an earlier run left.
Result<OutputFolder> prepare_results(const std::filesystem::path& directory);

// A line for each copy of the library that was tested in place of the program's own; mostly nothing.
std::string edited_libraries(const std::vector<Run>& runs);
// A few lines: what failed, what that has in common and an example of each kind; what was unsupported and why; the
// largest errors by function, and totals.
std::string summary(const Run& run);

}  // namespace hn
