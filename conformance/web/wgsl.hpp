// The cases' shaders in WGSL: what tools/lib/translate/wgsl, which this program has inside, makes of the library's text.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cases/case.hpp"
#include "expected/verdict.hpp"
#include "library/source.hpp"

namespace hn {

class WgslShaders {
 public:
  WgslShaders() = default;
  // Makes those of the cases that are in WGSL. Python does it, once for all; where it is missing, all are unsupported.
  WgslShaders(const SourceSet& sources, std::span<const Case> cases);

  // The text of what evaluates a function, in pieces that shaders have in common; or why there is none, as a verdict.
  tl::expected<std::vector<std::string>, Outcome> find(const Evaluation& evaluation) const;

 private:
  Result<void> make(const SourceSet& sources, std::span<const Case> cases);

  std::optional<Error> missing_;  // why none could be made
  std::vector<std::string> texts_;
  std::map<std::string, std::vector<std::size_t>> shaders_;  // by configuration and function
  std::map<std::string, std::string> errors_;                // by configuration
};

}  // namespace hn
