// The library's functions and knobs, as the cases see them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "library/profile.hpp"

namespace hn {

// Words that go into and come out of one evaluation of a function.
constexpr std::size_t kInputWords = 8;
constexpr std::size_t kOutputWords = 4;

// Points lie in a grid with rows of kGridSide: every OpenGL 3.1 implementation has textures of that size at the least.
constexpr std::size_t kGridSide = 1024;
// Invocations of a compute shader that go together. A multiple of what GPUs run at once, and less than the 128 that
// every implementation takes.
constexpr std::size_t kComputeGroup = 64;

enum class WordType { u32, i32, f32, f64 };

struct Column {
  std::string_view name;
  WordType type;
};

// Which bound of tolerance.hpp a function's results keep to.
enum class Accuracy {
  exact,
  sine,
  perlin2,
  perlin2_cell,
  perlin3,
  perlin3_cell,
  fbm2,
  fbm3,
  turbulence2,
  turbulence3,
  clouds2,
  clouds3,
};

struct Function {
  std::string_view id;
  std::string_view file;
  std::string_view columns;  // "x:f32 seed:u32 = value:f64", as in golden files
  std::vector<Column> inputs;
  std::vector<Column> outputs;
  Accuracy accuracy;
  std::string_view body;

  bool exact() const { return accuracy == Accuracy::exact; }
  // The input word of that name, or -1.
  int input(std::string_view name) const;
  int seed_word() const { return input("seed"); }
};

// A function from the text of its columns.
Function make_function(std::string_view id, std::string_view file, std::string_view columns, Accuracy accuracy,
                       std::string_view body);

std::span<const Function> all_functions();
const Function& find_function(std::string_view id);  // it must exist

// What HN_ARITHMETIC selects.
enum class Arithmetic { fast, precise, fixed };

// One setting of the knobs. The names are in case ids and golden files: a hash, and what differs from the default:
// "partial_fnv1", "fnv1+sine", "lattice+period48", "lattice+sine+fixed".
struct Configuration {
  std::string_view name;
  std::string_view knobs;  // the lines that select it in a shader
  int index;               // in all_configurations()

  bool is_default() const { return name == "lattice"; }
  bool hash_only() const { return name.find('+') == std::string_view::npos; }
  bool sine() const { return name.find("+sine") != std::string_view::npos; }
  // Cells, or 0 for 2^32.
  std::uint32_t period() const;
  Arithmetic arithmetic() const;
  bool fast() const { return arithmetic() == Arithmetic::fast; }
  // The name less the arithmetic, which stands at its end: case ids have a part of their own for it.
  std::string_view name_without_arithmetic() const;
};

std::span<const Configuration> all_configurations();
const Configuration& default_configuration();

// "exact" if a function's values do not depend on the arithmetic, else "fast", "precise" or "fixed".
std::string_view arithmetic_name(const Function& function, const Configuration& configuration);
// Whether the contract defines every bit of a function's results: the golden files have these bits.
bool has_exact_values(const Function& function, const Configuration& configuration);
// Whether all evaluations of a function must have the same bits: the driver's and the twin's, in any shape and stage.
bool has_same_bits(const Function& function, const Configuration& configuration);

// The version in which a configuration has most of its cases, of desktop OpenGL or of ES: the lowest that has bit
// casts, and "precise" where that is needed.
const Profile& main_profile(const Configuration& configuration, bool es);

// Its knobs, and what they need: the suite's own hash for HN_HASH_CUSTOM.
std::string knobs_of(const Configuration& configuration);

// Whether a function's values depend on the knobs. Where they do not, its golden file is that of "any".
bool depends_on_configuration(const Function& function);
// Whether there are values of a function to compare with: of a hash alone for every function; of other knobs for the
// functions that they concern.
bool covers(const Configuration& configuration, const Function& function);

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
// What the uniform "variant_seed" must hold. Any number with bits everywhere.
inline constexpr std::uint32_t kVariantSeed = 0xC2B2AE35u;

struct ShaderVariant {
  bool seeded = true;           // else the overload without a seed
  std::string_view knobs = "";  // further definitions, before the include
  Shape shape = Shape::called;
  SeedFrom seed_from = SeedFrom::point;
  std::span<const std::uint32_t> constants = {};  // of Shape::constant: kInputWords per point, of a row of the grid
};

// What is to be evaluated, and how.
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
std::string vertex_shader();         // for evaluation in the fragment stage
std::string idle_fragment_shader();  // for evaluation in the vertex stage
// The same for a shader that is no case: evaluate(uvec4 a, uvec4 b) is declared, and what follows is the caller's.
std::string shader_that_evaluates(const Evaluation& evaluation, std::string_view rest);
// A shader of any stage that includes a file, twice, and calls what it declares.
std::string calling_shader(std::string_view file, const Configuration& configuration, const Profile& profile,
                           Stage stage);

}  // namespace hn
