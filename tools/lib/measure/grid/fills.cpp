#include "fills.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "fast_noise.hpp"

namespace hn {
namespace {

using hashnoise::Arithmetic;
using hashnoise::Field;
using hashnoise::InstructionSet;
using hashnoise::Settings;

std::vector<float> out;  // all fills write it, since one runs at a time

// A list has the points of the grid.
template <int D>
std::array<std::vector<float>, D> positions_of_grid() {
  const auto size = grid<D>().size;
  std::array<std::vector<float>, D> positions;
  for (int i = 0; i < kPoints; ++i) {
    int rest = i;
    for (std::size_t axis = 0; axis < D; ++axis) {
      positions[axis].push_back(static_cast<float>(rest % size[axis]) * kStep);
      rest /= size[axis];
    }
  }
  return positions;
}

// Grids of the noise, each twice as dense as the one before and with a seed of its own, added up in parts that stay in
// a cache: FastNoise2 does not turn octaves either.
template <int D>
std::function<void()> octaves(Settings settings) {
  settings.fractal.clear();
  settings.octaves.reset();
  std::vector<std::shared_ptr<const Field<D>>> fields;
  for (int octave = 0; octave < kOctaves; ++octave) {
    fields.push_back(std::make_shared<const Field<D>>(settings));
    ++settings.seed;
  }
  return [fields] {
    constexpr int kParts = 64;
    static std::vector<float> one(kPoints / kParts);
    for (int part = 0; part < kParts; ++part) {
      auto part_grid = grid<D>();
      part_grid.size[D - 1] /= kParts;
      part_grid.first[D - 1] = part * part_grid.size[D - 1];
      float weight = 1.0f / (2.0f - std::ldexp(1.0f, 1 - kOctaves));
      const auto sum = std::span(out).subspan(static_cast<std::size_t>(part) * one.size(), one.size());
      std::ranges::fill(sum, 0.0f);
      for (const auto& field : fields) {
        field->fill(part_grid, one);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * one[i];
        weight *= 0.5f;
        for (float& step : part_grid.step) step *= 2.0f;
      }
    }
  };
}

template <int D>
std::vector<Fill> fills_in(const Subject& subject, const FastNoise* other, const FastNoise* strict) {
  static const auto positions = positions_of_grid<D>();
  hashnoise::Points<D> points;
  std::vector<std::span<const float>> spans;
  for (std::size_t axis = 0; axis < D; ++axis) {
    points.p[axis] = positions[axis];
    spans.push_back(points.p[axis]);
  }
  std::vector<Fill> all;
  const auto sets = hashnoise::instruction_sets();
  for (const InstructionSet set : sets) {
    const auto add = [&](std::string_view way, std::function<void()> run) {
      all.push_back({std::string(name(set)) + "/" + std::string(way), std::move(run)});
    };
    Settings settings{.noise = subject.noise, .fractal = subject.sum, .seed = kSeed, .instruction_set = set};
    if (!subject.sum.empty()) settings.octaves = kOctaves;
    const auto ours = [&](std::string_view way, Arithmetic arithmetic, const auto& place, int period = 0,
                          const hashnoise::Executor& executor = {}) {
      Settings changed = settings;
      changed.arithmetic = arithmetic;
      changed.period.fill(period);
      const auto field = std::make_shared<const Field<D>>(changed);
      out.resize(static_cast<std::size_t>(field->component_count()) * kPoints);
      add(way, [=] { field->fill(place, out, executor); });
    };
    ours("fast", Arithmetic::kFast, grid<D>());
    ours("fixed", Arithmetic::kFixed, grid<D>());
    ours("precise", Arithmetic::kPrecise, grid<D>());
    ours("points", Arithmetic::kFast, points);
    ours("tiles", Arithmetic::kFast, grid<D>(), 1000);
    if (set == sets.front()) ours("two threads", Arithmetic::kFast, grid<D>(), 0, hashnoise::threads(2));
    if (subject.sum == "fbm") add("octaves", octaves<D>(settings));
    if (const auto node = other ? other->node(subject, set) : nullptr) {
      add("FastNoise2", [=] { other->fill_grid(node.get(), D, out.data()); });
      add("FastNoise2 points", [=] { other->fill_points(node.get(), spans, out.data()); });
    }
    if (const auto node = strict ? strict->node(subject, set) : nullptr) {
      add("FastNoise2 strict", [=] { strict->fill_grid(node.get(), D, out.data()); });
    }
  }
  return all;
}

}  // namespace

std::vector<Subject> subjects() {
  struct Row {
    std::string noise, sum, node, fractal;
  };
  const Row rows[] = {
      {"value", "", "Value", ""},
      {"perlin", "", "Perlin", ""},
      {"simplex", "", "Simplex", ""},
      {"simplex_smooth", "", "SuperSimplex", ""},
      {"cellular", "", "CellularDistance", ""},
      {"perlin", "fbm", "Perlin", "FractalFBm"},
      {"simplex", "fbm", "Simplex", "FractalFBm"},
      {"perlin", "ridged", "Perlin", "FractalRidged"},
      {"simplex", "ridged", "Simplex", "FractalRidged"},
  };
  std::vector<Subject> all;
  for (const Row& row : rows) {
    for (const int dimensions : {2, 3}) {
      all.push_back({row.sum + (row.sum.empty() ? "" : "_") + row.noise + std::to_string(dimensions), row.noise,
                     row.sum, dimensions, row.node, row.fractal});
    }
  }
  return all;
}

std::vector<Fill> fills(std::span<const char* const> words) {
  static std::unique_ptr<const FastNoise> other, strict;  // as long as the fills
  const auto all = subjects();
  const auto subject = std::ranges::find(all, words.empty() ? "" : words.front(), &Subject::id);
  if (subject == all.end()) throw std::invalid_argument("the first word has to be a subject, such as perlin2");
  for (const std::string_view word : words.subspan(1)) {
    const std::string file(word.substr(std::min(word.find('=') + 1, word.size())));
    if (word.starts_with("fastnoise2=")) {
      other = std::make_unique<const FastNoise>(file);
    } else if (word.starts_with("strict=")) {
      strict = std::make_unique<const FastNoise>(file);
    } else {
      throw std::invalid_argument(std::string(word) + " is neither fastnoise2=FILE nor strict=FILE");
    }
  }
  return (subject->dimensions == 2 ? fills_in<2> : fills_in<3>)(*subject, other.get(), strict.get());
}

}  // namespace hn
