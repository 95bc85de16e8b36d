// The settings of the library's knobs under test (catalog/configurations.toml).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hn {

enum class Gradient { octahedral, sine };        // of HN_GRADIENT
enum class Arithmetic { fast, precise, fixed };  // of HN_ARITHMETIC
std::string_view name_of(Arithmetic arithmetic);

// Functions whose values depend on the same knobs (catalog/configurations.toml).
enum class Family {
#include "library/families.inc"
};

struct Configuration {
  std::string_view name;
  std::string_view hash;  // of HN_HASH_...
  Gradient gradient;
  Arithmetic arithmetic;
  int index;  // in all_configurations()

  bool is_default() const { return name == "lattice"; }
  bool hash_only() const { return gradient == Gradient::octahedral && fast(); }
  bool sine() const { return gradient == Gradient::sine; }
  bool fast() const { return arithmetic == Arithmetic::fast; }
  // The name without the arithmetic, which has its own part in case ids.
  std::string_view name_without_arithmetic() const;
  // Whether it is the default, apart from the arithmetic.
  bool default_but_for_arithmetic() const { return name_without_arithmetic() == "lattice"; }
};

std::span<const Configuration> all_configurations();
const Configuration& default_configuration();
const Configuration& configuration_named(std::string_view name);  // it must exist

// The lines that select it in a shader, and their needs: the suite's own hash for HN_HASH_CUSTOM.
std::string knobs_of(const Configuration& configuration);

}  // namespace hn
