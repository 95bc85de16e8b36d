// A driver is one way to get a context. Each lives in a file of its own; drivers.cpp lists them.
#pragma once

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace hn {

enum class Api { gl, gles };  // desktop OpenGL, or OpenGL ES

// The versions of OpenGL to ask for, highest first, where an interface has no way to say "the highest".
inline constexpr std::array<std::array<int, 2>, 8> kGlVersions = {
    {{4, 6}, {4, 5}, {4, 3}, {4, 1}, {4, 0}, {3, 3}, {3, 2}, {3, 1}}};
inline constexpr std::array<std::array<int, 2>, 3> kGlesVersions = {{{3, 2}, {3, 1}, {3, 0}}};

inline std::span<const std::array<int, 2>> versions_of(Api api) {
  if (api == Api::gles) return kGlesVersions;
  return kGlVersions;
}

// A context, current on the thread that made it until it is destroyed.
class Context {
 public:
  virtual ~Context() = default;

  // A function that the context has not is null.
  const GladGLContext& gl() const { return gl_; }
  Api api() const { return api_; }

 protected:
  // To be called by the derived class once its context is current.
  Result<void> load_functions(GLADloadfunc load, Api api = Api::gl);

 private:
  GladGLContext gl_{};
  Api api_ = Api::gl;
};

struct Browser;  // web/browser.hpp

// Not a driver of OpenGL, but run like one: the cases that ask glslang alone.
inline constexpr std::string_view kReferenceCompiler = "glslang";

struct Driver {
  std::string name;
  std::string description;
  // Of the process in which create is called, set before: Mesa looks at it when it is loaded.
  std::vector<std::array<std::string, 2>> environment = {};
  // An error says what is missing on this machine.
  std::function<Result<std::unique_ptr<Context>>()> create = {};
  // Of one evaluation; fewer where evaluating takes long.
  std::size_t most_points = std::size_t{1} << 20;
  // In place of create: the cases run in its page. Not to be called by anybody else.
  const Browser* browser = nullptr;

  bool is_reference_compiler() const { return name == kReferenceCompiler; }
};

// Sets the environment of the process, and creates. Once in a process: what Mesa has read stays read.
Result<std::unique_ptr<Context>> create_context(const Driver& driver);

// Those that every machine may have, and those of so many EGL devices.
std::vector<Driver> all_drivers(int egl_devices);
// Nothing if there is no driver of that name; egl-device:N is one, whether there is such a device or not.
std::optional<Driver> find_driver(std::string_view name);

// The seam: a function per way to a context, each in a file of its own.
using CreatedContext = Result<std::unique_ptr<Context>>;
CreatedContext create_osmesa();
CreatedContext create_egl(Api api);
CreatedContext create_egl_device(int number, Api api);
int egl_device_count();
enum class GlfwContext { native, egl, osmesa };
CreatedContext create_glfw(GlfwContext kind, Api api);

}  // namespace hn
