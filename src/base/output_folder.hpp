// The folder of a command's results.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "base/file_descriptor.hpp"
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

}  // namespace hn
