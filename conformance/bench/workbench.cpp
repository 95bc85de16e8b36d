#include "bench/workbench.hpp"

namespace hn {

Workbench::Workbench(const Context& context_, const SourceSet& sources_)
    : context(context_), sources(with_comparison_shaders(sources_)), tables_(context_) {}

Result<Program> Workbench::build(const std::string& fragment) {
  const Profile& profile = profile_named("gl330");
  const auto vertex_text = expand(sources, profile, quad_vertex_shader());
  if (!vertex_text) return tl::unexpected(vertex_text.error());
  const auto fragment_text = expand(sources, profile, fragment);
  if (!fragment_text) return tl::unexpected(fragment_text.error());
  auto program = Program::build(context, *vertex_text, *fragment_text);
  if (program) tables_.attach(*program);
  return program;
}

}  // namespace hn
