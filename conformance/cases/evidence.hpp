// Makes evidence of a fault for developers: a shader that stands alone, and pictures.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cases/case.hpp"
#include "gpu/gpu.hpp"

namespace hn {

// Evidence for a case that failed, if it is about values: of a known bug a shader without pictures. Nothing where
// evidence is impossible, or where making it throws.
std::optional<Evidence> make_evidence(Session& session, const Case& test, const Outcome& outcome);

// The colour that a program gives the first pixel of a target of 8 bits per channel: red, green, blue, alpha.
Result<std::array<std::uint8_t, 4>> draw_pixel(const Context& context, const Program& program);

// Decides which of the failed cases get evidence. A wrong function fails in many cases that look alike, and
// results.json must stay small enough to send even if all cases fail.
class EvidenceBudget {
 public:
  // Whether this case gets evidence. If so, it is counted.
  bool take(const CaseName& name);

 private:
  std::map<std::string, std::set<std::string>, std::less<>> by_function_;  // the cases, whatever their version
  int all_ = 0;
};

}  // namespace hn
