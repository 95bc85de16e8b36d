// Prints the bugs that run in WGSL, as JSON: what tools/lib/translate/wgsl/evaluation.py translates.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "cases/bugs/bugs.hpp"

int main() {
  nlohmann::json rows = nlohmann::json::array();
  for (const hn::Bug& bug : hn::all_bugs()) {
    const auto profiles = hn::split(bug.profiles, ' ');
    if (std::ranges::find(profiles, "wgsl") == profiles.end()) continue;
    rows.push_back({{"id", bug.function.id},
                    {"body", bug.function.body},
                    {"declarations", bug.declarations},
                    {"wgsl", bug.wgsl},
                    {"wgsl_declarations", bug.wgsl_declarations}});
  }
  std::puts(rows.dump().c_str());
}
