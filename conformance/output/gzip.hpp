// Data made small, for what browsers and everybody else unpacks.
#pragma once

#include <string>
#include <string_view>

namespace hn {

// Makes equal bytes each time: no name and no date are in it. Throws std::bad_alloc.
std::string to_gzip(std::string_view data);

}  // namespace hn
