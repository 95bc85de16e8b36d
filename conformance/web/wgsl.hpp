// The cases' shaders in WGSL, which tools/lib/translate/wgsl made of the library's text when this program was built.
#pragma once

#include <string>
#include <vector>

#include "cases/case.hpp"
#include "library/source.hpp"

namespace hn {

// The text of what evaluates a function, in pieces that shaders have in common. From another text than the embedded one
// there is none.
Result<std::vector<std::string>> wgsl_shader(const SourceSet& sources, const Evaluation& evaluation);
// As one text.
Result<std::string> wgsl_text(const SourceSet& sources, const Evaluation& evaluation);

}  // namespace hn
