#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "cases/evidence.hpp"
#include "output/encoding.hpp"

namespace hn {
namespace {

constexpr std::size_t kPixels = kPictureSide * kPictureSide;

// Between neighbouring points: of whole numbers 1; of positions a part of a cell, three cells in all, unless floats lie
// farther apart there; of a hash that is to become a float as much as shows all of them.
double step_of(const Column& column, std::uint32_t word) {
  if (column.type == WordType::f32) {
    constexpr double kPartOfCell = 1.0 / 32.0;
    const float size = std::fabs(std::bit_cast<float>(word));
    const float next = std::nextafter(size, std::numeric_limits<float>::infinity());
    const double spacing = static_cast<double>(next) - static_cast<double>(size);
    return std::isfinite(spacing) ? std::max(kPartOfCell, spacing) : kPartOfCell;
  }
  return column.name == "h" ? std::floor(0x1p32 / static_cast<double>(kPixels)) : 1.0;
}

std::uint32_t moved(const Column& column, std::uint32_t word, double steps) {
  const double by = steps * step_of(column, word);
  if (column.type == WordType::f32) {
    const float value = std::bit_cast<float>(word);
    return std::bit_cast<std::uint32_t>(static_cast<float>(static_cast<double>(value) + by));
  }
  // Whole numbers wrap around.
  return word + static_cast<std::uint32_t>(static_cast<std::int64_t>(by));
}

bool is_word(const Function& function) {
  const WordType type = function.outputs.front().type;
  return type == WordType::u32 || type == WordType::i32;
}

// 0 is black and 255 is white. A word is shown by its high byte, a float from -1 to 1.
double grey_of(const Function& function, std::uint32_t word) {
  if (is_word(function)) return static_cast<double>(word >> 24);
  return (number_of(word) + 1.0) * 127.5;
}

// In the same units, but with all bits of a word. Infinity where one of the values is not a number.
double difference_of(const Function& function, std::uint32_t got, std::uint32_t reference) {
  if (got == reference) return 0.0;
  if (is_word(function)) return std::fabs(static_cast<double>(got) - static_cast<double>(reference)) / 0x1p24;
  const double difference = std::fabs(grey_of(function, got) - grey_of(function, reference));
  return std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
}

std::uint8_t pixel_of(double grey) {
  if (std::isnan(grey)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 255.0)));
}

std::string picture(const std::vector<double>& greys) {
  std::vector<std::uint8_t> pixels(greys.size());
  std::transform(greys.begin(), greys.end(), pixels.begin(), pixel_of);
  const auto png = grey_png(pixels, static_cast<int>(kPictureSide), static_cast<int>(kPictureSide));
  return png ? to_base64(*png) : std::string();
}

}  // namespace

Words window_around(const Function& function, std::span<const std::uint32_t> words) {
  Words window;
  window.reserve(kPixels * kInputWords);
  for (std::size_t i = 0; i < kPixels; ++i) {
    const double right = static_cast<double>(i % kPictureSide) - static_cast<double>(kMiddle);
    const double up = static_cast<double>(kMiddle) - static_cast<double>(i / kPictureSide);
    const std::size_t begin = window.size();
    window.insert(window.end(), words.begin(), words.begin() + kInputWords);
    const auto& inputs = function.inputs;
    if (inputs.size() > 1) {
      window[begin] = moved(inputs[0], words[0], right);
      window[begin + 1] = moved(inputs[1], words[1], up);
    } else {  // a row goes on where the one below it ends
      window[begin] = moved(inputs[0], words[0], up * static_cast<double>(kPictureSide) + right);
    }
  }
  return window;
}

std::string describe_window(const Function& function, const Words& window) {
  const std::size_t middle = (kMiddle * kPictureSide + kMiddle) * kInputWords;
  const auto step = [&](std::size_t column) { return step_of(function.inputs[column], window[middle + column]); };
  std::string axes;
  if (function.inputs.size() > 1) {
    axes = fmt::format("{} grows to the right, {:.9g} per pixel, {} upwards, {:.9g} per pixel", function.inputs[0].name,
                       step(0), function.inputs[1].name, step(1));
  } else {
    axes = fmt::format("{} grows by {:.9g} per pixel to the right, and on from row to row upwards",
                       function.inputs[0].name, step(0));
  }
  return fmt::format("{}; the point where the case failed is in the middle. {}", axes,
                     is_word(function) ? "Words are shown by their high byte."
                                       : "The first result is shown: -1 and less is black, 1 and more is white.");
}

Pictures draw_pictures(const Function& function, const Words& got, const Words& reference) {
  std::vector<double> left;
  std::vector<double> right;
  std::vector<double> apart;
  double largest = 0.0;
  for (std::size_t i = 0; i < got.size(); i += kOutputWords) {
    left.push_back(grey_of(function, got[i]));
    right.push_back(grey_of(function, reference[i]));
    apart.push_back(difference_of(function, got[i], reference[i]));
    if (std::isfinite(apart.back())) largest = std::max(largest, apart.back());
  }
  const double factor = largest > 0.0 ? 255.0 / largest : 1.0;
  for (double& difference : apart) difference *= factor;
  return {picture(left), picture(right), picture(apart), factor};
}

}  // namespace hn
