#include "library/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/entry_named.hpp"

namespace hn {
namespace {

const std::vector<Function>& functions() {
  using enum Family;
  using enum WordType;
  static const std::vector<Function> kFunctions = {
#include "library/functions.inc"
  };
  return kFunctions;
}

std::string_view name_of(WordType type) {
  constexpr std::array<std::string_view, 4> kNames = {"u32", "i32", "f32", "f64"};
  return kNames.at(static_cast<std::size_t>(type));
}

std::string columns_text(std::span<const Column> columns) {
  std::string text;
  for (const Column& column : columns) text += fmt::format(" {}:{}", column.name, name_of(column.type));
  return text.substr(1);
}

}  // namespace

int Function::input(std::string_view name) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const Column& c) { return c.name == name; });
  return found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin());
}

namespace {

bool is_one_of(Family family, std::initializer_list<Family> families) {
  return std::ranges::find(families, family) != families.end();
}

std::string id_without(std::string_view text, std::string_view part) {
  std::string id(text);
  const std::string suffix = fmt::format("_{}", part);
  for (auto at = id.find(suffix); at != std::string::npos; at = id.find(suffix, at + 1)) {
    const auto end = at + suffix.size();
    if (end == id.size() || id[end] == '_') return id.erase(at, suffix.size());
  }
  throw std::logic_error(fmt::format("{} has no part {}", text, part));
}

}  // namespace

bool Function::is_noise() const {
  return is_gradient_noise() || is_simplex_noise() || is_cellular() ||
         is_one_of(family, {Family::lattice_noise, Family::extended_lattice_noise});
}

bool Function::is_cellular() const { return is_one_of(family, {Family::cellular, Family::extended_cellular}); }

bool Function::is_gradient_noise() const {
  return is_one_of(family, {Family::gradient_noise, Family::extended_gradient_noise, Family::octahedral_noise}) ||
         (is_simplex_noise() && !takes_wave());
}

bool Function::is_octave_sum() const {
  return is_one_of(family, {Family::octave_sum, Family::extended_octave_sum, Family::octahedral_octave_sum});
}

bool Function::is_further() const {
  return is_one_of(family,
                   {Family::extended_gradient_noise, Family::octahedral_noise, Family::extended_lattice_noise,
                    Family::extended_octave_sum, Family::octahedral_octave_sum, Family::simplex_noise, Family::curl,
                    Family::cellular, Family::extended_cellular, Family::utility, Family::distribution});
}

bool Function::is_derived() const {
  return bound.ends_with("_d") || bound.ends_with("_d_phase") || bound.ends_with("_d_bandwidth");
}

bool Function::is_costly() const {
  return is_octave_sum() || is_flow() || (is_noise() && (has_slopes() || axes == 4)) ||
         (is_cellular() && (axes == 3 || bound == "cell_border"));
}

// dx, dy, dz, dw
bool Function::is_slope(std::size_t output) const {
  const std::string_view name = outputs[output].name;
  return name.size() == 2 && name.front() == 'd';
}

std::string columns_of(const Function& function) {
  return fmt::format("{} = {}", columns_text(function.inputs), columns_text(function.outputs));
}

std::span<const Function> all_functions() { return functions(); }

const Function& find_function(std::string_view id) { return entry_named(functions(), &Function::id, id, "function"); }

const Function& without(const Function& function, std::string_view part) {
  return find_function(id_without(function.id, part));
}

bool has_without(const Function& function, std::string_view part) {
  return std::ranges::any_of(functions(),
                             [id = id_without(function.id, part)](const Function& other) { return other.id == id; });
}

bool is_declared(const Function& function, const Configuration& configuration) {
  return !configuration.sine() ||
         !is_one_of(function.family, {Family::octahedral_noise, Family::octahedral_octave_sum});
}

std::string_view arithmetic_name(const Function& function, const Configuration& configuration) {
  return function.exact() ? "exact" : name_of(configuration.arithmetic);
}

std::string_view configuration_name(const Function& function, const Configuration& configuration) {
  return function.family == Family::independent ? "any" : configuration.name_without_arithmetic();
}

bool has_exact_values(const Function& function, const Configuration& configuration) {
  return function.exact() || configuration.arithmetic == Arithmetic::fixed;
}

bool has_same_bits(const Function& function, const Configuration& configuration) {
  return function.exact() || !configuration.fast();
}

const Profile& main_profile(const Configuration& configuration, bool es) {
  if (configuration.arithmetic == Arithmetic::precise) return profile_named(es ? "es320" : "gl400");
  return profile_named(es ? "es300" : "gl330");
}

}  // namespace hn
