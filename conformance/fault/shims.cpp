#include "fault/shims.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <vector>

namespace hn {
namespace {

constexpr std::string_view kComponents = "xyzw";

// "uvec3" of "uint"; the scalar itself of size 1.
std::string type_of(std::string_view scalar, std::size_t size) {
  if (size == 1) return std::string(scalar);
  return fmt::format("{}vec{}", scalar == "float" ? "" : scalar.substr(0, 1), size);
}

// A function whose operands have these sizes, 1 or n, and these scalar types; of the first one's scalar type.
std::string function(const ShimLanguage& language, std::string_view name, const std::vector<std::string_view>& scalars,
                     const std::vector<std::size_t>& sizes, std::string_view code) {
  std::size_t size = 1;
  std::string parameters;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    size = std::max(size, sizes[i]);
    parameters += fmt::format("{}{}{} {}", i == 0 ? "" : ", ", language.highp(), type_of(scalars[i], sizes[i]),
                              static_cast<char>('a' + i));
  }
  std::string body(code);
  if (size > 1) {
    std::string components;
    for (std::size_t at = 0; at < size; ++at) {
      std::string operands;
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        operands += fmt::format("{}{}{}", i == 0 ? "" : ", ", static_cast<char>('a' + i),
                                sizes[i] == 1 ? "" : fmt::format(".{}", kComponents[at]));
      }
      components += fmt::format("{}{}({})", at == 0 ? "" : ", ", name, operands);
    }
    body = fmt::format("return {}({});", type_of(scalars[0], size), components);
  }
  return fmt::format("{}{} {}({}) {{ {} }}\n", language.highp(), type_of(scalars[0], size), name, parameters, body);
}

std::string shim(const ShimLanguage& language, std::string_view name, std::string_view scalar, std::string_view code,
                 std::size_t operands) {
  const std::vector<std::string_view> scalars(operands, scalar);
  std::string text = function(language, name, scalars, std::vector<std::size_t>(operands, 1), code);
  for (std::size_t size = 2; size <= 4; ++size) {
    // Every choice of operands that are vectors, but the empty one.
    for (std::size_t vectors = 1; vectors < (std::size_t{1} << operands); ++vectors) {
      std::vector<std::size_t> sizes;
      for (std::size_t i = 0; i < operands; ++i) sizes.push_back((vectors >> i) & 1 ? size : 1);
      text += function(language, name, scalars, sizes, code);
    }
  }
  return text;
}

}  // namespace

std::string unary_shim(const ShimLanguage& language, std::string_view name, std::string_view scalar,
                       std::string_view code) {
  return shim(language, name, scalar, code, 1);
}

std::string binary_shim(const ShimLanguage& language, std::string_view name, std::string_view scalar,
                        std::string_view code) {
  return shim(language, name, scalar, code, 2);
}

std::string ternary_shim(const ShimLanguage& language, std::string_view name, std::string_view scalar,
                         std::string_view code) {
  return shim(language, name, scalar, code, 3);
}

std::string shift_shim(const ShimLanguage& language, std::string_view name, std::string_view symbol,
                       std::string_view code_by_int) {
  std::string text;
  for (const std::string_view operand : {"int", "uint"}) {
    for (const std::string_view count : {"int", "uint"}) {
      const std::string right = fmt::format("return a {} b;", symbol);
      const std::string_view code = operand == "uint" && count == "int" ? code_by_int : right;
      text += function(language, name, {operand, count}, {1, 1}, code);
      for (std::size_t size = 2; size <= 4; ++size) {
        text += function(language, name, {operand, count}, {size, 1}, code);
        text += function(language, name, {operand, count}, {size, size}, code);
      }
    }
  }
  return text;
}

}  // namespace hn
