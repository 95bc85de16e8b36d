#include "output/embedded.hpp"

#include "base/entry_named.hpp"

namespace hn {

std::string_view text_of(std::span<const EmbeddedFile> files, std::string_view name) {
  return entry_named(files, &EmbeddedFile::name, name, "embedded file").text;
}

}  // namespace hn
