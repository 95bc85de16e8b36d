#include "cli/data_folder.hpp"

#include <system_error>

namespace hn {

std::filesystem::path data_folder_of(const std::filesystem::path& program) {
  std::error_code error;
  const auto folder = std::filesystem::canonical(program, error).parent_path();
  const auto built = folder / HN_BUILT_DATA;
  if (std::filesystem::is_directory(built, error)) return built;
  return (folder / HN_INSTALLED_DATA).lexically_normal();
}

}  // namespace hn
