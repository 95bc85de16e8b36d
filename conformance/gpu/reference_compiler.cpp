#include "gpu/reference_compiler.hpp"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <glslang/SPIRV/spirv.hpp>
#include <map>
#include <set>
#include <spirv-tools/libspirv.hpp>

namespace hn {
namespace {

EShLanguage language_of(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return EShLangVertex;
    case Stage::compute:
      return EShLangCompute;
    case Stage::fragment:
      break;
  }
  return EShLangFragment;
}

enum class Warnings { refuse, let_pass };

// Compiles and links; the SPIR-V where the profile has it, else nothing.
Result<std::vector<std::uint32_t>> compile(const ShaderText& source, const Profile& profile, Stage stage,
                                           Warnings warnings) {
  const EShLanguage language = language_of(stage);
  const auto rules = static_cast<EShMessages>(profile.spirv ? EShMsgSpvRules | EShMsgVulkanRules : EShMsgDefault);
  glslang::TShader shader(language);
  const char* const text = source.text.c_str();
  shader.setStrings(&text, 1);
  if (profile.spirv) {
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  }
  const bool compiled = shader.parse(GetDefaultResources(), profile.version, false, rules);
  const std::string log = shader.getInfoLog();
  if (!compiled) return fail("glslang does not compile it", source.translate(log));
  if (warnings == Warnings::refuse && log.find("WARNING") != std::string::npos) {
    return fail("glslang warns", source.translate(log));
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(rules)) return fail("glslang does not link it", source.translate(program.getInfoLog()));
  std::vector<std::uint32_t> words;
  if (profile.spirv) glslang::GlslangToSpv(*program.getIntermediate(language), words);
  return words;
}

}  // namespace

Result<void> validate_spirv(std::span<const std::uint32_t> words) {
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_0);
  std::string log;
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t& position, const char* message) {
    log += fmt::format("word {}: {}\n", position.index, message);
  });
  if (!tools.Validate(words.data(), words.size())) return fail("spirv-val rejects the SPIR-V", log);
  return {};
}

namespace {

// What is said of the module word by word: each instruction and its operands, from the result on if it has one.
template <typename Visit>
void for_each_instruction(std::span<const std::uint32_t> words, Visit visit) {
  constexpr std::size_t kHeader = 5;  // words before the first instruction
  for (std::size_t at = kHeader; at < words.size();) {
    const std::size_t length = words[at] >> 16;
    if (length == 0 || at + length > words.size()) break;
    visit(static_cast<spv::Op>(words[at] & 0xFFFFu), words.subspan(at + 1, length - 1));
    at += length;
  }
}

std::string text_of(std::span<const std::uint32_t> operands) { return reinterpret_cast<const char*>(operands.data()); }

bool rounds(spv::Op operation) {
  return operation == spv::OpFAdd || operation == spv::OpFSub || operation == spv::OpFMul ||
         operation == spv::OpVectorTimesScalar || operation == spv::OpDot || operation == spv::OpFDiv;
}

}  // namespace

std::vector<std::string> relaxed_precision(std::span<const std::uint32_t> words) {
  std::map<std::uint32_t, std::string> names;
  std::vector<std::uint32_t> relaxed;
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t> operands) {
    if (operation == spv::OpName) names[operands[0]] = text_of(operands.subspan(1));
    const bool relaxes = operation == spv::OpDecorate && operands[1] == spv::DecorationRelaxedPrecision;
    if (relaxes) relaxed.push_back(operands[0]);
  });
  std::vector<std::string> found;
  for (const std::uint32_t id : relaxed) found.push_back(names[id]);
  return found;
}

std::vector<std::string> contractible(std::span<const std::uint32_t> words) {
  std::map<std::uint32_t, std::string> names;
  std::set<std::uint32_t> precise;
  std::vector<std::string> found;
  std::string function;
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t> operands) {
    if (operation == spv::OpName) names[operands[0]] = text_of(operands.subspan(1));
    const bool forbids = operation == spv::OpDecorate && operands[1] == spv::DecorationNoContraction;
    if (forbids) precise.insert(operands[0]);
    if (operation == spv::OpFunction) function = names[operands[1]];
    const bool free = rounds(operation) && !precise.contains(operands[1]);
    if (free && (found.empty() || found.back() != function)) found.push_back(function);
  });
  return found;
}

std::string reference_compiler_version() {
  const glslang::Version version = glslang::GetVersion();
  return fmt::format("{}.{}.{}", version.major, version.minor, version.patch);
}

ReferenceCompiler::ReferenceCompiler() { glslang::InitializeProcess(); }
ReferenceCompiler::~ReferenceCompiler() { glslang::FinalizeProcess(); }

Result<void> ReferenceCompiler::check(const ShaderText& source, const Profile& profile, Stage stage) const {
  const auto words = compile(source, profile, stage, Warnings::refuse);
  if (!words) return tl::unexpected(words.error());
  return profile.spirv ? validate_spirv(*words) : Result<void>{};
}

Result<std::vector<std::uint32_t>> ReferenceCompiler::spirv(const ShaderText& source, Stage stage) const {
  return compile(source, profile_named("vulkan"), stage, Warnings::let_pass);
}

}  // namespace hn
