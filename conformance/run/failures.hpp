// The wrong cases of a run in groups: what fails, and what the failures have in common.
#pragma once

#include <string>
#include <vector>

#include "run/results.hpp"

namespace hn {

// Cases that belong together: wrong values of a function, or cases with the same status and message.
struct FailureGroup {
  Status status;
  std::string title;    // the function; or the first line of their message
  std::size_t ran = 0;  // of a function: how many of its cases ran; else 0
  std::string only;  // "only with HN_FIXED, only in the vertex stage": what they have in common beyond all that fails
  std::vector<const CaseResult*> cases;  // in their order; at least one

  bool of_function() const { return ran != 0; }
  // "129 of 267 cases of noise2d.perlin", "3 cases: does not compile"; and what they have in common.
  std::string text() const;
};

// The bad cases without an excuse.
struct Failures {
  std::size_t failed = 0;
  std::size_t ran = 0;  // cases that are not unsupported
  // First where to begin, if the failures are in several layers: "Begin with hash.lattice2, the lowest layer that
  // fails: 43 of 43 other failures are of what is made of it." Then sentences that are true of all failed cases and not
  // of the others, the strongest first: "Every failing case is in 2D; all 1311 in 3D pass." The others are cases that
  // the fault would have made fail: those of golden values and of the twin, and of checks that fail elsewhere. A driver
  // that agrees with itself shows nothing. If there is no sentence, one states that. Empty if fewer than two cases
  // failed.
  std::vector<std::string> common;
  std::vector<FailureGroup> groups;  // the lowest layer first, then in the order of their first cases
};
Failures failures_of(const Run& run);

}  // namespace hn
