#include "base/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace hn {

std::string command_line(std::string_view program, int argc, const char* const* argv) {
  std::string line(program);
  for (const std::string_view argument :
       std::span(argv, static_cast<std::size_t>(argc)).subspan(std::min(argc, 1) == 1)) {
    const bool plain =
        argument.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#~!") == std::string_view::npos && !argument.empty();
    if (plain) {
      line += fmt::format(" {}", argument);
      continue;
    }
    std::string quoted(argument);
    for (auto at = quoted.find('\''); at != std::string::npos; at = quoted.find('\'', at + 4)) {
      quoted.replace(at, 1, "'\\''");
    }
    line += fmt::format(" '{}'", quoted);
  }
  return line;
}

}  // namespace hn
