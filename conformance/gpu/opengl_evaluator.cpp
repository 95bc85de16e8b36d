// Functions evaluated by OpenGL.
#include <array>
#include <regex>
#include <utility>

#include "gpu/evaluator.hpp"
#include "gpu/gpu.hpp"

namespace hn {
namespace {

class LinkedProgram final : public Evaluable {
 public:
  LinkedProgram(GridRenderer& grid, Program program) : grid_(grid), program_(std::move(program)) {}

  Result<std::vector<std::uint32_t>> evaluate(std::span<const std::uint32_t> inputs) override {
    program_.set("trips", static_cast<std::int32_t>(uniforms.trips));
    program_.set("variant_seed", uniforms.variant_seed);
    return grid_.evaluate(program_, inputs);
  }

 private:
  GridRenderer& grid_;
  Program program_;
};

// A compute shader from a translator. The grid has its results in buffer 0.
class LoadedShader final : public Evaluable {
 public:
  LoadedShader(const GladGLContext& gl, GridRenderer& grid, Program program)
      : gl_(gl), grid_(grid), program_(std::move(program)) {
    gl_.GenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  }
  ~LoadedShader() override { gl_.DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data()); }

  // Invocations beyond the last point see zeros.
  Result<std::vector<std::uint32_t>> evaluate(std::span<const std::uint32_t> inputs) override {
    std::vector<std::uint32_t> points(inputs.begin(), inputs.end());
    points.resize(points.size() + kComputeGroup * kInputWords);
    fill(1, points);
    fill(2, std::array{uniforms.trips, uniforms.variant_seed});
    return grid_.evaluate(program_, inputs);
  }

 private:
  void fill(GLuint binding, std::span<const std::uint32_t> words) {
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffers_[binding - 1]);
    gl_.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(words.size_bytes()), words.data(), GL_STREAM_DRAW);
  }

  const GladGLContext& gl_;
  GridRenderer& grid_;
  Program program_;
  std::array<GLuint, 2> buffers_ = {};
};

// naga has the number of a buffer only in its name: "_group_0_binding_1_cs".
std::string with_bindings(const std::string& text) {
  static const std::regex kBuffer(R"(layout\(std430\)(?=[^{]*\{[^}]*\}?[^;{}]*_binding_(\d+)_))");
  return std::regex_replace(text, kBuffer, "layout(std430, binding = $1)");
}

class OpenGlEvaluator final : public Evaluator {
 public:
  explicit OpenGlEvaluator(const Context& context) : context_(context), info_(describe(context)), grid_(context) {}
  explicit OpenGlEvaluator(std::unique_ptr<Context> context)
      : own_(std::move(context)), context_(*own_), info_(describe(context_)), grid_(context_) {}

  const ContextInfo& info() const override { return info_; }

  std::string unsupported(const Profile& profile, Stage stage) const override {
    auto reason = unsupported_to_run(profile, info_.languages);
    return reason.empty() ? unsupported_reason(context_.gl(), stage) : reason;
  }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, const Evaluation& evaluation,
                                           std::string_view shader) override {
    HN_TRY(auto program, link(sources, evaluation, shader));
    return std::make_unique<LinkedProgram>(grid_, std::move(program));
  }

  std::vector<Form> takes() const override {
    std::vector<Form> forms;
    if (!unsupported_reason(context_.gl(), Stage::compute).empty()) return forms;
    if (info_.languages.gl_version >= 430) forms.push_back(Form::gl);
    if (info_.languages.es_version >= 310) forms.push_back(Form::glsl_es);
    return forms;
  }

  Result<std::unique_ptr<Evaluable>> load(const Code& code) override {
    HN_TRY(auto program, Program::build_compute(context_, {with_bindings(code.bytes), {}}));
    return std::make_unique<LoadedShader>(context_.gl(), grid_, std::move(program));
  }

  bool is_lost() const override {
    const GladGLContext& gl = context_.gl();
    if (gl.GetGraphicsResetStatus && gl.GetGraphicsResetStatus() != GL_NO_ERROR) return true;
    constexpr GLenum kContextLost = 0x0507;  // of OpenGL 4.5 and of KHR_robustness
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR; error = gl.GetError()) {
      if (error == kContextLost) return true;
    }
    return false;
  }

  const Context* context() const override { return &context_; }

 private:
  Result<Program> link(const SourceSet& sources, const Evaluation& evaluation, std::string_view shader) const {
    HN_TRY(const auto text, expand(sources, evaluation.profile, shader));
    if (evaluation.stage == Stage::compute) return Program::build_compute(context_, text);
    const bool of_vertices = evaluation.stage == Stage::vertex;
    HN_TRY(const auto other,
           expand(sources, evaluation.profile, of_vertices ? idle_fragment_shader() : vertex_shader()));
    return Program::build(context_, of_vertices ? text : other, of_vertices ? other : text, evaluation.stage);
  }

  std::unique_ptr<Context> own_;
  const Context& context_;
  const ContextInfo info_;
  GridRenderer grid_;
};

}  // namespace

std::unique_ptr<Evaluator> evaluator_on(const Context& context) { return std::make_unique<OpenGlEvaluator>(context); }

std::unique_ptr<Evaluator> evaluator_on(std::unique_ptr<Context> context) {
  return std::make_unique<OpenGlEvaluator>(std::move(context));
}

}  // namespace hn
