#include "bench_cpu/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "bench_cpu/add.hpp"

namespace hn {
namespace {

// A sample should be long against the resolution of the clock, and short against what else a machine does.
constexpr double kSampleSeconds = 6e-3;

double seconds_of(const std::function<void()>& work, int times) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < times; ++i) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
}

// The works of one set of instructions, as places in the list of all works.
struct Places {
  std::size_t fast = 0;
  std::size_t points = 0;
  std::size_t fixed = 0;
  std::size_t precise = 0;
  std::size_t tiles = 0;
  std::optional<std::size_t> octaves;
  std::optional<std::size_t> other_grid;
  std::optional<std::size_t> other_points;
  std::optional<std::size_t> strict_grid;
  std::optional<std::size_t> two_threads;
};

// The works of a subject, and what they write.
template <int D>
class Works {
 public:
  explicit Works(const Subject& subject) : subject_(subject), positions_(positions_of_grid(D)) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      points_.p[axis] = positions_[axis];
      spans_.push_back(points_.p[axis]);
    }
  }

  // Compared works stand next to each other.
  Result<Places> add(hashnoise::InstructionSet set, const FastNoise* other, const FastNoise* strict,
                     bool with_threads) {
    using hashnoise::Arithmetic;
    Places places;
    HN_TRY(const auto theirs, field_of(other, set));
    HN_TRY(const auto theirs_strict, field_of(strict, set));
    places.fast = add_ours(set, Arithmetic::kFast, [this](const auto& field) { field.fill(grid<D>(), out_); });
    if (theirs) {
      places.other_grid = add_work([this, theirs] { theirs->fill_grid(D, one_plane()); });
      places.points = add_points(set);
      places.other_points = add_work([this, theirs] { theirs->fill_points(spans_, one_plane()); });
    } else {
      places.points = add_points(set);
    }
    if (theirs && subject_.sum == "fbm") places.octaves = add_octaves(set);
    places.tiles = add_tiles(set);
    places.fixed = add_ours(set, Arithmetic::kFixed, [this](const auto& field) { field.fill(grid<D>(), out_); });
    if (theirs_strict) {
      places.strict_grid = add_work([this, theirs_strict] { theirs_strict->fill_grid(D, one_plane()); });
    }
    places.precise = add_ours(set, Arithmetic::kPrecise, [this](const auto& field) { field.fill(grid<D>(), out_); });
    if (with_threads) {
      places.two_threads =
          add_ours(set, Arithmetic::kFast, [this](const auto& field) { field.fill(grid<D>(), out_, two_threads_); });
    }
    return places;
  }

  std::vector<Timing> measure_all(int rounds) const { return measure(works_, rounds); }

 private:
  // Null without a library, and of a build that has not these instructions.
  Result<std::shared_ptr<const FastNoiseField>> field_of(const FastNoise* library,
                                                         hashnoise::InstructionSet set) const {
    std::shared_ptr<const FastNoiseField> field;
    if (library) {
      HN_TRY(auto made, library->field(subject_, set));
      if (made) field = std::make_shared<const FastNoiseField>(std::move(*made));
    }
    return field;
  }

  std::size_t add_work(std::function<void()> work) {
    works_.push_back(std::move(work));
    return works_.size() - 1;
  }

  template <typename Fill>
  std::size_t add_ours(hashnoise::InstructionSet set, hashnoise::Arithmetic arithmetic, Fill fill) {
    return add_field(settings_of(subject_, arithmetic, set), fill);
  }
  template <typename Fill>
  std::size_t add_field(const hashnoise::Settings& settings, Fill fill) {
    const auto field = std::make_shared<const hashnoise::Field<D>>(settings);
    out_.resize(std::max(out_.size(), static_cast<std::size_t>(field->component_count()) * kPoints));
    return add_work([field, fill] { fill(*field); });
  }
  std::size_t add_points(hashnoise::InstructionSet set) {
    return add_ours(set, hashnoise::Arithmetic::kFast, [this](const auto& field) { field.fill(points_, out_); });
  }

  std::size_t add_tiles(hashnoise::InstructionSet set) {
    hashnoise::Settings settings = settings_of(subject_, hashnoise::Arithmetic::kFast, set);
    settings.period.fill(1000);
    return add_field(settings, [this](const auto& field) { field.fill(grid<D>(), out_); });
  }

  // Grids of the noise, added up in parts that stay in a cache.
  std::size_t add_octaves(hashnoise::InstructionSet set) {
    hashnoise::Settings settings = settings_of(subject_, hashnoise::Arithmetic::kFast, set);
    settings.fractal.clear();
    settings.octaves.reset();
    std::vector<std::shared_ptr<const hashnoise::Field<D>>> fields;
    for (int octave = 0; octave < kOctaves; ++octave) {
      fields.push_back(std::make_shared<const hashnoise::Field<D>>(settings));
      ++settings.seed;
    }
    constexpr int kParts = 64;
    octave_.resize(kPoints / kParts);
    return add_work([this, fields] {
      for (int part = 0; part < kParts; ++part) {
        auto part_grid = grid<D>();
        part_grid.size[D - 1] /= kParts;
        part_grid.first[D - 1] = part * part_grid.size[D - 1];
        float weight = 1.0f / (2.0f - std::ldexp(1.0f, 1 - kOctaves));
        const auto sum = std::span(out_).subspan(static_cast<std::size_t>(part) * octave_.size(), octave_.size());
        std::ranges::fill(sum, 0.0f);
        for (const auto& field : fields) {
          field->fill(part_grid, octave_);
          hn::add(sum, octave_, weight);
          weight *= 0.5f;
          for (float& step : part_grid.step) step *= 2.0f;
        }
      }
    });
  }

  std::span<float> one_plane() { return std::span(out_).first(kPoints); }

  const Subject& subject_;
  std::vector<std::vector<float>> positions_;
  hashnoise::Points<D> points_;
  std::vector<std::span<const float>> spans_;
  std::vector<float> out_;
  std::vector<float> octave_;  // of a part of it
  hashnoise::Executor two_threads_ = hashnoise::threads(2);
  std::vector<std::function<void()>> works_;
};

void evaluate(Measurement& measurement, const Places& places, const std::vector<Timing>& timings) {
  const auto add = [&](const char* comparison, std::size_t first, std::optional<std::size_t> second) {
    if (second) measurement.ratios[comparison] = speed(timings[first], timings[*second]);
  };
  add("grids", places.fast, places.other_grid);
  add("points", places.points, places.other_points);
  if (places.octaves) add("octaves", *places.octaves, places.other_grid);
  add("strict fixed", places.fixed, places.strict_grid);
  add("strict precise", places.precise, places.strict_grid);
  add("fixed", places.fixed, places.fast);
  add("precise", places.precise, places.fast);
  add("tiles", places.tiles, places.fast);
  add("lists", places.points, places.fast);
  if (places.two_threads) add("threads", *places.two_threads, places.fast);
  const auto tell = [&](const char* name, std::optional<std::size_t> place) {
    if (place) measurement.millions_a_second[name] = kPoints * 1e-6 / timings[*place].median();
  };
  tell("fast", places.fast);
  tell("fixed", places.fixed);
  tell("precise", places.precise);
  tell("tiles", places.tiles);
  tell("points", places.points);
  tell("two threads", places.two_threads);
  tell("FastNoise2", places.other_grid);
  tell("FastNoise2 points", places.other_points);
  tell("FastNoise2 strict", places.strict_grid);
}

template <int D>
Result<std::vector<Measurement>> measure_in(const Subject& subject, const FastNoise* other, const FastNoise* strict,
                                            int rounds) {
  auto sets = hashnoise::instruction_sets();
  std::ranges::reverse(sets);
  Works<D> works(subject);
  std::vector<Places> places;
  for (const hashnoise::InstructionSet set : sets) {
    HN_TRY(const Places added, works.add(set, other, strict, set == sets.back()));
    places.push_back(added);
  }
  const std::vector<Timing> timings = works.measure_all(rounds);
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    measurements.push_back({subject, sets[i], {}, {}});
    evaluate(measurements.back(), places[i], timings);
  }
  return measurements;
}

}  // namespace

std::vector<Timing> measure(std::span<const std::function<void()>> works, int rounds) {
  std::vector<Timing> timings(works.size());
  std::vector<int> times;
  for (const auto& work : works) {
    seconds_of(work, 1);
    times.push_back(std::clamp(static_cast<int>(std::ceil(kSampleSeconds / seconds_of(work, 1))), 1, 1000));
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      works[i]();  // so that none finds what it reads further away than the next one does
      timings[i].samples.push_back(seconds_of(works[i], times[i]));
    }
  }
  return timings;
}

Ratio speed(const Timing& first, const Timing& second) { return ratio(second, first); }

std::vector<std::vector<float>> positions_of_grid(int dimensions) {
  const int width = dimensions == 2 ? 1024 : 128;
  const int height = dimensions == 2 ? 1024 : 128;
  std::vector<std::vector<float>> positions(static_cast<std::size_t>(dimensions));
  for (auto& axis : positions) axis.reserve(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    positions[0].push_back(static_cast<float>(i % width) * kStep);
    positions[1].push_back(static_cast<float>(i / width % height) * kStep);
    if (dimensions == 3) positions[2].push_back(static_cast<float>(i / width / height) * kStep);
  }
  return positions;
}

Result<std::vector<Measurement>> measure_subject(const Subject& subject, const FastNoise* other,
                                                 const FastNoise* strict, int rounds) {
  return subject.dimensions == 2 ? measure_in<2>(subject, other, strict, rounds)
                                 : measure_in<3>(subject, other, strict, rounds);
}

}  // namespace hn
