#include "bake/files.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "bake/mapping.hpp"
#include "bake/tests/options_fixture.hpp"

namespace hn {
namespace {

using Files = std::map<std::string, std::string>;

struct Product {
  Files files;
  Report report;
};

Product make(const BakeOptions& options) {
  Product made;
  const auto mappings = mappings_of(options, component_names(options));
  EXPECT_TRUE(mappings) << mappings.error().text();
  const auto report = write_files(options, compute(options, {}), mappings.value_or(std::vector<Mapping>{}),
                                  [&](const std::filesystem::path& path, std::string_view bytes) {
                                    made.files[path.string()] = bytes;
                                    return Result<void>();
                                  });
  EXPECT_TRUE(report) << report.error().text();
  if (report) made.report = *report;
  return made;
}

BakeOptions options_of(std::vector<std::string> words, Format format, const std::string& out) {
  auto options = parsed(std::move(words));
  EXPECT_TRUE(options) << options.error().err;
  options->format = format;
  options->out = out;
  return *options;
}

struct Picture {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<float>> channels;
  std::string record;
};

Picture read_exr(const std::string& bytes) {
  Imf::StdISStream stream;
  stream.str(bytes);
  Imf::InputFile file(stream);
  const auto window = file.header().dataWindow();
  Picture picture;
  picture.width = window.max.x + 1;
  picture.height = window.max.y + 1;
  Imf::FrameBuffer frame;
  for (auto channel = file.header().channels().begin(); channel != file.header().channels().end(); ++channel) {
    EXPECT_EQ(channel.channel().type, Imf::FLOAT);
    auto& values = picture.channels[channel.name()];
    values.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    frame.insert(channel.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                            sizeof(float) * static_cast<std::size_t>(picture.width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0, picture.height - 1);
  picture.record = file.header().typedAttribute<Imf::StringAttribute>("hashnoise").value();
  return picture;
}

template <typename T>
std::vector<T> numbers_in(const std::string& bytes) {
  std::vector<T> numbers(bytes.size() / sizeof(T));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(T));
  return numbers;
}

TEST(Files, RawFloatsAreThePlanes) {
  const BakeOptions options = options_of({"cellular", "--size", "33x21"}, Format::f32, "a.f32");
  const Planes planes = compute(options, {});
  std::vector<float> all = planes.planes[0].values;
  all.insert(all.end(), planes.planes[1].values.begin(), planes.planes[1].values.end());
  EXPECT_EQ(numbers_in<float>(make(options).files.at("a.f32")), all);
}

TEST(Files, RawWordsAreTheMappedPlanes) {
  BakeOptions options = options_of({"perlin_d", "--size", "33x21"}, Format::r16, "a.r16");
  options.ranges = {{-1.0, 1.0}, {-2.0, 2.0}, {-4.0, 4.0}};
  std::vector<std::uint16_t> all;
  const Planes planes = compute(options, {});
  for (std::size_t c = 0; c < 3; ++c) {
    const auto words = to_16_bits(planes.planes[c].values, options.ranges[c]).words;
    all.insert(all.end(), words.begin(), words.end());
  }
  EXPECT_EQ(numbers_in<std::uint16_t>(make(options).files.at("a.r16")), all);
}

TEST(Files, ExrHasTheFloats) {
  const BakeOptions options = options_of({"simplex_d", "--size", "50x30"}, Format::exr, "a.exr");
  const Planes planes = compute(options, {});
  const Picture picture = read_exr(make(options).files.at("a.exr"));
  EXPECT_EQ(picture.width, 50);
  EXPECT_EQ(picture.height, 30);
  ASSERT_EQ(picture.channels.size(), 3u);
  EXPECT_EQ(picture.channels.at("R"), planes.planes[0].values);
  EXPECT_EQ(picture.channels.at("G"), planes.planes[1].values);
  EXPECT_EQ(picture.channels.at("B"), planes.planes[2].values);
  const auto record = nlohmann::json::parse(picture.record);
  EXPECT_EQ(record.at("function"), "simplex_d");
  EXPECT_EQ(record.at("settings").at("arithmetic"), "fixed");
}

TEST(Files, ExrOfTwoComponentsHasABlueOfZero) {
  for (const char* const function : {"curl", "cellular", "phasor"}) {
    const BakeOptions options = options_of({function, "--size", "5x3"}, Format::exr, "a.exr");
    const Planes planes = compute(options, {});
    const std::map<std::string, std::vector<float>> expected = {
        {"R", planes.planes.at(0).values}, {"G", planes.planes.at(1).values}, {"B", std::vector<float>(5 * 3)}};
    EXPECT_EQ(read_exr(make(options).files.at("a.exr")).channels, expected) << function;
  }
}

TEST(Files, ExrNamesWhatIsNoColour) {
  const BakeOptions grey = options_of({"perlin", "--size", "5x3"}, Format::exr, "a.exr");
  EXPECT_EQ(read_exr(make(grey).files.at("a.exr")).channels.count("Y"), 1u);
  const BakeOptions five = options_of({"value_d", "--size", "5x3x2x2"}, Format::exr, "a.exr");
  const Picture picture = read_exr(make(five).files.at("a.exr"));
  for (const char* const name : {"value", "dx", "dy", "dz", "dw"}) EXPECT_EQ(picture.channels.count(name), 1u) << name;
}

TEST(Files, AnAtlasHasTheSlicesInRows) {
  BakeOptions options = options_of({"perlin", "--size", "6x4x7"}, Format::exr, "a.exr");
  options.columns = 3;
  const auto values = compute(options, {}).planes[0].values;
  const Picture picture = read_exr(make(options).files.at("a.exr"));
  EXPECT_EQ(picture.width, 18);
  EXPECT_EQ(picture.height, 12);
  const auto& pixels = picture.channels.at("Y");
  for (std::size_t slice = 0; slice < 9; ++slice) {
    for (std::size_t y = 0; y < 4; ++y) {
      for (std::size_t x = 0; x < 6; ++x) {
        const float pixel = pixels[(slice / 3 * 4 + y) * 18 + slice % 3 * 6 + x];
        ASSERT_EQ(pixel, slice < 7 ? values[(slice * 4 + y) * 6 + x] : 0.0f) << slice;
      }
    }
  }
}

TEST(Files, SlicesAreAFileEach) {
  BakeOptions options = options_of({"perlin", "--size", "6x4x3"}, Format::exr, "folder/a.exr");
  options.layout = Layout::slices;
  const auto values = compute(options, {}).planes[0].values;
  const Product made = make(options);
  ASSERT_EQ(made.files.size(), 3u);
  for (int slice = 0; slice < 3; ++slice) {
    const Picture picture = read_exr(made.files.at("folder/a.00" + std::to_string(slice) + ".exr"));
    const std::vector<float> expected(values.begin() + slice * 24, values.begin() + (slice + 1) * 24);
    EXPECT_EQ(picture.channels.at("Y"), expected);
    EXPECT_EQ(nlohmann::json::parse(picture.record).at("slice"), slice);
  }
}

// The simplified interface of libpng reads what its other one has written; 16 bits as they are need no gamma.
std::vector<std::uint16_t> read_png(const std::string& bytes, int channels, int& width, int& height) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string_view rest = bytes;
  png_set_read_fn(png, &rest, [](png_structp from, png_bytep data, png_size_t size) {
    auto& left = *static_cast<std::string_view*>(png_get_io_ptr(from));
    std::memcpy(data, left.data(), size);
    left.remove_prefix(size);
  });
  png_read_info(png, info);
  png_set_swap(png);
  width = static_cast<int>(png_get_image_width(png, info));
  height = static_cast<int>(png_get_image_height(png, info));
  EXPECT_EQ(png_get_bit_depth(png, info), 16);
  EXPECT_EQ(png_get_channels(png, info), channels);
  const auto row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  std::vector<std::uint16_t> pixels(row * static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    png_read_row(png, reinterpret_cast<png_bytep>(pixels.data() + y * row), nullptr);
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return pixels;
}

TEST(Files, PngHasTheMappedValues) {
  const struct {
    std::string function;
    std::string size;
    std::size_t components;
    int channels;
  } rows[] = {
      {"fbm", "31x17", 1, 1}, {"cellular", "31x17", 2, 3}, {"perlin_d", "31x17", 3, 3}, {"perlin_d", "31x17x1", 4, 4}};
  for (const auto& row : rows) {
    const BakeOptions options = options_of({row.function, "--size", row.size}, Format::png, "a.png");
    const Planes planes = compute(options, {});
    const Product made = make(options);
    int width = 0;
    int height = 0;
    const auto pixels = read_png(made.files.at("a.png"), row.channels, width, height);
    EXPECT_EQ(width, 31);
    EXPECT_EQ(height, 17);
    const auto channels = static_cast<std::size_t>(row.channels);
    ASSERT_EQ(planes.planes.size(), row.components);
    for (std::size_t c = 0; c < channels; ++c) {
      std::vector<std::uint16_t> expected(31 * 17);
      if (c < row.components) {
        expected = to_16_bits(planes.planes[c].values, made.report.components[c].mapping->interval).words;
      }
      for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_EQ(pixels[i * channels + c], expected[i]) << row.function;
    }
  }
}

TEST(Files, NormalizedFillTheirRange) {
  BakeOptions options = options_of({"cellular", "--size", "64x64"}, Format::r16, "a.r16");
  options.normalize = true;
  const auto words = numbers_in<std::uint16_t>(make(options).files.at("a.r16"));
  for (const std::size_t plane : {0u, 1u}) {
    const auto begin = words.begin() + static_cast<std::ptrdiff_t>(plane * 4096);
    EXPECT_EQ(*std::min_element(begin, begin + 4096), 0);
    EXPECT_EQ(*std::max_element(begin, begin + 4096), 65535);
  }
}

TEST(Files, CountsOfClampedValues) {
  BakeOptions options = options_of({"perlin", "--size", "64x64"}, Format::r16, "a.r16");
  options.ranges = {{-0.25, 0.25}};
  const auto values = compute(options, {}).planes[0].values;
  const auto outside = std::count_if(values.begin(), values.end(), [](float v) { return v < -0.25f || v > 0.25f; });
  EXPECT_GT(outside, 100);
  EXPECT_EQ(make(options).report.components[0].mapping->clamped, static_cast<std::size_t>(outside));
}

// Settings without an effect on the bytes are not in the file.
TEST(Files, AreTheSameByAnyThreadsAndInstructions) {
  for (const Format format : {Format::png, Format::exr, Format::f32, Format::r16}) {
    BakeOptions options =
        options_of({"fbm", "--noise", "simplex", "--size", "300x90", "--tile", "--cells", "8x3"}, format, "a");
    const Files reference = make(options).files;
    for (const hashnoise::InstructionSet set : hashnoise::instruction_sets()) {
      options.settings.instruction_set = set;
      options.threads = options.threads == 1 ? 2 : 1;
      EXPECT_EQ(make(options).files, reference) << name_of(format) << name(set);
    }
    options.settings.seed = 1;
    EXPECT_NE(make(options).files, reference);
  }
}

TEST(Files, WhatFitsNoFormatIsToldBefore) {
  BakeOptions five = options_of({"value_d", "--size", "5x3x2x2"}, Format::png, "a.png");
  const auto too_many = mappings_of(five, component_names(five));
  ASSERT_FALSE(too_many);
  EXPECT_NE(too_many.error().message.find("at most 4"), std::string::npos) << too_many.error().message;
  const BakeOptions slopes = options_of({"fbm_d"}, Format::png, "a.png");
  const auto unknown = mappings_of(slopes, component_names(slopes));
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("--normalize"), std::string::npos);
  BakeOptions ranges = options_of({"perlin_d"}, Format::png, "a.png");
  ranges.ranges = {{-1.0, 1.0}, {-1.0, 1.0}};
  EXPECT_FALSE(mappings_of(ranges, component_names(ranges)));
}

TEST(Files, NanIsCountedAndNotClamped) {
  const BakeOptions options = options_of({"perlin", "--size", "5x3"}, Format::r16, "a.r16");
  const auto mappings = mappings_of(options, component_names(options));
  ASSERT_TRUE(mappings);
  Planes planes = compute(options, {});
  planes.planes[0].values[3] = std::numeric_limits<float>::quiet_NaN();
  const auto report = write_files(options, std::move(planes), *mappings,
                                  [](const std::filesystem::path&, std::string_view) { return Result<void>(); });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->components[0].nans, 1u);
  EXPECT_EQ(report->components[0].mapping->clamped, 0u);
}

TEST(Files, AFileThatCannotBeWrittenIsAnError) {
  const BakeOptions options = options_of({"perlin", "--size", "5x3"}, Format::png, "a.png");
  const auto mappings = mappings_of(options, component_names(options));
  ASSERT_TRUE(mappings);
  const auto report =
      write_files(options, compute(options, {}), *mappings,
                  [](const std::filesystem::path&, std::string_view) -> Result<void> { return fail("full"); });
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().message, "full");
}

}  // namespace
}  // namespace hn
