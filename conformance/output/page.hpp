// Pages from Mustache templates (mustache.github.io).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace hn {

// {{x}} is escaped for HTML, {{{x}}} is not; {{> x}} is the template that data holds as the string x. A number is
// written as JSON writes it, so one that is to be rounded is put in as a string. null counts as false, and lists,
// objects and booleans write nothing.
// If a tag is reached and data has nothing for it, not even null, the error names the tag. So an absent list does not
// pass for an empty one. Tags in a section that is left out are not looked up.
Result<std::string> render_page(std::string_view mustache_template, const nlohmann::json& data);

}  // namespace hn
