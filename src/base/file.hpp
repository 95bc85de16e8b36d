// Reading and writing whole files.
#pragma once

#include <bit>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

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

}  // namespace hn
