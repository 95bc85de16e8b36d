// With a context the cases build a program, evaluate it over a grid of points, and read back the raw bits.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/driver/driver.hpp"
#include "gpu/stage_output.hpp"
#include "library/shaders.hpp"
#include "library/source.hpp"

namespace hn {

// A linked program. The context it was made in must be alive and current while it is.
class Program {
 public:
  // results_of: the stage whose output "result" is wanted, fragment or vertex.
  static Result<Program> build(const Context& context, const ShaderText& vertex, const ShaderText& fragment,
                               Stage results_of = Stage::fragment);
  static Result<Program> build_compute(const Context& context, const ShaderText& compute);
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  ~Program();

  GLuint id() const { return id_; }
  Stage results_of() const { return results_of_; }
  bool reads(const char* uniform) const;
  // Sets a uniform, if the program has it.
  void set(const char* uniform, std::int32_t value) const;
  void set(const char* uniform, std::uint32_t value) const;

 private:
  struct StageText;
  static Result<Program> link(const Context& context, std::span<const StageText> shaders, Stage results_of);
  Program(const GladGLContext& gl, GLuint id, Stage results_of) : gl_(&gl), id_(id), results_of_(results_of) {}
  const GladGLContext* gl_;
  GLuint id_;
  Stage results_of_;
};

// Empty if programs of the stage can be evaluated, whatever their version; else why not.
std::string unsupported_reason(const GladGLContext& gl, Stage stage);

// Compiles one shader and throws it away.
Result<void> compile_only(const Context& context, const ShaderText& shader, Stage stage);

// Evaluates a program at many points: a fragment, vertex or invocation per point, its input words in the textures
// "input_a" to "input_d" as far as it reads them, its result in a uvec4. Nothing is converted on the way in or out.
class GridRenderer {
 public:
  explicit GridRenderer(const Context& context);
  ~GridRenderer();
  GridRenderer(const GridRenderer&) = delete;
  GridRenderer& operator=(const GridRenderer&) = delete;

  // inputs: kInputWords per point, of at most 2^20 points. Returns kOutputWords per point.
  Result<std::vector<std::uint32_t>> evaluate(const Program& program, std::span<const std::uint32_t> inputs);

 private:
  void upload(std::size_t texture, std::span<const std::uint32_t> inputs, GLsizei grid_height);

  StageOutput& output_of(Stage stage);

  const GladGLContext& gl_;
  GLuint vertex_array_ = 0;
  GLuint framebuffer_ = 0;
  GLuint output_texture_ = 0;
  std::array<GLuint, kInputWords / 4> textures_ = {};    // of the inputs; 0 if no program has read them yet
  std::array<GLsizei, kInputWords / 4> rows_ = {};       // that each of them has
  std::array<std::unique_ptr<StageOutput>, 3> outputs_;  // by stage; made when they are first needed
};

}  // namespace hn
