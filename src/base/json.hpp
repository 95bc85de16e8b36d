// Text of JSON; and JSON from outside: results.json and journals, which may be damaged, or made by somebody else.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hn {

// Every function that reads throws std::invalid_argument for wrong input, with a message that names the fault.

// Copying, comparing and printing JSON takes stack for every level, so the depth is limited. We write ten levels, and
// the limit is far above that.
constexpr int kDeepestJson = 64;
nlohmann::json parse_json(std::string_view text);

const nlohmann::json& member_at(const nlohmann::json& json, const char* name);
std::string text_at(const nlohmann::json& json, const char* name);

// A loop over JSON that is not a list treats it as one. So this throws unless it is a list.
const nlohmann::json& list_at(const nlohmann::json& json, const char* name);

// get<> takes true for 1, 1.5 for 1, and -1 for the largest number.
std::uint64_t whole_number_at(const nlohmann::json& json, const char* name);
std::vector<std::uint32_t> words_at(const nlohmann::json& json, const char* name);  // a list
std::vector<std::string> texts_at(const nlohmann::json& json, const char* name);    // a list
double number_at(const nlohmann::json& json, const char* name);

// The text of JSON. A driver's log may hold any bytes; those that are not UTF-8 are replaced.
template <typename Json>
std::string dump(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hn
