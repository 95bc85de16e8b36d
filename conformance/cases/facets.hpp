// Facets are the parts of a case's id, in words. Failed cases may have some in common.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace hn {

inline constexpr std::size_t kFacets = 11;

// One text for each way to look at a case, to stand behind "every failing case is": "of perlin noise", "in 2D", "with
// HN_HASH_PCG", "in the vertex stage". A text is empty where the id does not name it, or where it does not matter.
// General texts come before special ones.
using Facets = std::array<std::string, kFacets>;
Facets facets_of(std::string_view id);

// The rule of GLSL that a case with wrong values shows to be broken, and where it stands; nothing for other languages.
std::string rule_of(std::string_view id);

}  // namespace hn
