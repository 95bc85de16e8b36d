// The files that the program comes with: the folders golden/ and expect/.
#pragma once

#include <filesystem>

namespace hn {

// The folder that holds them. It is found from the program's own path, so that both can be moved. It is the folder
// beside the program, as in a build; if that is missing, it is the folder of an installed program.
std::filesystem::path data_folder_of(const std::filesystem::path& program);

}  // namespace hn
