#include "output/encoding.hpp"

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <limits>
#include <new>
#include <stdexcept>

namespace hn {

std::string to_base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  // The iterators look at a byte too many where the number of bytes is not a multiple of 3.
  constexpr std::size_t kGroup = 3;
  const std::size_t padding = (kGroup - bytes.size() % kGroup) % kGroup;
  std::string whole(bytes);
  whole.append(padding, '\0');
  using Iterator = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Iterator(whole.cbegin()), Iterator(whole.cend()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

std::string to_gzip(std::string_view data) {
  if (data.size() > std::numeric_limits<uInt>::max()) throw std::length_error("to_gzip: more than 4 GiB");
  z_stream stream = {};
  constexpr int kGzip = 16;  // added to the bits of the window it selects gzip's header
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + kGzip, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::bad_alloc();
  }
  std::string packed(deflateBound(&stream, static_cast<uLong>(data.size())), '\0');
  // zlib reads through a pointer that is not const, and changes nothing there.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::logic_error("to_gzip: the bound of zlib did not suffice");
  return packed;
}

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
