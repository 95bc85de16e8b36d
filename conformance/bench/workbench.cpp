#include "bench/workbench.hpp"

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

}  // namespace hn
