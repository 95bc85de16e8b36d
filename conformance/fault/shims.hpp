// GLSL functions that stand in for operators and built-in functions, for every type that these take.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hn {

// A function of operands of scalar types ("int", "uint", "float"), which has the type of the first.
struct Shim {
  std::string_view name;
  std::vector<std::string_view> operands;
  std::string code;  // its body, of a, b and c
};

// The function, and those for vectors, component by component: each operand may be a scalar or a vector.
std::string glsl_of(const Shim& shim);

}  // namespace hn
