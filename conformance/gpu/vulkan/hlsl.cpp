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

constexpr const char* kDxcVariable = "HN_DXC";
// The older ones compile only parts of the language.
constexpr int kLeastMajor = 1;
constexpr int kLeastMinor = 10;

// The program that a variable names, or the usual one; its version is all that it prints.
Result<HlslCompiler> find(const char* variable, const char* usual, decltype(HlslCompiler::spirv) spirv) {
  const char* const named = std::getenv(variable);
  HlslCompiler compiler{named ? named : usual, {}, spirv};
  auto text = output_of(compiler.program, {"--version"});
  if (!text) return fail(fmt::format("{} cannot be run: {}", compiler.program, text.error().message));
  compiler.version = *std::move(text);
  return compiler;
}

Result<std::vector<std::uint32_t>> spirv_by_dxc(const std::string& program, const ShaderText& shader) {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  HN_DO(write_file(file("shader.hlsl"), shader.text));
  // -Gis: IEEE's rules where the text has `precise`.
  const auto compiled = run_process({.program = program,
                                     .arguments = {"-spirv", "-fspv-target-env=vulkan1.1", "-Gis", "-T", "cs_6_0", "-E",
                                                   "main", "-Fo", file("shader.spv"), file("shader.hlsl")},
                                     .output = file("compiled")});
  if (!compiled) return fail("dxc does not compile it", shader.translate(compiled.error().text()));
  return read_spirv(file("shader.spv"));
}

// It prints a line for every #line otherwise.
std::vector<std::string> quiet_environment() {
  constexpr std::array<std::string_view, 1> kOwn = {"VKD3D_SHADER_DEBUG="};
  std::vector<std::string> environment = environment_without(kOwn);
  environment.emplace_back("VKD3D_SHADER_DEBUG=none");
  return environment;
}

Result<std::vector<std::uint32_t>> spirv_by_vkd3d(const std::string& program, const ShaderText& shader) {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  HN_DO(write_file(file("shader.hlsl"), shader.text));
  const auto compiled = run_process({.program = program,
                                     .arguments = {"-x", "hlsl", "-b", "dxbc-tpf", "-p", "cs_5_0", "-e", "main", "-o",
                                                   file("shader.dxbc"), file("shader.hlsl")},
                                     .environment = quiet_environment(),
                                     .output = file("compiled")});
  if (!compiled) return fail("vkd3d-compiler does not compile it", shader.translate(compiled.error().text()));
  const auto translated =
      run_process({.program = program,
                   .arguments = {"-x", "dxbc-tpf", "-b", "spirv-binary", "--buffer-uav=storage-buffer", "-o",
                                 file("shader.spv"), file("shader.dxbc")},
                   .output = file("translated")});
  if (!translated) return fail("vkd3d-compiler makes no SPIR-V of it", translated.error().text());
  HN_TRY(const auto words, read_spirv(file("shader.spv")));
  return without_repeated_decorations(words);  // the type of all of its buffers has one for each
}

}  // namespace

bool is_dxc_named() { return std::getenv(kDxcVariable) != nullptr; }

Result<HlslCompiler> find_dxc() {
  HN_TRY(auto compiler, find(kDxcVariable, "dxc", spirv_by_dxc));
  compiler.version = compiler.version.substr(0, compiler.version.find('\n'));
  return compiler;
}

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

Result<HlslCompiler> find_vkd3d() {
  HN_TRY(auto compiler, find("HN_VKD3D_COMPILER", "vkd3d-compiler", spirv_by_vkd3d));
  compiler.version = vkd3d_version(compiler.version);
  if (reads_hlsl(compiler.version)) return compiler;
  return fail(fmt::format("{} is version {}, and HLSL needs {}.{}", compiler.program,
                          compiler.version.empty() ? "unknown" : compiler.version, kLeastMajor, kLeastMinor));
}

}  // namespace hn
