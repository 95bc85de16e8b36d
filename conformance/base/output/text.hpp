// Text from elsewhere, made fit for files that are read by others.
#pragma once

#include <string>
#include <string_view>

namespace hn {

// UTF-8 without the characters that XML 1.0 forbids; in place of what is none, U+FFFD. A driver's log may hold any
// bytes.
std::string clean_text(std::string_view bytes);

// At most so many bytes, with a remark where more are left out.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace hn
