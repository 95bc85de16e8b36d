// A driver is one way to get a context. Each lives in a file of its own; drivers.cpp lists them.
#pragma once

#include <glad/gl.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../result.hpp"

namespace hn {

// The versions of OpenGL to ask for, highest first, where an interface has no way to say "the highest".
constexpr std::array<std::array<int, 2>, 8> kContextVersions = {
    {{4, 6}, {4, 5}, {4, 3}, {4, 1}, {4, 0}, {3, 3}, {3, 2}, {3, 1}}};

// A context, current on the thread that made it until it is destroyed.
class Context {
 public:
  virtual ~Context() = default;

  const GladGLContext& gl() const { return gl_; }

 protected:
  // To be called by the derived class once its context is current.
  Result<void> load_functions(GLADloadfunc load);

 private:
  GladGLContext gl_{};
};

struct Driver {
  std::string name;
  std::string description;
  // An error says what is missing on this machine.
  std::function<Result<std::unique_ptr<Context>>()> create;
};

// Those that every machine may have, and one for each EGL device of this one, which EGL is asked for.
std::vector<Driver> all_drivers();
// Nothing if there is no driver of that name; egl-device:N is one, whether there is such a device or not.
std::optional<Driver> find_driver(std::string_view name);

// The seam: one function per driver, each in driver/<name>.cpp.
Result<std::unique_ptr<Context>> create_osmesa();
Result<std::unique_ptr<Context>> create_egl();
Result<std::unique_ptr<Context>> create_egl_device(int number);
int egl_device_count();

}  // namespace hn
