// The folder of a command's results, and folders that nobody needs afterwards.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "base/file.hpp"
#include "base/result.hpp"

namespace hn {

// A folder that no other process may use while this object lives. The system releases it when the process ends, in
// whatever way.
class OutputFolder {
 public:
  // Makes the folder, removes earlier files of these names from it, and makes sure that new ones can be written: before
  // the work rather than after it. If another process uses the folder, the error names it.
  static Result<OutputFolder> prepare(const std::filesystem::path& directory,
                                      std::initializer_list<std::string_view> names);

 private:
  explicit OutputFolder(FileDescriptor lock) : lock_(std::move(lock)) {}

  FileDescriptor lock_;
};

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
