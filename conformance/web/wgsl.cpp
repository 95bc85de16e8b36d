#include "web/wgsl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "web/files.hpp"

namespace hn {
namespace {

const nlohmann::json& embedded_shaders() {
  static const nlohmann::json shaders = nlohmann::json::parse(text_of(kWebFiles, "wgsl.json"));
  return shaders;
}

// Why the embedded shaders are not those of these sources, if they are not.
std::optional<Error> difference_of(const SourceSet& sources) {
  if (sources.transform()) return Error{"faults are injected into GLSL", ""};
  static const SourceSet embedded = SourceSet::embedded();
  const bool alike = std::ranges::all_of(embedded.files(), [&](const auto& file) {
    const SourceFile* other = sources.find(file.first);
    return other != nullptr && other->text == file.second.text;
  });
  if (alike) return std::nullopt;
  return Error{"this is WGSL of the library that hn-conform was built with: build hn-conform from the other copy", ""};
}

}  // namespace

tl::expected<std::vector<std::string>, Outcome> wgsl_shader(const SourceSet& sources, const Evaluation& evaluation) {
  if (const auto error = difference_of(sources)) return tl::unexpected(outcome_with(Status::unsupported, *error));
  const nlohmann::json& all = embedded_shaders();
  std::vector<std::string> pieces;
  for (const std::size_t number :
       all.at("shaders").at(fmt::format("{} {}", evaluation.configuration.name, evaluation.function.id))) {
    pieces.push_back(all.at("texts").at(number));
  }
  return pieces;
}

}  // namespace hn
