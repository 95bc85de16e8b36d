// The positions of places: a place's source comes back from the first octave of a sum.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "cases/value_checks.hpp"
#include "expected/points.hpp"

namespace hn {
namespace {

constexpr std::size_t kPointsOfEach = 64;
constexpr std::uint32_t kMostAxes = 4;
// A place is made in one of five ways: of a cell and a fraction, of a cell alone, of a position, of a cell and a
// fraction of 1, or of a position that is a whole number of units, which stands where a cell does. With the fourth it
// is the cell that comes back: the first octave must not go on to the next one.
constexpr std::uint32_t kWays = 5;
constexpr std::uint32_t kCellAlone = 1;
constexpr std::uint32_t kAtTheEnd = 3;
constexpr std::uint32_t kOfUnits = 4;

// Where the words of a point stand.
constexpr std::size_t kFractions = 4;
constexpr std::size_t kPositions = 8;
constexpr std::size_t kAxes = 12;
constexpr std::size_t kWay = 13;
constexpr std::size_t kCellsWord = 14;
constexpr std::size_t kUnitsWord = 15;

constexpr std::string_view kFiles =
    "#include \"octaves1d.glsl\"\n#include \"octaves2d.glsl\"\n#include \"octaves3d.glsl\"\n"
    "#include \"octaves4d.glsl\"\n#include \"position.glsl\"\n";

// The positions of places of so many axes.
std::string body_of(std::uint32_t axes) {
  const std::string_view components = std::string_view("xyzw").substr(0, axes);
  std::string bits;
  for (std::size_t i = 0; i < kMostAxes; ++i) {
    bits += i == 0 ? "" : ", ";
    bits += i < axes ? fmt::format("bits_of(x{}{})", axes == 1 ? "" : ".", components.substr(axes == 1 ? 1 : i, 1))
                     : std::string("0u");
  }
  return fmt::format(
      "if (d.x == {0}u) {{\n"
      "  hn_place{0} place = hn_place(cell.{1}, f.{1});\n"
      "  if (d.y == 1u) place = hn_place(cell.{1});\n"
      "  if (d.y == 2u) place = hn_place(p.{1});\n"
      "  if (d.y == 4u) place = hn_place(cell.{1}, int(d.z), int(d.w));\n"
      "  hn_octaves{0} o = hn_octaves(place, 1, 2.0f, 0.5f, 0u);\n"
      "  hn_{2} x = hn_position(o.place);\n"
      "  if (d.y == 3u) x = {2}(o.place.cell);\n"
      "  return uvec4({3});\n"
      "}}\n",
      axes, components, axes == 1 ? "float" : fmt::format("vec{}", axes), bits);
}

const Function& positions() {
  static const std::string kBody = [] {
    std::string body =
        "hn_ivec4 cell = ivec4(a);\n"
        "hn_vec4 f = vec4(float_of(b.x), float_of(b.y), float_of(b.z), float_of(b.w));\n"
        "hn_vec4 p = vec4(float_of(c.x), float_of(c.y), float_of(c.z), float_of(c.w));\n";
    for (std::uint32_t axes = 1; axes <= kMostAxes; ++axes) body += body_of(axes);
    return body + "return uvec4(0u, 0u, 0u, 0u);";
  }();
  // As if it were one more row of the table.
  static const Function kFunction = {.id = "place.all",
                                     .file = "place.glsl",
                                     .call = {},
                                     .body = kBody,
                                     .inputs = std::vector<Column>(kUnitsWord + 1, {"word", WordType::u32}),
                                     .outputs = std::vector<Column>(kMostAxes, {"position", WordType::f32}),
                                     .plain = {}};
  return kFunction;
}

std::uint32_t bits_of(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

// Places that a float holds: in the cells beside 0 with all bits of a fraction, and farther out with some.
void put_place(std::span<std::uint32_t> words, std::size_t axis, Random& random) {
  const bool near_0 = random.below(2) == 0;
  const int cell = near_0 ? -static_cast<int>(random.below(2)) : static_cast<int>(random.below(1u << 13)) - (1 << 12);
  const int bits = near_0 ? 24 : 11;
  const double fraction = std::ldexp(random.below(1u << bits), -bits);
  words[axis] = static_cast<std::uint32_t>(cell);
  words[kFractions + axis] = bits_of(fraction);
  words[kPositions + axis] = bits_of(cell + fraction);
}

// Up to eight cells are up to 64 units long, a power of two, so that a float holds the position.
void put_units(std::span<std::uint32_t> words, Random& random) {
  const std::uint32_t cells = 1 + random.below(8);
  const std::uint32_t units = 1u << random.below(7);
  words[kCellsWord] = cells;
  words[kUnitsWord] = units;
  for (std::size_t axis = 0; axis < kMostAxes; ++axis) {
    const double position = static_cast<std::int32_t>(words[axis]);
    words[kPositions + axis] = bits_of(position * cells / units);
  }
}

Words places() {
  Words inputs(kMostAxes * kWays * kPointsOfEach * kInputWords);
  Random random(0, "positions");
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    const auto words = std::span(inputs).subspan(i * kInputWords, kInputWords);
    for (std::size_t axis = 0; axis < kMostAxes; ++axis) put_place(words, axis, random);
    words[kAxes] = static_cast<std::uint32_t>(i % kMostAxes) + 1;
    words[kWay] = static_cast<std::uint32_t>(i / kMostAxes % kWays);
    if (words[kWay] == kAtTheEnd) std::ranges::fill(words.subspan(kFractions, kMostAxes), bits_of(1.0));
    if (words[kWay] == kOfUnits) put_units(words, random);
  }
  return inputs;
}

Judged check_positions(Session& session, const Evaluation& evaluation) {
  const Words inputs = places();
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Comparison comparison(evaluation.function, inputs);
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    const auto in = point(inputs, i);
    for (std::size_t axis = 0; axis < in[kAxes]; ++axis) {
      const bool is_cell = in[kWay] == kCellAlone || in[kWay] == kAtTheEnd;
      const std::uint32_t right = is_cell ? bits_of(static_cast<std::int32_t>(in[axis])) : in[kPositions + axis];
      comparison.bits(in, result(outputs, i)[axis], right, axis);
    }
  }
  return comparison.finish();
}

}  // namespace

// HN_FIXED keeps a fraction in two parts, floats in one.
std::vector<Case> position_cases() {
  std::vector<Case> cases;
  for (const std::string_view setting : {"lattice", "lattice+fixed"}) {
    const Configuration& configuration = configuration_named(setting);
    const Evaluation evaluation{
        positions(), configuration, main_profile(configuration, false), {.knobs = kFiles}, Stage::vertex};
    CaseName name = name_of(evaluation, "positions");
    name.configuration = configuration.name_without_arithmetic();
    name.arithmetic = name_of(configuration.arithmetic);
    cases.push_back({std::move(name), CheckKind{evaluation, check_positions}, Extent::one_driver});
  }
  return cases;
}

}  // namespace hn
