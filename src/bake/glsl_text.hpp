// GLSL of a user's, made fit for the compiler of C++ that compiles it beside the twin.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace hn {

// A user's text and its origin: "--expression", or "--source my_noise.glsl".
struct GlslText {
  std::string name;
  std::string text;

  // "NAME, line 1, column 5: MESSAGE", with the line itself and a mark below.
  std::string at(std::size_t offset, std::string_view message) const;
};

// The text in C++. Each line of it is one line of the GLSL.
struct CppText {
  GlslText glsl;
  std::string text;
  std::vector<std::uint32_t> origins;  // where each character comes from, as an offset in the GLSL

  // The offset of what stands at a line and a column of the C++, counted from 1.
  std::size_t origin(std::size_t line, std::size_t column) const;
};

// Literals such as 0.5 become floats, as they are in GLSL; v.yx becomes a function of v; the words of GLSL that C++ has
// not are left out, and so are comments. An error is about what GLSL has not, or the twin: matrices, doubles.
Result<CppText> cpp_of_functions(GlslText glsl);
// The same of one value: no statement, no directive, and brackets that are in pairs.
Result<CppText> cpp_of_expression(GlslText glsl);

}  // namespace hn
