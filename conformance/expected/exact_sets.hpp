// The sets of golden values in which every bit counts: each right implementation returns the same.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
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

// By the names of the functions, and then in the order of the settings of their files. The number of a set is its place
// here: digests of results name sets by it.
const std::vector<ExactSet>& exact_sets();

// The number of what a configuration has of a function; nothing if not every bit counts.
std::optional<std::size_t> exact_set(const Function& function, const Configuration& configuration);

// The number of the set that a case with these parts of its id is about. Nothing if there is none.
std::optional<std::size_t> exact_set(std::string_view function, std::string_view configuration,
                                     std::string_view arithmetic);

// CRC-32 of all golden files of a folder in the order of their names, as eight hexadecimal digits.
std::string golden_checksum(const std::filesystem::path& directory);

}  // namespace hn
