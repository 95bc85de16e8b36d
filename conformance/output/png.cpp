#include "output/png.hpp"

#include <fmt/format.h>
#include <png.h>

namespace hn {
namespace {

Result<png_image> image_of(std::span<const std::uint8_t> pixels, int width, int height) {
  if (width < 1 || height < 1 || pixels.size() / static_cast<std::size_t>(width) != static_cast<std::size_t>(height) ||
      pixels.size() % static_cast<std::size_t>(width) != 0) {
    return fail(fmt::format("{} pixels do not fill a picture of {} x {}", pixels.size(), width, height));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_GRAY;
  return image;
}

}  // namespace

Result<std::string> grey_png(std::span<const std::uint8_t> pixels, int width, int height) {
  HN_TRY(auto image, image_of(pixels, width, height));
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    return fail(image.message);
  }
  bytes.resize(size);
  return bytes;
}

Result<void> write_grey_png(const std::filesystem::path& path, std::span<const std::uint8_t> pixels, int width,
                            int height) {
  auto image = image_of(pixels, width, height);
  if (!image) return fail(fmt::format("cannot write {}: {}", path.string(), image.error().message));
  if (png_image_write_to_file(&*image, path.c_str(), 0, pixels.data(), 0, nullptr) != 0) return {};
  return fail(fmt::format("cannot write {}: {}", path.string(), image->message));
}

}  // namespace hn
