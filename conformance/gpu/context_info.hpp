// A ContextInfo has a context's description of itself, and the versions of the language that it accepts.
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
  // The system in a browser's page: "Linux", "Firefox 140". A driver of this machine has none.
  std::string system = {};
  std::string browser = {};
};

ContextInfo describe(const Context& context);

}  // namespace hn
