#include "cli/drivers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <utility>

#include "gpu/evaluator.hpp"
#include "gpu/vulkan/device.hpp"
#include "gpu/vulkan_drivers.hpp"
#include "web/webgpu_evaluator.hpp"

namespace hn {
namespace {

constexpr std::string_view kEglDevice = "egl-device:";
constexpr std::string_view kGles = "-gles";
constexpr std::string_view kVulkan = "vulkan:";

// A way to a context that has both APIs, as two drivers.
template <typename Create>
void add_both(std::vector<Driver>& drivers, Driver driver, Create create) {
  Driver gles = driver;
  gles.name += kGles;
  gles.description += ", OpenGL ES";
  driver.create = [create] { return create(Api::gl); };
  gles.create = [create] { return create(Api::gles); };
  drivers.push_back(std::move(driver));
  drivers.push_back(std::move(gles));
}

// EGL with the driver that the environment names; without that driver Mesa takes another one.
CreatedContext create_mesa(Api api, std::string_view renderer) {
  auto context = create_egl(api);
  if (!context) return context;
  const auto* got = reinterpret_cast<const char*>((*context)->gl().GetString(GL_RENDERER));
  if (got && std::string_view(got).find(renderer) != std::string_view::npos) return context;
  return fail(fmt::format("EGL gives {}, which is not {}", got ? got : "nothing", renderer));
}

CreatedContext create_zink(Api api, const Result<std::string>& lavapipe) {
  if (!lavapipe) return fail(fmt::format("Mesa's lavapipe is not here: {}", lavapipe.error().message));
  return create_mesa(api, "zink");
}

void add_mesa_drivers(std::vector<Driver>& drivers) {
  // softpipe interprets a shader: a hundred times as slow as llvmpipe.
  add_both(drivers,
           {.name = "softpipe",
            .description = "Mesa's reference rasterizer, by EGL without a window",
            .environment = {{"GALLIUM_DRIVER", "softpipe"}, {"LIBGL_ALWAYS_SOFTWARE", "true"}},
            .most_points = std::size_t{1} << 12},
           [](Api api) { return create_mesa(api, "softpipe"); });
  const auto lavapipe = vulkan_drivers("lvp_icd");
  add_both(drivers,
           {.name = "zink",
            .description = "OpenGL on Vulkan on the CPU: Mesa's zink on lavapipe, by EGL without a window",
            .environment = {{"MESA_LOADER_DRIVER_OVERRIDE", "zink"},
                            {"LIBGL_ALWAYS_SOFTWARE", "true"},
                            {"VK_DRIVER_FILES", lavapipe.value_or("")},
                            {"VK_ICD_FILENAMES", lavapipe.value_or("")},  // the older name
                            {"NODEVICE_SELECT", "1"}}},  // a layer of Mesa's that queries a display server
           [lavapipe](Api api) { return create_zink(api, lavapipe); });
}

void add_glfw_drivers(std::vector<Driver>& drivers) {
  add_both(drivers, {.name = "glfw", .description = "A hidden window, by GLFW: GLX, WGL or Cocoa"},
           [](Api api) { return create_glfw(GlfwContext::native, api); });
  add_both(drivers, {.name = "glfw-egl", .description = "A hidden window, by GLFW and EGL"},
           [](Api api) { return create_glfw(GlfwContext::egl, api); });
  drivers.push_back({.name = "glfw-osmesa", .description = "A hidden window, by GLFW and OSMesa", .create = [] {
                       return create_glfw(GlfwContext::osmesa, Api::gl);
                     }});
}

// The drivers that every machine may have.
std::vector<Driver> common_drivers() {
  std::vector<Driver> drivers;
  drivers.push_back({.name = std::string(kReferenceCompiler),
                     .description = "Khronos' reference compiler, which draws nothing",
                     .create = [] { return CreatedContext(fail("glslang draws nothing")); }});
  drivers.push_back(
      {.name = "osmesa", .description = "Mesa's off-screen library, rendering on the CPU", .create = create_osmesa});
  add_both(
      drivers,
      {.name = "egl", .description = "EGL without a window: Mesa's surfaceless platform, else the first EGL device"},
      create_egl);
  add_mesa_drivers(drivers);
  add_glfw_drivers(drivers);
  drivers.push_back({.name = "metal-stand-in",
                     .description = "Metal's shading language as C++14, compiled by clang++: no GPU, and not Apple's",
                     .create = [] { return CreatedContext(fail("it runs the cases of the suite only")); },
                     .platform = Platform::metal,
                     .create_evaluator = [](const ReferenceCompiler&) { return create_metal_evaluator(); }});
  // Dawn needs more of Vulkan than lavapipe of Mesa 22.3 has.
  const auto add_webgpu = [&](const char* name, const char* description, WebGpu which) {
    drivers.push_back(
        {.name = name,
         .description = description,
         .environment = which == WebGpu::dawn ? vulkan_environment() : vulkan_environment({}),
         .create = [] { return CreatedContext(fail("it runs the cases of the suite only")); },
         .platform = Platform::webgpu,
         .create_evaluator = [which](const ReferenceCompiler&) { return create_webgpu_evaluator(which); }});
  };
  add_webgpu("wgpu", "WebGPU by wgpu, which is naga: Python's package", WebGpu::wgpu);
  add_webgpu("dawn", "WebGPU by Dawn, which has Tint: the package webgpu of Node.js", WebGpu::dawn);
  for (const Browser& browser : all_browsers()) {
    drivers.push_back({.name = std::string(browser.name),
                       .description = std::string(browser.description),
                       .create = [] { return CreatedContext(fail("a browser runs the cases of the suite only")); },
                       .platform = browser.platform,
                       .browser = &browser});
  }
  return drivers;
}

void add_egl_device(std::vector<Driver>& drivers, int number) {
  add_both(drivers,
           {.name = fmt::format("{}{}", kEglDevice, number),
            .description = fmt::format("EGL device {}, without a window", number)},
           [number](Api api) { return create_egl_device(number, api); });
}

void add_vulkan_device(std::vector<Driver>& drivers, int number) {
  drivers.push_back(
      {.name = fmt::format("{}{}", kVulkan, number),
       .description = fmt::format("Vulkan device {}, without OpenGL: SPIR-V in compute shaders", number),
       .environment = vulkan_environment(),
       .create = [] { return CreatedContext(fail("a device of Vulkan runs the cases of the suite only")); },
       .platform = Platform::vulkan,
       .create_evaluator =
           [number](const ReferenceCompiler& compiler) { return create_vulkan_evaluator(number, compiler); }});
}

// The N behind the prefix.
std::optional<int> device_number(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, number);
  if (error != std::errc() || stop != end || number < 0) return std::nullopt;
  return number;
}

void set_environment(const std::vector<std::array<std::string, 2>>& environment) {
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
}

}  // namespace

std::vector<Form> Driver::takes() const {
  if (browser || is_reference_compiler()) return {};
  switch (platform) {
    case Platform::opengl:
      return {es_alone() ? Form::glsl_es : Form::gl};
    case Platform::vulkan:
      return {Form::spirv, Form::glsl_es, Form::gl, Form::glsl, Form::hlsl};
    case Platform::metal:
      return {Form::msl};
    case Platform::webgpu:
      return name == "dawn" ? std::vector{Form::wgsl} : std::vector{Form::wgsl, Form::spirv};
  }
  return {};
}

CreatedContext create_context(const Driver& driver) {
  set_environment(driver.environment);
  return driver.create();
}

Result<std::unique_ptr<Evaluator>> create_evaluator(const Driver& driver, const ReferenceCompiler& compiler) {
  set_environment(driver.environment);
  if (driver.create_evaluator) return driver.create_evaluator(compiler);
  HN_TRY(auto context, driver.create());
  return evaluator_on(std::move(context));
}

std::vector<Driver> all_drivers(const DeviceCounts& devices) {
  std::vector<Driver> drivers = common_drivers();
  for (int number = 0; number < devices.egl; ++number) add_egl_device(drivers, number);
  for (int number = 0; number < devices.vulkan; ++number) add_vulkan_device(drivers, number);
  return drivers;
}

void prepare_vulkan() { set_environment(vulkan_environment()); }

std::optional<Driver> find_driver(std::string_view name) {
  std::vector<Driver> drivers = common_drivers();
  const std::string_view device = name.ends_with(kGles) ? name.substr(0, name.size() - kGles.size()) : name;
  if (const auto number = device_number(device, kEglDevice)) add_egl_device(drivers, *number);
  if (const auto number = device_number(name, kVulkan)) add_vulkan_device(drivers, *number);
  for (Driver& driver : drivers) {
    if (driver.name == name) return std::move(driver);
  }
  return std::nullopt;
}

}  // namespace hn
