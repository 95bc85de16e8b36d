// Positions that a server and a client compute from whole numbers, each for itself (docs/guide/same-bits.md).
#include <functional>
#include <string_view>
#include <vector>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

constexpr std::string_view kReports = "hashnoise docs/guide/same-bits.md (ANGLE on SwiftShader, where sevenths differ)";

// Whole numbers near 0, and some of 20 bits on both sides.
std::vector<BugPoint> whole_points(const std::function<std::vector<std::uint32_t>(std::int32_t)>& expected) {
  std::vector<BugPoint> all;
  for (std::int32_t i = -64; i < 64; ++i) {
    for (const std::int32_t units : {i, i * 16381}) all.push_back({{word(units)}, expected(units)});
  }
  return all;
}

void add_quotient(std::vector<Bug>& bugs, std::string_view id, float divisor, std::string_view body,
                  std::string_view specification) {
  bugs.push_back({.function = bug_function(id, {{"units", i32}}, {{"position", f32}}, body),
                  .reference = kReports,
                  .specification = specification,
                  .defined = false,
                  .points = whole_points(
                      [=](std::int32_t units) { return std::vector{word(static_cast<float>(units) / divisor)}; })});
}

}  // namespace

void add_position_bugs(std::vector<Bug>& bugs) {
  bugs.push_back(
      {.function =
           bug_function("bugs.position_of_cell", {{"units", i32}}, {{"cell", i32}, {"fraction", f32}, {"eighths", f32}},
                        "hn_int units = int(a.x);\n"
                        "hn_float fraction = float(units & 1023) * 0.0009765625;\n"
                        "return uvec4(uint(units >> 10), bits_of(fraction), bits_of(float(units) * 0.125), 0u);"),
       .reference = kReports,
       .specification = "GLSL 4.60 sections 5.9 and 4.7.1: >> repeats the sign, and a product that is a float is exact",
       .defined = true,
       .points = whole_points([](std::int32_t units) {
         return std::vector{word(units >> 10), word(static_cast<float>(units & 1023) * 0x1p-10f),
                            word(static_cast<float>(units) * 0.125f)};
       })});
  add_quotient(bugs, "bugs.position_in_eighths", 8.0f, "return uvec4(bits_of(float(int(a.x)) / 8.0), 0u, 0u, 0u);",
               "GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place, even this one");
  add_quotient(bugs, "bugs.position_in_sevenths", 7.0f, "return uvec4(bits_of(float(int(a.x)) / 7.0), 0u, 0u, 0u);",
               "GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place");
}

}  // namespace hn
