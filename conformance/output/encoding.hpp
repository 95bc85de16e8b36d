// Bytes as text, made small, summed up, and as pictures.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace hn {

// As in RFC 4648, section 4, padding included.
std::string to_base64(std::string_view bytes);

// Makes equal bytes each time: no name and no date are in it. Throws std::bad_alloc.
std::string to_gzip(std::string_view data);

// Continues a checksum with these bytes.
inline std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      ::crc32(before, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

// Rows from top to bottom, a byte per pixel: 0 black, 255 white.
Result<std::string> grey_png(std::span<const std::uint8_t> pixels, int width, int height);

}  // namespace hn
