// Measures what the functions of cases cost on a driver, for run --timings.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "gpu/driver/driver.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/source.hpp"

namespace hn {

// {"timings": {"clock", "rounds", "functions"}} with the ratio to Perlin/Float of each of the wanted
// subjects, or {"error": "why"}.
nlohmann::ordered_json timings_report(const Context& context, const SourceSet& sources,
                                      const ReferenceCompiler& reference, const std::set<std::string>& wanted);

}  // namespace hn
