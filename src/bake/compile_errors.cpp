#include "bake/compile_errors.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <hashnoise/glsl.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "base/strings.hpp"

namespace hn {
namespace {

using namespace std::string_view_literals;

#define HN_BAKE_QUOTED(text) #text
#define HN_BAKE_TEXT_OF(macro) HN_BAKE_QUOTED(macro)
constexpr std::string_view kVersion = HN_BAKE_TEXT_OF(HN_I_NAMESPACE) "::";  // the namespace of the version

constexpr std::string_view kOwn = "hn-bake: ";  // the prefix of our static_asserts' messages

// "NAME:3:14: MESSAGE", at the beginning of a line or behind other words.
struct Remark {
  const CompiledText* text;
  std::size_t line;
  std::size_t column;
  std::string_view message;
};

std::size_t number_at(std::string_view& rest) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (error != std::errc() || !rest.starts_with(':')) return 0;
  rest.remove_prefix(1);
  return number;
}

std::optional<Remark> remark_of(std::string_view line, const CompiledText& text) {
  if (!text.cpp) return std::nullopt;
  const std::size_t found = line.find(fmt::format("{}:", text.name));
  if (found == std::string_view::npos) return std::nullopt;
  std::string_view rest = line.substr(found + text.name.size() + 1);
  const std::size_t line_number = number_at(rest);
  const std::size_t column = number_at(rest);
  if (line_number == 0 || column == 0) return std::nullopt;
  return Remark{&text, line_number, column, rest};
}

std::string_view message_of_error(std::string_view line) {
  constexpr std::string_view kMark = "error: ";
  const std::size_t found = line.find(kMark);
  return found == std::string_view::npos ? std::string_view() : line.substr(found + kMark.size());
}

void replace_all(std::string& text, std::string_view old, std::string_view by) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size())) {
    text.replace(at, old.size(), by);
  }
}

// The types by GLSL's names, and functions without the namespaces that they are in.
std::string in_glsl(std::string_view message) {
  std::string text(message.substr(0, message.find(" [-W")));
  for (const std::string_view space : {"hashnoise::"sv, kVersion, "of_the_user::"sv, "const "sv})
    replace_all(text, space, "");
  for (const std::string_view knob : {"hash_", "gradient_", "arithmetic_"}) {
    for (std::size_t at = text.find(knob); at != std::string::npos; at = text.find(knob, at + 1)) {
      const std::size_t end = text.find("::", at);
      if (end == at + knob.size() + 1) text.erase(at, end + 2 - at);
    }
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kVectors = {
      {{"<float>", "vec"}, {"<int>", "ivec"}, {"<unsigned int>", "uvec"}}};
  for (const auto& [type, name] : kVectors) {
    for (const char count : {'2', '3', '4'}) {
      replace_all(text, fmt::format("Vector{}{}", count, type), fmt::format("{}{}", name, count));
    }
  }
  replace_all(text, "unsigned int", "uint");
  // 'using vec2 = struct vec2' {aka 'struct vec2'}: GCC names a type several times.
  for (std::size_t at = text.find(" {aka "); at != std::string::npos; at = text.find(" {aka ", at)) {
    text.erase(at, text.find('}', at) + 1 - at);
  }
  for (std::size_t at = text.find("'using "); at != std::string::npos; at = text.find("'using ", at)) {
    const std::size_t end = text.find(" = ", at);
    if (end == std::string::npos) break;
    text.erase(end, text.find('\'', end) - end);
    text.erase(at + 1, 6);
  }
  replace_all(text, "float&", "float");
  return text;
}

// Explains a call that HN_ONLY_TYPES_OF_GLSL refuses: "...hn_value(TypesInCall ...) [with TypesInCall = {vec2, int}]"
// of GCC, and "'hn_value<vec2, int>' is unavailable" of Clang.
std::string of_refused_call(const std::string& text) {
  const std::size_t begin = text.find("hn_");
  const std::size_t end = text.find_first_of("(<'", begin);
  if (begin == std::string::npos || end == std::string::npos) return text;
  const std::string name = text.substr(begin, end - begin);
  std::size_t types = text.find("InCall = {");
  types = types == std::string::npos ? end + 1 : types + 10;
  const std::size_t types_end = text.find_first_of(">}", types);
  if (types_end == std::string::npos) return fmt::format("there is no {} of arguments of these types", name);
  return fmt::format("there is no {}({})", name, text.substr(types, types_end - types));
}

std::string explained(std::string_view message) {
  std::string text = in_glsl(message);
  if (text.find("use of deleted function") != std::string::npos || text.find("is unavailable: ") != std::string::npos) {
    return of_refused_call(text);
  }
  if (const std::size_t own = text.find(kOwn); own != std::string::npos) {
    return text.substr(own + kOwn.size(), text.find('"', own) - own - kOwn.size());  // Clang quotes it
  }
  if (text.find("no member named") != std::string::npos)
    text += "; a vector has .x, .y, .z, .w, and .xy and the like to read";
  if (text.find("operator[]") != std::string::npos || text.find("subscript") != std::string::npos) {
    text += "; a vector has .x, .y, .z and .w here, and no [0]";
  }
  return text;
}

}  // namespace

std::optional<std::string> first_error(std::string_view log, const CompiledText& expression,
                                       const CompiledText& source) {
  const std::vector<std::string_view> lines = split(log, '\n');
  std::string_view message;
  std::optional<Remark> remark;
  for (const std::string_view line : lines) {
    auto here = remark_of(line, expression);
    if (!here) here = remark_of(line, source);
    const std::string_view error = message_of_error(line);
    // GCC prints the cause of an error before it, and Clang behind it.
    if (!message.empty() && !error.empty()) break;
    if (!error.empty()) message = error;
    const bool is_error = here && !error.empty();
    if (here && (!remark || is_error)) remark = here;
    if (!message.empty() && remark) break;
  }
  // An error in the type of the whole value is reported in the code that calls it.
  if (!remark && message.find(kOwn) != std::string_view::npos) return expression.cpp->glsl.at(0, explained(message));
  if (message.empty() || !remark) return std::nullopt;
  const CppText& cpp = *remark->text->cpp;
  return cpp.glsl.at(cpp.origin(remark->line, remark->column), explained(message));
}

}  // namespace hn
