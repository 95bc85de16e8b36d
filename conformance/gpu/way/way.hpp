// The way of a shader from the suite to a driver: the translators that it goes through.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace hn {

// The languages of shaders between translators: GLSL for Vulkan (4.50), OpenGL (4.30) and ES (3.10), and others.
enum class Form { glsl, gl, glsl_es, spirv, hlsl, slang, dxbc, dxil, msl, wgsl };
std::string_view name_of(Form form);  // "glsl-es", as in options
std::optional<Form> form_named(std::string_view name);
// The ending of its files, by which some translators know it: ".spv".
std::string_view ending_of(Form form);

// A compute shader.
struct Code {
  Form form;
  std::string bytes;  // a text, or the bytes of a module
};

// The options of a run that name its way.
struct WayOptions {
  // In the order in which they translate: NAME[:FORM][=PROGRAM] of a known translator, or a command with {in} and
  // {out}. FORM is the one that it is to give. NAME:FORM:FORM has the one that it takes as well.
  std::vector<std::string> through = {};
  // The forms that the commands take and give, one of each for each command.
  std::vector<std::string> takes = {};
  std::vector<std::string> gives = {};
  // The profiles of the cases to be run, which the way has to have one of; empty: all of the suite.
  std::vector<std::string> profiles = {};
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WayOptions, through, takes, gives, profiles)

// A translation by one program.
struct Step {
  std::string name;                  // "spirv-opt"; of a command its program
  std::vector<std::string> command;  // with {in} and {out} for the files
  Form takes;
  Form gives;
  std::string version;               // as the program prints it; empty if it prints none
  std::string spec;                  // as in the options
  bool repeats_decorations = false;  // in its SPIR-V, where valid SPIR-V has each once

  std::string text() const;  // "spirv-opt 2023.1"
  std::vector<std::string> command_for(const std::string& in, const std::string& out) const;
};

// How a step ends that does not do its work. not_completed: it may have done it, but the way has no form for the
// shader, or the suite cannot complete its result.
enum class StepEnd { refused, gave_invalid, crashed, hung, not_completed };

struct Way {
  std::vector<Step> steps;

  bool empty() const { return steps.empty(); }
  std::string text() const;  // "spirv-opt 2023.1, spirv-cross 2021-01-15 to glsl-es"
  // The profiles of the cases that it takes: the suite writes their shaders in the form that the first step takes.
  std::vector<std::string> sources() const;
  // The form or translator that does not keep operations apart: GLSL ES 3.10, WGSL, or naga, to which `precise` means
  // nothing. Empty if all do.
  std::string contracts() const;
};

// The way that the options describe, to a driver that takes one of these forms; without any to any form. An error gives
// the place that is wrong, and what would be right.
Result<Way> find_way(const WayOptions& options, std::span<const Form> driver_takes);

// A translator that can be named, whether it is here or not.
struct KnownTranslator {
  std::string name;
  std::string forms;    // "spirv to glsl-es, gl, hlsl, msl"
  std::string program;  // that would run
  Result<std::string> version;
};
std::vector<KnownTranslator> known_translators();

}  // namespace hn
