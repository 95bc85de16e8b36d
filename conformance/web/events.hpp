// What somebody who runs cases tells while it does.
#pragma once

#include <functional>
#include <string>

#include "cases/case.hpp"

namespace hn {

// In this order: once who the driver is, or why it cannot be used here; then for each case that it begins and how it
// ended.
struct CaseEvents {
  std::function<void(const ContextInfo& info)> ready;
  std::function<void(const std::string& id)> started;
  std::function<void(const CaseResult& result)> finished;
  std::function<void(const std::string& why)> absent = {};  // in place of ready
};

}  // namespace hn
