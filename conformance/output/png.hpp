// Grey pictures as PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/result.hpp"

namespace hn {

// Rows from top to bottom, a byte per pixel: 0 black, 255 white.
Result<std::string> grey_png(std::span<const std::uint8_t> pixels, int width, int height);

}  // namespace hn
