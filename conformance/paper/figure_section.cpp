// The paper's figure: six algorithms by noise, turbulence and clouds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "output/png.hpp"
#include "paper/laboratory.hpp"

namespace hn {
namespace {

constexpr int kSide = 512;
// Cells along a side. Few for the octave sums, whose octaves have up to 32 times as many.
constexpr int kNoiseCells = 16;
constexpr int kOctaveCells = 4;
constexpr std::array kPictures = {Picture::noise, Picture::turbulence, Picture::clouds};

// A sheet is a row of three pictures for each algorithm of the paper's figure, in its order.
struct Sheet {
  Form form;
  std::string title;
};
const std::array kSheets = {Sheet{Form::intended, "As intended"},
                            Sheet{Form::published, "As published, on this driver"},
                            Sheet{Form::ours, "Ours, with the same hashes"}};
constexpr std::array<std::string_view, 6> kInFigure = {"fnv1",   "partial_fnv1", "jenkins", "partial_jenkins",
                                                       "murmur", "float"};

// The middles of the pixels of a square of so many cells, away from the origin, the top row first.
std::vector<Position> positions(int cells) {
  std::vector<Position> points;
  points.reserve(std::size_t{kSide} * kSide);
  const float step = static_cast<float>(cells) / static_cast<float>(kSide);
  for (int row = kSide - 1; row >= 0; --row) {
    for (int column = 0; column < kSide; ++column) {
      points.push_back(
          {32.0f + (static_cast<float>(column) + 0.5f) * step, 32.0f + (static_cast<float>(row) + 0.5f) * step, 0.0f});
    }
  }
  return points;
}

// Noise from -1 black to 1 white; turbulence from 0 to 1/2, since most of it is below; clouds from 0 to 1. What is no
// number is black.
float level_of(float value, Picture picture) {
  if (picture == Picture::noise) return 0.5f + 0.5f * value;
  return picture == Picture::turbulence ? 2.0f * value : value;
}

std::uint8_t grey(float value, Picture picture) {
  const float level = level_of(value, picture);
  return level > 0.0f ? static_cast<std::uint8_t>(std::lround(std::min(level, 1.0f) * 255.0f)) : std::uint8_t{0};
}

using Pixels = std::vector<std::uint8_t>;

Result<Pixels> draw(Laboratory& laboratory, const Entry& entry, Picture picture) {
  HN_TRY(const auto values, laboratory.values(subject_of(entry, 2, picture),
                                              positions(picture == Picture::noise ? kNoiseCells : kOctaveCells)));
  Pixels pixels(values.size());
  std::transform(values.begin(), values.end(), pixels.begin(), [&](float value) { return grey(value, picture); });
  return pixels;
}

void place(Pixels& sheet, const Pixels& picture, std::size_t row, std::size_t column) {
  constexpr std::size_t kSheetWidth = kSide * kPictures.size();
  for (std::size_t y = 0; y < kSide; ++y) {
    std::copy_n(&picture[y * kSide], kSide, &sheet[(row * kSide + y) * kSheetWidth + column * kSide]);
  }
}

// A row of the sheet, which it is placed in.
Result<nlohmann::json> draw_row(Laboratory& laboratory, const Entry& entry, Pixels& sheet, std::size_t row) {
  nlohmann::json figures = nlohmann::json::array();
  for (std::size_t column = 0; column < kPictures.size(); ++column) {
    const Picture picture = kPictures[column];
    HN_TRY(const auto pixels, draw(laboratory, entry, picture));
    place(sheet, pixels, row, column);
    const std::string file = fmt::format("{}.{}.png", entry.id(), name_of(picture));
    HN_DO(write_grey_png(laboratory.out / file, pixels, kSide, kSide));
    figures.push_back({{"file", file}, {"title", fmt::format("{}, {}", entry.algorithm->title, name_of(picture))}});
  }
  return figures;
}

Result<nlohmann::json> draw_sheet(Laboratory& laboratory, const Sheet& sheet, Section& section) {
  Pixels pixels(kInFigure.size() * kSide * kPictures.size() * kSide);
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string_view name : kInFigure) {
    const Entry entry{&algorithm_named(name), name == "float" ? Form::table : sheet.form};
    auto figures = draw_row(laboratory, entry, pixels, rows.size());
    if (!figures) {
      section.complete = false;
      section.data["errors"].push_back({{"id", entry.id()}, {"text", figures.error().text()}});
    }
    rows.push_back({{"title", entry.algorithm->title}, {"figures", figures ? *figures : nlohmann::json::array()}});
  }
  const std::string file = fmt::format("sheet.{}.png", name_of(sheet.form));
  HN_DO(write_grey_png(laboratory.out / file, pixels, static_cast<int>(kSide * kPictures.size()),
                       static_cast<int>(kSide * kInFigure.size())));
  return nlohmann::json{{"title", sheet.title}, {"file", file}, {"rows", rows}};
}

}  // namespace

Result<Section> draw_figures(Laboratory& laboratory) {
  Section section;
  section.data = {{"side", kSide},
                  {"noise_cells", kNoiseCells},
                  {"octave_cells", kOctaveCells},
                  {"sheets", nlohmann::json::array()},
                  {"errors", nlohmann::json::array()}};
  for (const Sheet& sheet : kSheets) {
    HN_TRY(auto drawn, draw_sheet(laboratory, sheet, section));
    section.data["sheets"].push_back(std::move(drawn));
  }
  section.page = section.data;
  return section;
}

}  // namespace hn
