// Errors as values: the attempt, the fault, and the log of whoever refused.
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

// HN_TRY(const auto words, compile(text)); declares a result's value, or returns its error from the function.
// HN_DO(write_file(path, text)); does so for a result that holds nothing.
#define HN_TRY(declaration, ...) HN_TRY_BY(HN_JOIN(result_, __LINE__), declaration, __VA_ARGS__)
#define HN_TRY_BY(result, declaration, ...)                      \
  auto result = (__VA_ARGS__);                                   \
  if (!result) return tl::unexpected(std::move(result).error()); \
  declaration = *std::move(result)
#define HN_DO(...)                                                                              \
  do {                                                                                          \
    if (auto result = (__VA_ARGS__); !result) return tl::unexpected(std::move(result).error()); \
  } while (false)
#define HN_JOIN(a, b) HN_JOIN_NOW(a, b)
#define HN_JOIN_NOW(a, b) a##b
