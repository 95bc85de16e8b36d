#include "expected/verdict.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace hn {
namespace {

constexpr std::uint64_t kMostUlpsTold = 1000;

}  // namespace

std::string_view name_of(Status status) {
  constexpr std::array kNames = {"pass", "warning", "fail", "unsupported", "crash", "timeout", "error"};
  static_assert(kNames.size() == kStatuses.size(), "a name for each, in their order");
  return kNames.at(static_cast<std::size_t>(status));
}

std::optional<Status> status_named(std::string_view name) {
  for (const Status status : kStatuses) {
    if (name_of(status) == name) return status;
  }
  return std::nullopt;
}

bool is_bad(Status status) {
  return status != Status::pass && status != Status::warning && status != Status::unsupported;
}

std::string measure_of(const Outcome& outcome) {
  if (outcome.samples == 0) return "";
  const std::string wrong = fmt::format("{} of {} values are wrong", outcome.mismatches, outcome.samples);
  if (outcome.max_abs == 0.0) return wrong;
  if (outcome.max_abs == std::numeric_limits<double>::max()) return wrong + ", some of them infinite or not a number";
  if (!outcome.allowed || *outcome.allowed >= outcome.max_abs)
    return wrong;  // where less is allowed, they are off by less
  if (*outcome.allowed > 0.0) {
    return fmt::format("{}; the largest difference is {:.3g}, and {:.3g} is allowed", wrong, outcome.max_abs,
                       *outcome.allowed);
  }
  const bool few = outcome.max_ulp != 0 && outcome.max_ulp <= kMostUlpsTold;
  const std::string units =
      few ? fmt::format(" ({} {} in the last place)", outcome.max_ulp, outcome.max_ulp == 1 ? "unit" : "units") : "";
  return fmt::format("{}; the largest difference is {:.3g}{}, and none is allowed", wrong, outcome.max_abs, units);
}

Outcome outcome_with(Status status, const Error& error) {
  Outcome outcome;
  outcome.status = status;
  outcome.message = error.text();
  return outcome;
}

bool as_expected(const CaseResult& result) {
  const Status status = result.outcome.status;
  if (is_bad(status)) return !result.excuse.empty();
  return result.excuse.empty() || status == Status::unsupported;
}

std::string_view function_of(std::string_view id) { return id.substr(0, id.find('.', id.find('.') + 1)); }

}  // namespace hn
