// FastNoise2 from a file: what of its C interface a comparison needs.
#pragma once

#include <filesystem>
#include <hashnoise/field.hpp>
#include <memory>
#include <optional>
#include <span>

#include "base/result.hpp"
#include "bench_cpu/subjects.hpp"

namespace hn {

struct FastNoiseFunctions;

// A noise of it, over positions in cells.
class FastNoiseField {
 public:
  FastNoiseField(std::shared_ptr<const FastNoiseFunctions> functions, std::vector<void*> nodes);
  FastNoiseField(FastNoiseField&& other) noexcept = default;
  ~FastNoiseField();

  // As many points as there are values, kPoints: those of grid().
  void fill_grid(int dimensions, std::span<float> values) const;
  void fill_points(std::span<const std::span<const float>> positions, std::span<float> values) const;

 private:
  std::shared_ptr<const FastNoiseFunctions> functions_;
  std::vector<void*> nodes_;  // the first is evaluated; the others are its sources
};

class FastNoise {
 public:
  // The error names what the file is not.
  static Result<FastNoise> open(const std::filesystem::path& path);

  // Nothing if this build of it has not these instructions. The error: it does not know a name.
  Result<std::optional<FastNoiseField>> field(const Subject& subject, hashnoise::InstructionSet set) const;

 private:
  explicit FastNoise(std::shared_ptr<const FastNoiseFunctions> functions) : functions_(std::move(functions)) {}

  std::shared_ptr<const FastNoiseFunctions> functions_;
};

}  // namespace hn
