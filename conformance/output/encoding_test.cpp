#include "output/encoding.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <array>
#include <string>
#include <vector>

namespace hn {
namespace {

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheRfc) {
  EXPECT_EQ(to_base64(""), "");
  EXPECT_EQ(to_base64("f"), "Zg==");
  EXPECT_EQ(to_base64("fo"), "Zm8=");
  EXPECT_EQ(to_base64("foo"), "Zm9v");
  EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(to_base64(std::string_view("\0\xff\xfb", 3)), "AP/7");
}

std::string unpacked(const std::string& packed) {
  z_stream stream = {};
  inflateInit2(&stream, MAX_WBITS + 16);  // gzip only
  std::string data(1 << 20, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(data.data());
  stream.avail_out = static_cast<uInt>(data.size());
  const int status = inflate(&stream, Z_FINISH);
  data.resize(stream.total_out);
  inflateEnd(&stream);
  return status == Z_STREAM_END ? data : "not gzip";
}

TEST(Gzip, UnpacksToTheSame) {
  std::string data;
  for (unsigned i = 0; i < 100'000; ++i) data += static_cast<char>(i * i % 251);
  for (const std::string& text : {std::string(), std::string("a"), std::string(3, '\0'), data}) {
    EXPECT_EQ(unpacked(to_gzip(text)), text);
  }
}

TEST(Gzip, IsTheSameEachTime) { EXPECT_EQ(to_gzip("the same"), to_gzip("the same")); }

TEST(Png, ReadsBackAsWritten) {
  const std::vector<std::uint8_t> pixels = {0, 1, 127, 128, 254, 255};
  const auto written = grey_png(pixels, 3, 2);
  ASSERT_TRUE(written) << written.error().text();
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&image, written->data(), written->size()));
  EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_GRAY));
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.height, 2u);
  std::vector<std::uint8_t> read(6);
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
  EXPECT_EQ(read, pixels);
}

TEST(Png, PixelsThatDoNotFillThePictureAreAnError) {
  const std::array<std::uint8_t, 5> pixels = {};
  EXPECT_EQ(grey_png(pixels, 3, 2).error().message, "5 pixels do not fill a picture of 3 x 2");
  for (const auto& [width, height] : {std::pair{2, 2}, {0, 5}, {5, 0}, {-1, -5}, {2, 3}}) {
    EXPECT_FALSE(grey_png(pixels, width, height)) << width << " x " << height;
  }
}

}  // namespace
}  // namespace hn
