// Pictures of 16 bits as PNG files, and of floats as EXR files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace hn {

// A channel: rows from top to bottom.
template <typename T>
struct Channel {
  std::string name;  // in EXR files
  std::vector<T> values;
};

// Texts that stand in a file, by their names.
using Texts = std::vector<std::pair<std::string, std::string>>;

// One channel is grey, two are red and green (blue is 0), three and four are RGB and RGBA. The error is libpng's.
Result<std::string> png_16(std::span<const Channel<std::uint16_t>> channels, int width, int height, const Texts& texts);

// With ZIP compression. The error is OpenEXR's.
Result<std::string> exr(std::span<const Channel<float>> channels, int width, int height, const Texts& texts);

}  // namespace hn
