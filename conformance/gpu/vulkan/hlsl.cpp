#include "gpu/vulkan/hlsl.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/process.hpp"
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

namespace {

// The older ones compile only parts of the language.
constexpr int kLeastMajor = 1;
constexpr int kLeastMinor = 10;

}  // namespace

std::string vkd3d_version(const std::string& text) {
  constexpr std::string_view kBefore = "version ";
  const auto at = text.find(kBefore);
  int major = 0;
  int minor = 0;
  const bool found = at != std::string::npos && std::sscanf(&text[at + kBefore.size()], "%d.%d", &major, &minor) == 2;
  return found ? fmt::format("{}.{}", major, minor) : "";
}

bool reads_hlsl(const std::string& version) {
  int major = 0;
  int minor = 0;
  if (std::sscanf(version.c_str(), "%d.%d", &major, &minor) != 2) return false;
  return major > kLeastMajor || (major == kLeastMajor && minor >= kLeastMinor);
}

Result<Vkd3d> Vkd3d::find() {
  const char* const named = std::getenv("HN_VKD3D_COMPILER");
  std::string program = named ? named : "vkd3d-compiler";
  const auto text = output_of(program, {"--version"});
  if (!text) return fail(fmt::format("{} cannot be run: {}", program, text.error().message));
  std::string version = vkd3d_version(*text);
  if (!reads_hlsl(version)) {
    return fail(fmt::format("{} is version {}, and HLSL needs {}.{}", program, version.empty() ? "unknown" : version,
                            kLeastMajor, kLeastMinor));
  }
  return Vkd3d(std::move(program), std::move(version));
}

// It prints a line for every #line otherwise.
std::vector<std::string> quiet_environment() {
  constexpr std::array<std::string_view, 1> kOwn = {"VKD3D_SHADER_DEBUG="};
  std::vector<std::string> environment = environment_without(kOwn);
  environment.emplace_back("VKD3D_SHADER_DEBUG=none");
  return environment;
}

Result<std::vector<std::uint32_t>> Vkd3d::spirv(const ShaderText& shader) const {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  HN_DO(write_file(file("shader.hlsl"), shader.text));
  const auto compiled = run_process({.program = program_,
                                     .arguments = {"-x", "hlsl", "-b", "dxbc-tpf", "-p", "cs_5_0", "-e", "main", "-o",
                                                   file("shader.dxbc"), file("shader.hlsl")},
                                     .environment = quiet_environment(),
                                     .output = file("compiled")});
  if (!compiled) return fail("vkd3d-compiler does not compile it", shader.translate(compiled.error().text()));
  const auto translated =
      run_process({.program = program_,
                   .arguments = {"-x", "dxbc-tpf", "-b", "spirv-binary", "--buffer-uav=storage-buffer", "-o",
                                 file("shader.spv"), file("shader.dxbc")},
                   .output = file("translated")});
  if (!translated) return fail("vkd3d-compiler makes no SPIR-V of it", translated.error().text());
  HN_TRY(const auto words, read_spirv(file("shader.spv")));
  return without_repeated_decorations(words);  // the type of all of its buffers has one for each
}

}  // namespace hn
