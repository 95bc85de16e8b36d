// The folder of a command's results.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "base/file_descriptor.hpp"
#include "base/result.hpp"

namespace hn {

// A folder that is ours alone for as long as this object lives; the system gives it free when the process ends, however
// that comes.
class OutputFolder {
 public:
  // Makes the folder, removes earlier files of these names from it, and makes sure that new ones can be written: before
  // the work rather than after it. An error if another process has it, which is named.
  static Result<OutputFolder> prepare(const std::filesystem::path& directory,
                                      std::initializer_list<std::string_view> names);

 private:
  explicit OutputFolder(FileDescriptor lock) : lock_(std::move(lock)) {}

  FileDescriptor lock_;
};

}  // namespace hn
