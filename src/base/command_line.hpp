// How a program was called, for the record.
#pragma once

#include <string>
#include <string_view>

namespace hn {

// The arguments after the first, quoted for a shell, behind the program's name.
std::string command_line(std::string_view program, int argc, const char* const* argv);

}  // namespace hn
