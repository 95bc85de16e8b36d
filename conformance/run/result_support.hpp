// Results for tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "run/results.hpp"

namespace hn {

inline CaseResult result(std::string id, Status status) {
  Outcome outcome;
  outcome.status = status;
  outcome.samples = 10;
  outcome.max_abs = 0.25;
  outcome.max_ulp = 3;
  outcome.message = "why";
  return {.id = std::move(id), .outcome = outcome, .seconds = 0.5};
}

// Through spirv-opt.
inline Way short_way(std::string version = "2023.1") {
  return {{{.name = "spirv-opt",
            .command = {"/usr/bin/spirv-opt", "-O", "{in}", "-o", "{out}"},
            .takes = Form::spirv,
            .gives = Form::spirv,
            .version = std::move(version),
            .spec = "spirv-opt"}}};
}

inline Run run_of(std::vector<CaseResult> cases) {
  Run run;
  run.driver = "osmesa";
  run.info = {"v", "r", "4.5", "4.50", {}};
  run.seed = 7;
  run.cases = std::move(cases);
  return run;
}

}  // namespace hn
