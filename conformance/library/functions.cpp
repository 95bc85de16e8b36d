#include "library/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/entry_named.hpp"

namespace hn {
namespace {

WordType type_of(std::string_view name) {
  if (name == "u32") return WordType::u32;
  if (name == "i32") return WordType::i32;
  if (name == "f32") return WordType::f32;
  if (name == "f64") return WordType::f64;
  throw std::logic_error(fmt::format("no column has the type '{}'", name));
}

// "x:f32 y:f32" -> columns
std::vector<Column> parse_columns(std::string_view text) {
  std::vector<Column> columns;
  while (!text.empty()) {
    const auto end = std::min(text.find(' '), text.size());
    const auto item = text.substr(0, end);
    const auto colon = item.find(':');
    if (colon == std::string_view::npos) throw std::logic_error(fmt::format("'{}' is not a column", item));
    columns.push_back({item.substr(0, colon), type_of(item.substr(colon + 1))});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return columns;
}

// The columns of coordinates come first.
int axes_of(std::span<const Column> inputs) {
  constexpr std::array<std::string_view, 4> kPoint = {"x", "y", "z", "w"};
  constexpr std::array<std::string_view, 4> kCell = {"cx", "cy", "cz", "cw"};
  const auto& names = !inputs.empty() && inputs.front().name == kCell.front() ? kCell : kPoint;
  std::size_t axes = 0;
  while (axes < std::min(inputs.size(), names.size()) && inputs[axes].name == names[axes]) ++axes;
  return static_cast<int>(axes);
}

const std::vector<Function>& functions() {
  using enum Family;
  static const std::vector<Function> kFunctions = {
#define FUNCTION(id, file, family, bound, columns, call, ...) \
  make_function(id, file, family, bound, columns, call, #__VA_ARGS__),
#include "library/functions.inc"
  };
  return kFunctions;
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

// "a_b_c" without "b" is "a_c".
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
         is_one_of(family, {Family::lattice_noise, Family::further_lattice_noise});
}

bool Function::is_cellular() const { return is_one_of(family, {Family::cellular, Family::further_cellular}); }

bool Function::is_gradient_noise() const {
  return is_one_of(family, {Family::gradient_noise, Family::further_gradient_noise, Family::octahedral_noise}) ||
         (is_simplex_noise() && !takes_wave());
}

bool Function::is_octave_sum() const {
  return is_one_of(family, {Family::octave_sum, Family::further_octave_sum, Family::octahedral_octave_sum});
}

bool Function::is_further() const {
  return is_one_of(family, {Family::further_gradient_noise, Family::octahedral_noise, Family::further_lattice_noise,
                            Family::further_octave_sum, Family::octahedral_octave_sum, Family::simplex_noise,
                            Family::curl, Family::cellular, Family::further_cellular, Family::utility,
                            Family::distribution});
}

namespace {

struct NoiseFacts {
  std::string_view name;
  bool jumps;
  bool is_never_negative;
};
constexpr NoiseFacts kNoises[] = {
#define NOISE(name, jumps, is_never_negative) {#name, jumps, is_never_negative},
#include "library/facts.inc"
};

bool is_noise_with(bool NoiseFacts::* fact, std::string_view name) {
  return std::ranges::any_of(kNoises, [&](const NoiseFacts& noise) { return noise.name == name && noise.*fact; });
}

}  // namespace

bool Function::is_continuous() const { return !is_noise_with(&NoiseFacts::jumps, bound); }
bool Function::is_sum_of_noise() const {
  constexpr std::string_view kSums[] = {
#define OCTAVE_SUM(name, ...) #name,
#include "library/facts.inc"
  };
  return is_octave_sum() && std::ranges::find(kSums, bound) != std::end(kSums);
}

bool Function::is_never_negative() const { return is_noise_with(&NoiseFacts::is_never_negative, bound); }

bool Function::is_derived() const { return bound.ends_with("_d") || bound.ends_with("_d_phase"); }

bool Function::is_costly() const {
  return is_octave_sum() || family == Family::curl || (is_noise() && (has_slopes() || axes == 4)) ||
         (is_cellular() && (axes == 3 || bound == "cell_border"));
}

// dx, dy, dz, dw
bool Function::is_slope(std::size_t output) const {
  const std::string_view name = outputs[output].name;
  return name.size() == 2 && name.front() == 'd';
}

Function make_function(std::string_view id, std::string_view file, Family family, std::string_view bound,
                       std::string_view columns, std::string_view call, std::string_view body) {
  constexpr std::string_view kEquals = " = ";
  const auto equals = columns.find(kEquals);
  if (equals == std::string_view::npos) throw std::logic_error(fmt::format("{}: it has no output column", id));
  Function function{id,
                    file,
                    family,
                    bound,
                    columns,
                    call,
                    body,
                    parse_columns(columns.substr(0, equals)),
                    parse_columns(columns.substr(equals + kEquals.size())),
                    0};
  function.axes = axes_of(function.inputs);
  return function;
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

namespace {

// In four dimensions value and derivative are two rows: perlin_d_value and perlin_d. The sums of noises with
// derivatives are in a file of their own: fbm_d.fbm_d2 and fbm_d.eroded2 belong to fbm.fbm2.
std::string plain_id(const Function& function) {
  if (function.is_octave_sum()) {
    const auto behind = function.id.find('.') + 1 + function.bound.size();
    return fmt::format("fbm.fbm{}", function.id.substr(behind));
  }
  const bool is_value = function.id.find("_d_") != std::string_view::npos && function.id.ends_with("_value");
  return id_without(is_value ? id_without(function.id, "value") : function.id, "d");
}

}  // namespace

const Function& plain_noise_of(const Function& function) { return find_function(plain_id(function)); }

bool has_plain_noise(const Function& function) {
  return std::ranges::any_of(functions(),
                             [id = plain_id(function)](const Function& other) { return other.id == id; });
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
