#include "expected/pairing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>

#include "expected/cellular.hpp"
#include "expected/compare.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

// Each constant point has the noise in the shader once more, which takes long to compile: so they are few.
constexpr std::size_t kConstantPoints = 4;

// Evaluates as most cases do, so that its program need not be built for this.
Evaluation plain(const Evaluation& evaluation) {
  if (evaluation.profile.platform() != Platform::opengl) {
    return {evaluation.function, evaluation.configuration, evaluation.profile, {}, evaluation.stage};
  }
  return {evaluation.function, evaluation.configuration, main_profile(evaluation.configuration, evaluation.profile.es)};
}

Words points_for(const Evaluation& evaluation, std::uint64_t seed, std::size_t count) {
  const Function& function = evaluation.function;
  Words inputs = random_points(function, count, Random(seed, "metamorphic"));
  if (evaluation.variant.seed_from != SeedFrom::point) {
    const auto word = static_cast<std::size_t>(function.seed_word());
    for (std::size_t i = word; i < inputs.size(); i += kInputWords) inputs[i] = kVariantSeed;
  }
  return inputs;
}

// The driver may be off on both ways.
Pairing pairing_of(const Evaluation& evaluation, const Evaluation& other, Words inputs, Words other_inputs, bool exact,
                   std::size_t most_words = kOutputWords) {
  Pairing pairing{evaluation, other, std::move(inputs), std::move(other_inputs), {}, exact, 1.0, most_words};
  const auto allowed_at = [](const Evaluation& way, const Words& words, std::size_t start, std::size_t output) {
    return tolerance(way.function, way.configuration, std::span(words).subspan(start, kInputWords), output);
  };
  for (std::size_t i = 0; i < pairing.inputs.size(); i += kInputWords) {
    const bool undecided = !exact && is_undecided(evaluation.function, evaluation.configuration,
                                                  std::span(pairing.inputs).subspan(i, kInputWords));
    for (std::size_t output = 0; output < pairing.words(); ++output) {
      const bool left_out = undecided && evaluation.function.jumps(output);
      pairing.allowed.push_back(left_out ? kUndecided
                                         : allowed_at(evaluation, pairing.inputs, i, output) +
                                               allowed_at(other, pairing.other_inputs, i, output));
    }
  }
  return pairing;
}

Pairing pairing_on(const Evaluation& evaluation, Words inputs) {
  return pairing_of(evaluation, plain(evaluation), inputs, inputs,
                    has_same_bits(evaluation.function, evaluation.configuration));
}

// As the function's words have it: a position is that of its cell and its fraction, and octaves are a whole detail.
std::uint32_t word_for(const Column& column, const Function& function, std::span<const std::uint32_t> inputs) {
  const int from = function.input(column.name);
  if (from >= 0) return inputs[static_cast<std::size_t>(from)];
  const auto number = [&](std::string_view name) {
    return std::bit_cast<float>(inputs[static_cast<std::size_t>(function.input(name))]);
  };
  if (const int cell = function.input(fmt::format("c{}", column.name)); cell >= 0) {
    const auto whole = static_cast<float>(static_cast<std::int32_t>(inputs[static_cast<std::size_t>(cell)]));
    return std::bit_cast<std::uint32_t>(whole + number(fmt::format("f{}", column.name)));
  }
  if (column.name == "octaves") return static_cast<std::uint32_t>(static_cast<std::int32_t>(number("detail")));
  if (column.name == "metric") return 1;
  if (column.name == "jitter") return std::bit_cast<std::uint32_t>(1.0f);
  throw std::logic_error(fmt::format("{} has no {}", function.id, column.name));
}

}  // namespace

std::vector<std::uint32_t> inputs_for(const Function& other, const Function& function,
                                      std::span<const std::uint32_t> inputs) {
  Words words(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    const auto point = inputs.subspan(i, kInputWords);
    for (std::size_t column = 0; column < other.inputs.size(); ++column) {
      words[i + column] = word_for(other.inputs[column], function, point);
    }
  }
  return words;
}

namespace {

// Against another function, as it is at the same words.
Pairing pairing_with(const Evaluation& evaluation, const Function& function, Words inputs, bool exact,
                     std::size_t most_words = kOutputWords) {
  Words others = inputs_for(function, evaluation.function, inputs);
  return pairing_of(evaluation, {function, evaluation.configuration, evaluation.profile}, std::move(inputs),
                    std::move(others), exact, most_words);
}

// --- Periods ---

// As many octaves as keep the cells of fixed arithmetic within an int, below 9 * 48 * 3^14 and a little more for the
// shift between octaves (docs/reference/contract.md, section 8). A progressive warp moves the octaves, and those of
// eight by few enough cells: its Jacobians stay below 2^31 units.
constexpr std::uint32_t kFixedOctaves = 15;
constexpr std::uint32_t kFixedMovedOctaves = 8;

bool moves_octaves(const Function& function) { return function.bound == "warp_progressive"; }

// From a cell of a sum, so many cells from the origin at most: with up to five octaves and a lacunarity of up to 3 no
// octave's cell wraps, and neither does that of a point some periods on.
constexpr std::int64_t kSumReach = std::int64_t{1} << 22;

// If the function takes cells, any int is a period. Positions are multiples of 1/8 that are floats a period on, too.
// The periods of octave sums are small: with a whole lacunarity the positions of all octaves are multiples of 1/32 and
// floats.
std::int32_t chosen_period(const Function& function, Random& random) {
  constexpr std::array<std::int32_t, 13> kPeriods = {0,  1,       2,       3,       5,          7, 48,
                                                     64, 1000003, 1 << 20, 1 << 30, 0x7FFFFFFF, -3};
  const std::uint32_t count = function.is_octave_sum() ? 7 : function.starts_from_integers() ? 13 : 10;
  return kPeriods[random.below(count)];
}

// The floored quotient's rest.
std::int64_t rest_of(std::int64_t cell, std::int64_t period) { return (cell % period + period) % period; }

// Where a point lies along an axis: in cells, and for positions in eighths of a cell besides.
struct Place {
  std::int64_t cell;
  std::int64_t eighths;

  std::uint32_t word(WordType type) const {
    if (type == WordType::i32) return static_cast<std::uint32_t>(cell);
    return std::bit_cast<std::uint32_t>(static_cast<float>(cell) + static_cast<float>(eighths) / 8.0f);
  }
};

// Within a period of the origin or, of cells, anywhere; every other one beside a multiple of the period.
Place random_place(const Function& function, std::int64_t period, Random& random) {
  const auto eighths = static_cast<std::int64_t>(random.below(8));
  const std::int64_t of_cells = function.is_octave_sum() ? kSumReach : std::int64_t{1} << 30;
  const std::int64_t reach = function.starts_from_integers() ? of_cells : std::max<std::int64_t>(period, 64);
  const auto anywhere = static_cast<std::int64_t>(random.below(static_cast<std::uint32_t>(2 * reach))) - reach;
  if (period <= 0 || random.below(2) == 0) return {anywhere, eighths};
  const std::int64_t multiple = anywhere - rest_of(anywhere, period);
  const std::int64_t beside = multiple + static_cast<std::int64_t>(random.below(3)) - 1;
  return {beside < -reach || beside >= reach ? anywhere : beside, eighths};
}

// Whether a function is of simplex noise, or of its lattice.
bool is_of_simplex(const Function& function) {
  return function.is_simplex_noise() || function.is_flow() || function.is_gullies();
}

// After how many cells a field repeats without a period: simplex noise on the plane has two lattice points to a cell
// along each axis. All others repeat after 2^32 cells, which is the same int.
std::int64_t cells_of_all(const Function& function) {
  return std::int64_t{1} << (is_of_simplex(function) && function.axes == 2 ? 31 : 32);
}

// Some periods on. Cells, which have room for it, go far, as long as they are ints.
Place moved(const Function& function, const Place& place, WordType type, std::int64_t period, Random& random) {
  if (period <= 0) return type == WordType::i32 ? Place{place.cell + cells_of_all(function), place.eighths} : place;
  std::int64_t periods = static_cast<std::int64_t>(random.below(3)) - 1;
  if (type == WordType::i32) periods *= random.below(2) == 0 ? 64 : 1;
  for (; periods != 0; periods /= 2) {
    const std::int64_t cell = place.cell + periods * period;
    if (cell == static_cast<std::int32_t>(cell)) return {cell, place.eighths};
  }
  return place;
}

// A cell whose noise reaches no seam, and its like within the period. hn_value_cubic takes one lattice point more on
// each side. Simplex and cellular noise take points of the cell before and of the cell after; a third distance and a
// border those of one cell more. One of the two noises of curl in space may be that of the next cell.
bool is_inside(const Function& function, std::int64_t rest, std::int64_t period) {
  const bool cubic = function.bound == "value_cubic";
  const bool far = function.bound == "cellular_three" || function.bound == "cell_border";
  const std::int64_t before = far ? 2 : cubic || is_of_simplex(function) || function.is_cellular() ? 1 : 0;
  const bool moved = function.is_flow() && function.axes == 3;
  const std::int64_t after = cubic || far || moved ? 2 : 1;
  return rest >= before && rest + after < period;
}

// Settings of octaves for pairings with periods, which have their own places and periods.
void settle_octaves(const Evaluation& evaluation, std::span<std::uint32_t> words, Random& random) {
  const Function& function = evaluation.function;
  if (!function.is_octave_sum()) return;
  const auto at = [&](std::string_view name) -> std::uint32_t& {
    return words[static_cast<std::size_t>(function.input(name))];
  };
  const bool many = evaluation.configuration.arithmetic == Arithmetic::fixed && !function.takes_cell();
  if (many) at("octaves") = random.below((moves_octaves(function) ? kFixedMovedOctaves : kFixedOctaves) + 1);
  at("lacunarity") = std::bit_cast<std::uint32_t>(1.0f + static_cast<float>(random.below(3)));
}

}  // namespace

Pairing variant_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  return pairing_on(evaluation, points_for(evaluation, seed, points));
}

// There are so few points that each has to count: those whose values are decided come first.
Pairing folded_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  Words inputs;
  Words undecided;
  const Words candidates = points_for(evaluation, seed, 8 * kConstantPoints);
  for (std::size_t i = 0; i < candidates.size(); i += kInputWords) {
    const auto point = std::span(candidates).subspan(i, kInputWords);
    Words& chosen = is_undecided(evaluation.function, evaluation.configuration, point) ? undecided : inputs;
    chosen.insert(chosen.end(), point.begin(), point.end());
  }
  inputs.insert(inputs.end(), undecided.begin(), undecided.end());
  inputs.resize(std::min(points, kConstantPoints) * kInputWords);
  Pairing pairing = pairing_on(evaluation, std::move(inputs));
  pairing.evaluation.variant.shape = Shape::constant;
  pairing.evaluation.variant.constants = pairing.inputs;
  return pairing;
}

// Points beside the seam are among them. A noise has the same bits there: its cells and its fractions are the same. So
// does an octave sum, as none of its positions is rounded; but a compiler of fast arithmetic may round the steps to
// them in another way, so there it is held to its tolerance. So is a progressive warp of floats at a position, since
// what moves an octave has more bits than the position has room for.
Pairing period_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  Random random(seed, "period");
  Words here = random_points(function, points, random);
  Words there = here;
  for (std::size_t i = 0; i < here.size(); i += kInputWords) {
    settle_octaves(evaluation, std::span(here).subspan(i, kInputWords), random);
    std::copy_n(&here[i], kInputWords, &there[i]);
    // The columns of coordinates come first; those of a cell's fraction keep their values.
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(function.axes); ++axis) {
      const std::int32_t period = chosen_period(function, random);
      const WordType type = function.inputs[axis].type;
      const Place place = random_place(function, period, random);
      here[i + axis] = place.word(type);
      there[i + axis] = moved(function, place, type, period, random).word(type);
      const std::size_t word = i + static_cast<std::size_t>(function.period_word()) + axis;
      here[word] = there[word] = static_cast<std::uint32_t>(period);
    }
  }
  const bool rounds = moves_octaves(function) && !function.takes_cell();
  const bool exact = !function.is_octave_sum() || (rounds ? has_exact_values(function, evaluation.configuration)
                                                          : has_same_bits(function, evaluation.configuration));
  return pairing_of(evaluation, evaluation, std::move(there), std::move(here), exact);
}

// Without a period, or where a cell reaches no seam, the noise is that of the form without periods.
Pairing wrapped_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  const Evaluation other{without(function, "period"), evaluation.configuration, evaluation.profile};
  Random random(seed, "wrapped");
  Words here = random_points(function, points, random);
  Words there = here;
  for (std::size_t i = 0; i < here.size(); i += kInputWords) {
    const bool no_periods = random.below(4) == 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(function.axes); ++axis) {
      const WordType type = function.inputs[axis].type;
      std::int32_t period = no_periods ? 0 : chosen_period(function, random);
      const Place place = random_place(function, period, random);
      here[i + axis] = place.word(type);
      there[i + axis] = here[i + axis];
      const std::int64_t rest = period > 0 ? rest_of(place.cell, period) : 0;
      if (period > 0 && is_inside(function, rest, period)) {
        there[i + axis] = Place{rest, place.eighths}.word(type);
      } else {
        period = 0;
      }
      here[i + static_cast<std::size_t>(function.period_word()) + axis] = static_cast<std::uint32_t>(period);
    }
  }
  Words others = inputs_for(other.function, function, there);
  return pairing_of(evaluation, other, std::move(here), std::move(others),
                    has_same_bits(function, evaluation.configuration));
}

// One period that is no power of two, and one that is; the smallest, and none.
Pairing constant_period_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  static constexpr std::array<std::int32_t, 4> kPeriods = {48, 64, 1, 0};
  const Function& function = evaluation.function;
  Words inputs = points_for(evaluation, seed, points);
  for (std::size_t i = static_cast<std::size_t>(function.period_word()); i < inputs.size(); i += kInputWords) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(function.axes); ++axis) {
      inputs[i + axis] = static_cast<std::uint32_t>(kPeriods[axis]);
    }
  }
  Pairing pairing = pairing_on(evaluation, std::move(inputs));
  pairing.evaluation.variant.periods = kPeriods;
  return pairing;
}

namespace {

// Two ways that round differently, in every arithmetic: so each is off by its own error.
Pairing pairing_by_error(const Evaluation& evaluation, const Evaluation& other, Words inputs, Words other_inputs,
                         double factor) {
  Pairing pairing{evaluation, other, std::move(inputs), std::move(other_inputs), {}, false, factor};
  for (std::size_t i = 0; i < pairing.inputs.size(); i += kInputWords) {
    for (std::size_t output = 0; output < pairing.words(); ++output) {
      pairing.allowed.push_back(error_of(evaluation.function, evaluation.configuration, output) +
                                std::fabs(factor) * error_of(other.function, other.configuration, output));
    }
  }
  return pairing;
}

void put_float(const Function& function, std::span<std::uint32_t> point, std::string_view column, float value) {
  point[static_cast<std::size_t>(function.input(column))] = std::bit_cast<std::uint32_t>(value);
}

// A multiple of 1/64 below one turn, and up to 2^16 whole turns of either sign: a float holds the sum of both.
constexpr std::uint32_t kPhases = 64;
constexpr std::uint32_t kTurns = 65536;
float random_part(Random& random) {
  return static_cast<float>(random.below(2 * kPhases - 1)) / static_cast<float>(kPhases) -
         static_cast<float>(kPhases - 1) / static_cast<float>(kPhases);
}
float random_turns(Random& random) {
  return static_cast<float>(random.below(2 * kTurns + 1)) - static_cast<float>(kTurns);
}

// Points at a part of a turn, and others so many turns on.
template <typename Turns>
std::pair<Words, Words> turned(const Evaluation& evaluation, std::uint64_t seed, std::string_view name,
                               std::size_t points, Turns turns) {
  Random random(seed, name);
  Words here = points_for(evaluation, seed, points);
  Words there = here;
  for (std::size_t i = 0; i < here.size(); i += kInputWords) {
    const float part = random_part(random);
    put_float(evaluation.function, std::span(here).subspan(i), "phase", part + turns(random));
    put_float(evaluation.function, std::span(there).subspan(i), "phase", part);
  }
  return {std::move(here), std::move(there)};
}

}  // namespace

// It holds with fast arithmetic, too: the steps from a phase to its angle are exact.
Pairing loop_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  auto [here, there] = turned(evaluation, seed, "loop", points, random_turns);
  return pairing_of(evaluation, evaluation, std::move(here), std::move(there), true);
}

Pairing half_turn_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  auto [here, there] = turned(evaluation, seed, "half turn", points, [](Random&) { return 0.5f; });
  return pairing_by_error(evaluation, evaluation, std::move(here), std::move(there), -1.0);
}

namespace {

// In space gradients that rotate reach larger values, so their noise has a smaller scale (docs/reference/contract.md,
// section 14). A flow is a product of two.
double scale_with_phase(const Function& function) {
  constexpr double kOfSimplex = 4902.0 / 4918.0;
  if (function.axes == 2) return 1.0;
  if (function.is_flow()) return kOfSimplex * kOfSimplex;
  return function.is_simplex_noise() ? kOfSimplex : 879.0 / 985.0;
}

}  // namespace

Pairing phase_zero_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  const Evaluation other{without(function, "phase"), evaluation.configuration, evaluation.profile};
  Random random(seed, "phase zero");
  Words inputs = points_for(evaluation, seed, points);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    put_float(function, std::span(inputs).subspan(i), "phase", random.below(2) == 0 ? 0.0f : random_turns(random));
  }
  Words others = inputs_for(other.function, function, inputs);
  return pairing_by_error(evaluation, other, std::move(inputs), std::move(others), scale_with_phase(function));
}

namespace {

// A cell and a fraction whose sum is a float: 2^11 cells in 2^12 parts, so that the first octaves of floats are exact,
// or, every fourth, 2^19 cells in eighths.
struct ExactPlace {
  std::int32_t cell;
  float fraction;
};

ExactPlace random_exact_place(Random& random) {
  const bool far = random.below(4) == 0;
  const std::uint32_t cells = far ? 1u << 20 : 1u << 8;
  const std::uint32_t parts = far ? 8 : 1u << 12;
  return {static_cast<std::int32_t>(random.below(cells)) - static_cast<std::int32_t>(cells / 2),
          static_cast<float>(random.below(parts)) / static_cast<float>(parts)};
}

}  // namespace

// Every bit counts with fixed arithmetic alone: with floats only a sum from a cell has positions that are whole
// numbers.
Pairing from_cell_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  const auto axes = static_cast<std::size_t>(function.axes);
  Random random(seed, "from cell");
  Words inputs = random_points(function, points, random);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    for (std::size_t axis = i; axis < i + axes; ++axis) {
      const auto [cell, fraction] = random_exact_place(random);
      inputs[axis] = static_cast<std::uint32_t>(cell);
      inputs[axis + axes] = std::bit_cast<std::uint32_t>(fraction);
    }
  }
  return pairing_with(evaluation, without(function, "cell"), std::move(inputs),
                      has_exact_values(function, evaluation.configuration));
}

// No octaves, some, and with fixed arithmetic now and then more than it takes.
Pairing whole_detail_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  const bool fixed = evaluation.configuration.arithmetic == Arithmetic::fixed;
  Random random(seed, "whole detail");
  Words inputs = random_points(function, points, random);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    const bool many = fixed && random.below(16) == 0;
    const auto octaves = static_cast<std::int32_t>(many ? 31 + random.below(4) : random.below(8)) - 1;
    put_float(function, std::span(inputs).subspan(i), "detail", static_cast<float>(octaves));
  }
  return pairing_with(evaluation, without(function, "detail"), std::move(inputs),
                      has_same_bits(function, evaluation.configuration));
}

// Up to half a cell of the last octave, or a quarter of those of gullies, none fades. With floats the compiler may
// contract the two in other ways.
Pairing small_footprint_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  Random random(seed, "small footprint");
  Words inputs = random_points(function, points, random);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    const auto here = std::span(inputs).subspan(i, kInputWords);
    const auto octaves = static_cast<std::int32_t>(here[static_cast<std::size_t>(function.input("octaves"))]);
    const auto lacunarity = std::bit_cast<float>(here[static_cast<std::size_t>(function.input("lacunarity"))]);
    const double of_last = function.is_gullies() ? 0.25 : 0.5;
    const auto most = static_cast<float>(
        of_last / std::pow(std::max(static_cast<double>(lacunarity), 1.0), std::max(octaves - 1, 0)));
    const float footprint = random.below(4) == 0 ? 0.0f : random.below(2) == 0 ? most : random.uniform(0.0f, most);
    put_float(function, here, "footprint", footprint);
  }
  return pairing_with(evaluation, without(function, "footprint"), std::move(inputs),
                      has_exact_values(function, evaluation.configuration));
}

namespace {

// The pairing with a function that is the same where this setting is 0 or below.
Pairing zero_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points, std::string_view setting,
                     const Function& with, bool exact) {
  const Function& function = evaluation.function;
  Random random(seed, fmt::format("zero {}", setting));
  Words inputs = random_points(function, points, random);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    put_float(function, std::span(inputs).subspan(i, kInputWords), setting, random.below(4) == 0 ? -1.0f : 0.0f);
  }
  return pairing_with(evaluation, with, std::move(inputs), exact);
}

}  // namespace

// Every octave is divided by 1 then. With floats a division by 1 may round.
Pairing zero_strength_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  return zero_pairing(evaluation, seed, points, "strength", find_function(evaluation.function.plain),
                      has_exact_values(evaluation.function, evaluation.configuration));
}

Pairing zero_bandwidth_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  return zero_pairing(evaluation, seed, points, "bandwidth", without(evaluation.function, "bandwidth"),
                      has_same_bits(evaluation.function, evaluation.configuration));
}

Pairing derivative_value_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  // Cellular noise has a second distance where this has a derivative.
  return pairing_with(evaluation, find_function(evaluation.function.plain), points_for(evaluation, seed, points),
                      has_same_bits(evaluation.function, evaluation.configuration), 1);
}

}  // namespace hn
