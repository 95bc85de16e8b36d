// Bugs of loops, and of assignments to parts of vectors.
#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using uint = std::uint32_t;

// One line of a linear congruential generator per iteration, so that each one counts.
uint iterated(uint h, int first, int end) {
  for (int i = first; i < end; ++i) h = h * 1664525u + 1013904223u + static_cast<uint>(i);
  return h;
}

constexpr Rule kLoops = defined("GLSL 4.60 section 6.3: a loop goes on while its condition holds, whatever its count");
constexpr std::string_view kInitializers = "ANGLE dont_use_loops_to_initialize_variables (Qualcomm and others)";
constexpr std::string_view kSwizzles = "ANGLE rewrite_repeated_assign_to_swizzled (NVIDIA, crbug 798117)";
constexpr Rule kAssignments = defined("GLSL 4.60 section 5.8: an assignment stores, and its value is what was stored");

// A function of the bug's own, from one vector to another.
template <typename Expected>
Bug swizzles(std::string_view id, std::string_view body, Expected expected, std::string_view declarations) {
  const std::vector<Column> columns = {{"x", u32}, {"y", u32}, {"z", u32}, {"w", u32}};
  return bug(id, columns, columns, body, kSwizzles, kAssignments,
             points<uint, uint, uint, uint>({{1, 2, 3, 4}, {0xFFFFFFFFu, 7, 0, 5}}, expected), kUsualProfiles,
             declarations);
}

}  // namespace

// Counts are held to 64 in the shaders: pixels beside the points, which run along with them, may see any words.
std::vector<Bug> flow_bugs() {
  return {
      bug("bugs.unary_minus_in_loop", {{"x", f32}, {"y", i32}, {"count", i32}}, {{"sum", f32}, {"whole_sum", i32}},
          "hn_float x = float_of(a.x);\nhn_int y = int(a.y);\n"
          "hn_float sum = 0.0;\nhn_int whole = 0;\n"
          "for (hn_int i = 0; i < min(int(a.z), 64); ++i) {\n"
          "  sum += -x;\n  whole += -y * (i + 1);\n}\n"
          "return uvec4(bits_of(sum), uint(whole), 0u, 0u);",
          "WebGL conformance/glsl/bugs/unary-minus-operator-in-dynamic-loop; ANGLE rewriteUnaryMinusOperator",
          defined("GLSL 4.60 section 5.9: - negates, in a loop as well; these sums are exact"),
          points<float, int, int>({{1.5f, 7, 0}, {1.5f, 7, 1}, {-0.25f, -3, 4}, {3.0f, 1, 13}},
                                  [](float x, int y, int count) {
                                    return words(0.0f - x * static_cast<float>(count), -y * (count * (count + 1) / 2));
                                  })),
      bug("bugs.loop_condition", {{"start", u32}, {"count", i32}},
          {{"for_loop", u32}, {"while_loop", u32}, {"break_loop", u32}},
          "hn_int n = min(int(a.y), 64);\nhn_uint f = a.x;\nhn_uint w = "
          "a.x;\nhn_uint b0 = a.x;\n"
          "for (hn_int i = 0; i < n; ++i) { f = f * 1664525u + 1013904223u + uint(i); }\n"
          "hn_int j = 0;\n"
          "while (j < n) { w = w * 1664525u + 1013904223u + uint(j); j = j + 1; }\n"
          "for (hn_int k = 0; k < 64; ++k) {\n"
          "  if (k >= n) { break; }\n"
          "  b0 = b0 * 1664525u + 1013904223u + uint(k);\n}\n"
          "return uvec4(f, w, b0, 0u);",
          "ANGLE add_and_true_to_loop_condition (Intel on macOS)", kLoops,
          points<uint, int>({{7, 0}, {7, 1}, {7, 2}, {7, 5}, {7, 20}, {7, 63}},
                            [](uint start, int count) {
                              const uint h = iterated(start, 0, count);
                              return words(h, h, h);
                            })),
      // Points beside each other leave it after different counts. Each component is iterated from its own start.
      bug("bugs.vector_behind_loop", {{"x", u32}, {"y", u32}, {"last", i32}}, {{"x", u32}, {"y", u32}},
          "hn_uvec2 v = uvec2(a.x, a.y);\nhn_int i = 0;\n"
          "do {\n  v = v * 1664525u + 1013904223u + uint(i);\n  i = i + 1;\n} "
          "while (i <= min(int(a.z), 63));\n"
          "return uvec4(v, 0u, 0u);",
          "lavapipe of Mesa 22.3.6, found by this suite: a point that has left computes the vector once more while "
          "others go on. Mesa 26.2.6 does not",
          kLoops,
          points<uint, uint, int>(
              {{7, 1, 0}, {7, 1, 1}, {7, 1, 2}, {7, 1, 5}, {7, 1, 20}, {7, 1, 63}},
              [](uint x, uint y, int last) { return words(iterated(x, 0, last + 1), iterated(y, 0, last + 1)); }),
          "gl330 es300 vulkan"),
      bug("bugs.loop_initializer", {{"first", i32}, {"end", i32}}, {{"for_loop", u32}},
          "hn_uint h = 7u;\n"
          "for (hn_int i = max(int(a.x), -64); i < min(int(a.y), 64); ++i) { h = h "
          "* 1664525u + 1013904223u + uint(i); }\n"
          "return uvec4(h, 0u, 0u, 0u);",
          kInitializers, kLoops,
          points<int, int>({{0, 3}, {2, 9}, {-4, 4}, {5, 5}},
                           [](int first, int end) { return words(iterated(7, first, end)); })),
      // 140 is the sum of the squares of 0 to 7.
      bug("bugs.array_initialized_in_loop", {{"x", u32}, {"index", i32}}, {{"element", u32}, {"sum", u32}},
          "hn_uint t[8];\n"
          "for (hn_int i = 0; i < 8; ++i) { t[i] = a.x + uint(i * i); }\n"
          "hn_uint sum = 0u;\n"
          "for (hn_int i = 0; i < 8; ++i) { sum += t[i]; }\n"
          "return uvec4(t[int(a.y) & 7], sum, 0u, 0u);",
          kInitializers, defined("GLSL 4.60 section 5.7: an element keeps what was assigned to it"),
          points<uint, uint>({{100, 0}, {100, 3}, {0x80000000u, 7}},
                             [](uint x, uint index) { return words(x + index * index, 8 * x + 140u); })),
      bug("bugs.vector_plus_scalar_in_loop", {{"x", f32}, {"y", f32}, {"s", f32}, {"count", i32}},
          {{"x", f32}, {"y", f32}, {"z", u32}, {"w", u32}},
          "hn_vec2 v = vec2(float_of(a.x), float_of(a.y));\nhn_uvec2 u = uvec2(1u, 2u);\n"
          "hn_float s = float_of(a.z);\n"
          "for (hn_int i = 0; i < min(int(a.w), 64); ++i) {\n  v += s;\n  u += 3u;\n}\n"
          "return uvec4(bits_of(v.x), bits_of(v.y), u);",
          "crbug 772651, WebGL conformance/glsl/bugs/vector-scalar-arithmetic-inside-loop",
          defined("GLSL 4.60 section 5.9: a scalar is added to each component; these sums are exact"),
          points<float, float, float, uint>({{1.0f, -2.0f, 0.5f, 0}, {1.0f, -2.0f, 0.5f, 3}, {0.25f, 8.0f, -4.0f, 7}},
                                            [](float x, float y, float s, uint count) {
                                              const float added = s * static_cast<float>(count);
                                              return words(x + added, y + added, 1u + 3u * count, 2u + 3u * count);
                                            })),
      swizzles(
          "bugs.swizzle_written_twice", "return hn_bug_swap(a);",
          [](uint x, uint y, uint, uint) { return words(y + x, x + x, y, x); },
          "#include \"config.glsl\"\n"
          "hn_uvec4 hn_bug_swap(hn_uvec4 v) {\n"
          "  v.xy = v.yx;\n  v.zw = v.xy;\n  v.xy = v.xy + v.ww;\n  return v;\n}\n"),
      swizzles(
          "bugs.swizzle_assigned_in_chain", "return hn_bug_chain(a);",
          [](uint x, uint y, uint, uint) { return words(y, x, y, x); },
          "#include \"config.glsl\"\n"
          "hn_uvec4 hn_bug_chain(hn_uvec4 v) {\n"
          "  hn_uvec4 r = uvec4(9u);\n  r.zw = r.xy = v.yx;\n  return r;\n}\n"),
  };
}

}  // namespace hn
