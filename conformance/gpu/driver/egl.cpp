#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <utility>
#include <vector>

#include "gpu/driver/driver.hpp"
#include "gpu/driver/library.hpp"

namespace hn {
namespace {

class EglContext final : public Context {
 public:
  EglContext(Library library, Api api) : library_(library), wanted_(api) {}
  ~EglContext() override {
    if (display_ == EGL_NO_DISPLAY) return;
    if (context_ != EGL_NO_CONTEXT) {
      HN_FUNCTION(library_, eglMakeCurrent)(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      HN_FUNCTION(library_, eglDestroyContext)(display_, context_);
    }
    HN_FUNCTION(library_, eglTerminate)(display_);
  }

  Result<void> start_surfaceless() { return start_on(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY); }

  Result<void> start_on_device(int number) {
    HN_TRY(const auto devices, find_devices());
    if (number >= static_cast<int>(devices.size())) {
      return fail(fmt::format("there is no EGL device {}; EGL finds {}", number, devices.size()));
    }
    return start_on(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(number)]);
  }

  Result<void> start_on_first_device() { return start_on_device(0); }

  Result<std::vector<EGLDeviceEXT>> find_devices() const {
    const auto query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    if (!query_devices) return fail("this EGL has no EGL_EXT_device_enumeration");
    EGLint count = 0;
    if (!query_devices(0, nullptr, &count)) return fail("EGL does not enumerate its devices");
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (count > 0 && !query_devices(count, devices.data(), &count)) return fail("EGL does not enumerate its devices");
    devices.resize(static_cast<std::size_t>(count));
    return devices;
  }

 private:
  template <typename Pointer>
  Pointer extension(const char* name) const {
    return reinterpret_cast<Pointer>(HN_FUNCTION(library_, eglGetProcAddress)(name));
  }

  Result<void> start_on(EGLenum platform, void* native) {
    const auto get_platform_display = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (!get_platform_display) return fail("this EGL has no EGL_EXT_platform_base");
    display_ = get_platform_display(platform, native, nullptr);
    if (display_ == EGL_NO_DISPLAY) return fail("EGL has no display on this platform");
    EGLint major = 0;
    EGLint minor = 0;
    if (!HN_FUNCTION(library_, eglInitialize)(display_, &major, &minor)) {
      display_ = EGL_NO_DISPLAY;
      return fail("EGL does not initialise on this platform");
    }
    const bool es = wanted_ == Api::gles;
    if (!HN_FUNCTION(library_, eglBindAPI)(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) {
      return fail(fmt::format("EGL has no {} here", es ? "OpenGL ES" : "desktop OpenGL"));
    }
    // A context that reports when it is lost, where the driver has it.
    for (const bool robust : {true, false}) {
      if (context_ == EGL_NO_CONTEXT) create(robust);
    }
    if (context_ == EGL_NO_CONTEXT) {
      return fail(fmt::format("EGL does not create a {}",
                              es ? "context of OpenGL ES 3.0 or later" : "core context of OpenGL 3.1 or later"));
    }
    if (!HN_FUNCTION(library_, eglMakeCurrent)(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      return fail("EGL does not make a context current without a surface");
    }
    return load_functions(HN_FUNCTION(library_, eglGetProcAddress), wanted_);
  }

  // No configuration and no surface: we draw into framebuffer objects only. A driver may give exactly the version that
  // we request, so we try the highest first.
  void create(bool robust) {
    for (const auto& [major_version, minor_version] : versions_of(wanted_)) {
      std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION, major_version, EGL_CONTEXT_MINOR_VERSION,
                                        minor_version};
      if (wanted_ == Api::gl) {  // ES has no profiles
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
      }
      if (robust) {
        attributes.insert(attributes.end(),
                          {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
      }
      attributes.push_back(EGL_NONE);
      context_ =
          HN_FUNCTION(library_, eglCreateContext)(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
      if (context_ != EGL_NO_CONTEXT) return;
    }
  }

  Library library_;
  Api wanted_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

Result<Library> open_egl() { return Library::open({"libEGL.so.1", "libEGL.so"}); }

}  // namespace

CreatedContext create_egl_device(int number, Api api) {
  HN_TRY(auto library, open_egl());
  auto context = std::make_unique<EglContext>(library, api);
  HN_DO(context->start_on_device(number));
  return context;
}

int egl_device_count() {
  auto library = open_egl();
  if (!library) return 0;
  const auto devices = EglContext(*library, Api::gl).find_devices();
  return devices ? static_cast<int>(devices->size()) : 0;
}

CreatedContext create_egl(Api api) {
  HN_TRY(auto library, open_egl());
  std::string why;
  for (const auto& [name, start] : {std::pair{"surfaceless", &EglContext::start_surfaceless},
                                    std::pair{"device", &EglContext::start_on_first_device}}) {
    auto context = std::make_unique<EglContext>(library, api);
    const auto started = (*context.*start)();
    if (started) return context;
    why += fmt::format("{}{}: {}", why.empty() ? "" : "; ", name, started.error().message);
  }
  return fail(why);
}

}  // namespace hn
