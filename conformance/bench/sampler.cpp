#include "bench/sampler.hpp"

#include <bit>

namespace hn {

Sampler::Sampler(const Context& context_, const SourceSet& sources_) : Workbench(context_, sources_), grid_(context_) {}

Result<std::vector<float>> Sampler::values(const Subject& subject, std::span<const Position> positions) {
  HN_TRY(const auto program, build(value_shader(subject), subject.profile));
  return values(program, positions);
}

Result<std::vector<float>> Sampler::values(const Program& program, std::span<const Position> positions) {
  std::vector<std::uint32_t> inputs(positions.size() * kInputWords);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    inputs[i * kInputWords] = std::bit_cast<std::uint32_t>(positions[i].x);
    inputs[i * kInputWords + 1] = std::bit_cast<std::uint32_t>(positions[i].y);
    inputs[i * kInputWords + 2] = std::bit_cast<std::uint32_t>(positions[i].z);
  }
  HN_TRY(const auto words, grid_.evaluate(program, inputs));
  std::vector<float> values(positions.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::bit_cast<float>(words[i * kOutputWords]);
  return values;
}

}  // namespace hn
