// The values that the paper's figure and statistics are made of, which tools/measure paper draws and tests.
#include <fmt/format.h>

#include <array>

#include "base/file.hpp"
#include "paper/laboratory.hpp"

namespace hn {
namespace {

// The figure: six algorithms by noise, turbulence and clouds, as squares of so many pixels.
constexpr int kSide = 512;
// Cells along a side. Few for the octave sums, whose octaves have up to 32 times as many.
constexpr int kNoiseCells = 16;
constexpr int kOctaveCells = 4;
constexpr std::array kPictures = {Picture::noise, Picture::turbulence, Picture::clouds};
constexpr std::array<std::string_view, 6> kInFigure = {"fnv1",   "partial_fnv1", "jenkins", "partial_jenkins",
                                                       "murmur", "float"};

// The middles of the pixels of a square of so many cells, away from the origin, the top row first.
std::vector<Position> pixels(int cells) {
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

// The statistics: 2^20 positions, each more than two cells from the next, so that no two are in neighbouring cells. The
// steps have odd numerators over the number of positions along an axis, so that every place in a cell is visited
// equally often.
constexpr int kSide2 = 1024;
constexpr std::array kSide3 = {128, 128, 64};
constexpr float kStep2 = 2.0f + 341.0f / 1024.0f;
constexpr std::array kStep3 = {2.0f + 41.0f / 128.0f, 2.0f + 41.0f / 128.0f, 2.0f + 41.0f / 64.0f};
// Half of the finest step between two places in a cell; keeps off the lattice, where the noise is 0.
constexpr std::array kOffset3 = {1.0f / 256.0f, 1.0f / 256.0f, 1.0f / 128.0f};
constexpr float kOffset2 = 1.0f / 2048.0f;
constexpr const char* kGrid2 = "value[j * 1024 + i] at (i * s + o, j * s + o), s = 2 + 341/1024, o = 1/2048";
constexpr const char* kGrid3 =
    "value[(k * 128 + j) * 128 + i] at (i * s + o, j * s + o, k * t + 2 o), s = 2 + 41/128, t = 2 + 41/64, o = 1/256";

std::vector<Position> apart(int dimensions) {
  std::vector<Position> points;
  points.reserve(std::size_t{1} << 20);
  if (dimensions == 2) {
    for (int j = 0; j < kSide2; ++j) {
      for (int i = 0; i < kSide2; ++i) {
        points.push_back({static_cast<float>(i) * kStep2 + kOffset2, static_cast<float>(j) * kStep2 + kOffset2, 0.0f});
      }
    }
    return points;
  }
  for (int k = 0; k < kSide3[2]; ++k) {
    for (int j = 0; j < kSide3[1]; ++j) {
      for (int i = 0; i < kSide3[0]; ++i) {
        points.push_back({static_cast<float>(i) * kStep3[0] + kOffset3[0],
                          static_cast<float>(j) * kStep3[1] + kOffset3[1],
                          static_cast<float>(k) * kStep3[2] + kOffset3[2]});
      }
    }
  }
  return points;
}

// Writes the values, and a row that names them.
Result<void> add(Section& section, Laboratory& laboratory, const Entry& entry, const Subject& subject,
                 std::string_view what, const std::string& file, std::span<const Position> points) {
  const auto values = laboratory.values(subject, points);
  if (values) HN_DO(write_file(laboratory.out / file, bytes_of(std::span(*values))));
  section.complete = section.complete && values;
  section.rows.push_back({std::string(entry.algorithm->title), std::string(title_of(entry.form)),
                          fmt::format("{}", subject.dimensions), std::string(what), file,
                          values ? "" : values.error().text()});
  return {};
}

}  // namespace

Result<Section> write_values(Laboratory& laboratory) {
  Section section{"values",
                  {{"side", fmt::format("{}", kSide)},
                   {"cells of noise", fmt::format("{}", kNoiseCells)},
                   {"cells of sums", fmt::format("{}", kOctaveCells)},
                   {"2D", kGrid2},
                   {"3D", kGrid3}},
                  {"algorithm", "form", "dimensions", "what", "file", "problem"}};
  const auto noise = pixels(kNoiseCells);
  const auto sums = pixels(kOctaveCells);
  for (const Entry& entry : all_entries()) {
    if (std::ranges::count(kInFigure, entry.algorithm->name) == 0) continue;
    for (const Picture picture : kPictures) {
      const std::string file = fmt::format("values/{}.{}.f32", entry.id(), name_of(picture));
      HN_DO(add(section, laboratory, entry, subject_of(entry, 2, picture), name_of(picture), file,
                picture == Picture::noise ? noise : sums));
    }
  }
  for (const int dimensions : {2, 3}) {
    const auto points = apart(dimensions);
    for (const Entry& entry : all_entries()) {
      HN_DO(add(section, laboratory, entry, subject_of(entry, dimensions), "statistics",
                fmt::format("values/{}.{}d.f32", entry.id(), dimensions), points));
    }
  }
  return section;
}

}  // namespace hn
