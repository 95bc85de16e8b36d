// Checks of cellular noise: against a search of all cells around, in C++, and of its functions against each other.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <list>
#include <optional>

#include "cases/places.hpp"
#include "cases/value_checks.hpp"
#include "expected/cellular.hpp"
#include "expected/pairing.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

constexpr std::size_t kCellularPoints = 2048;  // a quarter of what is costly
constexpr std::uint32_t kFurthestCellularCell = 64;
constexpr double kUnit = 0x1p-16;  // of places
constexpr std::uint32_t kUnits = 65536;
// So many places that may depend on far cells are tried to find some that do.
constexpr std::size_t kTries = 4096;
constexpr std::size_t kFarPoints = 64;

std::size_t points_of(const Session& session, const Function& function) {
  return std::min(function.is_costly() ? kCellularPoints / 4 : kCellularPoints, session.most_points);
}

using Places = std::vector<Place>;

Places random_places(const Function& function, Random& random) {
  Places places;
  for (int axis = 0; axis < function.axes; ++axis) {
    places.push_back(
        {random_cell_of(function, kFurthestCellularCell, random), static_cast<double>(random.below(kUnits)) * kUnit});
  }
  return places;
}

void put(const Function& function, std::span<std::uint32_t> words, const Places& places) {
  for (std::size_t axis = 0; axis < places.size(); ++axis) put(function, words, axis, places[axis]);
}

// A place from the corner of the cell at hand, rounded to units.
Places at(const Places& places, const std::array<double, 3>& from_corner) {
  Places there;
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    const double units = std::round(from_corner[axis] / kUnit) * kUnit;
    there.push_back(moved({places[axis].cell, 0.0}, units));
  }
  return there;
}

// Walls, middles and places one unit beside them.
Places at_edges(Places places, Random& random) {
  for (Place& place : places) {
    const double edge = random.below(2) == 0 ? 0.0 : 0.5;
    if (random.below(4) != 0) place = moved({place.cell, edge}, kUnit * (static_cast<double>(random.below(3)) - 1.0));
  }
  return places;
}

std::array<double, 3> between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0, (a[2] + b[2]) / 2.0};
}

// Random points of all regions; and places on edges of cells, at feature points and halfway between the two nearest.
Words points_to_search(Session& session, const Function& function, const Configuration& configuration) {
  Random random(session.seed, "search");
  // Extreme coordinates are whole for the most part, where on a regular lattice all is equally near: with floats too
  // many points would be left out of what jumps.
  const bool undecided = function.jumps() && configuration.arithmetic != Arithmetic::fixed;
  Words inputs = random_points(function, points_of(session, function), random,
                               undecided ? Extremes::none : defined_extremes(configuration));
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    const std::uint32_t kind = random.below(8);
    if (kind > 3) continue;
    const auto words = std::span(inputs).subspan(i, kInputWords);
    const Places places = random_places(function, random);
    put(function, words, places);
    if (kind < 2) put(function, words, at_edges(places, random));
    if (kind < 2) continue;
    const CellularValue here = searched(function, configuration, words);
    const auto middle = between(here.nearest.at, here.next.at);
    put(function, words, at(places, kind == 2 || undecided ? here.nearest.at : middle));
  }
  return inputs;
}

// Places beside walls whose third distance is that of a cell two steps away. A block of cells that is too small has
// wrong values there. The golden files have such places of borders: they are too rare to be found at random.
void add_far_points(Words& inputs, Session& session, const Function& function, const Configuration& configuration) {
  if (function.bound != "cellular_three") return;
  Random random(session.seed, "far");
  const std::size_t all = inputs.size() / kInputWords;
  std::size_t found = 0;
  for (std::size_t i = 0; i < kTries && found < std::min(kFarPoints, all); ++i) {
    Words words(point(inputs, i % all).begin(), point(inputs, i % all).end());
    if (function.takes_jitter()) {
      words[static_cast<std::size_t>(function.input("jitter"))] = std::bit_cast<std::uint32_t>(1.0f);
    }
    words[static_cast<std::size_t>(function.seed_word())] = random.word();
    Places places = random_places(function, random);
    for (Place& place : places) {
      if (random.below(2) == 0) continue;
      const double away = static_cast<double>(1 + random.below(4096)) * kUnit;
      place.fraction = random.below(2) == 0 ? away : 1.0 - away;
    }
    put(function, words, places);
    if (searched(function, configuration, words, 1).values == searched(function, configuration, words, 2).values) {
      continue;
    }
    std::copy(words.begin(), words.end(), inputs.begin() + static_cast<std::ptrdiff_t>(found++ * kInputWords));
  }
}

// In space a third distance to a cell in an outer row of the slab is too rare to be found at random, and with
// HN_METRIC_CHEBYSHEV the least so. These places of the default hash have one, in both rows of a slab along each axis.
// They are of 57 to which 5 million random places climbed, each to where that cell comes nearest.
struct PlaceOfOuterRow {
  std::array<std::int32_t, 3> cell;
  std::array<float, 3> fraction;
  std::uint32_t seed;
};
constexpr std::array kOuterRows = {
    PlaceOfOuterRow{{2920, -29924, 254}, {0.999984741f, 0.580404222f, 0.488676637f}, 519446753u},
    PlaceOfOuterRow{{14936, 26655, 27018}, {0.999984741f, 0.338829756f, 0.57711643f}, 2879366958u},
    PlaceOfOuterRow{{15572, 13564, 23690}, {0.455076367f, 0.999984741f, 0.46064809f}, 3907506375u},
    PlaceOfOuterRow{{-21575, 32746, 26916}, {0.435896397f, 0.0f, 0.518482804f}, 3080208130u},
    PlaceOfOuterRow{{7392, -12951, -29374}, {0.41370672f, 0.531171858f, 0.0f}, 2259446335u},
    PlaceOfOuterRow{{25713, -16780, -9891}, {0.52306354f, 0.458711654f, 0.999984741f}, 4062265238u}};

// They take the place of the last points.
void add_outer_rows(Words& inputs, const Function& function, const Configuration& configuration) {
  const bool takes_them = function.bound == "cellular_three" && function.axes == 3 && function.takes_cell() &&
                          function.input("metric") >= 0 && configuration.hash == default_configuration().hash;
  if (!takes_them) return;
  const std::size_t count = std::min(kOuterRows.size(), inputs.size() / kInputWords);
  for (std::size_t i = 0; i < count; ++i) {
    const PlaceOfOuterRow& row = kOuterRows[i];
    const auto words = std::span(inputs).last((i + 1) * kInputWords).first(kInputWords);
    std::ranges::fill(words, 0u);  // of periods, too
    words[static_cast<std::size_t>(function.input("jitter"))] = std::bit_cast<std::uint32_t>(1.0f);
    words[static_cast<std::size_t>(function.input("metric"))] = 4u;  // HN_METRIC_CHEBYSHEV
    words[static_cast<std::size_t>(function.seed_word())] = row.seed;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(function, words, axis, {static_cast<std::uint32_t>(row.cell[axis]), static_cast<double>(row.fraction[axis])});
    }
  }
}

// How far an output may be off the value that was found.
std::optional<double> allowed_to_searched(const Function& function, const Configuration& configuration,
                                          std::span<const std::uint32_t> inputs, const CellularValue& right,
                                          std::size_t word) {
  if (configuration.arithmetic == Arithmetic::fixed) return std::nullopt;
  if (function.jumps(word) && right.second - right.first < kClearMargin) return kUndecided;
  return cellular_tolerance(function, configuration, inputs, word);
}

std::uint32_t bits_of(const Function& function, std::size_t word, double value) {
  return function.is_name(word) ? static_cast<std::uint32_t>(static_cast<std::int32_t>(value))
                                : std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

}  // namespace

Judged check_search(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  Words inputs = points_to_search(session, function, configuration);
  add_far_points(inputs, session, function, configuration);
  add_outer_rows(inputs, function, configuration);
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    const auto in = point(inputs, i);
    const CellularValue right = searched(function, configuration, in);
    for (std::size_t word = 0; word < function.outputs.size(); ++word) {
      comparison.word(in, result(outputs, i)[word], right.values[word], bits_of(function, word, right.values[word]),
                      allowed_to_searched(function, configuration, in, right, word), word);
    }
  }
  return comparison.finish();
}

namespace {

// The point for another form: at a position, or from a cell.
void put_for(const Function& form, const Function& function, std::span<std::uint32_t> words,
             std::span<const std::uint32_t> inputs, const Places& places) {
  for (std::size_t column = 0; column < form.inputs.size(); ++column) {
    const int from = function.input(form.inputs[column].name);
    words[column] = from >= 0 ? inputs[static_cast<std::size_t>(from)] : form.inputs[column].name == "metric" ? 1u : 0u;
  }
  put(form, words, places);
}

// A row of a pair that names the nearest point, or leads to it: `noise2d.cellular_cell_nearest`.
const Function& row_of(int axes, std::string_view name) {
  return find_function(fmt::format("noise{}d.{}", axes, name));
}

// The results that a function returns beside the nearest point that it sets: the text of the form that sets nothing,
// with two more arguments.
const Function& returned_beside(const Function& setting) {
  static std::list<Function> made;
  static std::list<std::string> texts;
  const auto found = std::find_if(made.begin(), made.end(), [&](const Function& f) { return f.id == setting.id; });
  if (found != made.end()) return *found;
  const Function& alone = *returning(setting);
  std::string& text = texts.emplace_back(alone.body);
  text.insert(text.rfind("); return "), ", nearest, offset");
  text = fmt::format("hn_ivec{0} nearest; hn_vec{0} offset; {1}", setting.axes, text);
  Function& beside = made.emplace_back(setting);
  beside.body = text;
  beside.outputs = alone.outputs;
  return beside;
}

// One way to the nearest point and to its properties.
struct Route {
  const Function* names;
  const Function* offsets;
  const Function* distances;  // null if a function returns none
  bool from_next_cell;        // with a fraction of 1 in place of 0
};

struct PointNames {
  Words inputs;  // of the names
  Words names;
  Words offsets;
  Words distances;
};

}  // namespace

const Function* returning(const Function& function) {
  if (!function.is_cellular() || !(function.is_name(0) || function.is_offset)) return nullptr;
  const auto returns_for_same = [&](const Function& other) {
    return other.bound == function.bound && other.axes == function.axes && !other.is_name(0) && !other.is_offset &&
           std::ranges::equal(other.inputs, function.inputs, {}, &Column::name, &Column::name);
  };
  const auto found = std::ranges::find_if(all_functions(), returns_for_same);
  return found == all_functions().end() ? nullptr : &*found;
}

// A fast value is rounded in another way in each text.
Judged check_returned(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const Function& alone = *returning(function);
  const Words inputs = random_points(function, points_of(session, function), Random(session.seed, "returned"));
  std::vector<double> allowed;
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    for (std::size_t word = 0; word < alone.outputs.size(); ++word) {
      allowed.push_back(2.0 * error_of(alone, configuration, word));
    }
  }
  return check_pairing(session, {.evaluation = {returned_beside(function), configuration, profile, {}, stage},
                                 .other = {alone, configuration, profile, {}, stage},
                                 .inputs = inputs,
                                 .other_inputs = inputs,
                                 .allowed = std::move(allowed),
                                 .exact = has_same_bits(function, configuration)});
}

// From its cell and from the next one with a fraction of 1 in place of 0, and without a period from a position: the
// same names, offsets and distances. The name is that of a cell within the period, whose point is where the offset
// leads; and the first distance is that to it.
Judged check_cell_names(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const Configuration& configuration = evaluation.configuration;
  const auto axes = static_cast<std::size_t>(function.axes);
  const bool border = function.bound == "cell_border";
  const Function& offsets = row_of(function.axes, "cellular_offset");
  const Function& cell_names = row_of(function.axes, "cellular_cell_nearest");
  const Function& cell_offsets = row_of(function.axes, "cellular_cell_offset");
  const Function& names = row_of(function.axes, "cellular_nearest");
  std::vector<Route> ways = {{&cell_names, border ? &row_of(function.axes, "cell_border_cell_offset") : &cell_offsets,
                              border ? nullptr : &returned_beside(cell_names), false},
                             {&cell_names, &cell_offsets, &row_of(function.axes, "cellular_cell_full"), true}};
  if (!function.takes_period()) {
    ways.push_back({&function, &offsets, border ? nullptr : &returned_beside(names), false});
    ways.push_back({&names, &offsets, &row_of(function.axes, "cellular_full"), false});
  }
  ways.push_back({&cell_names, &cell_offsets, &row_of(function.axes, "cellular_cell_full"), false});
  const std::size_t points = points_of(session, function);
  Random random(session.seed, "names");
  const Words settings = random_points(function, points, random);
  std::vector<Places> all_places;
  for (std::size_t i = 0; i < points; ++i) {
    Places places = random_places(function, random);
    for (Place& place : places) {
      place.cell = random.below(2 * kFurthestCellularCell) - kFurthestCellularCell;
      if (random.below(4) == 0) place.fraction = 0.0;
    }
    all_places.push_back(places);
  }
  std::vector<PointNames> known;
  for (const Route& way : ways) {
    const auto run = [&](const Function* form, Words& inputs) -> tl::expected<Words, Outcome> {
      inputs.assign(points * kInputWords, 0u);
      if (form == nullptr) return Words{};
      for (std::size_t i = 0; i < points; ++i) {
        Places places = all_places[i];
        for (Place& place : places) {
          if (way.from_next_cell && place.fraction == 0.0) place = {place.cell - 1u, 1.0};
        }
        put_for(*form, function, std::span(inputs).subspan(i * kInputWords, kInputWords), point(settings, i), places);
      }
      return evaluate(session, {*form, configuration, evaluation.profile, {}, evaluation.stage}, inputs);
    };
    PointNames one;
    Words inputs;
    HN_TRY(const auto distances, run(way.distances, inputs));
    HN_TRY(const auto led, run(way.offsets, inputs));
    HN_TRY(const auto named, run(way.names, one.inputs));
    one.names = named;
    one.offsets = led;
    one.distances = distances;
    known.push_back(std::move(one));
  }
  const PointNames& first = known.back();
  const double error = error_of(offsets, configuration, 0);
  const bool exact = has_same_bits(function, configuration);
  Comparison comparison(function, settings);
  for (std::size_t i = 0; i < points; ++i) {
    const auto in = point(settings, i);
    const auto number = [&](const Words& words, std::size_t word) { return number_of(result(words, i)[word]); };
    const bool undecided = is_undecided(cell_names, configuration, point(first.inputs, i));
    for (const PointNames& other : known) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const auto column = std::optional<double>(exact ? std::nullopt : std::optional(undecided ? kUndecided : 0.0));
        comparison.word(in, result(other.names, i)[axis], 0.0, result(first.names, i)[axis], column, axis);
        if (exact || !undecided) {
          comparison.number(in, std::bit_cast<float>(result(other.offsets, i)[axis]), number(first.offsets, axis),
                            exact ? 0.0 : 2.0 * error);
        }
      }
      for (std::size_t word = 0; word < 2 && !other.distances.empty(); ++word) {
        comparison.number(in, std::bit_cast<float>(result(other.distances, i)[word]), number(first.distances, word),
                          exact ? 0.0 : 2.0 * error);
      }
    }
    // The name within its period, and the point of that cell.
    Words there(point(first.inputs, i).begin(), point(first.inputs, i).end());
    Words at_name(kInputWords);
    Places named;
    for (std::size_t axis = 0; axis < axes; ++axis) named.push_back({result(first.names, i)[axis], 0.5});
    put_for(cell_names, cell_names, at_name, there, named);
    const std::vector<FeaturePoint> near = feature_points(cell_names, configuration, at_name);
    const FeaturePoint& own = near[near.size() / 2];
    double sum = 0.0;
    double largest = 0.0;
    double square = 0.0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const auto period = static_cast<std::int32_t>(there[static_cast<std::size_t>(cell_names.period_word()) + axis]);
      const auto name = static_cast<std::int32_t>(named[axis].cell);
      comparison.require(period <= 0 || (name >= 0 && name < period), in, static_cast<float>(name),
                         "the name of a cell within the period");
      const double cells = period > 0 ? static_cast<double>(period) : 0x1p32;
      const double offset = number(first.offsets, axis);
      const double target = static_cast<double>(static_cast<std::int32_t>(all_places[i][axis].cell)) +
                            all_places[i][axis].fraction + offset;
      const double away = target - (static_cast<double>(name) + own.at[axis]);
      comparison.number(in, static_cast<float>(away - cells * std::round(away / cells)), 0.0, 2.0 * error);
      sum += std::fabs(offset);
      largest = std::max(largest, std::fabs(offset));
      square += offset * offset;
    }
    const int metric = border ? 1 : static_cast<int>(there[static_cast<std::size_t>(cell_names.input("metric"))]);
    static_assert(kMetrics == 5);  // any other number counts as Euclidean
    const double distance = metric == 2   ? square
                            : metric == 3 ? sum
                            : metric == 4 ? largest
                            : metric == 5 ? sum + square
                                          : std::sqrt(square);
    comparison.number(in, static_cast<float>(number(first.distances, 0)), distance, 4.0 * error);
  }
  return comparison.finish();
}

// With P and Q, the two nearest points at the distances a and b: the border with any other point is no nearer than
// (b - a) / 2, and that with Q no farther than (a + b) / 2. Halfway between P and Q the border is there, unless a third
// point is nearer.
Judged check_border(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const Function& distances = row_of(function.axes, function.takes_cell() ? "cellular_cell" : "cellular");
  Random random(session.seed, "border");
  Words inputs = random_points(function, points_of(session, function), random);
  std::vector<bool> on_border;
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    const auto words = std::span(inputs).subspan(i, kInputWords);
    const Places places = random_places(function, random);
    put(function, words, places);
    on_border.push_back(random.below(2) == 0);
    if (!on_border.back()) continue;
    const CellularValue here = searched(function, configuration, words);
    put(function, words, at(places, between(here.nearest.at, here.next.at)));
    // Rounded to units it is nearly there.
    const CellularValue there = searched(function, configuration, words);
    on_border.back() = there.second - there.first < 8.0 * kUnit;
  }
  HN_TRY(const auto borders, evaluate(session, evaluation, inputs));
  HN_TRY(const auto both,
         evaluate(session, {distances, configuration, profile, {}, stage}, inputs_for(distances, function, inputs)));
  const double error = error_of(function, configuration, 0) + error_of(distances, configuration, 0);
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < on_border.size(); ++i) {
    const auto number = [&](const Words& words, std::size_t word) { return number_of(result(words, i)[word]); };
    const double border = number(borders, 0);
    const double least = (number(both, 1) - number(both, 0)) / 2.0;
    const double most = (number(both, 1) + number(both, 0)) / 2.0;
    comparison.require(border >= least - error && border <= most + error, point(inputs, i), static_cast<float>(border),
                       fmt::format("from {:.9g} to {:.9g}", least, most));
    if (on_border[i]) comparison.number(point(inputs, i), static_cast<float>(border), 0.0, 4.0 * kUnit + error);
  }
  return comparison.finish();
}

}  // namespace hn
