// Golden files: what the oracle says. tools/golden writes them; docs/formats.md describes the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "library/functions.hpp"

namespace hn {

struct GoldenRow {
  int line;                           // in the file
  std::vector<std::uint32_t> inputs;  // a bit pattern per input column
  std::vector<std::uint64_t> values;  // a bit pattern per output column
};

// A hash over a function's values on a box of whole numbers, the last axis fastest.
struct GoldenDigest {
  std::vector<std::uint32_t> origin;
  std::vector<std::uint32_t> size;
  std::uint32_t seed = 0;
  std::uint64_t fnv1a64 = 0;

  std::size_t points() const;
  // Inputs of all points, kInputWords each, with the seed behind the coordinates.
  std::vector<std::uint32_t> inputs() const;
};

struct Golden {
  std::vector<GoldenRow> rows;
  std::optional<GoldenDigest> digest;
};

// The bits of a result that a golden file gives a value for, where every bit counts.
std::uint32_t result_bits(const Column& column, std::uint64_t value);

// What a file's lines "arithmetic" and "hash" say. Precise floats are as near to the exact values as fast ones, so they
// have the same files.
std::string_view golden_arithmetic(const Function& function, const Configuration& configuration);
std::string_view golden_configuration(const Function& function, const Configuration& configuration);

// An error if there is no such folder, or no golden file in it.
Result<void> check_golden_folder(const std::filesystem::path& directory);

// The file's name in the folder of golden files.
std::filesystem::path golden_path(const std::filesystem::path& directory, const Function& function,
                                  const Configuration& configuration);

// Reads a file and holds it against what the function's table says. Errors name the file and the line, what is wrong
// and what would be right, and can be printed whatever the bytes are.
Result<Golden> read_golden(const std::filesystem::path& path, const Function& function,
                           const Configuration& configuration);
Result<Golden> parse_golden(std::string_view text, std::string_view path, const Function& function,
                            const Configuration& configuration);

// FNV-1a, 64 bit, of words as little-endian bytes.
std::uint64_t fnv1a64(const std::vector<std::uint32_t>& words);

}  // namespace hn
