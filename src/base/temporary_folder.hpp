// A place for files that nobody needs afterwards.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace hn {

// A folder that is gone with this object. Throws std::system_error if none can be made.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }
  void write(std::string_view name, std::string_view text) const;

  // The prefix of a process's folders.
  static std::string prefix(pid_t owner);

 private:
  std::filesystem::path path_;  // empty once it is moved from
};

// Removes the folders of processes that were killed.
void remove_left_folders();
// Removes those of a process that ends without its destructors.
void remove_folders_of(pid_t owner);

}  // namespace hn
