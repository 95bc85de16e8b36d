// Writing whole files.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "../result.hpp"

namespace hn {

// Writes a file, in a folder that is made if it is not there.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

// The bytes of numbers, as they lie in memory.
template <typename T>
std::string_view bytes_of(std::span<const T> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace hn
