// What the cases do with a context: build a program, evaluate it over a grid of points, read back the raw bits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "driver/driver.hpp"
#include "functions.hpp"
#include "result.hpp"
#include "source.hpp"

namespace hn {

// A linked program. The context it was made in must be alive and current while it is.
class Program {
 public:
  static Result<Program> build(const Context& context, const ShaderText& vertex, const ShaderText& fragment);
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  ~Program();

  GLuint id() const { return id_; }

 private:
  Program(const GladGLContext& gl, GLuint id) : gl_(&gl), id_(id) {}
  const GladGLContext* gl_;
  GLuint id_;
};

// Compiles one shader and throws it away.
Result<void> compile_only(const Context& context, const ShaderText& shader, Stage stage);

// Evaluates a program at many points: a fragment per point, its input words in the textures "input_a" and "input_b",
// its result in a uvec4. Nothing is converted on the way in or out.
class GridRenderer {
 public:
  explicit GridRenderer(const Context& context);
  ~GridRenderer();
  GridRenderer(const GridRenderer&) = delete;
  GridRenderer& operator=(const GridRenderer&) = delete;

  // inputs: kInputWords per point, of at most 2^20 points. Returns kOutputWords per point.
  Result<std::vector<std::uint32_t>> evaluate(const Program& program, std::span<const std::uint32_t> inputs);

 private:
  void upload(std::span<const std::uint32_t> inputs, GLsizei width, GLsizei height);

  const GladGLContext& gl_;
  GLuint vertex_array_ = 0;
  GLuint framebuffer_ = 0;
  GLuint textures_[3] = {};  // input a, input b, output
};

}  // namespace hn
