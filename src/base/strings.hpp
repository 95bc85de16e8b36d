// Strings taken apart and changed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hn {

// The parts between separators; a text without one is a single part.
std::vector<std::string_view> split(std::string_view text, char separator);

std::string in_upper_case(std::string_view text);  // of ASCII letters

}  // namespace hn
