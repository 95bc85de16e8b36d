// The results for build servers: JUnit's XML.
#pragma once

#include <string>
#include <vector>

#include "run/results.hpp"

namespace hn {

constexpr std::string_view kJunitFile = "junit.xml";

// A suite per driver, a test per case. Failures are values that are wrong and excuses that are not needed; errors are
// crashes, timeouts and what the suite could not do. Unsupported and excused cases are skipped, with the reason. A
// driver that is not here is a suite with one skipped test.
std::string junit_text(const std::vector<Run>& runs, const std::vector<std::string>& problems = {});

}  // namespace hn
