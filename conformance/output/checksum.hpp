// CRC-32, the checksum of gzip and PNG, which Python and a few lines of JavaScript have as well.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string_view>

namespace hn {

// Continues a checksum with these bytes.
inline std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      ::crc32(before, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

}  // namespace hn
