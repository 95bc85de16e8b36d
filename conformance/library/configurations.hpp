// The settings of the library's knobs under test (configurations.inc).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace hn {

enum class Gradient { octahedral, sine };        // of HN_GRADIENT
enum class Arithmetic { fast, precise, fixed };  // of HN_ARITHMETIC
std::string_view name_of(Arithmetic arithmetic);

// Functions whose values depend on the same knobs. A set of them is their sum.
enum class Family : unsigned {
  independent = 1u << 0,     // exact, whatever the knobs
  hash = 1u << 1,            // exact: of words, and of lattice points
  gradient = 1u << 2,        // exact: hn_gradient with the octahedral gradient
  sine_gradient = 1u << 3,   // hn_gradient with the sine gradient
  gradient_noise = 1u << 4,  // of gradients at lattice points, where it is 0
  lattice_noise = 1u << 5,   // of the words of lattice points, without gradients
  octave_sum = 1u << 6,
  // The same code as above in other dimensions and forms, so that few settings have values of them.
  further_gradient_noise = 1u << 7,
  octahedral_noise = 1u << 8,  // gradient noise that is not declared with the sine gradient
  further_lattice_noise = 1u << 9,
  further_octave_sum = 1u << 10,
  // Gradient noise, and what is made of it, that HN_GRADIENT does not change. Few settings have values of it, too.
  simplex_noise = 1u << 11,
  curl = 1u << 12,
  cellular = 1u << 13,          // cellular noise without further settings; HN_GRADIENT does not change it
  further_cellular = 1u << 14,  // with periods, a jitter, a metric, and what it sets
  // Octave sums of noise that is not declared with the sine gradient.
  octahedral_octave_sum = 1u << 15,
  utility = 1u << 16,       // what HN_ARITHMETIC changes, and is no noise
  distribution = 1u << 17,  // the same, of a value and the numbers of its distribution
};

constexpr unsigned operator|(Family a, Family b) { return static_cast<unsigned>(a) | static_cast<unsigned>(b); }
constexpr unsigned operator|(unsigned a, Family b) { return a | static_cast<unsigned>(b); }

struct Configuration {
  std::string_view name;
  std::string_view hash;  // of HN_HASH_...
  Gradient gradient;
  Arithmetic arithmetic;
  unsigned families;  // that have values with it
  int index;          // in all_configurations()

  bool is_default() const { return name == "lattice"; }
  bool hash_only() const { return gradient == Gradient::octahedral && fast(); }
  bool sine() const { return gradient == Gradient::sine; }
  bool fast() const { return arithmetic == Arithmetic::fast; }
  // Whether a function of a family has values with it.
  constexpr bool covers(Family family, std::string_view function) const;
  // The name without the arithmetic, which has its own part in case ids.
  std::string_view name_without_arithmetic() const;
  // Whether it is the default, apart from the arithmetic.
  bool default_but_for_arithmetic() const { return name_without_arithmetic() == "lattice"; }
};

// The table, here so that a twin can leave out what has no values with its configuration (expected/twin.cpp).
inline constexpr auto kConfigurations = [] {
  using enum Family;
  constexpr Gradient OCTAHEDRAL = Gradient::octahedral;
  constexpr Gradient SINE = Gradient::sine;
  constexpr Arithmetic FAST = Arithmetic::fast;
  constexpr Arithmetic PRECISE = Arithmetic::precise;
  constexpr Arithmetic FIXED = Arithmetic::fixed;
  std::array configurations = {
#define CONFIGURATION(name, hash, gradient, arithmetic, families) \
  Configuration{name, #hash, gradient, arithmetic, families, 0},
#define VALUES(name, function)
#include "library/configurations.inc"
  };
  int index = 0;
  for (Configuration& configuration : configurations) configuration.index = index++;
  return configurations;
}();

struct FurtherValues {
  std::string_view configuration;
  std::string_view function;
};

inline constexpr FurtherValues kFurtherValues[] = {
#define CONFIGURATION(...)
#define VALUES(name, function) {name, function},
#include "library/configurations.inc"
};

constexpr bool Configuration::covers(Family family, std::string_view function) const {
  return (families & static_cast<unsigned>(family)) != 0 ||
         std::ranges::any_of(kFurtherValues, [&](const FurtherValues& further) {
           return further.configuration == name && further.function == function;
         });
}

std::span<const Configuration> all_configurations();
const Configuration& default_configuration();
const Configuration& configuration_named(std::string_view name);  // it must exist

// The lines that select it in a shader, and what they need: the suite's own hash for HN_HASH_CUSTOM.
std::string knobs_of(const Configuration& configuration);

}  // namespace hn
