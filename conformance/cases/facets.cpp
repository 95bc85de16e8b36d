#include "cases/facets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "cases/bugs/bugs.hpp"
#include "expected/verdict.hpp"
#include "library/functions.hpp"

namespace hn {
namespace {

// Null for a file as a whole, a setting or a known bug, which are no functions.
const Function* known_function(std::string_view id) {
  const auto functions = all_functions();
  const auto found = std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.id == id; });
  return found == functions.end() ? nullptr : &*found;
}

std::string kind_of(std::string_view id, const Function* function) {
  if (function != nullptr) {
    if (function->is_noise()) return fmt::format("of {} noise", function->bound);
    if (function->is_octave_sum()) return "of octave sums";
    if (id.starts_with("position.")) return "of positions";
    return id.starts_with("hash.") ? "of hashes" : "of gradients";
  }
  if (id.starts_with("bugs.")) return "of what drivers are known to get wrong";
  return id.starts_with("config.") ? "of the settings" : "";  // files as a whole are none of a kind
}

std::string dimensions_of(std::string_view id, const Function* function) {
  if (function != nullptr) return function->axes == 0 ? "" : fmt::format("in {}D", function->axes);
  const std::string_view file = id.substr(0, id.find('.'));
  const auto digit = file.find_last_of("1234");
  const bool has_dimension = digit != std::string_view::npos && file.substr(digit + 1) == "d";
  return has_dimension ? fmt::format("in {}D", file[digit]) : "";
}

// "lattice+sine": the hash, and settings other than the defaults.
struct Knobs {
  std::string hash;
  std::string gradient;
};

Knobs knobs_in(std::string_view configuration) {
  if (configuration == "any") return {};
  const auto parts = split(configuration, '+');
  const bool sine = std::ranges::find(parts, "sine") != parts.end();
  return {fmt::format("with HN_HASH_{}", in_upper_case(parts[0])),
          sine ? "with HN_GRADIENT_SINE" : "without HN_GRADIENT_SINE"};
}

// Empty for functions that have no forms with a period.
std::string periods_of(const Function* function) {
  if (function == nullptr || !(function->is_noise() || function->is_octave_sum())) return "";
  return function->takes_period() ? "with a period" : "without a period";
}

std::string language_of(std::string_view profile) {
  if (profile == "vulkan") return "in Vulkan's GLSL";
  if (profile.starts_with("hlsl")) return "in HLSL";
  if (profile == "wgsl") return "in WGSL";
  return profile.starts_with("es") ? "in GLSL ES" : "in desktop GLSL";
}

// The rule behind a known bug; nothing if there is no such bug.
std::string_view rule_of_bug(std::string_view id) {
  const auto bugs = all_bugs();
  const auto bug = std::ranges::find(bugs, id, [](const Bug& b) { return b.function.id; });
  return bug == bugs.end() ? std::string_view{} : bug->rule.text;
}

}  // namespace

Facets facets_of(std::string_view id) {
  const std::string_view name = function_of(id);
  const Function* const function = known_function(name);
  Facets facets;
  facets[0] = kind_of(name, function);
  facets[1] = dimensions_of(name, function);
  facets[9] = fmt::format("of {}", name);
  // file.function.configuration.arithmetic.stage.profile.check
  const auto parts = split(id, '.');
  if (parts.size() != 7) return facets;
  const Knobs knobs = knobs_in(parts[2]);
  facets[2] = parts[3] == "exact" ? "" : fmt::format("with HN_{}", in_upper_case(parts[3]));
  facets[3] = knobs.hash;
  facets[4] = knobs.gradient;
  facets[5] = periods_of(function);
  facets[6] = fmt::format("in the {} stage", parts[4]);
  facets[7] = language_of(parts[5]);
  facets[8] = fmt::format("in {}", parts[5]);
  // These two compare with right values. The others look for something special, and name it.
  if (parts[6] != "golden" && parts[6] != "twin") facets[10] = fmt::format("of the check {}", parts[6]);
  return facets;
}

std::string rule_of(std::string_view id) {
  if (const auto rule = rule_of_bug(function_of(id)); !rule.empty()) return std::string(rule);
  const auto parts = split(id, '.');
  if (parts.size() != 7 || parts[5].starts_with("hlsl") || parts[5] == "wgsl") return {};
  std::string rule =
      "GLSL 4.60 section 4.7.1: +, - and * of floats are rounded correctly, and a * b + c once or twice; section "
      "4.1.3: "
      "+, - and * of integers keep the low 32 bits";
  if (parts[3] == "precise") rule = rule_of_bug("bugs.contracted_despite_precise");
  if (parts[3] == "exact" || parts[3] == "fixed") {
    rule = fmt::format("{}; section 5.9: &, |, ^ and shifts act on each of these bits",
                       rule_of_bug("bugs.words_wrap_at_32_bits"));
  }
  return rule;
}

}  // namespace hn
