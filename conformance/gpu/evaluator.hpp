// An evaluator evaluates functions at points, and describes itself: a context of OpenGL, or something else. The cases
// that look at values do not know which.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "gpu/context_info.hpp"
#include "gpu/driver/driver.hpp"
#include "gpu/reference_compiler.hpp"
#include "gpu/way/way.hpp"
#include "library/profile.hpp"
#include "library/shaders.hpp"
#include "library/source.hpp"

namespace hn {

// A function of the library, ready to be evaluated.
class Evaluable {
 public:
  virtual ~Evaluable() = default;

  // Evaluates it at many points. inputs: kInputWords per point, of at most 2^20 points. Returns kOutputWords per point.
  // Nothing is converted on the way in or out.
  virtual Result<std::vector<std::uint32_t>> evaluate(std::span<const std::uint32_t> inputs) = 0;

  // The values of the uniforms that some shapes of a shader read.
  struct Uniforms {
    std::uint32_t trips = kLoopTrips;
    std::uint32_t variant_seed = kVariantSeed;
  };
  Uniforms uniforms;
};

class WayEvaluator;  // gpu/way/evaluator.hpp

class Evaluator {
 public:
  virtual ~Evaluator() = default;

  virtual const ContextInfo& info() const = 0;
  // Empty if it evaluates functions in this version and stage, else why not.
  virtual std::string unsupported(const Profile& profile, Stage stage) const = 0;
  // shader: evaluation_shader(evaluation). The result must not outlive this.
  virtual Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, const Evaluation& evaluation,
                                                   std::string_view shader) = 0;
  // Whether it broke and never evaluates anything again. Then its destructor may hang.
  virtual bool is_lost() const = 0;
  // For work in OpenGL alone; null elsewhere.
  virtual const Context* context() const = 0;

  // The forms that load() takes, the best first.
  virtual std::vector<Form> takes() const { return {}; }
  // Builds a compute shader of others: over buffers of results (binding 0), points (1) and uniforms (2), as those of
  // the suite's own for Vulkan. The result must not outlive this.
  virtual Result<std::unique_ptr<Evaluable>> load(const Code& code) {
    return fail(fmt::format("this driver takes no {} of others", name_of(code.form)));
  }

  // This, if its shaders go a way; else null.
  virtual WayEvaluator* way() { return nullptr; }
};

// On a context that lives longer, or on one of its own.
std::unique_ptr<Evaluator> evaluator_on(const Context& context);
std::unique_ptr<Evaluator> evaluator_on(std::unique_ptr<Context> context);

// On the device of that number. An error names the part that this machine lacks.
Result<std::unique_ptr<Evaluator>> create_vulkan_evaluator(int number, const ReferenceCompiler& compiler);

// An error names the part that this machine lacks.
Result<std::unique_ptr<Evaluator>> create_metal_evaluator();

}  // namespace hn
