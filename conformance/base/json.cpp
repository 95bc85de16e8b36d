#include "base/json.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace hn {

nlohmann::json parse_json(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  return nlohmann::json::parse(text, [](int depth, Event event, const nlohmann::json&) {
    const bool opens = event == Event::object_start || event == Event::array_start;
    if (opens && depth >= kDeepestJson) {
      throw std::invalid_argument(fmt::format("it is nested deeper than {} levels", kDeepestJson));
    }
    return true;
  });
}

const nlohmann::json& list_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& list = json.at(name);
  if (!list.is_array()) throw std::invalid_argument(fmt::format("\"{}\" is not a list", name));
  return list;
}

std::uint64_t whole_number_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& number = json.at(name);
  if (!number.is_number_unsigned()) {
    throw std::invalid_argument(fmt::format("\"{}\" is not a whole number from 0 on", name));
  }
  return number.get<std::uint64_t>();
}

std::vector<std::uint32_t> words_at(const nlohmann::json& json, const char* name) {
  std::vector<std::uint32_t> words;
  for (const nlohmann::json& word : list_at(json, name)) {
    constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max();
    if (!word.is_number_unsigned() || word.get<std::uint64_t>() > kLargest) {
      throw std::invalid_argument(fmt::format("\"{}\" has an entry that is not a word", name));
    }
    words.push_back(word.get<std::uint32_t>());
  }
  return words;
}

double number_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& number = json.at(name);
  if (!number.is_number()) throw std::invalid_argument(fmt::format("\"{}\" is not a number", name));
  return number.get<double>();
}

}  // namespace hn
