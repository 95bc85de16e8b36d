// Golden files: the values of the oracle. tools/make golden writes them; docs/reference/formats.md describes the
// format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
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

// The golden values of a function with a setting of the knobs.
struct Golden {
  std::string calls;  // the function of the library: "hn_perlin"
  std::vector<GoldenRow> rows;
  std::optional<GoldenDigest> digest;
};

// The bits of a result that a golden file gives a value for, where every bit counts.
std::uint32_t result_bits(const Column& column, std::uint64_t value);

// The name of a setting in a file: "lattice+fixed:fixed". Precise floats are as near to the exact values as fast ones,
// so they have the same values.
std::string golden_setting(const Function& function, const Configuration& configuration);
// The settings that have values of a function, in the order of their values, with one of the configurations of each.
struct GoldenSetting {
  std::string name;
  const Configuration* configuration;
};
std::vector<GoldenSetting> golden_settings(const Function& function);

// An error if there is no such folder, or no golden file in it.
Result<void> check_golden_folder(const std::filesystem::path& directory);

// The file's name in the folder of golden files. It has the values of all settings.
std::filesystem::path golden_path(const std::filesystem::path& directory, const Function& function);

// Reads a file, compares all of it with the function's table, and returns the values for a configuration that covers
// the function. Errors name the file, the line, the wrong text and the right one, and can be printed whatever the bytes
// are.
Result<Golden> read_golden(const std::filesystem::path& path, const Function& function,
                           const Configuration& configuration);
Result<Golden> parse_golden(std::string_view text, std::string_view path, const Function& function,
                            const Configuration& configuration);

// FNV-1a, 64 bit, of words as little-endian bytes.
std::uint64_t fnv1a64(const std::vector<std::uint32_t>& words);

// A setting in a golden file: exact in any arithmetic, or exact with HN_FIXED.
struct ExactSet {
  std::string_view function;
  std::string setting;  // "lattice+fixed:fixed"
};

// By the names of the functions, and then in the order of the settings of their files.
const std::vector<ExactSet>& exact_sets();

// CRC-32 of all golden files of a folder in the order of their names, as eight hexadecimal digits.
std::string golden_checksum(const std::filesystem::path& directory);

}  // namespace hn
