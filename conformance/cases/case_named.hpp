// For tests that run a case by its id.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "cases/case.hpp"

namespace hn {

// Each list is made once for a process, and that of thorough runs, which is ten times as long, only if it is needed.
inline const Case& case_named(std::string_view id) {
  static std::map<Scope, std::vector<Case>> lists;
  for (const Scope scope : {Scope::covered, Scope::thorough}) {
    auto list = lists.find(scope);
    if (list == lists.end()) list = lists.emplace(scope, all_cases(scope)).first;
    const auto found = std::ranges::find(list->second, id, &Case::id);
    if (found != list->second.end()) return *found;
  }
  ADD_FAILURE() << "there is no case " << id;
  return lists.at(Scope::covered).front();
}

}  // namespace hn
