// Metamorphic checks: the driver must come to the same values on another way, within twice the tolerance, since it may
// be off on both. What the values are, other checks tell.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "cases/value_checks.hpp"
#include "expected/pairing.hpp"

namespace hn {
namespace {

// In a loop each trip leaves a word, of the point at hand and of its neighbours; as in the shader: exact functions may
// have several words, and those that a function has not are 0.
std::uint32_t left_by_trip(std::span<const std::uint32_t> words) { return words[0] ^ words[1] ^ words[2] ^ words[3]; }

Outcome compare(Session& session, const Pairing& pairing) {
  const auto expected = evaluate(session, pairing.other, pairing.other_inputs);
  if (!expected) return expected.error();
  const auto got = evaluate(session, pairing.evaluation, pairing.inputs);
  if (!got) return got.error();
  const Function& function = pairing.evaluation.function;
  Comparison comparison(function, pairing.inputs);
  const auto compare_word = [&](std::size_t i, std::uint32_t word, std::uint32_t other) {
    const auto in = point(pairing.inputs, i);
    if (pairing.exact) {
      comparison.bits(in, word, other);
    } else {
      comparison.number(in, std::bit_cast<float>(word), static_cast<double>(std::bit_cast<float>(other)),
                        pairing.allowed[i]);
    }
  };
  for (std::size_t i = 0; i < pairing.allowed.size(); ++i) {
    const auto words = result(*got, i);
    for (std::size_t trip = 0; pairing.in_loop() && trip < kLoopTrips; ++trip) {
      compare_word(i ^ trip, words[trip], left_by_trip(result(*expected, i ^ trip)));
    }
    for (std::size_t word = 0; !pairing.in_loop() && word < function.outputs.size(); ++word) {
      compare_word(i, words[word], result(*expected, i)[word]);
    }
  }
  return comparison.finish();
}

Outcome check_variant(Session& session, const Evaluation& evaluation) {
  return compare(session, variant_pairing(evaluation, session.seed));
}

Outcome check_folded(Session& session, const Evaluation& evaluation) {
  return compare(session, folded_pairing(evaluation, session.seed));
}

Outcome check_period(Session& session, const Evaluation& evaluation) {
  return compare(session, period_pairing(evaluation, session.seed));
}

// ---------------------------------------------------------------------------------------------------------------------

// The octave sum that stands for all of them where the arithmetic is not the default.
constexpr std::string_view kArithmeticSum = "fbm.fbm2";

bool is_noise(const Function& function) { return !function.exact() && function.accuracy != Accuracy::sine; }

bool stands_for_arithmetic(const Configuration& configuration) {
  return !configuration.fast() && configuration.name_without_arithmetic() == "lattice";
}

// Every noise, and of the exact functions a hash and a gradient. Each variant is a shader more to compile, and goes the
// same ways with every hash.
bool has_variants(const Function& function, const Configuration& configuration) {
  if (stands_for_arithmetic(configuration)) return function.id == "noise3d.perlin" || function.id == kArithmeticSum;
  if (!configuration.is_default()) return false;
  return is_noise(function) || function.id == "hash.lattice3" || function.id == "gradient.lattice3";
}

// These, and perlin with every hash: the other stages have the shaders anyway, for the golden files.
bool has_stages(const Function& function, const Configuration& configuration) {
  if (!configuration.fast()) return has_stages_of_arithmetic(function, configuration);
  return has_variants(function, configuration) || (function.id.ends_with(".perlin") && configuration.hash_only());
}

// Of octave sums, whose code does not depend on the period, with one that is no power of two. (Over 2^20 cells their
// positions would have no fraction left.)
bool has_period(const Function& function, const Configuration& configuration) {
  if (configuration.period() == 0) return false;
  if (!configuration.fast() && function.file == "fbm.glsl") return function.id == kArithmeticSum;
  if (function.input("octaves") >= 0) return configuration.name == "lattice+period48";
  return covers(configuration, function);
}

void add_variants(std::vector<Case>& cases, const Function& function, const Configuration& configuration,
                  const Profile& profile) {
  const auto add = [&](const ShaderVariant& variant, std::string_view name, Check* check) {
    add_case(cases, {function, configuration, profile, variant}, name, check);
  };
  add({.shape = Shape::inlined}, "inlined", check_variant);
  add({.shape = Shape::in_loop}, "in_loop", check_variant);
  add({.seed_from = SeedFrom::constant}, "constant_seed", check_variant);
  add({.seed_from = SeedFrom::uniform}, "uniform_seed", check_variant);
  add({}, "folded", check_folded);
}

}  // namespace

std::vector<StageProfile> other_stages(const Configuration& configuration) {
  if (configuration.arithmetic() == Arithmetic::precise) {
    return {{Stage::vertex, "gl400"}, {Stage::compute, "gl430"}};
  }
  return {{Stage::vertex, "gl330"}, {Stage::vertex, "es300"}, {Stage::compute, "gl430"}, {Stage::compute, "es310"}};
}

bool has_stages_of_arithmetic(const Function& function, const Configuration& configuration) {
  return function.id == "noise3d.perlin" && stands_for_arithmetic(configuration);
}

void add_metamorphic_cases(std::vector<Case>& cases, const Function& function, const Configuration& configuration) {
  for (const bool es : {false, true}) {
    if (es && !configuration.fast()) continue;  // their shaders are built in few versions
    const Profile& profile = main_profile(configuration, es);
    if (has_variants(function, configuration)) add_variants(cases, function, configuration, profile);
    if (has_period(function, configuration)) {
      add_case(cases, {function, configuration, profile}, "period", check_period);
    }
  }
  if (!has_stages(function, configuration)) return;
  for (const auto& [stage, profile] : other_stages(configuration)) {
    add_case(cases, {function, configuration, profile_named(profile), {}, stage}, "as_fragment", check_variant);
  }
}

}  // namespace hn
