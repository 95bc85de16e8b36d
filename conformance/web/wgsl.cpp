#include "web/wgsl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "web/files.hpp"

namespace hn {
namespace {

const nlohmann::json& embedded_shaders() {
  static const nlohmann::json shaders = nlohmann::json::parse(text_of(kWebFiles, "wgsl.json"));
  return shaders;
}

}  // namespace

Result<std::vector<std::string>> wgsl_shader(const SourceSet& sources, const Evaluation& evaluation) {
  if (auto reason = sources.untranslated(evaluation.profile); !reason.empty()) return fail(std::move(reason));
  const nlohmann::json& all = embedded_shaders();
  std::vector<std::string> pieces;
  for (const std::size_t number :
       all.at("shaders").at(fmt::format("{} {}", evaluation.configuration.name, evaluation.function.id))) {
    pieces.push_back(all.at("texts").at(number));
  }
  return pieces;
}

Result<std::string> wgsl_text(const SourceSet& sources, const Evaluation& evaluation) {
  HN_TRY(const auto pieces, wgsl_shader(sources, evaluation));
  return fmt::format("{}", fmt::join(pieces, ""));
}

}  // namespace hn
