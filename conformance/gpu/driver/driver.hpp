// A driver is one way to get a context. Each lives in a file of its own; cli/drivers.cpp lists them.
#pragma once

#include <glad/gl.h>

#include <array>
#include <memory>
#include <span>

#include "base/result.hpp"

namespace hn {

enum class Api { gl, gles };  // desktop OpenGL, or OpenGL ES

// The versions of OpenGL to ask for, highest first, where an interface has no way to name "the highest".
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

  // A function that the context lacks is null.
  const GladGLContext& gl() const { return gl_; }
  Api api() const { return api_; }

 protected:
  // The derived class calls this once its context is current.
  Result<void> load_functions(GLADloadfunc load, Api api = Api::gl);

 private:
  GladGLContext gl_{};
  Api api_ = Api::gl;
};

// The seam: a function per way to a context, each in a file of its own.
using CreatedContext = Result<std::unique_ptr<Context>>;
CreatedContext create_osmesa();
CreatedContext create_egl(Api api);
CreatedContext create_egl_device(int number, Api api);
int egl_device_count();
enum class GlfwContext { native, egl, osmesa };
CreatedContext create_glfw(GlfwContext kind, Api api);

}  // namespace hn
