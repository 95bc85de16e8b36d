#include "output/png.hpp"

#include <fmt/format.h>
#include <png.h>

namespace hn {

Result<std::string> grey_png(std::span<const std::uint8_t> pixels, int width, int height) {
  if (width < 1 || height < 1 || pixels.size() / static_cast<std::size_t>(width) != static_cast<std::size_t>(height) ||
      pixels.size() % static_cast<std::size_t>(width) != 0) {
    return fail(fmt::format("{} pixels do not fill a picture of {} x {}", pixels.size(), width, height));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    return fail(image.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace hn
