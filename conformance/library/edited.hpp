// A copy of the library that is under test in place of the one that this program was built with: --glsl.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hn {

struct EditedLibrary {
  std::string folder;                // as it was named
  std::string digest;                // of the text of its files
  std::vector<std::string> changed;  // its files that this program has with another text

  bool operator==(const EditedLibrary&) const = default;
};

// The library under test, for people: "hashnoise 0.2.0", or "the library in copy (perlin2d.glsl differs from hashnoise
// 0.2.0; digest 0123456789abcdef)".
std::string library_text(const std::optional<EditedLibrary>& library);

nlohmann::ordered_json to_json(const EditedLibrary& library);
// Throws the exceptions of base/json.hpp for anything else.
EditedLibrary edited_library_from(const nlohmann::json& json);

}  // namespace hn
