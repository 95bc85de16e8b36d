#include "bench/counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <spirv-tools/optimizer.hpp>

#include "base/file.hpp"
#include "gpu/spirv.hpp"

namespace hn {
namespace {

// Declarations and options of NVIDIA's assembly begin with these: the grammar of NV_gpu_program4 and 5, of
// NV_fragment_program4, and of the extensions to them. Every other text that ends in a semicolon is an instruction.
constexpr auto kDeclarations = std::to_array<std::string_view>(
    {"OPTION", "ATTRIB", "PARAM", "TEMP", "OUTPUT", "ALIAS", "BUFFER", "BUFFER4", "CBUFFER", "TEXTURE", "IMAGE",
     "STORAGE", "COUNTER", "SUBROUTINETYPE", "SUBROUTINE",
     // and the modifiers before some of them
     "SHORT", "LONG", "INT", "UINT", "FLOAT", "FLAT", "CENTROID", "NOPERSPECTIVE", "SAMPLE"});
constexpr std::string_view kBlanks = " \t\r\n";

// Comments run from "#" to the end of the line.
std::string without_comments(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const std::string_view before = text.substr(0, text.find('#'));
    kept += before;
    text.remove_prefix(before.size());
    text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
  }
  return kept;
}

// The word that a statement begins with, behind its labels ("BB2:").
std::string_view first_word(std::string_view text) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_$";
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_not_of(kLetters));
    text.remove_prefix(word.size());
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (word.empty() || !text.starts_with(':')) return word;
    text.remove_prefix(1);
  }
}

std::string program_binary(const GladGLContext& gl, const Program& program) {
  GLint length = 0;
  gl.GetProgramiv(program.id(), GL_PROGRAM_BINARY_LENGTH, &length);
  std::string binary(static_cast<std::size_t>(std::max(length, 0)), '\0');
  GLenum format = 0;
  GLsizei written = 0;
  if (!binary.empty()) gl.GetProgramBinary(program.id(), length, &written, &format, binary.data());
  binary.resize(static_cast<std::size_t>(written));
  return binary;
}

// Empty if NVIDIA's assembly can be had of this context, else why not.
std::string nvidia_absence(const GladGLContext& gl) {
  const auto* const vendor = reinterpret_cast<const char*>(gl.GetString(GL_VENDOR));
  if (!vendor || std::string_view(vendor).find("NVIDIA") == std::string_view::npos) {
    return fmt::format("the driver is not NVIDIA's but {}'s", vendor ? vendor : "nobody");
  }
  GLint formats = 0;
  if (gl.GetProgramBinary) gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  return formats > 0 ? "" : "the driver offers no program binaries";
}

}  // namespace

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

namespace {

Result<std::vector<std::uint32_t>> optimised_spirv(const ReferenceCompiler& reference, const ShaderText& text) {
  return reference.spirv(text, Stage::fragment).and_then([](const auto& words) { return optimise_spirv(words); });
}

}  // namespace

Result<std::vector<std::uint32_t>> optimised_spirv(const SourceSet& sources, const ReferenceCompiler& reference,
                                                   const Subject& subject) {
  return expand(sources, profile_named("vulkan"), quad_shader(subject)).and_then([&](const ShaderText& text) {
    return optimised_spirv(reference, text);
  });
}

std::optional<std::int64_t> count_nvidia(std::string_view binary) {
  const auto start = binary.find("!!NVfp");
  if (start == std::string_view::npos) return std::nullopt;
  // A text is over where the binary goes on, whether it came to its END or not.
  const std::string text = without_comments(binary.substr(start, binary.find('\0', start) - start));
  std::string_view rest = text;
  rest.remove_prefix(std::min(rest.find_first_of(kBlanks), rest.size()));  // "!!NVfp5.0"
  for (std::int64_t count = 0;;) {
    const std::string_view word = first_word(rest);
    if (word == "END") return count;
    const auto end = rest.find(';');
    if (end == std::string_view::npos) return std::nullopt;
    rest.remove_prefix(end + 1);
    if (!word.empty() && std::find(kDeclarations.begin(), kDeclarations.end(), word) == kDeclarations.end()) ++count;
  }
}

std::string count_text(const Counts& counts, std::string_view source,
                       const std::map<std::string, std::string>& absent) {
  const auto found = counts.instructions.find(source);
  if (found != counts.instructions.end()) return fmt::format("{}", found->second);
  return absent.contains(std::string(source)) ? "not here" : "failed";
}

Result<void> write_spirv(const std::filesystem::path& directory, std::string_view id,
                         std::span<const std::uint32_t> words) {
  if (words.empty()) return {};
  return write_file(directory / "spirv" / fmt::format("{}.spv", id), bytes_of(words));
}

bool counts_programs(const Context& context) { return nvidia_absence(context.gl()).empty(); }

CountReport count_instructions(const Context& context, const ReferenceCompiler& reference,
                               std::span<const CountedShader> shaders) {
  CountReport report;
  const std::string no_nvidia = nvidia_absence(context.gl());
  if (!no_nvidia.empty()) report.absent.emplace(kNvidiaSource, no_nvidia);
  for (const CountedShader& shader : shaders) {
    Counts counts;
    const auto optimised = optimised_spirv(reference, shader.vulkan);
    if (optimised) {
      counts.optimised = *optimised;
      counts.instructions.emplace(kSpirvSource, count_spirv(*optimised));
    } else {
      counts.problems.push_back(fmt::format("SPIR-V: {}", optimised.error().text()));
    }
    if (shader.program && no_nvidia.empty()) {
      const auto count = count_nvidia(program_binary(context.gl(), *shader.program));
      if (count) counts.instructions.emplace(kNvidiaSource, *count);
      if (!count) counts.problems.push_back(fmt::format("{}: the program binary has no assembly text", kNvidiaSource));
    }
    report.counts.push_back(std::move(counts));
  }
  return report;
}

}  // namespace hn
