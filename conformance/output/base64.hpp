// Bytes as text, to stand in JSON and in pages.
#pragma once

#include <string>
#include <string_view>

namespace hn {

// As in RFC 4648, section 4, padding included.
std::string to_base64(std::string_view bytes);

}  // namespace hn
