#include "bench/counts.hpp"

#include <fmt/format.h>

#include <spirv-tools/optimizer.hpp>

#include "base/file.hpp"
#include "gpu/spirv.hpp"

namespace hn {

Result<std::vector<std::uint32_t>> optimise_spirv(std::span<const std::uint32_t> words) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_0);
  std::string log;
  optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    log += fmt::format("{}\n", message);
  });
  optimizer.RegisterPerformancePasses();
  std::vector<std::uint32_t> optimised;
  if (!optimizer.Run(words.data(), words.size(), &optimised)) return fail("spirv-opt fails", log);
  return optimised;
}

Result<std::vector<std::uint32_t>> optimised_spirv(const SourceSet& sources, const ReferenceCompiler& reference,
                                                   const Subject& subject) {
  HN_TRY(const auto text, expand(sources, profile_named("vulkan"), quad_shader(subject)));
  HN_TRY(const auto words, reference.spirv(text, Stage::fragment));
  return optimise_spirv(words);
}

Result<void> write_spirv(const std::filesystem::path& directory, std::string_view id,
                         std::span<const std::uint32_t> words) {
  if (words.empty()) return {};
  return write_file(directory / "spirv" / fmt::format("{}.spv", id), bytes_of(words));
}

}  // namespace hn
