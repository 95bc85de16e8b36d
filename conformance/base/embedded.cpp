#include "base/embedded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace hn {

std::string_view text_of(std::span<const EmbeddedFile> files, std::string_view name) {
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& file) { return file.name == name; });
  if (found == files.end()) throw std::logic_error(fmt::format("there is no embedded file \"{}\"", name));
  return found->text;
}

}  // namespace hn
