// Writes what a run leaves behind: results.json, junit.xml, index.html, and what a person reads in a terminal.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/output_folder.hpp"
#include "report/junit.hpp"
#include "report/report_page.hpp"
#include "run/results.hpp"

namespace hn {

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
