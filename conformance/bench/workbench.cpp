#include "bench/workbench.hpp"

#include <bit>

#include "gpu/context_info.hpp"

namespace hn {

Workbench::Workbench(const Context& context_, const SourceSet& sources_)
    : context(context_),
      sources(with_comparison_shaders(sources_)),
      languages_(describe(context_).languages),
      tables_(context_) {}

std::string Workbench::unsupported(std::string_view profile) const {
  return unsupported_reason(profile_named(profile), languages_);
}

Result<Program> Workbench::build(const std::string& fragment, std::string_view profile_name) {
  const Profile& profile = profile_named(profile_name);
  HN_TRY(const auto vertex_text, expand(sources, profile, quad_vertex_shader()));
  HN_TRY(const auto fragment_text, expand(sources, profile, fragment));
  auto program = Program::build(context, vertex_text, fragment_text);
  if (program) tables_.attach(*program);
  return program;
}

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
