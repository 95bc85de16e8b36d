#include "gpu/context_info.hpp"

#include <cstdlib>

#include "gpu/gpu.hpp"

namespace hn {
namespace {

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

LanguageSupport languages_of_es(const GladGLContext& gl) {
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  return {.gl_version = 0, .es_version = major * 100 + minor * 10, .gl130 = false, .bit_encoding = false};
}

// The version of ES that a context of desktop OpenGL accepts.
int highest_es_version(const GladGLContext& gl) {
  if (has_extension(gl, "GL_ARB_ES3_2_compatibility")) return 320;
  if (has_extension(gl, "GL_ARB_ES3_1_compatibility")) return 310;
  return has_extension(gl, "GL_ARB_ES3_compatibility") ? 300 : 0;
}

bool takes_glsl_130(const Context& context) {
  return compile_only(context, {"#version 130\nvoid main() {}\n", {}}, Stage::fragment).has_value();
}

}  // namespace

ContextInfo describe(const Context& context) {
  const GladGLContext& gl = context.gl();
  ContextInfo info{string_of(gl, GL_VENDOR),
                   string_of(gl, GL_RENDERER),
                   string_of(gl, GL_VERSION),
                   string_of(gl, GL_SHADING_LANGUAGE_VERSION),
                   {}};
  if (context.api() == Api::gles) {
    info.languages = languages_of_es(gl);
    return info;
  }
  info.languages = {glsl_version_number(info.glsl_version), highest_es_version(gl), takes_glsl_130(context),
                    has_extension(gl, "GL_ARB_shader_bit_encoding")};
  return info;
}

}  // namespace hn
