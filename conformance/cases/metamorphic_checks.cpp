// Metamorphic checks: the driver must come to the same values on another way, within twice the tolerance, since it may
// be off on both. What the values are, other checks tell.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "cases/targets.hpp"
#include "cases/value_checks.hpp"
#include "expected/pairing.hpp"

namespace hn {
namespace {

// In a loop each trip leaves a word, of the point at hand and of its neighbours; as in the shader: functions may have
// several words if every bit counts, and those that a function has not are 0.
std::uint32_t left_by_trip(std::span<const std::uint32_t> words) { return words[0] ^ words[1] ^ words[2] ^ words[3]; }

}  // namespace

Outcome check_pairing(Session& session, const Pairing& pairing) {
  const auto expected = evaluate(session, pairing.other, pairing.other_inputs);
  if (!expected) return expected.error();
  const auto got = evaluate(session, pairing.evaluation, pairing.inputs);
  if (!got) return got.error();
  Comparison comparison(pairing.evaluation.function, pairing.inputs);
  // column: the output that the word is; nothing for what a trip leaves of all of them.
  const auto compare_word = [&](std::size_t i, std::optional<std::size_t> column, std::uint32_t word,
                                std::uint32_t other) {
    const auto in = point(pairing.inputs, i);
    if (pairing.exact) {
      comparison.bits(in, word, other, column);
    } else {
      const std::size_t output = column.value_or(0);
      comparison.word(in, word, pairing.factor * static_cast<double>(std::bit_cast<float>(other)), other,
                      pairing.allowed[i * pairing.words() + output], output);
    }
  };
  for (std::size_t i = 0; i < pairing.inputs.size() / kInputWords; ++i) {
    const auto words = result(*got, i);
    for (std::size_t trip = 0; pairing.in_loop() && trip < kLoopTrips; ++trip) {
      compare_word(i ^ trip, std::nullopt, words[trip], left_by_trip(result(*expected, i ^ trip)));
    }
    for (std::size_t word = 0; !pairing.in_loop() && word < pairing.words(); ++word) {
      compare_word(i, word, words[word], result(*expected, i)[word]);
    }
  }
  return comparison.finish();
}

namespace {

// Of an exact function one goes the same ways as another: those of three axes and a seed stand for all.
bool has_variants(const Function& function) {
  return !function.exact() || (function.axes == 3 && function.seed_word() >= 0);
}

struct Variant {
  std::string_view name;
  ShaderVariant variant;
  MakePairing* make;
};

// It is held against the noise, or the sum, without a derivative.
bool has_value_with_derivative(const Function& function) {
  return function.is_derived() && function.outputs.front().name == "value";
}

constexpr std::array kVariants = {
    Variant{"inlined", {.shape = Shape::inlined}, variant_pairing},
    Variant{"in_loop", {.shape = Shape::in_loop}, variant_pairing},
    Variant{"constant_seed", {.seed_from = SeedFrom::constant}, variant_pairing},
    Variant{"uniform_seed", {.seed_from = SeedFrom::uniform}, variant_pairing},
    Variant{"folded", {}, folded_pairing},
};

}  // namespace

// A variant of the shader is one more to compile. With the defaults each function has all of them, in one arithmetic
// and one version or another; of further functions some. Vulkan has them of the other functions, in turn.
void add_metamorphic_cases(std::vector<Case>& cases, const Evaluation& evaluation, const Target& target,
                           Extent extent) {
  const auto& [function, configuration, profile, none, stage] = evaluation;
  const bool defaults = configuration.default_but_for_arithmetic() && covers(configuration, function);
  const bool of_vulkan = profile.platform() == Platform::vulkan && profile.in_glsl() && !function.is_further();
  if ((target.main || of_vulkan) && defaults && has_variants(function)) {
    for (std::size_t i = 0; i < kVariants.size(); ++i) {
      const auto& [name, variant, make] = kVariants[i];
      // Of several words that are near the right ones nothing can be said by what a trip leaves of them.
      if (name == "in_loop" && function.outputs.size() > 1 && !has_same_bits(function, configuration)) continue;
      const bool all = target.main
                           ? configuration.is_default() && !function.is_further() && (!profile.es || function.exact())
                           : function.exact();
      const bool some = has_turn(function, configuration, target.number + i) && !(function.is_further() && profile.es);
      cases.push_back({name_of(evaluation, name), PairingKind{{function, configuration, profile, variant, stage}, make},
                       all || some ? Extent::one_driver : Extent::thorough});
    }
  }
  const bool has_fragment = profile.platform() == Platform::opengl;
  if (!target.main && stage != Stage::fragment && has_fragment && covers(configuration, function)) {
    cases.push_back({name_of(evaluation, "as_fragment"), PairingKind{evaluation, variant_pairing}, extent});
  }
  if (!target.main || !covers(configuration, function)) return;
  const auto add = [&](std::string_view name, MakePairing* make) {
    cases.push_back({name_of(evaluation, name), PairingKind{evaluation, make}, std::max(extent, Extent::one_driver)});
  };
  if (function.takes_period()) {
    add("period", period_pairing);
    // Without a period octaves turn, so that a sum is another one.
    if (function.has_form_without_period() && !function.is_octave_sum()) add("wrapped", wrapped_pairing);
    // One more shader to compile.
    const bool chosen = configuration.is_default() && !profile.es;
    cases.push_back({name_of(evaluation, "constant_period"), PairingKind{evaluation, constant_period_pairing},
                     chosen ? Extent::one_driver : Extent::thorough});
  }
  // Sums on the line and in four dimensions have not all forms in the table.
  const bool has_position = function.is_octave_sum() && function.takes_cell() && has_without(function, "cell");
  if (has_position) add("from_cell", from_cell_pairing);
  if (function.takes_detail()) add("whole_detail", whole_detail_pairing);
  if (function.takes_footprint()) add("small_footprint", small_footprint_pairing);
  if (function.takes_phase()) {
    add("loop", loop_pairing);
    // With periods the field has no values but those that it has without.
    if (!function.takes_period()) {
      add("half_turn", half_turn_pairing);
      add("phase_zero", phase_zero_pairing);
    }
  }
  if (function.bound == "eroded") add("zero_strength", zero_strength_pairing);
  const bool comes_with_value = function.is_noise() || function.is_octave_sum();
  if (comes_with_value && has_value_with_derivative(function)) add("derivative_value", derivative_value_pairing);
}

}  // namespace hn
