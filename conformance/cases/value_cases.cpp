// Cases that evaluate functions on the driver: against the golden files, against the twin, and for properties.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "cases/value_checks.hpp"
#include "expected/golden.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"
#include "expected/twin.hpp"

namespace hn {

tl::expected<Words, Outcome> evaluate(Session& session, const Evaluation& evaluation,
                                      std::span<const std::uint32_t> inputs) {
  if (const auto reason = unsupported_to_run(evaluation.profile, session.info.languages); !reason.empty()) {
    return tl::unexpected(outcome_with(Status::unsupported, {reason, {}}));
  }
  if (const auto reason = unsupported_reason(session.context.gl(), evaluation.stage); !reason.empty()) {
    return tl::unexpected(outcome_with(Status::unsupported, {reason, {}}));
  }
  const auto program = session.evaluation_program(evaluation);
  if (!program) return tl::unexpected(outcome_with(Status::fail, program.error()));
  auto outputs = session.grid.evaluate(**program, inputs);
  if (!outputs) return tl::unexpected(outcome_with(Status::fail, outputs.error()));
  return *outputs;
}

namespace {

// With the default knobs a million, and all that a grid takes, in each arithmetic; with the others a quarter, which are
// many. In ES, which is there for the contexts that have no GLSL 3.30, a sixteenth of that.
std::uint64_t twin_points(const Session& session, const Evaluation& evaluation) {
  if (session.points != 0) return session.points;
  std::uint64_t points = std::uint64_t{1} << 20;
  if (evaluation.configuration.name_without_arithmetic() != default_configuration().name) points /= 4;
  if (evaluation.profile.name != main_profile(evaluation.configuration, false).name) points /= 16;
  return std::min<std::uint64_t>(points, session.most_points);
}

// --- Golden ----------------------------------------------------------------------------------------------------------

Words inputs_of(const Golden& golden) {
  Words words(golden.rows.size() * kInputWords);
  for (std::size_t i = 0; i < golden.rows.size(); ++i) {
    std::copy(golden.rows[i].inputs.begin(), golden.rows[i].inputs.end(),
              words.begin() + static_cast<std::ptrdiff_t>(i * kInputWords));
  }
  return words;
}

Outcome check_digest(Session& session, const Evaluation& evaluation, const GoldenDigest& digest, Outcome outcome) {
  const Words inputs = digest.inputs();
  const auto outputs = evaluate(session, evaluation, inputs);
  if (!outputs) return outputs.error();
  Words values(digest.points());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = (*outputs)[i * kOutputWords];
  outcome.samples += values.size();
  const std::uint64_t got = fnv1a64(values);
  if (got == digest.fnv1a64) return outcome;
  ++outcome.mismatches;
  outcome.status = Status::fail;
  outcome.message = fmt::format("the digest of {} points from {} is {:016x}, expected {:016x}", values.size(),
                                describe_inputs(evaluation.function, point(inputs, 0)), got, digest.fnv1a64);
  return outcome;
}

Outcome check_golden(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const auto golden =
      read_golden(golden_path(session.golden_directory, function, configuration), function, configuration);
  if (!golden) return outcome_with(Status::error, golden.error());
  const Words inputs = inputs_of(*golden);
  const auto outputs = evaluate(session, evaluation, inputs);
  if (!outputs) return outputs.error();
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < golden->rows.size(); ++i) {
    compare_with_golden(comparison, function, configuration, point(inputs, i), result(*outputs, i),
                        golden->rows[i].values);
  }
  const Outcome outcome = comparison.finish();
  if (!golden->digest || outcome.status != Status::pass) return outcome;
  return check_digest(session, evaluation, *golden->digest, outcome);
}

// --- Twin ------------------------------------------------------------------------------------------------------------

// As many as fit are evaluated at a time.
Outcome check_twin(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const std::uint64_t all = twin_points(session, evaluation);
  Comparison comparison(function, {});
  std::uint64_t done = 0;
  for (std::uint64_t batch = 0; done < all; ++batch) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(all - done, session.most_points));
    const Session::PointSet& points = session.twin_points(function, configuration, count, batch);
    const auto inputs = std::span(points.inputs).first(count * kInputWords);
    const auto outputs = evaluate(session, evaluation, inputs);
    if (!outputs) return outputs.error();
    Words expected(count * kOutputWords);
    evaluate_twin(function, configuration, inputs, expected);
    comparison.next_grid(inputs);
    for (std::size_t i = 0; i < count; ++i) {
      compare_with_twin(comparison, evaluation, point(inputs, i), result(*outputs, i), result(expected, i),
                        points.allowed[i]);
    }
    done += count;
    if (done < all) session.still_alive();
  }
  return comparison.finish();
}

// ---------------------------------------------------------------------------------------------------------------------

void add(std::vector<Case>& cases, const Function& function, const Configuration& configuration, const Profile& profile,
         std::string_view name, Check* check) {
  add_case(cases, {function, configuration, profile}, name, check);
}

// Of what the user names instead of the noise fixed arithmetic makes an integer, on the plane and in space.
bool takes_other_noise(const Function& function, const Configuration& configuration) {
  if (configuration.is_default()) return function.input("octaves") >= 0;
  return configuration.name == "lattice+fixed" && (function.id == "fbm.fbm2" || function.id == "fbm.turbulence3");
}

void add_properties(std::vector<Case>& cases, const Function& function, const Configuration& configuration,
                    const Profile& profile) {
  const bool once = configuration.is_default();  // for what does not depend on the knobs
  if (once && function.seed_word() >= 0) add(cases, function, configuration, profile, "unseeded", check_unseeded);
  if (takes_other_noise(function, configuration)) {
    add(cases, function, configuration, profile, "noise_knob", check_noise_knob);
  }
  const bool has_period = function.id.starts_with("gradient.lattice");
  if (once && has_period) add(cases, function, configuration, profile, "wrapped", check_wrapped);
  if (function.exact()) return;
  add(cases, function, configuration, profile, "range", check_range);
  const auto name = configuration.name_without_arithmetic();
  if (name == "lattice" || name == "lattice+sine") {
    add(cases, function, configuration, profile, "finite", check_finite);
  }
  if (!function.id.ends_with(".perlin")) return;
  add(cases, function, configuration, profile, "zero", check_zero);
  // With the sine gradient a hash is as weak as published, and a period of 48 cells has not room for many points.
  if (!configuration.hash_only()) return;
  add(cases, function, configuration, profile, "seeds", check_seeds);
  add(cases, function, configuration, profile, "mirror", check_mirror);
}

void add_fragment_cases(std::vector<Case>& cases, const Function& function, const Configuration& configuration) {
  for (const Profile& profile : run_profiles()) {
    // The code of an octave sum is the same with every hash, and the noise below it has cases of its own. Of the
    // periods one is tried in every version.
    const bool octave_sum = function.input("octaves") >= 0;
    const bool main_version = profile.name == "gl330";
    const bool one_period = configuration.period() == 0 || configuration.name == "lattice+period48";
    const bool everywhere = octave_sum ? configuration.is_default() : one_period;
    if (main_version || everywhere) add(cases, function, configuration, profile, "golden", check_golden);
    // Desktop OpenGL and ES are enough for the large sets: golden values tell their versions apart.
    if (main_version || profile.es) add(cases, function, configuration, profile, "twin", check_twin);
    if (main_version || (profile.es && configuration.is_default())) {
      add_properties(cases, function, configuration, profile);
    }
  }
}

// Of the other arithmetics the noise of the default hash is tried in every version that there is one for; its sums, if
// they are fixed, and one other gradient have golden values in ES, for WebGL2; all else goes through the main version
// only, since most of what a case takes is the time to compile it.
void add_arithmetic_cases(std::vector<Case>& cases, const Function& function, const Configuration& configuration) {
  const Profile& main = main_profile(configuration, false);
  const Profile& es = main_profile(configuration, true);
  const bool fixed = configuration.arithmetic() == Arithmetic::fixed;
  const bool octave_sum = function.input("octaves") >= 0;
  const bool everywhere = configuration.name_without_arithmetic() == "lattice" && !octave_sum;
  for (const auto& [name, check] : {std::pair("golden", &check_golden), std::pair("twin", &check_twin)}) {
    add(cases, function, configuration, main, name, check);
    if (everywhere) add(cases, function, configuration, es, name, check);
    if (everywhere && fixed) add(cases, function, configuration, profile_named("gl140"), name, check);
  }
  const bool in_browsers = configuration.name == "lattice+fixed" || function.accuracy == Accuracy::sine;
  if (fixed && in_browsers && !everywhere) add(cases, function, configuration, es, "golden", check_golden);
  add_properties(cases, function, configuration, main);
}

// The other stages run the same code through another part of the driver's compiler: every function; every hash once as
// itself, once on the lattice and once in a noise; and one of each other knob. All of them in all would be 600
// programs, half a minute of compiling.
void add_stage_cases(std::vector<Case>& cases, const Function& function, const Configuration& configuration) {
  constexpr std::array<std::string_view, 3> kOfEveryHash = {"hash.word", "hash.lattice3", "noise3d.perlin"};
  const bool of_every_hash = std::find(kOfEveryHash.begin(), kOfEveryHash.end(), function.id) != kOfEveryHash.end();
  const bool every_hash = configuration.hash_only() && of_every_hash;
  const bool other_knob = configuration.name == "fnv1+sine" || configuration.name == "lattice+period48";
  const bool arithmetic = has_stages_of_arithmetic(function, configuration);
  if (!configuration.is_default() && !every_hash && !other_knob && !arithmetic) return;
  for (const auto& [stage, profile] : other_stages(configuration)) {
    add_case(cases, {function, configuration, profile_named(profile), {}, stage}, "golden", check_golden);
  }
}

}  // namespace

void add_case(std::vector<Case>& cases, const Evaluation& evaluation, std::string_view name, Check* check) {
  const Function& function = evaluation.function;
  const std::string id = fmt::format(
      "{}.{}.{}.{}.{}.{}", function.id,
      depends_on_configuration(function) ? evaluation.configuration.name_without_arithmetic() : "any",
      arithmetic_name(function, evaluation.configuration), name_of(evaluation.stage), evaluation.profile.name, name);
  const auto kept = std::make_shared<const Evaluation>(evaluation);
  cases.push_back({id, [=](Session& session) { return check(session, *kept); }, kept});
}

void add_value_cases(std::vector<Case>& cases) {
  for (const Function& function : all_functions()) {
    for (const Configuration& configuration : all_configurations()) {
      if (covers(configuration, function)) {
        const auto add_cases = configuration.fast() ? add_fragment_cases : add_arithmetic_cases;
        add_cases(cases, function, configuration);
        add_stage_cases(cases, function, configuration);
      }
      add_metamorphic_cases(cases, function, configuration);
    }
  }
}

}  // namespace hn
