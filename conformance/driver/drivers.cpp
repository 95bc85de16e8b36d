#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "driver.hpp"

namespace hn {
namespace {

constexpr std::array kDrivers = {
    Driver{"osmesa", "Mesa's off-screen library, rendering on the CPU", create_osmesa},
    Driver{"egl", "EGL without a window: Mesa's surfaceless platform, else the first EGL device", create_egl},
};

std::string string_of(const GladGLContext& gl, GLenum name) {
  const auto* text = reinterpret_cast<const char*>(gl.GetString(name));
  return text ? text : "";
}

// "4.50", "4.60 NVIDIA", "3.30 - Build ..." -> 450, 460, 330
int glsl_version_number(const std::string& text) {
  char* end = nullptr;
  const long major = std::strtol(text.c_str(), &end, 10);
  const long minor = *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0;
  return static_cast<int>(major * 100 + minor);
}

bool has_extension(const GladGLContext& gl, std::string_view name) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* extension = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (extension && extension == name) return true;
  }
  return false;
}

int highest_es_version(const GladGLContext& gl) {
  if (has_extension(gl, "GL_ARB_ES3_2_compatibility")) return 320;
  if (has_extension(gl, "GL_ARB_ES3_1_compatibility")) return 310;
  return has_extension(gl, "GL_ARB_ES3_compatibility") ? 300 : 0;
}

bool takes_glsl_130(const GladGLContext& gl) {
  const char* const text = "#version 130\nvoid main() {}\n";
  const GLuint shader = gl.CreateShader(GL_FRAGMENT_SHADER);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  gl.DeleteShader(shader);
  return compiled != GL_FALSE;
}

}  // namespace

Result<void> Context::load_functions(GLADloadfunc load) {
  const int version = gladLoadGLContext(&gl_, load);
  if (version == 0) return fail("the context was made, but its OpenGL functions cannot be loaded");
  const int major = GLAD_VERSION_MAJOR(version);
  const int minor = GLAD_VERSION_MINOR(version);
  if (major < 3 || (major == 3 && minor < 1)) {
    return fail(fmt::format("the context offers OpenGL {}.{}; 3.1 or later is needed", major, minor));
  }
  return {};
}

ContextInfo describe(const Context& context) {
  const GladGLContext& gl = context.gl();
  ContextInfo info{string_of(gl, GL_VENDOR),
                   string_of(gl, GL_RENDERER),
                   string_of(gl, GL_VERSION),
                   string_of(gl, GL_SHADING_LANGUAGE_VERSION),
                   {}};
  info.languages = {glsl_version_number(info.glsl_version), highest_es_version(gl), takes_glsl_130(gl),
                    has_extension(gl, "GL_ARB_shader_bit_encoding")};
  return info;
}

std::span<const Driver> all_drivers() { return kDrivers; }

const Driver* find_driver(std::string_view name) {
  const auto found = std::find_if(kDrivers.begin(), kDrivers.end(), [&](const Driver& d) { return d.name == name; });
  return found == kDrivers.end() ? nullptr : &*found;
}

}  // namespace hn
