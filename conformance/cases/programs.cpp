#include "cases/programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace hn {
namespace {

// The subject of a program.
enum class Facet { row, noise, bound, family, axes, form, start, setting, hash, gradient, arithmetic, version, stage };
constexpr std::size_t kFacets = static_cast<std::size_t>(Facet::stage) + 1;

// The arguments beside the coordinates and the seed: a cell and a fraction, periods, a phase and so on. A function of
// one noise is in another form the same code with other glue. Positions in whole units have two rows, which cover them.
std::string form_of(const Function& function) {
  std::string form;
  for (const std::string_view column : {"cx", "px", "phase", "jitter", "metric", "detail", "footprint"}) {
    if (function.input(column) >= 0) form += fmt::format("{}{}", form.empty() ? "" : " ", column);
  }
  return form.empty() ? "a position" : form;
}

// A row may have a part of a function's result, by code of its own: in four dimensions the value that comes with
// derivatives, and of cellular noise the cell that is nearest and where its point lies. A distribution is computed by
// code of its own, too.
std::string_view part_of(const Function& function) {
  if (function.is_derived() && !function.has_slopes()) return "the value of ";
  if (function.is_name(0)) return "the cell of ";
  if (function.is_offset) return "the offset of ";
  if (function.outputs.front().name == "reach") return "the distribution of ";
  return "";
}

// A fractal has code of its own for the place of its first octave.
std::string start_of(const Function& function) {
  return function.is_octave_sum() ? fmt::format("octaves of {} axes from {}", function.axes, form_of(function))
                                  : form_of(function);
}

std::string noise_word_of(const Function& function) {
  return fmt::format("{}{} of {} axes", part_of(function), function.bound, function.axes);
}

std::string word_of(Facet facet, const PlannedProgram& program) {
  const Function& function = *program.function;
  const Configuration& configuration = *program.configuration;
  switch (facet) {
    case Facet::row:
      return std::string(function.id);
    case Facet::noise:
      return function.exact() ? std::string(function.id) : noise_word_of(function);
    case Facet::bound:
      return std::string(function.bound);
    case Facet::family:
      return fmt::format("family {}", static_cast<unsigned>(function.family));
    case Facet::axes:
      return fmt::format("{} axes", function.axes);
    case Facet::form:
      return form_of(function);
    case Facet::start:
      return start_of(function);
    case Facet::setting:
      return std::string(configuration.name);
    case Facet::hash:
      return std::string(configuration.hash);
    case Facet::gradient:
      return configuration.sine() ? "sine" : "octahedral";
    case Facet::arithmetic:
      return std::string(arithmetic_name(function, configuration));
    case Facet::version:
      return std::string(program.target.profile->name);
    case Facet::stage:
      return std::string(name_of(program.target.stage));
  }
  return {};
}

// Where a thing has to be shown: in OpenGL, or in every other language, whose programs are the same text under other
// macros and other compilers.
enum class Reach { opengl, elsewhere, everywhere };

struct FacetRule {
  Facet first;
  std::optional<Facet> with;  // the things are pairs, if there is one
  Reach where;
};

constexpr std::array kShown = {
    FacetRule{Facet::row, {}, Reach::opengl},
    // Above the steps of the arithmetic a noise is one text, and so is its form above the noise.
    FacetRule{Facet::noise, Facet::arithmetic, Reach::opengl},
    FacetRule{Facet::noise, Facet::gradient, Reach::opengl},
    FacetRule{Facet::form, Facet::arithmetic, Reach::everywhere},
    FacetRule{Facet::start, Facet::arithmetic, Reach::opengl},
    FacetRule{Facet::form, Facet::axes, Reach::opengl},
    FacetRule{Facet::form, Facet::bound, Reach::opengl},
    FacetRule{Facet::setting, Facet::family, Reach::opengl},
    // A hash joins the words of so many coordinates in its own way.
    FacetRule{Facet::setting, Facet::axes, Reach::opengl},
    // A version or a stage may be wrong in these.
    FacetRule{Facet::version, Facet::stage, Reach::everywhere},
    FacetRule{Facet::version, Facet::arithmetic, Reach::everywhere},
    FacetRule{Facet::version, Facet::family, Reach::everywhere},
    FacetRule{Facet::version, Facet::bound, Reach::elsewhere},
    FacetRule{Facet::version, Facet::axes, Reach::everywhere},
    FacetRule{Facet::version, Facet::form, Reach::everywhere},
    FacetRule{Facet::version, Facet::hash, Reach::opengl},
    FacetRule{Facet::version, Facet::gradient, Reach::opengl},
    FacetRule{Facet::stage, Facet::arithmetic, Reach::opengl},
    FacetRule{Facet::stage, Facet::bound, Reach::opengl},
    FacetRule{Facet::stage, Facet::axes, Reach::opengl},
    FacetRule{Facet::stage, Facet::form, Reach::opengl},
    FacetRule{Facet::stage, Facet::hash, Reach::opengl},
};

bool is_opengl(const PlannedProgram& program) { return program.target.profile->platform() == Platform::opengl; }

// Programs in other languages than GLSL stand for themselves alone, and their name has the language.
std::string where_shown(const PlannedProgram& program) { return is_opengl(program) ? "" : " beside OpenGL"; }

// Calls take(words of the thing) for each thing that a program shows.
template <typename Take>
void for_each_thing(const PlannedProgram& program, Take take) {
  for (std::size_t kind = 0; kind < kShown.size(); ++kind) {
    const auto& [first, with, where] = kShown[kind];
    const bool here = where == Reach::everywhere || (where == Reach::opengl) == is_opengl(program);
    if (here) take(kind, first, with);
  }
}

// The things of the product by number, with the programs that show them.
struct ShownThings {
  std::vector<Candidate> programs;
  std::vector<std::string> words;
};

// Numbers for the words of a facet. Thousands of programs share the words of a facet.
class Numbers {
 public:
  int of(Facet facet, const PlannedProgram& program) {
    const auto [found, is_new] = known_.try_emplace(source_of(facet, program), 0);
    if (is_new) {
      std::string word = word_of(facet, program);
      found->second = numbers_.try_emplace(word, static_cast<int>(words_.size())).first->second;
      if (found->second == static_cast<int>(words_.size())) words_.push_back(std::move(word));
    }
    return found->second;
  }
  const std::string& word(int number) const { return words_[static_cast<std::size_t>(number)]; }

 private:
  using Source = std::tuple<Facet, const void*, const void*>;
  // The source of a facet's words.
  static Source source_of(Facet facet, const PlannedProgram& program) {
    switch (facet) {
      case Facet::setting:
      case Facet::hash:
      case Facet::gradient:
        return {facet, program.configuration, nullptr};
      case Facet::arithmetic:
        return {facet, program.configuration, program.function->exact() ? program.function : nullptr};
      case Facet::version:
        return {facet, program.target.profile, nullptr};
      case Facet::stage:
        return {facet, name_of(program.target.stage).data(), nullptr};
      default:
        return {facet, program.function, nullptr};
    }
  }

  std::map<Source, int> known_;
  std::map<std::string, int> numbers_;
  std::vector<std::string> words_;
};

ShownThings things_of(const std::vector<PlannedProgram>& programs) {
  ShownThings things;
  Numbers numbers;
  std::array<std::unordered_map<std::uint64_t, std::size_t>, 2 * kShown.size()>
      known;  // of a pair of numbers the thing
  for (const PlannedProgram& program : programs) {
    const bool apart = !is_opengl(program);
    Candidate candidate{.shows = {}, .round = 0, .cost = 0};
    std::array<int, kFacets> numbers_here;  // computed once: a facet is in several pairs
    numbers_here.fill(-1);
    const auto number_of = [&](Facet facet) {
      int& number = numbers_here[static_cast<std::size_t>(facet)];
      if (number < 0) number = numbers.of(facet, program);
      return number;
    };
    for_each_thing(program, [&](std::size_t kind, Facet first, std::optional<Facet> with) {
      const int a = number_of(first);
      const int b = with ? number_of(*with) : -1;
      const std::uint64_t pair = (static_cast<std::uint64_t>(a) << 32) + static_cast<std::uint32_t>(b);
      const auto [found, is_new] = known[kind * 2 + (apart ? 1 : 0)].try_emplace(pair, things.words.size());
      if (is_new) {
        things.words.push_back(numbers.word(a) + (with ? " with " + numbers.word(b) : "") + where_shown(program));
      }
      candidate.shows.push_back(found->second);
    });
    things.programs.push_back(std::move(candidate));
  }
  return things;
}

const ShownThings& all_things() {
  static const ShownThings kThings = things_of(all_programs());
  return kThings;
}

// Among equals it prefers the default hash, and the stage that compiles faster: llvmpipe compiles a pixel's shader
// twice, for triangles that cover a block and that do not.
int cost_of(const PlannedProgram& program) {
  const bool default_hash = program.configuration->hash == default_configuration().hash;
  return (default_hash ? 0 : 2) + (program.target.stage == Stage::fragment ? 1 : 0);
}

// Every driver runs these: the main versions of OpenGL, and Vulkan's own GLSL, with a program of each family and each
// arithmetic.
bool may_be_for_all(const PlannedProgram& program) {
  const Profile& profile = *program.target.profile;
  const bool of_vulkan = profile.platform() == Platform::vulkan && profile.in_glsl();
  return program.configuration->default_but_for_arithmetic() && (program.target.main || of_vulkan);
}

}  // namespace

const std::vector<PlannedProgram>& all_programs() {
  static const std::vector<PlannedProgram> kPrograms = [] {
    std::vector<PlannedProgram> programs;
    for (const Function& function : all_functions()) {
      for (const Configuration& configuration : all_configurations()) {
        if (!covers(configuration, function)) continue;
        for (const Target& target : targets_of(configuration)) programs.push_back({&function, &configuration, target});
      }
    }
    return programs;
  }();
  return kPrograms;
}

std::vector<std::string> shown_by(const PlannedProgram& program) {
  std::vector<std::string> words;
  for_each_thing(program, [&](std::size_t, Facet first, std::optional<Facet> with) {
    words.push_back(word_of(first, program) + (with ? " with " + word_of(*with, program) : "") + where_shown(program));
  });
  return words;
}

std::vector<std::string> not_shown(std::span<const Extent> extents) {
  const ShownThings& things = all_things();
  std::vector<bool> shown(things.words.size());
  for (std::size_t i = 0; i < things.programs.size(); ++i) {
    if (extents[i] == Extent::thorough) continue;
    for (const std::size_t thing : things.programs[i].shows) shown[thing] = true;
  }
  std::vector<std::string> words;
  for (std::size_t thing = 0; thing < shown.size(); ++thing) {
    if (!shown[thing]) words.push_back(things.words[thing]);
  }
  return words;
}

std::vector<bool> cover_of(std::span<const Candidate> candidates, std::size_t things) {
  std::vector<bool> chosen(candidates.size());
  std::vector<bool> shown(things);
  // For each candidate the number of new things: an upper limit where it was not counted lately, since it only falls.
  std::vector<std::ptrdiff_t> news;
  for (const Candidate& candidate : candidates) news.push_back(std::ssize(candidate.shows));
  const auto count = [&](std::size_t i) {
    news[i] = std::ranges::count_if(candidates[i].shows, [&](std::size_t thing) { return !shown[thing]; });
  };
  const auto choose = [&](std::size_t i) {
    chosen[i] = true;
    for (const std::size_t thing : candidates[i].shows) shown[thing] = true;
  };
  // One of each round, if the round has anything new: the first pass is over the table, in its order, so
  // that additions at the end change nothing before them.
  std::map<std::size_t, std::vector<std::size_t>> rounds;
  for (std::size_t i = 0; i < candidates.size(); ++i) rounds[candidates[i].round].push_back(i);
  const auto best_of = [&](const std::vector<std::size_t>& members) -> std::optional<std::size_t> {
    std::optional<std::size_t> best;
    const auto is_better = [&](std::size_t i) {
      if (!best) return news[i] > 0;
      return news[i] > news[*best] || (news[i] == news[*best] && candidates[i].cost < candidates[*best].cost);
    };
    for (const std::size_t i : members) {
      if (!is_better(i)) continue;
      count(i);
      if (is_better(i)) best = i;
    }
    return best;
  };
  for (const auto& [round, members] : rounds) {
    if (const auto best = best_of(members)) choose(*best);
  }
  // Then the rest, by its round.
  for (const auto& [round, members] : rounds) {
    while (const auto best = best_of(members)) choose(*best);
  }
  return chosen;
}

namespace {

// The programs, each in the round of its function; in other languages than GLSL a round has all functions.
std::vector<Candidate> candidates_in_rounds() {
  const std::vector<PlannedProgram>& programs = all_programs();
  std::vector<Candidate> candidates = all_things().programs;
  std::map<std::string_view, std::size_t> rounds;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::string_view name = is_opengl(programs[i]) ? programs[i].function->id : programs[i].target.profile->name;
    candidates[i].round = rounds.try_emplace(name, rounds.size()).first->second;
    candidates[i].cost = cost_of(programs[i]);
  }
  return candidates;
}

}  // namespace

const std::vector<bool>& is_in_es_cover() {
  static const std::vector<bool> kIn = [] {
    const std::vector<PlannedProgram>& programs = all_programs();
    std::vector<Candidate> candidates = candidates_in_rounds();
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (programs[i].target.profile->name != "es300") candidates[i].shows.clear();
    }
    return cover_of(candidates, all_things().words.size());
  }();
  return kIn;
}

const std::vector<Extent>& program_extents() {
  static const std::vector<Extent> kExtents = [] {
    const std::vector<PlannedProgram>& programs = all_programs();
    const std::vector<Candidate> candidates = candidates_in_rounds();
    const std::vector<bool> chosen = cover_of(candidates, all_things().words.size());
    std::vector<Extent> extents(programs.size(), Extent::thorough);
    std::set<std::string> shown;
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (!chosen[i]) continue;
      extents[i] = Extent::one_driver;
      if (!may_be_for_all(programs[i])) continue;
      const Profile& profile = *programs[i].target.profile;
      const std::string platform(name_of(profile.platform()));
      const bool new_family = shown.insert(platform + word_of(Facet::family, programs[i])).second;
      const bool new_arithmetic = shown.insert(platform + word_of(Facet::arithmetic, programs[i])).second;
      if (new_family || new_arithmetic) extents[i] = Extent::every_driver;
    }
    return extents;
  }();
  return kExtents;
}

}  // namespace hn
