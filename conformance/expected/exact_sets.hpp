// The sets of golden values in which every bit counts: each right implementation returns the same.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "library/functions.hpp"

namespace hn {

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
