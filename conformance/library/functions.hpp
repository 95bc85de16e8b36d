// The library's functions, as the suite sees them (functions.inc).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "library/configurations.hpp"
#include "library/profile.hpp"

namespace hn {

// Words that go into and come out of one evaluation of a function.
constexpr std::size_t kInputWords = 8;
constexpr std::size_t kOutputWords = 4;

enum class WordType { u32, i32, f32, f64 };

struct Column {
  std::string_view name;
  WordType type;
};

struct Function {
  std::string_view id;
  std::string_view file;
  Family family;
  std::string_view bound;    // "exact", "sine", the name of a noise in bounds.inc, "fbm", "turbulence" or "clouds"
  std::string_view columns;  // "x:f32 seed:u32 = value:f64", as in golden files
  std::string_view call;     // of a position p, for bench
  std::string_view body;
  std::vector<Column> inputs;
  std::vector<Column> outputs;
  int axes;  // of the lattice point, position or cell that it takes; 0 if it takes none. They come first

  bool exact() const { return bound == "exact"; }
  bool is_noise() const { return family == Family::gradient_noise || family == Family::lattice_noise; }
  bool is_octave_sum() const { return family == Family::octave_sum; }
  bool takes_cell() const { return input("cx") >= 0; }  // and the fraction in it, in place of a position
  // The input word of that name, or -1.
  int input(std::string_view name) const;
  int seed_word() const { return input("seed"); }
};

// What a row of the table says. Throws if the columns are not columns.
Function make_function(std::string_view id, std::string_view file, Family family, std::string_view bound,
                       std::string_view columns, std::string_view call, std::string_view body);

std::span<const Function> all_functions();
const Function& find_function(std::string_view id);  // it must exist

// What case ids say of the arithmetic: "exact" if a function's values do not depend on it.
std::string_view arithmetic_name(const Function& function, const Configuration& configuration);
// What case ids and golden files say of the configuration: "any" if a function's values do not depend on it.
std::string_view configuration_name(const Function& function, const Configuration& configuration);
// Whether the contract defines every bit of a function's results: the golden files have these bits.
bool has_exact_values(const Function& function, const Configuration& configuration);
// Whether all evaluations of a function must have the same bits: the driver's and the twin's, in any shape and stage.
bool has_same_bits(const Function& function, const Configuration& configuration);

// Whether there are values of a function to compare with.
inline bool covers(const Configuration& configuration, const Function& function) {
  return configuration.covers(function.family);
}

// The version in which a configuration has most of its cases, of desktop OpenGL or of ES: the lowest that has bit
// casts, and "precise" where that is needed.
const Profile& main_profile(const Configuration& configuration, bool es);

}  // namespace hn
