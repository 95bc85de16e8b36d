// Bugs of loops, and of assignments to parts of vectors.
#include <algorithm>
#include <array>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using uint = std::uint32_t;

// One line of a linear congruential generator per iteration, so that each one counts.
uint iterated(uint h, int first, int end) {
  for (int i = first; i < end; ++i) h = h * 1664525u + 1013904223u + static_cast<uint>(i);
  return h;
}

constexpr Rule kLoops = defined(
    "GLSL 4.60 section 6.3, WGSL (Control Flow), HLSL (Flow Control) and C++14 [stmt.iter] (Metal): a loop goes on "
    "while "
    "its condition holds, whatever its count");
constexpr Rule kSwitch = defined(
    "GLSL 4.60 section 6.2, WGSL (Switch Statement), HLSL (switch Statement) and C++14 [stmt.switch] (Metal): the case "
    "with "
    "the value runs, or the default, wherever it stands");
constexpr std::string_view kInitializers = "ANGLE dont_use_loops_to_initialize_variables (Qualcomm and others)";
constexpr std::string_view kSwizzles = "ANGLE rewrite_repeated_assign_to_swizzled (NVIDIA, crbug 798117)";
constexpr Rule kAssignments = defined("GLSL 4.60 section 5.8: an assignment stores, and its value is what was stored");

// A function of the bug's own, from one vector to another.
template <typename Expected>
Bug swizzles(std::string_view id, std::string_view body, Expected expected, std::string_view declarations) {
  const std::vector<Column> columns = {{"x", u32}, {"y", u32}, {"z", u32}, {"w", u32}};
  return bug(id, columns, columns, body, kSwizzles, kAssignments,
             points<uint, uint, uint, uint>({{1, 2, 3, 4}, {0xFFFFFFFFu, 7, 0, 5}}, expected),
             "gl330 es300 vulkan hlsl60 hlsl50", declarations);
}

}  // namespace

// Counts are held to 64 in the shaders: pixels beside the points, which run along with them, may see any words.
std::vector<Bug> flow_bugs() {
  return {
      bug("bugs.unary_minus_in_loop", {{"x", f32}, {"y", i32}, {"count", i32}}, {{"sum", f32}, {"whole_sum", i32}},
          "hn_float x = float_of(a.x);\nhn_int y = int(a.y);\n"
          "hn_float sum = 0.0f;\nhn_int whole = 0;\n"
          "for (hn_int i = 0; i < min(int(a.z), 64); ++i) {\n"
          "  sum += -x;\n  whole += -y * (i + 1);\n}\n"
          "return uvec4(bits_of(sum), uint(whole), 0u, 0u);",
          "WebGL conformance/glsl/bugs/unary-minus-operator-in-dynamic-loop; ANGLE rewriteUnaryMinusOperator",
          defined(
              "GLSL 4.60 section 5.9, and every other language: - negates, in a loop as well; these sums are exact"),
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
              [](uint x, uint y, int last) { return words(iterated(x, 0, last + 1), iterated(y, 0, last + 1)); })),
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
          kInitializers,
          defined("GLSL 4.60 section 5.7, and every other language: an element keeps what was assigned to it"),
          points<uint, uint>({{100, 0}, {100, 3}, {0x80000000u, 7}},
                             [](uint x, uint index) { return words(x + index * index, 8 * x + 140u); })),
      bug("bugs.vector_plus_scalar_in_loop", {{"x", f32}, {"y", f32}, {"s", f32}, {"count", i32}},
          {{"x", f32}, {"y", f32}, {"z", u32}, {"w", u32}},
          "hn_vec2 v = vec2(float_of(a.x), float_of(a.y));\nhn_uvec2 u = uvec2(1u, 2u);\n"
          "hn_float s = float_of(a.z);\n"
          "for (hn_int i = 0; i < min(int(a.w), 64); ++i) {\n  v += s;\n  u += 3u;\n}\n"
          "return uvec4(bits_of(v.x), bits_of(v.y), u);",
          "crbug 772651, WebGL conformance/glsl/bugs/vector-scalar-arithmetic-inside-loop",
          defined("GLSL 4.60 section 5.9, and every other language: a scalar is added to each component; these sums "
                  "are exact"),
          points<float, float, float, uint>({{1.0f, -2.0f, 0.5f, 0}, {1.0f, -2.0f, 0.5f, 3}, {0.25f, 8.0f, -4.0f, 7}},
                                            [](float x, float y, float s, uint count) {
                                              const float added = s * static_cast<float>(count);
                                              return words(x + added, y + added, 1u + 3u * count, 2u + 3u * count);
                                            })),
      bug("bugs.three_nested_loops", {{"first", i32}, {"second", i32}, {"third", i32}},
          {{"steps", u32}, {"hash", u32}, {"fixed", u32}, {"two", u32}},
          "hn_ivec3 n = min(ivec3(int(a.x), int(a.y), int(a.z)), ivec3(4, 4, 4));\n"
          "hn_uint steps = 0u;\nhn_uint h = 7u;\nhn_uint two = 0u;\n"
          "for (hn_int i = 0; i < n.x; ++i) {\n  for (hn_int j = 0; j < n.y; ++j) {\n"
          "    for (hn_int k = 0; k < n.z; ++k) {\n      steps += 1u;\n"
          "      h = h * 1664525u + 1013904223u + uint(i * 16 + j * 4 + k);\n    }\n    two += 1u;\n  }\n}\n"
          "hn_uint fixed_steps = 0u;\n"
          "for (hn_int i = 0; i < 2; ++i) {\n  for (hn_int j = 0; j < 2; ++j) {\n"
          "    for (hn_int k = 0; k < 2; ++k) { fixed_steps += 1u; }\n  }\n}\n"
          "return uvec4(steps, h, fixed_steps, two);",
          "gfx-rs/wgpu 5067 and gpuweb/cts 3063 (Metal on AMD, Intel, DXC: 4 of 8 steps); gfx-rs/wgpu 5246", kLoops,
          points<int, int, int>({{2, 2, 2}, {3, 4, 1}, {1, 0, 3}, {4, 3, 2}},
                                [](int first, int second, int third) {
                                  uint h = 7;
                                  for (int n = 0; n < first * second * third; ++n) {
                                    const int i = n / (second * third);
                                    const int j = n / third % second;
                                    h = h * 1664525u + 1013904223u + static_cast<uint>(i * 16 + j * 4 + n % third);
                                  }
                                  return words(first * second * third, h, 8, first * second);
                                })),
      bug("bugs.do_while", {{"end", u32}}, {{"steps", u32}, {"by_three", u32}},
          "hn_uint n = 0u;\ndo {\n  n += 1u;\n  if (n > 60u) { break; }\n} while (n != a.x);\n"
          "hn_uint m = 0u;\ndo { m += 3u; } while (m < min(a.x, 64u));\n"
          "return uvec4(n, m, 0u, 0u);",
          "gfx-rs/wgpu 4982 (naga: break if)", kLoops,
          points<uint>({5u, 1u, 60u, 100u},
                       [](uint end) { return words(end > 60u ? 61u : end, (std::min(end, 64u) + 2u) / 3u * 3u); })),
      bug("bugs.nested_selections", {{"x", u32}, {"y", u32}, {"count", i32}}, {{"hash", u32}, {"selected", u32}},
          "hn_uint h = 0u;\nhn_uint selected = 0u;\n"
          "for (hn_int i = 0; i < min(int(a.z), 8); ++i) {\n"
          "  hn_uint low = a.x < a.y ? 0u : (a.y < a.x ? 255u : 128u);\n"
          "  hn_uint high = a.x < a.y ? 255u : (a.y < a.x ? 0u : 64u);\n"
          "  selected = (i & 1) == 0 ? low : high;\n  h = h * 257u + selected;\n}\n"
          "return uvec4(h, selected, 0u, 0u);",
          "halide/Halide 7072 (FXC)",
          defined("GLSL 4.60 section 5.9, and every other language: the second expression is chosen where the first is "
                  "true, else the third"),
          points<uint, uint, int>({{1, 2, 1}, {1, 2, 4}, {2, 1, 5}, {3, 3, 2}, {3, 3, 7}},
                                  [](uint x, uint y, int count) {
                                    const uint even = x == y ? 128u : x < y ? 0u : 255u;
                                    const uint odd = x == y ? 64u : 255u - even;
                                    uint h = 0;
                                    for (int i = 0; i < count; ++i) h = h * 257u + (i % 2 == 0 ? even : odd);
                                    return words(h, count % 2 == 0 ? odd : even);
                                  })),
      // Each turn takes one of four elements a state further; behind the third state it goes on to the next.
      bug("bugs.switch_in_loop", {{"count", i32}}, {{"hash", u32}, {"at", i32}, {"states", u32}},
          "hn_uint t[4];\nfor (hn_int j = 0; j < 4; ++j) { t[j] = 0u; }\nhn_int at = 0;\nhn_uint h = 7u;\n"
          "for (hn_int i = 0; i < min(int(a.x), 16); ++i) {\n  switch (t[at]) {\n"
          "    case 0u: t[at] = 1u; break;\n"
          "    case 1u:\n      t[at] = 2u;\n      if (at == 3) { break; }\n      h = h * 3u + uint(at);\n      break;\n"
          "    case 2u: t[at] = 9u; at = min(at + 1, 3); break;\n    default: h += 1000u; break;\n  }\n}\n"
          "return uvec4(h, uint(at), t[0] + t[1] * 10u + t[2] * 100u + t[3] * 1000u, 0u);",
          "gfx-rs/wgpu 5656 and gpuweb/gpuweb 4430 (FXC)", kSwitch,
          points<uint>({1u, 2u, 3u, 8u, 12u, 16u},
                       [](uint count) {
                         // Three turns for an element; the last one stays, and then each turn counts.
                         const uint at = std::min(count / 3u, 3u);
                         const std::array<uint, 4> hashes = {7u * 3u, 21u * 3u + 1u, 64u * 3u + 2u, 194u};
                         uint h = 7;
                         uint states = 0;
                         for (uint i = 0, scale = 1; i < 4; ++i, scale *= 10) {
                           const uint turns = std::min(count - std::min(count, 3 * i), 3u);
                           states += (turns == 3 ? 9u : turns) * scale;
                           if (turns >= 2) h = hashes[i];
                         }
                         return words(h + (count > 12u ? (count - 12u) * 1000u : 0u), at, states);
                       })),
      bug("bugs.switch_default_in_middle", {{"x", u32}}, {{"case", u32}},
          "hn_uint r = 7u;\nswitch (a.x) {\n  case 1u: r = 1u; break;\n  default: r = 9u; break;\n"
          "  case 3u:\n  case 4u: r = 3u; break;\n}\nreturn uvec4(r, 0u, 0u, 0u);",
          "gfx-rs/naga 2181", kSwitch,
          points<uint>({3u, 1u, 0u, 4u, 0xFFFFFFFFu},
                       [](uint x) { return words(x == 1u              ? 1u
                                                 : x == 3u || x == 4u ? 3u
                                                                      : 9u); })),
      bug("bugs.switch_of_constant", {{"x", u32}}, {{"default", u32}},
          "hn_uint v = 7u;\nswitch (0u) {\n  default:\n    if (a.x > 3u) {\n      v = 100u + a.x;\n      break;\n    "
          "}\n"
          "    v = 200u + a.x;\n    break;\n}\nreturn uvec4(v, 0u, 0u, 0u);",
          "KhronosGroup/SPIRV-Tools 3445 and SPIRV-Cross 1402 (FXC skips the default)", kSwitch,
          points<uint>({5u, 3u, 0u}, [](uint x) { return words(x > 3u ? 100u + x : 200u + x); })),
      swizzles(
          "bugs.swizzle_written_twice", "return hn_bug_swap(a);",
          [](uint x, uint y, uint, uint) { return words(y + x, x + x, y, x); },
          "hn_uvec4 hn_bug_swap(hn_uvec4 v) {\n"
          "  v.xy = v.yx;\n  v.zw = v.xy;\n  v.xy = v.xy + v.ww;\n  return v;\n}\n"),
      swizzles(
          "bugs.swizzle_assigned_in_chain", "return hn_bug_chain(a);",
          [](uint x, uint y, uint, uint) { return words(y, x, y, x); },
          "hn_uvec4 hn_bug_chain(hn_uvec4 v) {\n"
          "  hn_uvec4 r = uvec4(9u, 9u, 9u, 9u);\n  r.zw = r.xy = v.yx;\n  return r;\n}\n"),
  };
}

}  // namespace hn
