#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "driver.hpp"

namespace hn {
namespace {

constexpr std::array kDrivers = {
    Driver{"osmesa", "Mesa's off-screen library, rendering on the CPU", create_osmesa},
    Driver{"egl", "EGL without a window: Mesa's surfaceless platform, else the first EGL device", create_egl},
};

}  // namespace

Result<void> Context::load_functions(GLADloadfunc load) {
  const int version = gladLoadGLContext(&gl_, load);
  if (version == 0) return fail("the context was made, but its OpenGL functions cannot be loaded");
  const int major = GLAD_VERSION_MAJOR(version);
  const int minor = GLAD_VERSION_MINOR(version);
  if (major < 3 || (major == 3 && minor < 1)) {
    return fail(fmt::format("the context offers OpenGL {}.{}; 3.1 or later is needed", major, minor));
  }
  return {};
}

std::span<const Driver> all_drivers() { return kDrivers; }

const Driver* find_driver(std::string_view name) {
  const auto found = std::find_if(kDrivers.begin(), kDrivers.end(), [&](const Driver& d) { return d.name == name; });
  return found == kDrivers.end() ? nullptr : &*found;
}

}  // namespace hn
