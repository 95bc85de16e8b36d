#include "base/verdict.hpp"

namespace hn {

std::string_view name_of(Status status) {
  switch (status) {
    case Status::pass:
      return "pass";
    case Status::warning:
      return "warning";
    case Status::fail:
      return "fail";
    case Status::unsupported:
      return "unsupported";
    case Status::crash:
      return "crash";
    case Status::timeout:
      return "timeout";
    case Status::error:
      break;
  }
  return "error";
}

std::optional<Status> status_named(std::string_view name) {
  for (const Status status : kStatuses) {
    if (name_of(status) == name) return status;
  }
  return std::nullopt;
}

bool is_bad(Status status) {
  switch (status) {
    case Status::pass:
    case Status::warning:
    case Status::unsupported:
      return false;
    case Status::fail:
    case Status::crash:
    case Status::timeout:
    case Status::error:
      break;
  }
  return true;
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
