// Metamorphic checks: the driver must come to the same values in another way, within twice the tolerance, since both
// may be off. Other checks verify the values themselves.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "cases/case.hpp"
#include "cases/value_checks.hpp"
#include "expected/pairing.hpp"

namespace hn {
namespace {

// In a loop each trip leaves a word, of the point at hand and of its neighbours; as in the shader: functions may have
// several words if every bit counts, and those that a function has not are 0.
std::uint32_t left_by_trip(std::span<const std::uint32_t> words) { return words[0] ^ words[1] ^ words[2] ^ words[3]; }

}  // namespace

Judged check_pairing(Session& session, const Pairing& pairing) {
  HN_TRY(const auto expected, evaluate(session, pairing.other, pairing.other_inputs));
  HN_TRY(const auto got, evaluate(session, pairing.evaluation, pairing.inputs));
  return judge_pairing(pairing, got, expected);
}

Outcome judge_pairing(const Pairing& pairing, std::span<const std::uint32_t> got,
                      std::span<const std::uint32_t> expected) {
  Comparison comparison(pairing.evaluation.function, pairing.inputs);
  // column: the output that the word is; nothing for what a trip leaves of all of them.
  const auto compare_word = [&](std::size_t i, std::optional<std::size_t> column, std::uint32_t word,
                                std::uint32_t other) {
    const auto in = point(pairing.inputs, i);
    if (pairing.exact) {
      comparison.bits(in, word, other, column);
    } else {
      const std::size_t output = column.value_or(0);
      comparison.word(in, word, pairing.factor * number_of(other), other, pairing.allowed[i * pairing.words() + output],
                      output);
    }
  };
  for (std::size_t i = 0; i < pairing.inputs.size() / kInputWords; ++i) {
    const auto words = result(got, i);
    for (std::size_t trip = 0; pairing.in_loop() && trip < kLoopTrips; ++trip) {
      compare_word(i ^ trip, std::nullopt, words[trip], left_by_trip(result(expected, i ^ trip)));
    }
    for (std::size_t word = 0; !pairing.in_loop() && word < pairing.words(); ++word) {
      compare_word(i, word, words[word], result(expected, i)[word]);
    }
  }
  return comparison.finish();
}

namespace {

// All exact functions go the same ways, so that those of three axes and a seed stand for all.
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
  return function.is_derived() && function.outputs.front().name == "value" && !function.plain.empty();
}

constexpr std::array kVariants = {
    Variant{"inlined", {.shape = Shape::inlined}, variant_pairing},
    Variant{"in_loop", {.shape = Shape::in_loop}, variant_pairing},
    Variant{"constant_seed", {.seed_from = SeedFrom::constant}, variant_pairing},
    Variant{"uniform_seed", {.seed_from = SeedFrom::uniform}, variant_pairing},
    Variant{"folded", {}, folded_pairing},
};

// Other ways to compute these points.
std::vector<Relation> variants_of(const Evaluation& evaluation, const Target& target) {
  const auto& [function, configuration, profile, none, stage] = evaluation;
  const bool of_vulkan = profile.platform() == Platform::vulkan && profile.in_glsl();
  if (!(target.main || of_vulkan) || !configuration.default_but_for_arithmetic() || !has_variants(function)) return {};
  std::vector<Relation> variants;
  for (const auto& [name, variant, make] : kVariants) {
    // If several words are only near the right ones, a loop over them proves nothing.
    if (name == "in_loop" && function.outputs.size() > 1 && !has_same_bits(function, configuration)) continue;
    variants.push_back({name, PairingKind{{function, configuration, profile, variant, stage}, make}});
  }
  return variants;
}

}  // namespace

std::vector<Relation> relations_of(const Evaluation& evaluation, const Target& target) {
  const Function& function = evaluation.function;
  std::vector<Relation> relations = variants_of(evaluation, target);
  if (!target.main) return relations;
  const auto add = [&](std::string_view name, MakePairing* make, const Function& with) {
    relations.push_back({name, PairingKind{evaluation, make}, &with});
  };
  if (function.takes_period()) {
    // Without a period octaves rotate, so that a sum is another one.
    const bool is_one_of_two = function.has_form_without_period() && has_without(function, "period");
    if (is_one_of_two && !function.is_octave_sum()) {
      add("wrapped", wrapped_pairing, without(function, "period"));
    }
    relations.push_back({"constant_period", PairingKind{evaluation, constant_period_pairing}});
  }
  // Sums on the line and in four dimensions have not all forms in the table.
  const bool has_position = function.is_octave_sum() && function.takes_cell() && has_without(function, "cell");
  if (has_position) add("from_cell", from_cell_pairing, without(function, "cell"));
  if (function.is_octave_sum() && function.takes_detail()) {
    add("whole_detail", whole_detail_pairing, without(function, "detail"));
  }
  if (function.takes_footprint()) add("small_footprint", small_footprint_pairing, without(function, "footprint"));
  // With periods the field has no values but those that it has without. Points that go round are nearer to the centres
  // of their cells, and waves always have a phase.
  if (function.takes_phase() && !function.takes_period() && !function.is_cellular() && !function.takes_wave()) {
    add("phase_zero", phase_zero_pairing, without(function, "phase"));
  }
  const bool comes_with_value = function.is_noise() || function.is_octave_sum();
  if (function.bound == "phasor_bandwidth" && has_without(function, "bandwidth")) {
    add("zero_bandwidth", zero_bandwidth_pairing, without(function, "bandwidth"));
  }
  if (function.bound == "eroded") add("zero_strength", zero_strength_pairing, find_function(function.plain));
  if (comes_with_value && has_value_with_derivative(function)) {
    add("derivative_value", derivative_value_pairing, find_function(function.plain));
  }
  return relations;
}

std::vector<Relation> repetitions_of(const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  std::vector<Relation> repetitions;
  const auto add = [&](std::string_view name, MakePairing* make) {
    repetitions.push_back({name, PairingKind{evaluation, make}});
  };
  if (function.takes_period()) add("period", period_pairing);
  if (function.takes_phase()) {
    add("loop", loop_pairing);
    if (!function.takes_period() && !function.is_cellular()) add("half_turn", half_turn_pairing);
  }
  return repetitions;
}

Relation as_fragment(const Evaluation& evaluation) { return {"as_fragment", PairingKind{evaluation, variant_pairing}}; }

}  // namespace hn
