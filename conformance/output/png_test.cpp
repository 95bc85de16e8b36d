#include "output/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <vector>

namespace hn {
namespace {

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
