// Events are what a runner of cases reports while it runs.
#pragma once

#include <functional>
#include <string>

#include "cases/case.hpp"

namespace hn {

// The order is: once the driver's information, or why it cannot be used here; then, for each case, that it begins and
// how it ended.
struct CaseEvents {
  std::function<void(const ContextInfo& info)> ready;
  std::function<void(const std::string& id)> started;
  std::function<void(const CaseResult& result)> finished;
  std::function<void(const std::string& why)> absent = {};  // in place of ready
};

}  // namespace hn
