// The library's functions, as the suite sees them. The catalog has them (tools/lib/catalog/tables/functions.py).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "library/configurations.hpp"
#include "library/profile.hpp"

namespace hn {

// Words that go into and come out of one evaluation of a function. The largest has a cell, a fraction and periods of
// four axes, and a seed.
constexpr std::size_t kInputWords = 16;
constexpr std::size_t kOutputWords = 4;

enum class WordType { u32, i32, f32, f64 };

struct Column {
  std::string_view name;
  WordType type;
};

struct Function {
  std::string_view id;
  std::string_view file;  // to include
  Family family = Family::independent;
  std::string_view bound = "exact";  // or "sine", the name of a noise in bounds.inc, or that of an octave sum
  std::string_view call;             // of a position p, for bench; empty if another row measures the same
  std::string_view body;             // of uvec4 evaluate(uvec4 a, uvec4 b, uvec4 c, uvec4 d)
  std::vector<Column> inputs;        // the words that go in, in the order a.x a.y a.z a.w b.x .. d.w
  std::vector<Column> outputs;
  int axes = 0;  // of the lattice point, position or cell that it takes; 0 if it takes none. They come first
  // The id of the noise whose derivative, or whose value beside it, it is; of an octave sum, that of the sum without
  // slopes. Empty if there is none: the components of vectors have no rows without derivatives, and neither has a
  // quadrature.
  std::string_view plain;
  std::uint32_t configurations = 0;  // that it has values with: a bit for each, by its index
  bool has_unseeded = false;         // whether there is an overload without a seed
  bool is_continuous = true;         // of a noise
  bool is_never_negative = false;    // of a noise
  // Whether it is an octave sum of one noise that adds each octave to a mean, so that its derivatives are those of its
  // value.
  bool is_sum_of_noise = false;
  bool is_offset = false;  // its outputs are the components of the vector to the nearest feature point

  bool exact() const { return bound == "exact"; }
  bool is_noise() const;
  bool is_gradient_noise() const;                                            // it is 0 at lattice points
  bool is_simplex_noise() const { return family == Family::simplex_noise; }  // or phasor noise, of the same lattices
  bool is_cellular() const;
  bool is_octave_sum() const;
  bool is_gullies() const { return bound == "gullies"; }
  bool is_flow() const { return family == Family::curl || is_sum_of_flows(); }  // velocities without divergence
  bool is_sum_of_flows() const { return bound == "curl_fbm"; }
  bool is_further() const;                              // it is of a family that few settings have values of
  bool takes_cell() const { return input("cx") >= 0; }  // and the fraction in it, in place of a position
  bool takes_period() const { return period_word() >= 0; }
  bool takes_phase() const { return input("phase") >= 0; }
  bool takes_wave() const { return input("kx") >= 0; }
  bool takes_jitter() const { return input("jitter") >= 0; }
  bool takes_strength() const { return input("strength") >= 0; }
  bool takes_amplitude() const { return input("amplitude") >= 0; }
  bool takes_footprint() const { return input("footprint") >= 0; }
  bool takes_count() const { return input("n") >= 0; }        // of items
  bool takes_detail() const { return input("detail") >= 0; }  // a float of octaves
  // Whether an output is the cell of the nearest feature point or the word of a hexagon, which is exact though other
  // outputs are not.
  bool is_name(std::size_t output) const {
    const WordType type = outputs[output].type;
    return (type == WordType::i32 || type == WordType::u32) && !exact();
  }
  // Whether an output, or the last one at least, jumps where two feature points are equally near.
  bool jumps(std::size_t output) const { return is_cellular() && (is_name(output) || is_offset || is_slope(output)); }
  bool jumps() const { return jumps(outputs.size() - 1); }
  // Whether it takes positions that are whole numbers of units.
  bool inputs_are_units() const { return input("units") >= 0; }
  // Whether rounding is no part of the way to its cell: it takes a cell, or whole numbers that become one.
  bool starts_from_integers() const { return inputs.front().type == WordType::i32; }
  bool is_slope(std::size_t output) const;  // whether an output is a derivative
  bool has_slopes() const { return is_slope(outputs.size() - 1); }
  bool is_derived() const;  // has_slopes(), or is the value that such a noise has beside them
  bool is_costly() const;   // several times as much as a noise
  // The input word of that name, or -1.
  int input(std::string_view name) const;
  int seed_word() const { return input("seed"); }
  // Whether it is one of a pair of rows, with a period and without, as its id shows.
  bool has_form_without_period() const { return takes_period() && id.ends_with("_period"); }
  int period_word() const { return input("px"); }  // that of the first axis; those of the others follow
  // The parameters of its evaluate: a uvec4 for each four input words, and at least two.
  std::size_t parameters() const { return std::max<std::size_t>((inputs.size() + 3) / 4, 2); }
};

// "x:f32 seed:u32 = value:f64", as in golden files.
std::string columns_of(const Function& function);

std::span<const Function> all_functions();
const Function& find_function(std::string_view id);  // it must exist
// The function whose id has one part less: "noise2d.perlin_cell" is without(noise2d.perlin_cell_period, "period"). It
// must exist.
const Function& without(const Function& function, std::string_view part);
bool has_without(const Function& function, std::string_view part);
// Whether the library declares it with these knobs.
bool is_declared(const Function& function, const Configuration& configuration);

// The arithmetic in case ids: "exact" if a function's values do not depend on it.
std::string_view arithmetic_name(const Function& function, const Configuration& configuration);
// The configuration in case ids and golden files: "any" if a function's values do not depend on it.
std::string_view configuration_name(const Function& function, const Configuration& configuration);
// Whether the contract defines every bit of a function's results: the golden files have these bits.
bool has_exact_values(const Function& function, const Configuration& configuration);
// Whether all evaluations of a function must have the same bits: the driver's and the twin's, in any shape and stage.
bool has_same_bits(const Function& function, const Configuration& configuration);

// Whether there are values of a function to compare with.
inline bool covers(const Configuration& configuration, const Function& function) {
  return (function.configurations >> configuration.index & 1u) != 0;
}

// The version in which a configuration has most of its cases, of desktop OpenGL or of ES: the lowest that has bit
// casts, and "precise" where that is needed.
const Profile& main_profile(const Configuration& configuration, bool es);

}  // namespace hn
