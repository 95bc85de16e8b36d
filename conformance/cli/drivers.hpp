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
  // The environment of the process that calls create. It is set before, because Mesa reads it when it is loaded.
  std::vector<std::array<std::string, 2>> environment = {};
  // An error says what is missing on this machine.
  std::function<Result<std::unique_ptr<Context>>()> create = {};
  // The most points of one evaluation; fewer where evaluating takes long.
  std::size_t most_points = std::size_t{1} << 20;
  // In place of create: the cases run in the page of this browser, and create gives an error.
  const Browser* browser = nullptr;

  bool is_reference_compiler() const { return name == kReferenceCompiler; }
};

// Sets the environment of the process, and creates the context. Call it once in a process: Mesa reads the environment
// only once.
Result<std::unique_ptr<Context>> create_context(const Driver& driver);

// The drivers that every machine may have, and one for each EGL device.
std::vector<Driver> all_drivers(int egl_devices);
// Nothing if there is no driver of that name. egl-device:N always is one, even if the device is missing.
std::optional<Driver> find_driver(std::string_view name);

}  // namespace hn
