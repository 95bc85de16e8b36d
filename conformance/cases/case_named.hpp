// For tests that run a case by its id.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cases/case.hpp"

namespace hn {

inline Case case_named(std::string_view id) {
  const auto found = cases_with(std::array{std::string(id)});
  if (!found) throw std::logic_error(found.error().text());
  return found->front();
}

}  // namespace hn
