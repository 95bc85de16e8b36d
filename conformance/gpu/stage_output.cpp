#include "gpu/stage_output.hpp"

#include <algorithm>

#include "library/shaders.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr GLuint kNothing = 0xDEADBEEF;

class Pixels final : public StageOutput {
 public:
  explicit Pixels(const GladGLContext& gl) : gl_(gl) {}

  Result<Words> run(GLuint, std::size_t points) override {
    const auto [width, height] = grid_size(points);
    // A smaller grid takes a corner of the framebuffer, since softpipe goes on with the gl_FragCoord.y of the height
    // that a program was first used with.
    gl_.Viewport(0, 0, width, height);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(0, 0, width, height);
    constexpr GLuint kNothings[4] = {kNothing, kNothing, kNothing, kNothing};
    gl_.ClearBufferuiv(GL_COLOR, 0, kNothings);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    Words words(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kOutputWords);
    gl_.ReadPixels(0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words.data());
    words.resize(points * kOutputWords);
    return words;
  }

 private:
  const GladGLContext& gl_;
};

// Results in a buffer. Whole groups of points are evaluated, and those beyond the last one thrown away.
class BufferOutput : public StageOutput {
 public:
  BufferOutput(const GladGLContext& gl, GLenum target) : gl_(gl), target_(target) { gl_.GenBuffers(1, &buffer_); }
  ~BufferOutput() override { gl_.DeleteBuffers(1, &buffer_); }

  Result<Words> run(GLuint program, std::size_t points) override {
    const std::size_t groups = (points + kComputeGroup - 1) / kComputeGroup;
    Words words(groups * kComputeGroup * kOutputWords, kNothing);
    const auto bytes = static_cast<GLsizeiptr>(words.size() * sizeof(std::uint32_t));
    gl_.BindBuffer(target_, buffer_);
    gl_.BufferData(target_, bytes, words.data(), GL_STREAM_READ);
    gl_.BindBufferBase(target_, 0, buffer_);
    execute(gl_, program, groups);
    gl_.BindBufferBase(target_, 0, 0);
    gl_.BindBuffer(target_, buffer_);
    // Not glGetBufferSubData, which ES does not have.
    const auto* const mapped = static_cast<std::uint32_t*>(gl_.MapBufferRange(target_, 0, bytes, GL_MAP_READ_BIT));
    if (!mapped) return fail("the driver does not map the buffer of the results");
    std::copy_n(mapped, words.size(), words.begin());
    if (!gl_.UnmapBuffer(target_)) return fail("the driver lost the buffer of the results");
    words.resize(points * kOutputWords);
    return words;
  }

 private:
  virtual void execute(const GladGLContext& gl, GLuint program, std::size_t groups) const = 0;

  const GladGLContext& gl_;
  GLenum target_;
  GLuint buffer_ = 0;
};

class CapturedVertices final : public BufferOutput {
 public:
  explicit CapturedVertices(const GladGLContext& gl) : BufferOutput(gl, GL_TRANSFORM_FEEDBACK_BUFFER) {}

 private:
  void execute(const GladGLContext& gl, GLuint program, std::size_t groups) const override {
    const GLint row = gl.GetUniformLocation(program, "row");
    const std::size_t vertices = groups * kComputeGroup;
    gl.Enable(GL_RASTERIZER_DISCARD);
    gl.BeginTransformFeedback(GL_POINTS);
    for (std::size_t first = 0; first < vertices; first += kGridSide) {
      gl.Uniform1i(row, static_cast<GLint>(first / kGridSide));
      gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(std::min(vertices - first, kGridSide)));
    }
    gl.EndTransformFeedback();
    gl.Disable(GL_RASTERIZER_DISCARD);
  }
};

class StoredInvocations final : public BufferOutput {
 public:
  explicit StoredInvocations(const GladGLContext& gl) : BufferOutput(gl, GL_SHADER_STORAGE_BUFFER) {}

 private:
  void execute(const GladGLContext& gl, GLuint, std::size_t groups) const override {
    gl.DispatchCompute(static_cast<GLuint>(groups), 1, 1);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  }
};

}  // namespace

GridSize grid_size(std::size_t points) {
  return {static_cast<GLsizei>(std::min(points, kGridSide)),
          static_cast<GLsizei>((points + kGridSide - 1) / kGridSide)};
}

std::unique_ptr<StageOutput> make_stage_output(const GladGLContext& gl, Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return std::make_unique<CapturedVertices>(gl);
    case Stage::compute:
      return std::make_unique<StoredInvocations>(gl);
    case Stage::fragment:
      break;
  }
  return std::make_unique<Pixels>(gl);
}

}  // namespace hn
