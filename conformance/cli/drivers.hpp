// The ways to run cases on this machine, by name.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/driver/driver.hpp"
#include "gpu/evaluator.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/profile.hpp"
#include "run/results.hpp"
#include "web/browser.hpp"

namespace hn {

struct Driver {
  std::string name;
  std::string description;
  // The environment of the process that calls create. It is set before, because Mesa reads it when it is loaded.
  std::vector<std::array<std::string, 2>> environment = {};
  // An error names the part that this machine lacks.
  std::function<Result<std::unique_ptr<Context>>()> create = {};
  // The most points of one evaluation; fewer where evaluating takes long.
  std::size_t most_points = std::size_t{1} << 20;
  // In place of create, which then gives an error: who evaluates without OpenGL.
  Platform platform = Platform::opengl;
  std::function<Result<std::unique_ptr<Evaluator>>(const ReferenceCompiler&)> create_evaluator = {};
  // In place of both: the cases run in the page of this browser, and create gives an error.
  const Browser* browser = nullptr;

  bool is_reference_compiler() const { return name == kReferenceCompiler; }
  // Whether it has OpenGL ES or WebGL, and no desktop version.
  bool es_alone() const { return platform == Platform::opengl && (browser || name.ends_with("-gles")); }
  // The forms of shaders that it may take from a translator; whether a device does, its evaluator knows.
  std::vector<Form> takes() const;
  bool has_context() const { return !browser && !create_evaluator && !is_reference_compiler(); }
};

// Sets the environment of the process, and creates the context. Call it once in a process: Mesa reads the environment
// only once.
Result<std::unique_ptr<Context>> create_context(const Driver& driver);
// Creates an evaluator, on a context or without one. The compiler must live longer.
Result<std::unique_ptr<Evaluator>> create_evaluator(const Driver& driver, const ReferenceCompiler& compiler);

// How many devices this machine has of the kinds that are numbered.
struct DeviceCounts {
  int egl = 0;
  int vulkan = 0;
};

// The drivers that every machine may have, and one for each device.
std::vector<Driver> all_drivers(const DeviceCounts& devices);
// Sets the environment in which vulkan:N finds its devices.
void prepare_vulkan();
// Nothing if there is no driver of that name. egl-device:N and vulkan:N always are one, even if the device is missing.
std::optional<Driver> find_driver(std::string_view name);

}  // namespace hn
