// What a context says about itself, and which versions of the language it accepts.
#pragma once

#include <string>

#include "gpu/driver/driver.hpp"
#include "library/profile.hpp"

namespace hn {

struct ContextInfo {
  std::string vendor;
  std::string renderer;
  std::string gl_version;
  std::string glsl_version;
  LanguageSupport languages;
};

ContextInfo describe(const Context& context);

}  // namespace hn
