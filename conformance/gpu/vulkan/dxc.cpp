#include "gpu/vulkan/dxc.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <regex>

#include "base/file.hpp"
#include "base/process.hpp"
#include "base/temporary_folder.hpp"

namespace hn {
namespace {

constexpr const char* kVariable = "HN_DXC";

}  // namespace

bool Dxc::is_named() { return std::getenv(kVariable) != nullptr; }

Result<Dxc> Dxc::find() {
  const char* const named = std::getenv(kVariable);
  std::string program = named ? named : "dxc";
  const TemporaryFolder folder;
  const auto output = folder.path() / "version";
  const auto ran = run_process({.program = program, .arguments = {"--version"}, .output = output});
  if (!ran) return fail(fmt::format("{} cannot be run: {}", program, ran.error().message));
  HN_TRY(const std::string text, read_file(output));
  return Dxc(std::move(program), text.substr(0, text.find('\n')));
}

Result<std::vector<std::uint32_t>> Dxc::spirv(const ShaderText& shader) const {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  // It puts a file's name before a line's number; 0 is one that translate reads.
  const std::string text = std::regex_replace(shader.text, std::regex("(^|\n)#line (\\d+)\n"), "$1#line $2 \"0\"\n");
  HN_DO(write_file(file("shader.hlsl"), text));
  // -Gis: IEEE's rules where the text says `precise`.
  const auto compiled = run_process({.program = program_,
                                     .arguments = {"-spirv", "-fspv-target-env=vulkan1.1", "-Gis", "-T", "cs_6_0", "-E",
                                                   "main", "-Fo", file("shader.spv"), file("shader.hlsl")},
                                     .output = file("compiled")});
  if (!compiled) return fail("dxc does not compile it", shader.translate(compiled.error().text()));
  HN_TRY(const auto bytes, read_file(file("shader.spv")));
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

}  // namespace hn
