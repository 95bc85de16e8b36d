#include "gpu/reference_compiler.hpp"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "base/text.hpp"
#include "gpu/spirv.hpp"

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

EShMessages rules_of(const Profile& profile) {
  const EShMessages hlsl = profile.in_glsl() ? EShMsgDefault : EShMsgReadHlsl;
  return static_cast<EShMessages>(profile.spirv ? EShMsgSpvRules | EShMsgVulkanRules | hlsl : EShMsgDefault);
}

// Sets the language of a shader, and the one that it is compiled to.
void set_environment(glslang::TShader& shader, const Profile& profile, EShLanguage language) {
  if (!profile.spirv) return;
  shader.setEnvInput(profile.in_glsl() ? glslang::EShSourceGlsl : glslang::EShSourceHlsl, language,
                     glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  if (!profile.in_glsl()) shader.setEntryPoint("main");
}

// Compiles and links; the SPIR-V where the profile has it, else nothing. Writes the tree of the program, if there is a
// place for it.
Result<std::vector<std::uint32_t>> compile(const ShaderText& source, const Profile& profile, Stage stage,
                                           Warnings warnings, std::string* tree = nullptr) {
  const EShLanguage language = language_of(stage);
  const EShMessages rules = rules_of(profile);
  glslang::TShader shader(language);
  const char* const text = source.text.c_str();
  shader.setStrings(&text, 1);
  set_environment(shader, profile, language);
  const bool compiled = shader.parse(GetDefaultResources(), profile.version, false, rules);
  const std::string log = shader.getInfoLog();
  if (!compiled) return fail("glslang does not compile it", source.translate(log));
  if (warnings == Warnings::refuse && log.find("WARNING") != std::string::npos) {
    return fail("glslang warns", source.translate(log));
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(tree == nullptr ? rules : static_cast<EShMessages>(rules | EShMsgAST))) {
    return fail("glslang does not link it", source.translate(program.getInfoLog()));
  }
  if (tree != nullptr) *tree = program.getInfoDebugLog();
  std::vector<std::uint32_t> words;
  if (profile.spirv) glslang::GlslangToSpv(*program.getIntermediate(language), words);
  return words;
}

}  // namespace

std::string reference_compiler_version() {
  const glslang::Version version = glslang::GetVersion();
  return fmt::format("{}.{}.{}", version.major, version.minor, version.patch);
}

ReferenceCompiler::ReferenceCompiler() { glslang::InitializeProcess(); }
ReferenceCompiler::~ReferenceCompiler() { glslang::FinalizeProcess(); }

Result<void> ReferenceCompiler::check(const ShaderText& source, const Profile& profile, Stage stage) const {
  HN_TRY(const auto words, compile(source, profile, stage, Warnings::refuse));
  return profile.spirv ? validate_spirv(words) : Result<void>{};
}

Result<std::vector<std::uint32_t>> ReferenceCompiler::spirv(const ShaderText& source, const Profile& profile,
                                                            Stage stage) const {
  return compile(source, profile, stage, Warnings::let_pass);
}

Result<std::vector<std::uint32_t>> ReferenceCompiler::spirv(const ShaderText& source, Stage stage) const {
  return spirv(source, profile_named("vulkan"), stage);
}

Result<ShaderText> ReferenceCompiler::preprocessed(const ShaderText& source, const Profile& profile,
                                                   Stage stage) const {
  const EShLanguage language = language_of(stage);
  glslang::TShader shader(language);
  const char* const text = source.text.c_str();
  shader.setStrings(&text, 1);
  set_environment(shader, profile, language);
  ShaderText result{{}, source.paths};
  glslang::TShader::ForbidIncluder none;
  if (shader.preprocess(GetDefaultResources(), profile.version, ENoProfile, false, false, rules_of(profile),
                        &result.text, none)) {
    return result;
  }
  return fail("glslang does not preprocess it", source.translate(shader.getInfoLog()));
}

Result<std::set<std::size_t>> ReferenceCompiler::lines_of_called(const ShaderText& source, const Profile& profile,
                                                                 Stage stage) const {
  std::string tree;
  HN_DO(compile(source, profile, stage, Warnings::let_pass, &tree));
  // "0:12  Function Definition: f(i1; ( global float)". A linked program has no others.
  std::set<std::size_t> lines;
  for (const std::string_view line : split(tree, '\n')) {
    if (!line.starts_with("0:") || line.find("Function Definition: ") == line.npos) continue;
    lines.insert(std::stoul(std::string(line.substr(2))));
  }
  return lines;
}

}  // namespace hn
