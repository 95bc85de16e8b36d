// An evaluator whose shaders go a way before they come to another evaluator.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
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

// Its languages are the profiles of the cases that the way takes. The compiler must live longer.
std::unique_ptr<Evaluator> evaluator_through(Way way, std::unique_ptr<Evaluator> inner,
                                             const ReferenceCompiler& compiler, WgslText wgsl,
                                             Translating translating = {});

}  // namespace hn
