// The process that runs the cases of one driver.
#pragma once

#include <filesystem>

namespace hn {

// What the hidden subcommand "child JOB" does, with the path of the job: the exit status of the program.
int child_command(const std::filesystem::path& job);

}  // namespace hn
