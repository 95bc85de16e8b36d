// The cases that evaluate functions on the driver: which there are follows from the tables of functions and
// configurations, and which of them a run has without --thorough, from the cover of programs.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "cases/programs.hpp"
#include "cases/value_checks.hpp"

namespace hn {
namespace {

// The properties of a function that follow from its row alone, and need no program but its own.
std::vector<Relation> properties_of(const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  std::vector<Relation> properties;
  const auto add = [&](std::string_view name, Check* check) {
    properties.push_back({name, CheckKind{evaluation, check}});
  };
  const bool is_plain = !function.takes_period() && !function.takes_jitter();
  if (function.is_cellular() && !profile.es) {
    add("search", check_search);
    if (function.bound == "cell_border" && is_plain) add("border", check_border);
  }
  // With periods the field has no values but those that it has without. Where the jitter is chosen, it may be none:
  // then a field is its own mirror, and has no seeds.
  if (function.exact() || !is_plain) return properties;
  add("range", check_range);
  // A hash changes no value's size.
  if (configuration.hash == default_configuration().hash) add("finite", check_finite);
  if (function.is_flow()) add("divergence", check_divergence);
  if (!function.is_noise()) return properties;
  const bool has_seams = !function.inputs_are_units() && function.is_continuous;
  if (configuration.hash == default_configuration().hash && has_seams) add("seams", check_seams);
  if (function.starts_from_integers()) return properties;
  if (function.is_gradient_noise() && !function.is_slope(0)) add("zero", check_zero);
  // With the sine gradient a hash is as weak as published. With derivatives the field is the same.
  if (!configuration.hash_only() || function.is_derived()) return properties;
  add("seeds", check_seeds);
  add("mirror", check_mirror);
  return properties;
}

// The cases that compile other programs besides.
std::vector<Relation> further_cases_of(const Evaluation& evaluation, const Target& target) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  std::vector<Relation> further = relations_of(evaluation, target);
  if (!target.main) return further;
  const auto add = [&](std::string_view name, Check* check, const Function* with = nullptr) {
    further.push_back({name, CheckKind{evaluation, check}, with});
  };
  const bool once = configuration.is_default();  // for what does not depend on the knobs
  // HN_FIXED converts a noise of the user's to an integer.
  const bool takes_noise = once || configuration.name == "lattice+fixed";
  if (takes_noise && function.is_sum_of_noise) {
    Relation over_constant{"other_noise", CheckKind{evaluation, check_other_noise}};
    if (cuts_noise_off(function, configuration.arithmetic)) {
      over_constant.besides =
          function.has_slopes() ? "cut slopes" : fmt::format("cut {}", name_of(configuration.arithmetic));
    }
    further.push_back(std::move(over_constant));
  }
  if (!profile.es && (function.id.ends_with("cellular_cell_nearest") || function.id.ends_with("cell_border_nearest"))) {
    further.push_back({"cell_names", CheckKind{evaluation, check_cell_names}, nullptr, 4});
  }
  if (const Function* alone = returning(function)) {
    std::string dimension = fmt::format("{} of {} axes", function.bound, function.axes);
    further.push_back({"returned", CheckKind{evaluation, check_returned}, alone, 2, std::move(dimension)});
  }
  if (!function.has_slopes()) return further;
  if (function.is_sum_of_noise) {
    // The errors of sums in integers are no part of this suite: golden files have their bits.
    if (configuration.arithmetic != Arithmetic::fixed)
      add("derivative", check_slope_sum, &find_function(function.plain));
  } else if (function.is_noise() && !function.plain.empty()) {
    add("derivative", check_derivative, &find_function(function.plain));
  }
  return further;
}

Evaluation evaluation_of(const PlannedProgram& program) {
  return {*program.function, *program.configuration, *program.target.profile, {}, program.target.stage};
}

}  // namespace

CaseName name_of(const Evaluation& evaluation, std::string_view check) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  return {.function = std::string(function.id),
          .configuration = std::string(configuration_name(function, configuration)),
          .arithmetic = std::string(arithmetic_name(function, configuration)),
          .stage = stage,
          .profile = std::string(profile.name),
          .check = std::string(check)};
}

namespace {

// A check meets every arithmetic in which it exists, and every family, dimension and version, or, where it compares
// functions, every noise and every sum. Taken are those that compile little which the cover has not.
class FurtherCases {
 public:
  FurtherCases() : programs_(all_programs()), extents_(program_extents()), chosen_(programs_.size()) {
    for (std::size_t i = 0; i < programs_.size(); ++i) {
      if (programs_[i].target.stage == Stage::fragment) places_[key_of(programs_[i], *programs_[i].function)] = i;
    }
    for (std::size_t i = 0; i < programs_.size(); ++i) add(i);
    const std::vector<bool> cover = cover_of(candidates_, things_.size());
    for (std::size_t i = 0; i < cover.size(); ++i) {
      if (cover[i]) chosen_[of_[i].first].insert(of_[i].second);
    }
  }

  const std::vector<std::set<std::string_view>>& chosen() const { return chosen_; }

 private:
  using Key = std::tuple<const Function*, const Configuration*, const Profile*>;
  static Key key_of(const PlannedProgram& program, const Function& function) {
    return {&function, program.configuration, program.target.profile};
  }

  bool is_compiled(const Key& key) const {
    const auto found = places_.find(key);
    return found != places_.end() && extents_[found->second] != Extent::thorough;
  }

  void add(std::size_t i) {
    const PlannedProgram& program = programs_[i];
    const Evaluation evaluation = evaluation_of(program);
    for (const Relation& further : further_cases_of(evaluation, program.target)) {
      const auto& [function, configuration, profile, variant, stage] = evaluation;
      Candidate candidate{.shows = {}, .round = 0, .cost = extents_[i] == Extent::thorough ? 2 : 0};
      if (further.with && !is_compiled(key_of(program, *further.with))) candidate.cost += 2;
      const std::string platform(name_of(profile.platform()));
      const auto show = [&](std::string_view what) {
        const std::string thing = std::string(further.check) + " " + platform + " " + std::string(what);
        candidate.shows.push_back(things_.try_emplace(thing, things_.size()).first->second);
      };
      show(name_of(configuration.arithmetic));
      if (!further.besides.empty()) show(further.besides);
      if (further.with || further.programs > 1) {
        show(function.bound);
      } else {
        show("family " + std::to_string(static_cast<unsigned>(function.family)));
        show("axes " + std::to_string(function.axes));
        if (profile.platform() == Platform::opengl) show(profile.name);
      }
      candidate.round = rounds_.try_emplace(further.check, rounds_.size()).first->second;
      candidates_.push_back(std::move(candidate));
      of_.emplace_back(i, further.check);
    }
  }

  const std::vector<PlannedProgram>& programs_;
  const std::vector<Extent>& extents_;
  std::vector<std::set<std::string_view>> chosen_;
  std::map<Key, std::size_t> places_;
  std::map<std::string, std::size_t> things_;
  std::map<std::string_view, std::size_t> rounds_;
  std::vector<Candidate> candidates_;
  std::vector<std::pair<std::size_t, std::string_view>> of_;  // each candidate's program, and its check
};

// The checks of a run without --thorough, of each program in all_programs().
const std::vector<std::set<std::string_view>>& chosen_further_cases() {
  static const FurtherCases kFurther;
  return kFurther.chosen();
}

}  // namespace

void add_value_cases(std::vector<Case>& cases, Scope scope, const Subjects* subjects) {
  const std::vector<PlannedProgram>& programs = all_programs();
  const std::vector<Extent>& extents = program_extents();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const PlannedProgram& program = programs[i];
    if (subjects && !subjects->contains(program.function->id)) continue;
    const std::set<std::string_view>& chosen = chosen_further_cases()[i];
    const bool thorough = scope == Scope::thorough;
    const bool for_es = is_in_es_cover()[i];
    const bool is_chosen = for_es || extents[i] != Extent::thorough;
    if (!thorough && !is_chosen && chosen.empty()) continue;
    const Evaluation evaluation = evaluation_of(program);
    const auto add = [&](const Relation& one, Extent extent, bool of_es = false) {
      Case test{name_of(evaluation, one.check), one.kind, extent};
      test.for_es = of_es;
      if (thorough || test.is_covered(true)) cases.push_back(std::move(test));
    };
    // One driver is enough for cases that examine the library more than the driver.
    const Extent by_one = std::max(extents[i], Extent::one_driver);
    add({"golden", GoldenKind{evaluation}}, extents[i], for_es);
    const Platform platform = evaluation.profile.platform();
    if (platform != Platform::webgpu) add({"twin", CheckKind{evaluation, check_twin}}, extents[i], for_es);
    if (platform == Platform::opengl && (program.target.main || is_chosen)) {
      for (const Relation& property : properties_of(evaluation)) add(property, by_one, for_es);
      for (const Relation& repetition : repetitions_of(evaluation)) add(repetition, by_one, for_es);
    }
    const bool other_stage = platform == Platform::opengl && evaluation.stage != Stage::fragment;
    if (other_stage) add(as_fragment(evaluation), Extent::thorough);
    for (const Relation& further : further_cases_of(evaluation, program.target)) {
      add(further, chosen.contains(further.check) ? Extent::one_driver : Extent::thorough);
    }
    const bool has_unseeded = evaluation.function.has_unseeded && evaluation.configuration.is_default();
    if (has_unseeded && program.target.main) add({"unseeded", CheckKind{evaluation, check_unseeded}}, Extent::thorough);
  }
  for (Case& test : unseeded_cases()) cases.push_back(std::move(test));
  for (Case& test : position_cases()) cases.push_back(std::move(test));
}

}  // namespace hn
