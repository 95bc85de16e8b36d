// Describes the demand of each check, for docs/reference/checks.md.
#pragma once

#include <span>
#include <string_view>

namespace hn {

struct CheckDescription {
  std::string_view check;  // the last part of a case's id
  std::string_view text;   // sentences, in Markdown
};

// Every check, in the order of the page.
std::span<const CheckDescription> check_descriptions();

}  // namespace hn
