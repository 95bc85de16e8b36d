#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "driver.hpp"

namespace hn {
namespace {

constexpr std::string_view kEglDevice = "egl-device:";

// Those that every machine may have.
std::vector<Driver> common_drivers() {
  return {
      {"osmesa", "Mesa's off-screen library, rendering on the CPU", create_osmesa},
      {"egl", "EGL without a window: Mesa's surfaceless platform, else the first EGL device", create_egl},
  };
}

Driver egl_device(int number) {
  return {fmt::format("{}{}", kEglDevice, number), fmt::format("EGL device {}, without a window", number),
          [number] { return create_egl_device(number); }};
}

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

std::vector<Driver> all_drivers() {
  std::vector<Driver> drivers = common_drivers();
  for (int number = 0; number < egl_device_count(); ++number) drivers.push_back(egl_device(number));
  return drivers;
}

std::optional<Driver> find_driver(std::string_view name) {
  for (Driver& driver : common_drivers()) {
    if (driver.name == name) return std::move(driver);
  }
  int number = 0;
  const char* const end = name.data() + name.size();
  if (name.starts_with(kEglDevice)) {
    const auto [stop, error] = std::from_chars(name.data() + kEglDevice.size(), end, number);
    if (error == std::errc() && stop == end && number >= 0) return egl_device(number);
  }
  return std::nullopt;
}

}  // namespace hn
