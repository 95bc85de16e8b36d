// The version of the library that this program was built with.
#pragma once

#include <string>

namespace hn {

std::string library_version();  // "0.2.0"

}  // namespace hn
