#include "fault/shims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace hn {
namespace {

// "uvec3" of "uint"; the scalar itself of size 1.
std::string type_of(std::string_view scalar, std::size_t size) {
  if (size == 1) return std::string(scalar);
  return fmt::format("{}vec{}", scalar == "float" ? "" : scalar.substr(0, 1), size);
}

// The function with a result of that size; `vectors` has a bit for each operand that is a vector.
std::string function(const Shim& shim, std::size_t size, unsigned vectors) {
  std::vector<std::string> parameters;
  std::array<std::vector<std::string>, 4> arguments;  // for each component
  for (std::size_t i = 0; i < shim.operands.size(); ++i) {
    const bool is_vector = (vectors >> i & 1u) != 0;
    const char name = static_cast<char>('a' + i);
    parameters.push_back(fmt::format("highp {} {}", type_of(shim.operands[i], is_vector ? size : 1), name));
    for (std::size_t at = 0; at < size; ++at) {
      arguments[at].push_back(is_vector ? fmt::format("{}.{}", name, "xyzw"[at]) : std::string(1, name));
    }
  }
  const std::string type = type_of(shim.operands[0], size);
  std::string body = shim.code;
  if (size > 1) {
    std::vector<std::string> components;
    for (std::size_t at = 0; at < size; ++at) {
      components.push_back(fmt::format("{}({})", shim.name, fmt::join(arguments[at], ", ")));
    }
    body = fmt::format("return {}({});", type, fmt::join(components, ", "));
  }
  return fmt::format("highp {} {}({}) {{ {} }}\n", type, shim.name, fmt::join(parameters, ", "), body);
}

}  // namespace

std::string glsl_of(const Shim& shim) {
  std::string text = function(shim, 1, 0);
  for (std::size_t size = 2; size <= 4; ++size) {
    for (unsigned vectors = 1; vectors < 1u << shim.operands.size(); ++vectors) text += function(shim, size, vectors);
  }
  return text;
}

}  // namespace hn
