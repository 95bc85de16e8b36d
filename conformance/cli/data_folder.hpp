// The files that the program comes with: the folders golden/ and expect/.
#pragma once

#include <filesystem>

namespace hn {

// The folder that holds them, found from the program's own path, so that both can be moved: the one beside the program,
// where the build has them, or the one that an installed program has. The latter if there is none.
std::filesystem::path data_folder_of(const std::filesystem::path& program);

}  // namespace hn
