#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/json.hpp"

namespace hn {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string in_upper_case(std::string_view text) {
  std::string upper(text);
  std::ranges::transform(upper, upper.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return upper;
}

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// The two characters of three bytes that are valid UTF-8 and no XML: U+FFFE and U+FFFF.
bool begins_with_non_character(std::string_view text) {
  return text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
}

// The library that writes JSON replaces bytes that are not UTF-8.
std::string valid_utf8(std::string_view bytes) {
  const std::string json = dump(nlohmann::json(bytes));
  return nlohmann::json::parse(json).get<std::string>();
}

}  // namespace

std::string clean_text(std::string_view bytes) {
  const std::string text = valid_utf8(bytes);
  std::string clean;
  clean.reserve(text.size());
  for (std::string_view rest = text; !rest.empty();) {
    const char c = rest.front();
    const bool forbidden = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
    if (forbidden || begins_with_non_character(rest)) {
      clean += kReplacement;
      rest.remove_prefix(forbidden ? 1 : 3);
    } else {
      clean += c;
      rest.remove_prefix(1);
    }
  }
  return clean;
}

std::string printable(std::string_view bytes) {
  std::string text;
  const std::string clean = clean_text(bytes);
  for (std::string_view rest = clean; !rest.empty();) {
    // U+0080 to U+009F are control characters of two bytes.
    const bool wide = rest.size() > 1 && rest[0] == '\xC2' && static_cast<unsigned char>(rest[1]) < 0xA0;
    if (wide || rest[0] == '\x7F') {
      text += kReplacement;
    } else if (rest[0] != '\r') {
      text += rest[0];
    }
    rest.remove_prefix(wide ? 2 : 1);
  }
  return text;
}

std::string in_quotes(std::string_view bytes, std::size_t most) {
  std::string text;
  while (!bytes.empty() && text.size() < most) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    if (byte == '\r') {
      text += "\\r";  // of a file that came from Windows
    } else {
      text += byte >= 0x20 && byte < 0x7F ? std::string(1, bytes.front()) : fmt::format("\\x{:02x}", byte);
    }
    bytes.remove_prefix(1);
  }
  return fmt::format("\"{}\"{}", text, bytes.empty() ? "" : fmt::format(" and {} bytes more", bytes.size()));
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  return fmt::format("{} ... ({} characters more)", text.substr(0, most), text.size() - most);
}

std::string command_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (word.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#~!") == std::string::npos && !word.empty()) {
      line += word;
      continue;
    }
    std::string quoted = word;
    for (auto at = quoted.find('\''); at != std::string::npos; at = quoted.find('\'', at + 4)) {
      quoted.replace(at, 1, "'\\''");
    }
    line += fmt::format("'{}'", quoted);
  }
  return line;
}

}  // namespace hn
