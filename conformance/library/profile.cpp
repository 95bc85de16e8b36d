#include "library/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/entry_named.hpp"

namespace hn {
namespace {

constexpr std::array kAll = {
    Profile{"gl130", "#version 130", 130, false, false},   Profile{"gl140", "#version 140", 140, false, false},
    Profile{"gl150", "#version 150", 150, false, false},   Profile{"gl330", "#version 330", 330, false, false},
    Profile{"gl400", "#version 400", 400, false, false},   Profile{"gl410", "#version 410", 410, false, false},
    Profile{"gl420", "#version 420", 420, false, false},   Profile{"gl430", "#version 430", 430, false, false},
    Profile{"gl440", "#version 440", 440, false, false},   Profile{"gl450", "#version 450", 450, false, false},
    Profile{"gl460", "#version 460", 460, false, false},   Profile{"es300", "#version 300 es", 300, true, false},
    Profile{"es310", "#version 310 es", 310, true, false}, Profile{"es320", "#version 320 es", 320, true, false},
    Profile{"vulkan", "#version 450", 450, false, true},
};

constexpr std::array kOther = {
    Profile{"hlsl50", "", 50, false, true, Language::hlsl},
    Profile{"hlsl60", "", 60, false, true, Language::hlsl},
    Profile{"hlsl2021", "", 2021, false, true, Language::hlsl, true},
    Profile{"slang", "", 0, false, true, Language::hlsl, true},
    Profile{"msl", "", 0, false, false, Language::metal},
    Profile{"wgsl", "", 1, false, false, Language::wgsl},
};

constexpr std::array kRun = {kAll[1], kAll[3], kAll[11]};
static_assert(kRun[0].name == "gl140" && kRun[1].name == "gl330" && kRun[2].name == "es300");

constexpr std::array kRefused = {
    Profile{"gl120", "#version 120", 120, false, false},
    Profile{"es100", "#version 100", 100, true, false},
};

}  // namespace

std::string_view name_of(Stage stage) {
  constexpr std::array<std::string_view, 3> kNames = {"fragment", "vertex", "compute"};
  return kNames.at(static_cast<std::size_t>(stage));
}

std::string_view name_of(Platform platform) {
  constexpr std::array<std::string_view, 4> kNames = {"OpenGL", "Vulkan", "Metal", "WebGPU"};
  return kNames.at(static_cast<std::size_t>(platform));
}

Platform Profile::platform() const {
  switch (language) {
    case Language::metal:
      return Platform::metal;
    case Language::wgsl:
      return Platform::webgpu;
    case Language::hlsl:
    case Language::glsl:
      break;
  }
  return spirv ? Platform::vulkan : Platform::opengl;
}

std::span<const Profile> all_profiles() { return kAll; }
std::span<const Profile> other_languages() { return kOther; }
std::span<const Profile> run_profiles() { return kRun; }
std::span<const Profile> refused_profiles() { return kRefused; }

const Profile& profile_named(std::string_view name) {
  const auto refused = std::ranges::find(kRefused, name, &Profile::name);
  if (refused != std::end(kRefused)) return *refused;
  const auto other = std::ranges::find(kOther, name, &Profile::name);
  return other != std::end(kOther) ? *other : entry_named(kAll, &Profile::name, name, "profile");
}

std::string unsupported_reason(const Profile& profile, const LanguageSupport& support) {
  if (profile.platform() != Platform::opengl) {
    if (std::ranges::find(support.profiles, profile.name) != support.profiles.end()) return {};
    return fmt::format("this driver does not run {}, which is for drivers of {}", profile.name,
                       name_of(profile.platform()));
  }
  const int highest = profile.es ? support.es_version : support.gl_version;
  if (profile.version == 130 && highest >= 130 && !support.gl130) return "this context does not accept GLSL 1.30";
  if (profile.version <= highest) return {};
  if (highest == 0) return fmt::format("this context does not compile {}", profile.es ? "GLSL ES" : "desktop GLSL");
  const std::string_view language = profile.es ? "GLSL ES" : "GLSL";
  return fmt::format("{} {}.{:02} is beyond this context's {}.{:02}", language, profile.version / 100,
                     profile.version % 100, highest / 100, highest % 100);
}

std::string unsupported_to_run(const Profile& profile, const LanguageSupport& support) {
  if (auto reason = unsupported_reason(profile, support); !reason.empty()) return reason;
  if (profile.has_bit_casts() || support.bit_encoding) return {};
  return fmt::format("the suite needs GL_ARB_shader_bit_encoding in GLSL {}.{:02}", profile.version / 100,
                     profile.version % 100);
}

}  // namespace hn
