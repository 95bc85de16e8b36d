// For tests that are about one configuration.
#pragma once

#include <string_view>

#include "library/functions.hpp"

namespace hn {

inline const Configuration& configuration_named(std::string_view name) {
  for (const Configuration& configuration : all_configurations()) {
    if (configuration.name == name) return configuration;
  }
  return default_configuration();
}

}  // namespace hn
