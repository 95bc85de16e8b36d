#include "base/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace hn {

nlohmann::json parse_json(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  try {
    return nlohmann::json::parse(text, [](int depth, Event event, const nlohmann::json&) {
      const bool opens = event == Event::object_start || event == Event::array_start;
      if (opens && depth >= kDeepestJson) {
        throw std::invalid_argument(fmt::format("it is nested deeper than {} levels", kDeepestJson));
      }
      return true;
    });
  } catch (const nlohmann::json::parse_error& error) {
    // Its own words name the parser's states. The byte is the one behind what was read.
    if (error.byte > text.size()) throw std::invalid_argument("the JSON ends too early");
    const std::string_view read = text.substr(0, error.byte);
    throw std::invalid_argument(fmt::format("there is no JSON any more in line {}, column {}",
                                            1 + std::count(read.begin(), read.end(), '\n'),
                                            read.size() - (read.rfind('\n') + 1)));
  } catch (const nlohmann::json::out_of_range&) {
    throw std::invalid_argument("a number in it is too large");
  }
}

const nlohmann::json& member_at(const nlohmann::json& json, const char* name) {
  if (!json.is_object() || !json.contains(name)) throw std::invalid_argument(fmt::format("\"{}\" is missing", name));
  return json[name];
}

std::string text_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& text = member_at(json, name);
  if (!text.is_string()) throw std::invalid_argument(fmt::format("\"{}\" is not text", name));
  return text.get<std::string>();
}

const nlohmann::json& list_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& list = member_at(json, name);
  if (!list.is_array()) throw std::invalid_argument(fmt::format("\"{}\" is not a list", name));
  return list;
}

std::uint64_t whole_number_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& number = member_at(json, name);
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

std::vector<std::string> texts_at(const nlohmann::json& json, const char* name) {
  std::vector<std::string> texts;
  for (const nlohmann::json& text : list_at(json, name)) {
    if (!text.is_string()) throw std::invalid_argument(fmt::format("\"{}\" has an entry that is not text", name));
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

double number_at(const nlohmann::json& json, const char* name) {
  const nlohmann::json& number = member_at(json, name);
  if (!number.is_number()) throw std::invalid_argument(fmt::format("\"{}\" is not a number", name));
  return number.get<double>();
}

}  // namespace hn
