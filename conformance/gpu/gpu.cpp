#include "gpu/gpu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hn {
namespace {

// The log of a shader or a program, by the two functions that OpenGL has for each.
std::string info_log(PFNGLGETSHADERIVPROC get_parameter, PFNGLGETSHADERINFOLOGPROC get_log, GLuint id) {
  GLint length = 0;
  get_parameter(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  get_log(id, length, nullptr, log.data());
  return log.c_str();
}

GLenum gl_stage(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return GL_VERTEX_SHADER;
    case Stage::compute:
      return GL_COMPUTE_SHADER;
    case Stage::fragment:
      break;
  }
  return GL_FRAGMENT_SHADER;
}

class ShaderObject {
 public:
  ShaderObject(const GladGLContext& gl, Stage stage) : gl_(gl), stage_(stage), id_(gl.CreateShader(gl_stage(stage))) {}
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
    return fail(fmt::format("the driver does not compile the {} shader", name_of(stage_)),
                source.translate(info_log(gl_.GetShaderiv, gl_.GetShaderInfoLog, id_)));
  }

  GLuint id() const { return id_; }

 private:
  const GladGLContext& gl_;
  Stage stage_;
  GLuint id_;
};

constexpr auto kSide = static_cast<GLsizei>(kGridSide);

// Invocations beside the grid run along: pixels in blocks of 2 x 2 and, in llvmpipe, 4 x 4; those of a whole group; and
// in softpipe vertices, in fours, with any number that an older draw left there. The words of an older grid could send
// them into a loop of 2^32 turns: a GPU or softpipe hangs, and llvmpipe ends all the loops of the block after 65,535.
// So whole rows are written, and some rows more, with zeros beside the grid.
constexpr GLsizei kBlock = 4;
GLsizei whole_blocks(GLsizei pixels) { return (pixels + kBlock - 1) / kBlock * kBlock; }

// A texture without pixels yet, bound to the unit at hand.
GLuint make_texture(const GladGLContext& gl) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

// Gives the texture that is bound a grid of four words a point.
void allocate(const GladGLContext& gl, GLsizei rows) {
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, kSide, rows, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
}

}  // namespace

struct Program::StageText {
  Stage stage;
  const ShaderText& text;
};

Result<Program> Program::build(const Context& context, const ShaderText& vertex, const ShaderText& fragment,
                               Stage results_of) {
  const std::array<StageText, 2> shaders = {{{Stage::vertex, vertex}, {Stage::fragment, fragment}}};
  return link(context, shaders, results_of);
}

Result<Program> Program::build_compute(const Context& context, const ShaderText& compute) {
  const std::array<StageText, 1> shaders = {{{Stage::compute, compute}}};
  return link(context, shaders, Stage::compute);
}

Result<Program> Program::link(const Context& context, std::span<const StageText> shaders, Stage results_of) {
  const GladGLContext& gl = context.gl();
  Program program(gl, gl.CreateProgram(), results_of);
  for (const StageText& shader : shaders) {
    const ShaderObject object(gl, shader.stage);
    HN_DO(object.compile(shader.text));
    gl.AttachShader(program.id_, object.id());  // keeps it for as long as the program is
  }
  if (results_of == Stage::vertex) {
    const char* const captured = "result";
    gl.TransformFeedbackVaryings(program.id_, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  }
  if (gl.BindFragDataLocation) gl.BindFragDataLocation(program.id_, 0, "result");  // not in ES, where 0 is the only one
  // For those who count the instructions in it.
  if (gl.ProgramParameteri) gl.ProgramParameteri(program.id_, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  gl.LinkProgram(program.id_);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id_, GL_LINK_STATUS, &linked);
  if (linked) return program;
  const auto judged =
      std::find_if(shaders.begin(), shaders.end(), [&](const StageText& shader) { return shader.stage == results_of; });
  const std::string log = info_log(gl.GetProgramiv, gl.GetProgramInfoLog, program.id_);
  return fail("the driver does not link the program", judged->text.translate(log));
}

Program::Program(Program&& other) noexcept
    : gl_(other.gl_), id_(std::exchange(other.id_, 0)), results_of_(other.results_of_) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(id_, other.id_);
  std::swap(results_of_, other.results_of_);
  return *this;
}

Program::~Program() {
  if (id_ != 0) gl_->DeleteProgram(id_);
}

bool Program::reads(const char* uniform) const { return gl_->GetUniformLocation(id_, uniform) >= 0; }

void Program::set(const char* uniform, std::int32_t value) const {
  gl_->UseProgram(id_);
  gl_->Uniform1i(gl_->GetUniformLocation(id_, uniform), value);
}

void Program::set(const char* uniform, std::uint32_t value) const {
  gl_->UseProgram(id_);
  gl_->Uniform1ui(gl_->GetUniformLocation(id_, uniform), value);
}

std::string unsupported_reason(const GladGLContext& gl, Stage stage) {
  return stage == Stage::compute && !gl.DispatchCompute ? "this context has no compute shaders" : "";
}

Result<void> compile_only(const Context& context, const ShaderText& shader, Stage stage) {
  return ShaderObject(context.gl(), stage).compile(shader);
}

GridRenderer::GridRenderer(const Context& context) : gl_(context.gl()) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.ActiveTexture(GL_TEXTURE0);  // the other units are other people's
  output_texture_ = make_texture(gl_);
  allocate(gl_, kSide);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output_texture_, 0);
}

GridRenderer::~GridRenderer() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());  // 0 is none
  gl_.DeleteTextures(1, &output_texture_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

void GridRenderer::upload(std::size_t texture, std::span<const std::uint32_t> inputs, GLsizei grid_height) {
  const GLsizei width = kSide;
  const GLsizei height = whole_blocks(grid_height);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (std::size_t i = 0; i * kInputWords < inputs.size(); ++i) {
    std::copy_n(&inputs[i * kInputWords + texture * 4], 4, &words[i * 4]);
  }
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(texture));
  if (textures_[texture] == 0) textures_[texture] = make_texture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, textures_[texture]);
  if (rows_[texture] < height) {  // llvmpipe clears what it allocates: no more of it than somebody needs
    allocate(gl_, height);
    rows_[texture] = height;
  }
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words.data());
}

Result<std::vector<std::uint32_t>> GridRenderer::evaluate(const Program& program,
                                                          std::span<const std::uint32_t> inputs) {
  const std::size_t points = inputs.size() / kInputWords;
  if (points > kGridSide * kGridSide) throw std::logic_error(fmt::format("no grid has {} points", points));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return fail("this driver does not render to RGBA32UI, which OpenGL 3.0 requires");
  }
  while (gl_.GetError() != GL_NO_ERROR) {
  }
  constexpr std::array<const char*, kInputWords / 4> kInputs = {"input_a", "input_b", "input_c", "input_d"};
  for (std::size_t i = 0; i < kInputs.size(); ++i) {
    if (!program.reads(kInputs[i])) continue;
    upload(i, inputs, grid_size(points).height);
    program.set(kInputs[i], static_cast<std::int32_t>(i));
  }
  gl_.UseProgram(program.id());
  gl_.BindVertexArray(vertex_array_);
  auto words = output_of(program.results_of()).run(program.id(), points);
  if (!words) return words;
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) {
    return fail(fmt::format("OpenGL error {:#06x} while evaluating {} points", error, points));
  }
  return words;
}

StageOutput& GridRenderer::output_of(Stage stage) {
  auto& output = outputs_[static_cast<std::size_t>(stage)];
  if (!output) output = make_stage_output(gl_, stage);
  return *output;
}

}  // namespace hn
