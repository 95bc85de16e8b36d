// An evaluator whose shaders go a way before they come to another evaluator.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gpu/evaluator.hpp"
#include "gpu/way/way.hpp"

namespace hn {

// Writes a case's shader in WGSL. The caller gives it, since this room does not see the one that translates.
using WgslText = std::function<Result<std::string>(const SourceSet&, const Evaluation&)>;

struct Translating {
  std::chrono::milliseconds limit{30000};  // for a translator, which is then killed with all that it started
  std::filesystem::path kept = {};         // a folder for the inputs of steps that are at fault; none if it is empty
};

// Its languages are the profiles of the cases that the way takes.
class WayEvaluator : public Evaluator {
 public:
  virtual const Way& steps() const = 0;
  // Takes only the first steps from now on, without one of them that keeps the form, if one is named. The suite's own
  // compilers complete their result, or, with no step, the driver's own language stands for it. False if the driver
  // cannot run it.
  virtual bool use_steps(std::size_t count, std::optional<std::size_t> without = {}) = 0;
  // Names the files of the next shaders. They are kept where a step fails, or the driver refuses its result; or always.
  virtual void start(std::string_view name, bool keep_always) = 0;

  struct FailedStep {
    StepEnd end;
    std::size_t number;  // from 1
  };
  // The step that failed for the last shader.
  virtual std::optional<FailedStep> failed_step() const = 0;
  // The file that a step gets, from the folder on that holds all that is kept: "ways/NAME/1-spirv-opt.spv".
  virtual std::string input_of(std::size_t number) const = 0;
};

// The compiler must live longer.
std::unique_ptr<WayEvaluator> evaluator_through(Way way, std::unique_ptr<Evaluator> inner,
                                                const ReferenceCompiler& compiler, WgslText wgsl,
                                                Translating translating = {});

}  // namespace hn
