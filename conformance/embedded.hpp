// The files of glsl/ as they were when the program was built, in the order of their dependence. embed.cmake generates
// the definition.
#pragma once

#include <span>
#include <string_view>

namespace hn {

struct EmbeddedFile {
  std::string_view name;
  std::string_view text;
};

extern const std::span<const EmbeddedFile> kEmbeddedFiles;

}  // namespace hn
