#include "gpu/vulkan/dxc.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "base/file.hpp"
#include "base/process.hpp"
#include "base/temporary_folder.hpp"
#include "gpu/spirv.hpp"

namespace hn {
namespace {

constexpr const char* kVariable = "HN_DXC";

}  // namespace

bool Dxc::is_named() { return std::getenv(kVariable) != nullptr; }

Result<Dxc> Dxc::find() {
  const char* const named = std::getenv(kVariable);
  std::string program = named ? named : "dxc";
  const auto text = output_of(program, {"--version"});
  if (!text) return fail(fmt::format("{} cannot be run: {}", program, text.error().message));
  return Dxc(std::move(program), text->substr(0, text->find('\n')));
}

Result<std::vector<std::uint32_t>> Dxc::spirv(const ShaderText& shader) const {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  HN_DO(write_file(file("shader.hlsl"), shader.text));
  // -Gis: IEEE's rules where the text has `precise`.
  const auto compiled = run_process({.program = program_,
                                     .arguments = {"-spirv", "-fspv-target-env=vulkan1.1", "-Gis", "-T", "cs_6_0", "-E",
                                                   "main", "-Fo", file("shader.spv"), file("shader.hlsl")},
                                     .output = file("compiled")});
  if (!compiled) return fail("dxc does not compile it", shader.translate(compiled.error().text()));
  return read_spirv(file("shader.spv"));
}

}  // namespace hn
