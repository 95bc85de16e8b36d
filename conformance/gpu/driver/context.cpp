#include <fmt/format.h>

#include "gpu/driver/driver.hpp"

namespace hn {

Result<void> Context::load_functions(GLADloadfunc load, Api api) {
  api_ = api;
  const bool es = api == Api::gles;
  const int version = es ? gladLoadGLES2Context(&gl_, load) : gladLoadGLContext(&gl_, load);
  if (version == 0) return fail("the context was made, but its OpenGL functions cannot be loaded");
  const int major = GLAD_VERSION_MAJOR(version);
  const int minor = GLAD_VERSION_MINOR(version);
  const int lowest_minor = es ? 0 : 1;
  if (major < 3 || (major == 3 && minor < lowest_minor)) {
    return fail(fmt::format("the context offers OpenGL{} {}.{}; 3.{} or later is needed", es ? " ES" : "", major, minor,
                            lowest_minor));
  }
  return {};
}

}  // namespace hn
