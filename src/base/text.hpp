// Text taken apart, quoted, and made fit for files and terminals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hn {

// The parts between separators; a text without one is a single part.
std::vector<std::string_view> split(std::string_view text, char separator);

std::string in_upper_case(std::string_view text);  // of ASCII letters

// UTF-8 without the characters that XML 1.0 forbids. Bytes that are not UTF-8 become U+FFFD: a driver's log may hold
// any bytes.
std::string clean_text(std::string_view bytes);

// For a terminal: without what moves its cursor or changes its colours, too.
std::string printable(std::string_view bytes);

// Bytes from elsewhere as a part of a message: in quotes, with \xNN for each that is not printable ASCII, cut after
// about so many characters.
std::string in_quotes(std::string_view bytes, std::size_t most = 60);

// The text with a limit of bytes, and with a remark if some are left out.
std::string shortened(std::string_view text, std::size_t most);

// The words of a command, quoted for a shell where they need it.
std::string command_line(const std::vector<std::string>& words);

}  // namespace hn
