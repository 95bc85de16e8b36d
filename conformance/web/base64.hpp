// Bytes as text for a page: RFC 4648, section 4.
#pragma once

#include <string>
#include <string_view>

namespace hn {

std::string base64(std::string_view bytes);

}  // namespace hn
