// Other people's shaders, as bench --against and check name them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/workbench.hpp"
#include "gpu/reference_compiler.hpp"

namespace hn {

struct Foreign {
  std::string argument;                // as it was given, for messages
  std::string name;                    // of its subjects: NAME2 and NAME3
  std::string file;                    // as the sources know it
  std::string expression;              // what includes it, as the sources know it
  std::string_view profile = "gl330";  // its version of GLSL
};

// Reads [NAME[@VERSION]=]FILE:EXPRESSION; the name is else the first word of the expression. Adds the file and its
// includes to the sources: an include is a file beside the including one, or else a file of the library. The version is
// VERSION, or that of the file's #version line if it is later than GLSL 3.30. option: for messages, before the
// argument.
Result<Foreign> read_foreign(const std::string& argument, SourceSet& sources, std::string_view option = "--against");

// Its subjects: of a position in the plane, in space, or both, whichever compiles. An error if neither does.
Result<std::vector<Subject>> foreign_subjects(Workbench& workbench, const Foreign& foreign);
// The same without a context: by glslang, as shaders for Vulkan.
Result<std::vector<Subject>> foreign_subjects(const SourceSet& sources, const ReferenceCompiler& reference,
                                              const Foreign& foreign);

}  // namespace hn
