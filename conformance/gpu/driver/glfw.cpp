// Contexts of a hidden window, by GLFW, as in a game.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "gpu/driver/driver.hpp"
#include "gpu/driver/library.hpp"
#include "gpu/driver/xvfb.hpp"

namespace hn {
namespace {

class GlfwWindowContext final : public Context {
 public:
  explicit GlfwWindowContext(Library library) : library_(library) {}
  ~GlfwWindowContext() override {
    if (window_) HN_FUNCTION(library_, glfwDestroyWindow)(window_);
    if (initialised_) HN_FUNCTION(library_, glfwTerminate)();
  }

  Result<void> start(GlfwContext kind, Api api) {
    HN_TRY(auto display, Xvfb::where_no_display());
    display_ = std::move(display);
    if (!HN_FUNCTION(library_, glfwInit)()) return fail(fmt::format("GLFW does not start: {}", last_error()));
    initialised_ = true;
    const auto hint = HN_FUNCTION(library_, glfwWindowHint);
    for (const auto& [major, minor] : versions_of(api)) {
      HN_FUNCTION(library_, glfwDefaultWindowHints)();
      hint(GLFW_VISIBLE, GLFW_FALSE);
      hint(GLFW_CONTEXT_CREATION_API, creation_api(kind));
      hint(GLFW_CLIENT_API, api == Api::gles ? GLFW_OPENGL_ES_API : GLFW_OPENGL_API);
      hint(GLFW_CONTEXT_VERSION_MAJOR, major);
      hint(GLFW_CONTEXT_VERSION_MINOR, minor);
      // Profiles came with OpenGL 3.2, and GLFW refuses a profile for an earlier version.
      const bool has_profiles = api == Api::gl && (major > 3 || minor >= 2);
      if (has_profiles) hint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
      if (has_profiles) hint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS gives no other
      window_ = HN_FUNCTION(library_, glfwCreateWindow)(kSize, kSize, "hn-conform", nullptr, nullptr);
      if (window_) break;
    }
    if (!window_) return fail(fmt::format("GLFW does not create a context: {}", last_error()));
    HN_FUNCTION(library_, glfwMakeContextCurrent)(window_);
    return load_functions(HN_FUNCTION(library_, glfwGetProcAddress), api);
  }

 private:
  static constexpr int kSize = 16;  // we draw into framebuffer objects

  static int creation_api(GlfwContext kind) {
    if (kind == GlfwContext::egl) return GLFW_EGL_CONTEXT_API;
    return kind == GlfwContext::osmesa ? GLFW_OSMESA_CONTEXT_API : GLFW_NATIVE_CONTEXT_API;
  }

  std::string last_error() const {
    const char* text = nullptr;
    HN_FUNCTION(library_, glfwGetError)(&text);
    return text ? text : "it gives no reason";
  }

  Xvfb display_;  // outlives the window
  Library library_;
  bool initialised_ = false;
  GLFWwindow* window_ = nullptr;
};

}  // namespace

CreatedContext create_glfw(GlfwContext kind, Api api) {
  HN_TRY(auto library, Library::open({"libglfw.so.3", "libglfw.3.dylib"}));
  auto context = std::make_unique<GlfwWindowContext>(library);
  HN_DO(context->start(kind, api));
  return context;
}

}  // namespace hn
