// Prints a program's output, and notices whether it arrived.
#pragma once

#include <string_view>

namespace hn {

// Writes to the standard error, with the program's name.
void complain(std::string_view program, std::string_view message);

// Printed text may not have arrived: on a full disk, for example. Then this complains, and a status of 0 becomes 1.
int status_once_printed(std::string_view program, int status);

}  // namespace hn
