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
#include "run/results.hpp"
#include "web/browser.hpp"

namespace hn {

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

}  // namespace hn
