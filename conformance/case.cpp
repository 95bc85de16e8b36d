#include "case.hpp"

#include <fmt/format.h>

#include <utility>

namespace hn {

std::string_view name_of(Status status) {
  switch (status) {
    case Status::pass:
      return "pass";
    case Status::fail:
      return "fail";
    case Status::unsupported:
      return "unsupported";
    case Status::error:
      break;
  }
  return "error";
}

Outcome error_outcome(const Error& error, Status status) {
  Outcome outcome;
  outcome.status = status;
  outcome.message = error.text();
  return outcome;
}

Session::Session(const Context& context_, const SourceSet& sources_, const ReferenceCompiler& reference_,
                 std::filesystem::path golden_directory_, std::uint64_t seed_)
    : context(context_),
      info(describe(context_)),
      sources(sources_),
      reference(reference_),
      golden_directory(std::move(golden_directory_)),
      seed(seed_),
      grid(context_) {}

Result<const Program*> Session::evaluation_program(const Function& function, const Hash& hash, const Profile& profile,
                                                   std::string_view extra_knobs) {
  const std::string key = fmt::format("{} {} {} {}", function.id, hash.name, profile.name, extra_knobs);
  if (kept_ && key == kept_key_) return kept_.get();
  const auto vertex = expand(sources, profile, vertex_shader());
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = expand(sources, profile, evaluation_shader(function, hash, profile, extra_knobs));
  if (!fragment) return tl::unexpected(fragment.error());
  auto program = Program::build(context, *vertex, *fragment);
  if (!program) return tl::unexpected(program.error());
  kept_ = std::make_unique<Program>(std::move(*program));
  kept_key_ = key;
  return kept_.get();
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_value_cases(cases);
  add_compile_cases(cases);
  return cases;
}

}  // namespace hn
