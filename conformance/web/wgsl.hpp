// The cases' shaders in WGSL, which tools/lib/translate/wgsl made of the library's text when this program was built.
#pragma once

#include <string>
#include <vector>

#include "cases/case.hpp"
#include "expected/verdict.hpp"
#include "library/source.hpp"

namespace hn {

// The text of what evaluates a function, in pieces that shaders have in common; or why there is none, as a verdict: of
// another text than the embedded one there is none.
tl::expected<std::vector<std::string>, Outcome> wgsl_shader(const SourceSet& sources, const Evaluation& evaluation);

}  // namespace hn
