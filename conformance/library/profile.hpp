// The versions of the shading language that the library targets.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hn {

enum class Stage { fragment, vertex, compute };
std::string_view name_of(Stage stage);

enum class Language { glsl, hlsl, metal, wgsl };
// Whose drivers run a shader.
enum class Platform { opengl, vulkan, metal, webgpu };
std::string_view name_of(Platform platform);  // "OpenGL"

struct Profile {
  std::string_view name;       // in case ids: "gl330", "es300", "vulkan", "hlsl60"
  std::string_view directive;  // "#version 330"; nothing in other languages
  int version;
  bool es;
  bool spirv;
  Language language = Language::glsl;
  bool by_translator = false;  // no driver takes it otherwise

  Platform platform() const;
  bool in_glsl() const { return language == Language::glsl; }

  // Whether #line names the line that follows it. Before GLSL 3.30 it named its own: GLSL 1.30 section 3.3 against GLSL
  // 3.30 and GLSL ES 3.00 section 3.4.
  bool line_names_next() const { return es || version >= 330 || !in_glsl(); }
  // Whether uintBitsToFloat and its like are in the language.
  bool has_bit_casts() const { return es || version >= 330 || !in_glsl(); }
  bool has_precise() const { return version >= (es ? 320 : 400); }
};

// Every targeted version of GLSL, oldest first, GLSL before GLSL ES before Vulkan.
std::span<const Profile> all_profiles();

// Other languages, by the version of each: shader model 6.0 is hlsl60, and hlsl2021 the language itself, which glslang
// does not have. Metal's language, msl, and Slang have none here.
std::span<const Profile> other_languages();

// The profiles whose shaders are run, not only compiled: the oldest arithmetic path, the current one, and ES.
std::span<const Profile> run_profiles();

// Versions that the library must refuse.
std::span<const Profile> refused_profiles();

// Any of the above by its name, which must exist.
const Profile& profile_named(std::string_view name);

// The languages that a context or a device accepts.
struct LanguageSupport {
  int gl_version = 0;        // highest GLSL version, 0 for none
  int es_version = 0;        // highest GLSL ES version, 0 for none
  bool gl130 = true;         // a core context need not take GLSL 1.30
  bool bit_encoding = true;  // GL_ARB_shader_bit_encoding
  // If a driver is of another platform than OpenGL: the names of the profiles whose compute shaders it runs.
  std::vector<std::string> profiles = {};

  // Compute shaders came with GLSL 4.30 and GLSL ES 3.10.
  bool has_stage(Stage stage) const {
    if (!profiles.empty()) return stage == Stage::compute;
    return stage != Stage::compute || gl_version >= 430 || es_version >= 310;
  }
};

// Empty if the profile can be compiled, else why not.
std::string unsupported_reason(const Profile& profile, const LanguageSupport& support);

// Why the profile cannot run the shaders of the cases, which have to look at the bits of floats.
std::string unsupported_to_run(const Profile& profile, const LanguageSupport& support);

}  // namespace hn
