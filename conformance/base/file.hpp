// Writing whole files.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string_view>

#include "base/result.hpp"

namespace hn {

// Creates a folder for results, removes earlier files of these names from it, and makes sure that new ones can be
// written: before the work rather than after it.
Result<void> prepare_output(const std::filesystem::path& directory, std::initializer_list<std::string_view> names);

// Writes a file, in a folder that is made if it is not there; beside it first and renamed, so that nobody reads half a
// file.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

// A folder that is gone with this object. Throws std::system_error if none can be made.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// The bytes of numbers, as they lie in memory.
template <typename T>
std::string_view bytes_of(std::span<const T> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace hn
