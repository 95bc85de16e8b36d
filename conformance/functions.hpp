// The library's functions and hashes, as the cases see them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profile.hpp"

namespace hn {

// Words that go into and come out of one evaluation of a function.
constexpr std::size_t kInputWords = 8;
constexpr std::size_t kOutputWords = 4;

enum class WordType { u32, i32, f32, f64 };

struct Column {
  std::string_view name;
  WordType type;
};

// Which bound of tolerance.hpp a function's results keep to.
enum class Accuracy {
  exact,
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

std::span<const Function> all_functions();
const Function& find_function(std::string_view id);  // it must exist

struct Hash {
  std::string_view name;   // in case ids and golden files: "partial_fnv1"
  std::string_view knobs;  // the lines that select it in a shader
  int number;              // the value of HN_HASH
};

std::span<const Hash> all_hashes();
const Hash& default_hash();

// Whether a function's values depend on the hash. Where they do not, its golden file is that of the hash "any".
bool depends_on_hash(const Function& function);

// The shaders of the cases, before their includes are expanded. The fragment shader evaluates the function at the point
// of its pixel.
struct ShaderVariant {
  bool seeded = true;           // else the overload without a seed
  std::string_view knobs = "";  // further definitions, before the include
};
std::string evaluation_shader(const Function& function, const Hash& hash, const Profile& profile,
                              const ShaderVariant& variant = {});
std::string vertex_shader();
// A shader of any stage that includes a file, twice, and calls what it declares.
std::string calling_shader(std::string_view file, const Hash& hash, const Profile& profile, Stage stage);

}  // namespace hn
