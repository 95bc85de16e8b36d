// The shaders of the cases: what evaluates a function, in which stage and variant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "library/functions.hpp"
#include "library/profile.hpp"

namespace hn {

// Points lie in a grid with rows of kGridSide: every OpenGL 3.1 implementation has textures of that size at the least.
constexpr std::size_t kGridSide = 1024;
// Invocations of a compute shader that go together. A multiple of what GPUs run at once, and less than the 128 that
// every implementation takes.
constexpr std::size_t kComputeGroup = 64;

// How main comes to the result.
enum class Shape {
  called,    // a function of its own evaluates the point
  inlined,   // the same in main itself
  in_loop,   // in a loop over kLoopTrips points, the one at hand first; each leaves a word of the result
  constant,  // the first points are constants of the shader
};
// Where the seed comes from: from the point, or it is kVariantSeed.
enum class SeedFrom { point, constant, uniform };

// As many as a result has words. The shader reads the number from the uniform "trips".
inline constexpr std::uint32_t kLoopTrips = 4;
// The value of the uniform "variant_seed": any number with bits everywhere.
inline constexpr std::uint32_t kVariantSeed = 0xC2B2AE35u;

struct ShaderVariant {
  bool seeded = true;                  // else the overload without a seed
  std::string_view knobs = "";         // further definitions, before the include
  std::string_view declarations = "";  // functions of the row's own, before evaluate
  Shape shape = Shape::called;
  SeedFrom seed_from = SeedFrom::point;
  std::span<const std::uint32_t> constants = {};  // of Shape::constant: kInputWords per point, of a row of the grid
  std::span<const std::int32_t> periods = {};     // of each axis, as constants of the shader; else from the point
};

// A function to evaluate, and how.
struct Evaluation {
  const Function& function;
  const Configuration& configuration;
  const Profile& profile;
  ShaderVariant variant = {};
  Stage stage = Stage::fragment;
};

// The shaders of the cases, before their includes are expanded. A shader evaluates the function at the point of its
// pixel, vertex or invocation, and names what it is (CASE_VERTEX, CASE_IN_LOOP, ...) for faults that concern only that.
std::string evaluation_shader(const Evaluation& evaluation);
// The text between evaluate's parentheses: an argument for each parameter, by its number.
template <typename Text>
std::string arguments_of(const Function& function, Text text_of, std::string_view separator = ", ") {
  std::string arguments;
  for (std::size_t i = 0; i < function.parameters(); ++i) {
    arguments += std::string(i == 0 ? "" : separator) + text_of(i);
  }
  return arguments;
}
// A function of that name, with evaluate's parameters, that has the body of a row.
std::string declared_evaluate(const Function& function, std::string_view name,
                              std::span<const std::int32_t> periods = {});
std::string vertex_shader();         // for evaluation in the fragment stage
std::string idle_fragment_shader();  // for evaluation in the vertex stage
// The text of a shader that is not a case: evaluate is declared, with the function's parameters, and what follows is
// the caller's.
std::string shader_that_evaluates(const Evaluation& evaluation, std::string_view rest);
// The functions that the shader for a file calls. If the file includes others and has no function of its own, it calls
// one of each file, or of each family, since drivers take long to compile more. Otherwise it calls all functions of the
// file, or a few: those of each kind at a position.
enum class Callees { few, of_each_family, of_each_file };
// A shader of any stage that includes a file, twice, and calls what it declares.
std::string calling_shader(std::string_view file, const Configuration& configuration, const Profile& profile,
                           Stage stage, Callees callees = Callees::of_each_family);

}  // namespace hn
