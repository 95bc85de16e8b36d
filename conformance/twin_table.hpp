// How twin.cpp, compiled once per hash, hands its table to twin_table.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace hn {

struct TwinEntry {
  std::string_view id;
  void (*evaluate)(const std::uint32_t* inputs, std::uint32_t* outputs, std::size_t points);
};

// The table for a value of HN_HASH; twin.cpp defines one each time it is compiled.
template <int hash>
std::span<const TwinEntry> twin_entries();
template <>
std::span<const TwinEntry> twin_entries<1>();
template <>
std::span<const TwinEntry> twin_entries<2>();
template <>
std::span<const TwinEntry> twin_entries<3>();
template <>
std::span<const TwinEntry> twin_entries<4>();
template <>
std::span<const TwinEntry> twin_entries<5>();
template <>
std::span<const TwinEntry> twin_entries<6>();
template <>
std::span<const TwinEntry> twin_entries<7>();
template <>
std::span<const TwinEntry> twin_entries<8>();
template <>
std::span<const TwinEntry> twin_entries<9>();

}  // namespace hn
