// Rewrites a C++ compiler's messages on a user's GLSL in the words of GLSL.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bake/glsl_text.hpp"

namespace hn {

// A text as the compiler reads it, and the name that #line gives it there.
struct CompiledText {
  std::string_view name;
  const CppText* cpp;  // null if there is none
};

// The first error of GCC's or Clang's log, as one of the user's text where that has caused it: the place in the text,
// and what is wrong there. Nothing if the log names no place in any of the texts.
std::optional<std::string> first_error(std::string_view log, const CompiledText& expression,
                                       const CompiledText& source);

}  // namespace hn
