#include "counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include "output/file.hpp"

namespace hn {
namespace {

// Behind the magic number, the version, the generator, the bound and the schema.
constexpr std::size_t kHeaderWords = 5;

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

void add_amd(CountReport& report, std::string_view family) {
  std::vector<std::vector<std::uint32_t>> shaders;
  std::vector<std::size_t> owners;
  for (std::size_t i = 0; i < report.counts.size(); ++i) {
    if (report.counts[i].optimised.empty()) continue;
    shaders.push_back(report.counts[i].optimised);
    owners.push_back(i);
  }
  const auto statistics = amd_counts(family, shaders);
  if (!statistics) {
    report.absent.emplace(family, statistics.error().text());
    return;
  }
  for (std::size_t i = 0; i < owners.size(); ++i) {
    Counts& counts = report.counts[owners[i]];
    const auto& one = (*statistics)[i];
    if (one) {
      counts.amd.emplace(family, *one);
    } else {
      counts.problems.push_back(fmt::format("{}: {}", family, one.error().text()));
    }
  }
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

std::int64_t count_spirv(std::span<const std::uint32_t> words) {
  std::int64_t count = 0;
  bool inside = false;
  for (std::size_t i = kHeaderWords; i < words.size();) {
    const auto opcode = static_cast<spv::Op>(words[i] & spv::OpCodeMask);
    const std::uint32_t length = words[i] >> spv::WordCountShift;
    if (length == 0) break;  // no SPIR-V
    if (opcode == spv::OpFunctionEnd) inside = false;
    if (inside && opcode != spv::OpLabel && opcode != spv::OpFunctionParameter) ++count;
    if (opcode == spv::OpFunction) inside = true;
    i += length;
  }
  return count;
}

std::optional<std::int64_t> count_nvidia(std::string_view binary) {
  // "!!NVfp5.0" starts the text of a fragment program, "END" ends it.
  const auto start = binary.find("!!NVfp");
  if (start == std::string_view::npos) return std::nullopt;
  const auto end = binary.find("\nEND", start);
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view text = binary.substr(start, end - start);
  constexpr std::string_view kDeclarations[] = {"OPTION", "ATTRIB",  "OUTPUT",  "PARAM", "TEMP",
                                                "LONG",   "SHORT",   "INTEGER", "FLOAT", "BUFFER",
                                                "FLAT",   "CBUFFER", "TEXTURE", "INT",   "UINT"};
  std::int64_t count = 0;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const auto last = line.find_last_not_of(" \t\r");
    const bool declaration =
        std::any_of(std::begin(kDeclarations), std::end(kDeclarations), [&](std::string_view word) {
          return line.starts_with(word) && line.size() > word.size() && line[word.size()] == ' ';
        });
    if (last != std::string_view::npos && line[last] == ';' && !declaration && !line.starts_with('#')) ++count;
  }
  return count;
}

Result<void> write_spirv(const std::filesystem::path& directory, std::string_view id, const Counts& counts) {
  if (counts.optimised.empty()) return {};
  return write_file(directory / "spirv" / fmt::format("{}.spv", id), bytes_of(std::span(counts.optimised)));
}

CountReport count_instructions(const Context& context, const ReferenceCompiler& reference,
                               std::span<const CountedShader> shaders) {
  CountReport report;
  if (auto reason = nvidia_absence(context.gl()); !reason.empty()) report.absent.emplace("nvidia", std::move(reason));
  for (const CountedShader& shader : shaders) {
    Counts counts;
    const auto spirv = reference.spirv(shader.vulkan, Stage::fragment);
    const auto optimised = spirv ? optimise_spirv(*spirv) : spirv;
    if (optimised) {
      counts.optimised = *optimised;
      counts.spirv = count_spirv(*optimised);
    } else {
      counts.problems.push_back(fmt::format("SPIR-V: {}", optimised.error().text()));
    }
    if (shader.program && !report.absent.contains("nvidia")) {
      counts.nvidia = count_nvidia(program_binary(context.gl(), *shader.program));
      if (!counts.nvidia) counts.problems.push_back("nvidia: the program binary has no assembly text");
    }
    report.counts.push_back(std::move(counts));
  }
  for (const std::string_view family : amd_families()) add_amd(report, family);
  return report;
}

}  // namespace hn
