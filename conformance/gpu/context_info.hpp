// A ContextInfo has what a context says about itself, and which versions of the language it accepts.
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
  // What the page of a browser says: "Linux", "Firefox 140". A driver of this machine says neither.
  std::string system = {};
  std::string browser = {};
};

ContextInfo describe(const Context& context);

}  // namespace hn
