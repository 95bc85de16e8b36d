// FNV-1a with 64 bits.
#pragma once

#include <cstdint>
#include <string_view>

namespace hn {

inline constexpr std::uint64_t kEmptyDigest = 0xCBF29CE484222325u;

constexpr std::uint64_t fnv1a64(std::string_view bytes, std::uint64_t before = kEmptyDigest) {
  for (const char byte : bytes) before = (before ^ static_cast<unsigned char>(byte)) * 0x100000001B3u;
  return before;
}

}  // namespace hn
