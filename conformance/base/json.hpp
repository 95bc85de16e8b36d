// Text of JSON; and JSON from outside: results.json and journals, which may be damaged, or made by somebody else.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hn {

// What is wrong is thrown by all that read: nlohmann::json::exception or std::invalid_argument.

// To copy, to compare and to print JSON takes stack for every level, so it may be nested only so deep: far deeper than
// anything that we write, which has ten levels.
constexpr int kDeepestJson = 64;
nlohmann::json parse_json(std::string_view text);

// To go over something that is no list goes over it as if it were one.
const nlohmann::json& list_at(const nlohmann::json& json, const char* name);

// get<> takes true for 1, 1.5 for 1, and -1 for the largest number.
std::uint64_t whole_number_at(const nlohmann::json& json, const char* name);
std::vector<std::uint32_t> words_at(const nlohmann::json& json, const char* name);  // a list
double number_at(const nlohmann::json& json, const char* name);

// The text of JSON. A driver's log may hold any bytes; those that are no UTF-8 are replaced.
template <typename Json>
std::string dump(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hn
