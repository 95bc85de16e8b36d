// Reading and writing whole files; and descriptors of open ones.
#pragma once

#include <unistd.h>

#include <bit>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.hpp"

namespace hn {

// Writes a file, and makes its folder if it is missing. It writes beside the file and renames, so that nobody reads
// half a file. A link stays one, and a file that is there keeps its mode. An error has the reason, and leaves the old
// file as it was: what is no regular file is an error, too.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

// The bytes of a file. An error names it, and ends with the hint: what the file should be, or where it comes from.
Result<std::string> read_file(const std::filesystem::path& path, std::string_view hint = {});

// The last bytes of what was written to a log from a place on, with a limit. Empty if it cannot be read.
std::string end_of_log(const std::filesystem::path& path, std::size_t most, std::size_t from = 0);

// The bytes of numbers as they lie in memory: little-endian, as all of our formats require.
template <typename T>
std::string_view bytes_of(std::span<const T> numbers) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

// A file descriptor that is closed with its owner.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileDescriptor() {
    if (fd_ >= 0) close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_ = -1;
};

}  // namespace hn
