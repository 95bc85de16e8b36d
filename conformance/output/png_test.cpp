#include "output/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <vector>

#include "base/file.hpp"
#include "base/temporary_folder.hpp"

namespace hn {
namespace {

TEST(Png, ReadsBackAsWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  const std::vector<std::uint8_t> pixels = {0, 1, 127, 128, 254, 255};
  const auto written = write_grey_png(path, pixels, 3, 2);
  ASSERT_TRUE(written) << written.error().text();
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&image, path.c_str()));
  EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_GRAY));
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.height, 2u);
  std::vector<std::uint8_t> read(6);
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
  EXPECT_EQ(read, pixels);
}

TEST(Png, InMemoryIsThatOfTheFile) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  const std::vector<std::uint8_t> pixels = {0, 1, 127, 128, 254, 255};
  ASSERT_TRUE(write_grey_png(path, pixels, 2, 3));
  EXPECT_EQ(*grey_png(pixels, 2, 3), read_file(path).value());
  EXPECT_FALSE(grey_png(pixels, 2, 2));
}

TEST(Png, AFolderThatIsAbsentIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "absent" / "a.png";
  const auto written = write_grey_png(path, std::array<std::uint8_t, 1>{7}, 1, 1);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "cannot write " + path.string() + ": No such file or directory");
}

TEST(Png, PixelsThatDoNotFillThePictureAreAnError) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  const std::array<std::uint8_t, 5> pixels = {};
  EXPECT_EQ(write_grey_png(path, pixels, 3, 2).error().message,
            "cannot write " + path.string() + ": 5 pixels do not fill a picture of 3 x 2");
  for (const auto& [width, height] : {std::pair{2, 2}, {0, 5}, {5, 0}, {-1, -5}, {2, 3}}) {
    EXPECT_FALSE(write_grey_png(path, pixels, width, height)) << width << " x " << height;
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace hn
