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
// A tag that is reached and that data has nothing for, not even null, is an error that names it; so an absent list does
// not pass for an empty one. What stands in a section that is left out is not looked up.
Result<std::string> render_page(std::string_view mustache_template, const nlohmann::json& data);

}  // namespace hn
