#include "gpu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hn {
namespace {

std::string shader_log(const GladGLContext& gl, GLuint shader) {
  GLint length = 0;
  gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.GetShaderInfoLog(shader, length, nullptr, log.data());
  return log.c_str();
}

std::string program_log(const GladGLContext& gl, GLuint program) {
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.GetProgramInfoLog(program, length, nullptr, log.data());
  return log.c_str();
}

std::string_view stage_name(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER:
      return "vertex";
    case GL_COMPUTE_SHADER:
      return "compute";
    default:
      return "fragment";
  }
}

class ShaderObject {
 public:
  ShaderObject(const GladGLContext& gl, GLenum stage) : gl_(gl), stage_(stage), id_(gl.CreateShader(stage)) {}
  ~ShaderObject() { gl_.DeleteShader(id_); }
  ShaderObject(const ShaderObject&) = delete;
  ShaderObject& operator=(const ShaderObject&) = delete;

  Result<void> compile(const ShaderText& source) const {
    const char* const text = source.text.c_str();
    gl_.ShaderSource(id_, 1, &text, nullptr);
    gl_.CompileShader(id_);
    GLint compiled = GL_FALSE;
    gl_.GetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
    if (compiled) return {};
    return fail(fmt::format("the driver does not compile the {} shader", stage_name(stage_)),
                source.translate(shader_log(gl_, id_)));
  }

  GLuint id() const { return id_; }

 private:
  const GladGLContext& gl_;
  GLenum stage_;
  GLuint id_;
};

// The textures are at most this wide; every OpenGL 3.1 implementation has 1024 at the least.
constexpr std::size_t kWidth = 1024;

void set_nearest(const GladGLContext& gl) {
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

Result<Program> Program::build(const Context& context, const ShaderText& vertex, const ShaderText& fragment) {
  const GladGLContext& gl = context.gl();
  const ShaderObject vertex_shader(gl, GL_VERTEX_SHADER);
  if (auto done = vertex_shader.compile(vertex); !done) return tl::unexpected(done.error());
  const ShaderObject fragment_shader(gl, GL_FRAGMENT_SHADER);
  if (auto done = fragment_shader.compile(fragment); !done) return tl::unexpected(done.error());
  Program program(gl, gl.CreateProgram());
  gl.AttachShader(program.id_, vertex_shader.id());
  gl.AttachShader(program.id_, fragment_shader.id());
  gl.BindFragDataLocation(program.id_, 0, "result");
  gl.LinkProgram(program.id_);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id_, GL_LINK_STATUS, &linked);
  if (!linked) return fail("the driver does not link the program", fragment.translate(program_log(gl, program.id_)));
  return program;
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(id_, other.id_);
  return *this;
}

Program::~Program() {
  if (id_ != 0) gl_->DeleteProgram(id_);
}

Result<void> compile_only(const Context& context, const ShaderText& shader, GLenum stage) {
  return ShaderObject(context.gl(), stage).compile(shader);
}

GridRenderer::GridRenderer(const Context& context) : gl_(context.gl()) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.GenTextures(3, textures_);
}

GridRenderer::~GridRenderer() {
  gl_.DeleteTextures(3, textures_);
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

Result<void> GridRenderer::resize(std::size_t points) {
  const auto width = static_cast<GLsizei>(std::min(points, kWidth));
  const auto height = static_cast<GLsizei>((points + kWidth - 1) / kWidth);
  if (width == width_ && height == height_) return {};
  for (const GLuint texture : textures_) {
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    set_nearest(gl_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, width, height, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures_[2], 0);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return fail("this driver does not render to RGBA32UI, which OpenGL 3.0 requires");
  }
  width_ = width;
  height_ = height;
  return {};
}

void GridRenderer::upload(std::span<const std::uint32_t> inputs) {
  const std::size_t texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  std::vector<std::uint32_t> words(texels * 4);
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::size_t i = 0; i * kInputWords < inputs.size(); ++i) {
      std::copy_n(&inputs[i * kInputWords + half * 4], 4, &words[i * 4]);
    }
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(half));
    gl_.BindTexture(GL_TEXTURE_2D, textures_[half]);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words.data());
  }
}

Result<std::vector<std::uint32_t>> GridRenderer::evaluate(const Program& program,
                                                          std::span<const std::uint32_t> inputs) {
  const std::size_t points = inputs.size() / kInputWords;
  while (gl_.GetError() != GL_NO_ERROR) {
  }
  if (auto done = resize(points); !done) return tl::unexpected(done.error());
  upload(inputs);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, width_, height_);
  // So that a draw that does nothing cannot pass for the one before it.
  constexpr GLuint kNothing[4] = {0xDEADBEEF, 0xDEADBEEF, 0xDEADBEEF, 0xDEADBEEF};
  gl_.ClearBufferuiv(GL_COLOR, 0, kNothing);
  gl_.UseProgram(program.id());
  gl_.Uniform1i(gl_.GetUniformLocation(program.id(), "input_a"), 0);
  gl_.Uniform1i(gl_.GetUniformLocation(program.id(), "input_b"), 1);
  gl_.BindVertexArray(vertex_array_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * kOutputWords);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words.data());
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) {
    return fail(fmt::format("OpenGL error {:#06x} while rendering {} x {}", error, width_, height_));
  }
  words.resize(points * kOutputWords);
  return words;
}

}  // namespace hn
