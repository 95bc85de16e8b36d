#include "library/edited.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "base/version.hpp"

namespace hn {
namespace {

constexpr std::size_t kMostFilesNamed = 3;

std::string differences(const std::vector<std::string>& changed) {
  const std::string original = fmt::format("hashnoise {}", library_version());
  if (changed.empty()) return fmt::format("the same text as {}", original);
  const std::size_t named = std::min(changed.size(), kMostFilesNamed);
  const std::string names =
      fmt::format("{}", fmt::join(changed.begin(), changed.begin() + static_cast<std::ptrdiff_t>(named), ", "));
  if (named < changed.size()) {
    return fmt::format("{} and {} more of its files differ from {}", names, changed.size() - named, original);
  }
  return fmt::format("{} {} from {}", names, named == 1 ? "differs" : "differ", original);
}

}  // namespace

std::string library_text(const std::optional<EditedLibrary>& library) {
  if (!library) return fmt::format("hashnoise {}", library_version());
  return fmt::format("the library in {} ({}; digest {})", library->folder, differences(library->changed),
                     library->digest);
}

nlohmann::ordered_json to_json(const EditedLibrary& library) {
  return {{"folder", library.folder}, {"digest", library.digest}, {"changed", library.changed}};
}

EditedLibrary edited_library_from(const nlohmann::json& json) {
  return {text_at(json, "folder"), text_at(json, "digest"), texts_at(json, "changed")};
}

}  // namespace hn
