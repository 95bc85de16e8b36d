// GLSL functions that stand in for operators and built-in functions, for every type that these take.
#pragma once

#include <string>
#include <string_view>

#include "library/profile.hpp"

namespace hn {

// The language that the functions are written in.
struct ShimLanguage {
  const Profile& profile;

  std::string highp() const { return profile.es ? "highp " : ""; }
  bool has_precise() const { return profile.version >= (profile.es ? 320 : 400); }
};

// A function of one, two or three operands of a scalar type ("int", "uint", "float") and its vectors, component by
// component; of several operands each may be a scalar or a vector. code is the body for scalars, of a, b and c.
std::string unary_shim(const ShimLanguage& language, std::string_view name, std::string_view scalar,
                       std::string_view code);
std::string binary_shim(const ShimLanguage& language, std::string_view name, std::string_view scalar,
                        std::string_view code);
std::string ternary_shim(const ShimLanguage& language, std::string_view name, std::string_view scalar,
                         std::string_view code);

// A shift: operand and count may be of different types. code_by_int is the body for a uint shifted by an int.
std::string shift_shim(const ShimLanguage& language, std::string_view name, std::string_view symbol,
                       std::string_view code_by_int);

}  // namespace hn
