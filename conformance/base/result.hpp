// Errors as values: what was attempted, what went wrong, and the log of whoever refused.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace hn {

struct Error {
  std::string message;
  std::string log;  // a compiler's or a driver's own words, already translated to real files and lines; may be empty

  std::string text() const { return log.empty() ? message : message + "\n" + log; }
};

template <typename T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message, std::string log = {}) {
  return tl::unexpected<Error>(Error{std::move(message), std::move(log)});
}

}  // namespace hn
