// The process that runs the cases of one driver.
#pragma once

#include <filesystem>

namespace hn {

// Runs the hidden subcommand "child JOB" with the path of the job. Returns the exit status of the program.
int child_command(const std::filesystem::path& job);

}  // namespace hn
