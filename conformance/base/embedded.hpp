// Files as they were when the program was built. embed.cmake generates the definitions.
#pragma once

#include <span>
#include <string_view>

namespace hn {

struct EmbeddedFile {
  std::string_view name;
  std::string_view text;
};

// glsl/, in the order of their dependence.
extern const std::span<const EmbeddedFile> kEmbeddedFiles;
// What the report, bench and paper need: the shaders they compare with, the paper's table, the templates of their
// pages.
extern const std::span<const EmbeddedFile> kResources;

// The text of one of the resources, which must exist.
std::string_view resource(std::string_view name);

}  // namespace hn
