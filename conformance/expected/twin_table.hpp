// How twin.cpp, compiled once per configuration, hands its table to twin_table.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace hn {

struct TwinEntry {
  std::string_view id;
  // Null if the function has no values with the configuration.
  void (*evaluate)(const std::uint32_t* inputs, std::uint32_t* outputs, std::size_t points);
};

// The table for a configuration, by its index; twin.cpp defines one each time it is compiled.
template <int index>
std::span<const TwinEntry> twin_entries();
#define TWIN(index) \
  template <>       \
  std::span<const TwinEntry> twin_entries<index>();
#include "expected/twins.inc"
#undef TWIN

}  // namespace hn
