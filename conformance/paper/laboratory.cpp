#include "laboratory.hpp"

#include <bit>
#include <utility>

namespace hn {

Laboratory::Laboratory(const Context& context_, const SourceSet& sources_, const ReferenceCompiler& reference_,
                       std::filesystem::path out_, int rounds_, bool dump_)
    : context(context_),
      sources(with_comparison_shaders(sources_)),
      reference(reference_),
      out(std::move(out_)),
      rounds(rounds_),
      dump(dump_),
      stopwatch(context_),
      tables_(context_),
      grid_(context_) {}

Result<Program> Laboratory::build(const std::string& fragment) {
  const Profile& profile = profile_named("gl330");
  const auto vertex_text = expand(sources, profile, quad_vertex_shader());
  if (!vertex_text) return tl::unexpected(vertex_text.error());
  const auto fragment_text = expand(sources, profile, fragment);
  if (!fragment_text) return tl::unexpected(fragment_text.error());
  auto program = Program::build(context, *vertex_text, *fragment_text);
  if (program) tables_.attach(*program);
  return program;
}

Result<std::vector<float>> Laboratory::values(const Subject& subject, std::span<const Position> positions) {
  const auto program = build(value_shader(subject));
  if (!program) return tl::unexpected(program.error());
  std::vector<std::uint32_t> inputs(positions.size() * kInputWords);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    inputs[i * kInputWords] = std::bit_cast<std::uint32_t>(positions[i].x);
    inputs[i * kInputWords + 1] = std::bit_cast<std::uint32_t>(positions[i].y);
    inputs[i * kInputWords + 2] = std::bit_cast<std::uint32_t>(positions[i].z);
  }
  const auto words = grid_.evaluate(*program, inputs);
  if (!words) return tl::unexpected(words.error());
  std::vector<float> values(positions.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::bit_cast<float>((*words)[i * kOutputWords]);
  return values;
}

}  // namespace hn
