// Files as they were when the program was built. embed.cmake generates their definitions, and the header files.hpp of
// each room that has some.
#pragma once

#include <span>
#include <string_view>

#include "base/entry_named.hpp"

namespace hn {

struct EmbeddedFile {
  std::string_view name;
  std::string_view text;
};

// The text of one of the files, which must be among them.
inline std::string_view text_of(std::span<const EmbeddedFile> files, std::string_view name) {
  return entry_named(files, &EmbeddedFile::name, name, "embedded file").text;
}

}  // namespace hn
