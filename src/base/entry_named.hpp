// Looking up a name in one of our own tables.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace hn {

// The entry whose member has this value. Throws std::logic_error if there is none; its message has `what`: "profile".
template <typename Table, typename Member>
const auto& entry_named(const Table& table, Member member, std::string_view name, std::string_view what) {
  const auto found = std::ranges::find(table, name, member);
  if (found == std::ranges::end(table)) throw std::logic_error(fmt::format("there is no {} \"{}\"", what, name));
  return *found;
}

}  // namespace hn
