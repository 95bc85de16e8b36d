// Positions that a server and a client compute from whole numbers, each for itself (docs/guide/same-bits.md).
#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

constexpr std::string_view kReports = "hashnoise docs/guide/same-bits.md (ANGLE on SwiftShader, where sevenths differ)";

// Whole numbers near 0, and some of 20 bits on both sides.
template <typename Expected>
Points whole_points(Expected expected) {
  Points all;
  for (int i = -64; i < 64; ++i) {
    for (const int units : {i, i * 16381}) all.push_back({words(units), expected(units)});
  }
  return all;
}

}  // namespace

std::vector<Bug> position_bugs() {
  return {
      bug("bugs.position_of_cell", {{"units", i32}}, {{"cell", i32}, {"fraction", f32}, {"eighths", f32}},
          "hn_int units = int(a.x);\n"
          "hn_float fraction = float(units & 1023) * 0.0009765625f;\n"
          "return uvec4(uint(units >> 10), bits_of(fraction), bits_of(float(units) * 0.125f), 0u);",
          kReports,
          defined("GLSL 4.60 sections 5.9 and 4.7.1, and every other language: >> repeats the sign, and a product that "
                  "is a "
                  "float is exact"),
          whole_points([](int units) {
            return words(units >> 10, static_cast<float>(units & 1023) * 0x1p-10f, static_cast<float>(units) * 0.125f);
          })),
      bug("bugs.position_in_eighths", {{"units", i32}}, {{"position", f32}},
          "return uvec4(bits_of(float(int(a.x)) / 8.0f), 0u, 0u, 0u);", kReports,
          left_open("GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place, even this one"),
          whole_points([](int units) { return words(static_cast<float>(units) / 8.0f); })),
      bug("bugs.position_in_sevenths", {{"units", i32}}, {{"position", f32}},
          "return uvec4(bits_of(float(int(a.x)) / 7.0f), 0u, 0u, 0u);", kReports,
          left_open("GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place"),
          whole_points([](int units) { return words(static_cast<float>(units) / 7.0f); })),
  };
}

}  // namespace hn
