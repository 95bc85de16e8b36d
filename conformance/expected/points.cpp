#include "expected/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>

#include "library/digest.hpp"

namespace hn {
namespace {

std::uint32_t random_word(Random& random) {
  constexpr std::array<std::uint32_t, 12> kEdges = {0u,     1u,      2u,       0x7Fu,       0x80u,       0xFFu,
                                                    0x100u, 0xFFFFu, 0x10000u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu};
  const std::uint32_t choice = random.below(8);
  if (choice == 0) return kEdges[random.below(kEdges.size())];
  return choice == 1 ? 1u << random.below(32) : random.word();
}

// How many items are shuffled, up to 2^31: few, a power of two or one beside it, and any number of bits.
std::uint32_t random_count(Random& random) {
  constexpr std::uint32_t kMost = 1u << 31;
  switch (random.below(3)) {
    case 0:
      return random.below(8);
    case 1:
      return std::min((1u << random.below(32)) + random.below(3) - 1u, kMost);
    default:
      return 1u + (random.word() >> (1u + random.below(31)));
  }
}

// Where a point lies. All coordinates of a point share it.
enum class Region { near, negative, lattice, far, very_far, extreme, steep };
// The last two regions are for callers that name them. A steep point is one of an octave sum at a position: a tiny one,
// which a huge lacunarity makes large. (From a cell, and for gullies, a lacunarity beyond 255 is cut off.)
constexpr std::uint32_t kRegions = 5;

std::uint32_t regions_of(const Function& function, Extremes extremes) {
  if (extremes == Extremes::none) return kRegions;
  const bool steep =
      function.is_octave_sum() && !function.takes_cell() && !function.is_gullies() && extremes == Extremes::floats;
  return steep ? kRegions + 2 : kRegions + 1;
}

std::uint32_t random_cell(Region region, Random& random) {
  switch (region) {
    case Region::near:
      return random.below(256);
    case Region::negative:
    case Region::lattice:
      return 0u - random.below(256);
    case Region::far:
      return (random.below(2) == 0 ? 0u : 0u - (3u << 20)) + (1u << 20) + random.below(1u << 20);
    case Region::very_far:
    case Region::extreme:
    case Region::steep:
      break;
  }
  return random_word(random);
}

// Draws a number of either sign, from 2^low up to and without 2^high, every power of two as often. At -127 numbers are
// subnormal.
float random_magnitude(int low, int high, Random& random) {
  const auto exponent = static_cast<std::uint32_t>(low + 127) + random.below(static_cast<std::uint32_t>(high - low));
  return std::bit_cast<float>((exponent << 23) | (random.word() & 0x807FFFFFu));
}

// The smallest that HN_PRECISE sees of a position and of an octave sum's start, and the next ones below.
float random_threshold(Random& random) {
  constexpr std::array kThresholds = {0x1p-32f, 0x1.fffffep-33f, 0x1p-126f, 0x1.fffffcp-127f};
  const float threshold = kThresholds[random.below(kThresholds.size())];
  return random.below(2) == 0 ? threshold : -threshold;
}

// A number that a float can hold and a fraction cannot.
float random_extreme(int high, Random& random) {
  switch (random.below(7)) {
    case 0:
      return random_magnitude(-127, -126, random);
    case 1:
      return random_magnitude(-126, -30, random);
    case 2:
      return random_magnitude(-34, -18, random);  // about where HN_PRECISE and HN_FIXED see nothing any more
    case 3:
      return -0.0f;
    case 4:
      return random_magnitude(0, 32, random);
    case 5:
      return random_threshold(random);
    default:
      return random_magnitude(23, high, random);
  }
}

// So small that no lacunarity below 2^126 takes the next octave to 2^96.
float random_tiny(Random& random) {
  return random.below(2) == 0 ? random_magnitude(-127, -126, random) : random_magnitude(-126, -30, random);
}

float random_position(Region region, Random& random) {
  switch (region) {
    case Region::near:
      return random.uniform(0.0f, 64.0f);
    case Region::negative:
      return random.uniform(-64.0f, 0.0f);
    case Region::lattice: {
      // On a lattice line, or one float beside it. Beside 0 that would be a subnormal, which a driver may flush, so
      // there it is a tiny normal float.
      const float line = static_cast<float>(random.below(129)) - 64.0f;
      const std::uint32_t side = random.below(3);
      if (side == 0) return line;
      if (line == 0.0f) return side == 1 ? 1e-30f : -1e-30f;
      return std::nextafter(line, side == 1 ? 100.0f : -100.0f);
    }
    case Region::far:
      return std::copysign(random.uniform(1048576.0f, 2097152.0f), random.uniform(-1.0f, 1.0f));
    case Region::very_far:
    case Region::extreme:
    case Region::steep:
      break;
  }
  return std::copysign(random.uniform(2097152.0f, 8388608.0f), random.uniform(-1.0f, 1.0f));
}

float random_fraction(Random& random) {
  constexpr std::array kEdges = {0.0f, 1.0f, 0.5f, 5.9604645e-8f, 0.99999994f};
  return random.below(16) == 0 ? kEdges[random.below(kEdges.size())] : random.uniform(0.0f, 1.0f);
}

float extreme_fraction(Extremes extremes, Random& random) {
  const float value = random_extreme(128, random);
  if (extremes == Extremes::integers) return value;
  const float inside = std::fabs(value) <= 1.0f ? std::fabs(value) : 1.0f / std::fabs(value);
  return std::signbit(value) && value == 0.0f ? value : inside;
}

// Few octaves at positions far out, so that the last one still has a fraction. From a cell it always has one.
std::uint32_t random_octaves(const Function& function, Region region, Random& random) {
  const bool far = region == Region::far || region == Region::very_far;
  return far && !function.takes_cell() ? random.below(2) : random.below(6);
}

// A float of octaves: as many as there may be whole ones, often exactly or nearly that; now and then none. A single
// octave more than a whole number begins with little weight.
float random_detail(Region region, Extremes extremes, Random& random) {
  if (region == Region::extreme && extremes == Extremes::integers && random.below(64) == 0) return 33.5f;
  if (random.below(16) == 0) return random.below(2) == 0 ? 0.0f : -1.0f;
  if (extremes != Extremes::none && random.below(16) == 0) return random.below(2) == 0 ? 1e-40f : 0x1p-32f;
  const bool far = region == Region::far || region == Region::very_far;
  const auto most = static_cast<float>(region == Region::steep ? 2 : far ? 1 : 1 + random.below(7));
  switch (random.below(4)) {
    case 0:
      return most;
    case 1:
      return most - std::ldexp(1.0f, -1 - static_cast<int>(random.below(20)));
    case 2:
      return most - 1.0f + std::ldexp(1.0f, -1 - static_cast<int>(random.below(20)));
    default:
      return random.uniform(most - 1.0f, most);
  }
}

// Halves and less, down to where all of many octaves count in full; nothing, and more than a cell.
float random_footprint(Region region, Extremes extremes, Random& random) {
  if (region == Region::extreme && extremes == Extremes::integers && random.below(2) == 0) {
    return random_extreme(128, random);
  }
  if (random.below(8) == 0) return random.below(2) == 0 ? 0.0f : 3.0f;
  return std::ldexp(random.uniform(0.5f, 1.0f), -static_cast<int>(random.below(9)));
}

// Usual values, the range, its ends, and values beyond.
float random_strength(const Function& function, Region region, Extremes extremes, Random& random) {
  if (region == Region::extreme && extremes == Extremes::integers && random.below(2) == 0) {
    return random_extreme(128, random);
  }
  constexpr std::array kPingPong = {2.0f, 2.0f, 0.0f, 64.0f, -1.0f, 100.0f};
  constexpr std::array kWeighted = {1.0f, 1.0f, 0.5f, 0.0f, -1.0f, 2.0f};
  constexpr std::array kEroded = {1.0f, 1.0f, 0.0f, 16.0f, -1.0f, 17.0f};
  const bool weighted = function.bound == "weighted";
  if (random.below(2) == 0) return random.uniform(0.0f, weighted ? 1.0f : 4.0f);
  const auto& some = weighted ? kWeighted : function.bound == "eroded" ? kEroded : kPingPong;
  return some[random.below(kPingPong.size())];
}

// Usual values, the ends, values beyond and 0; and values too small for HN_PRECISE. An error of a progressive warp
// grows with each octave, by more for a larger amplitude: so most are small.
float random_amplitude(const Function& function, Region region, Extremes extremes, Random& random) {
  if (region == Region::extreme && extremes == Extremes::integers && random.below(2) == 0) {
    return random_extreme(128, random);
  }
  constexpr std::array kSome = {0.0f, 64.0f, 65.0f, -1.0f, 0x1p-20f, 1e-30f};
  const float usual = function.bound == "warp_progressive" ? 0.25f : 1.0f;
  if (random.below(2) == 0) return random.uniform(0.0f, 2.0f * usual);
  return random.below(2) == 0 ? usual : kSome[random.below(kSome.size())];
}

// Draws a depth of gullies: a usual one, none, its end, beyond, or so little that HN_PRECISE sees nothing. An error
// grows with each octave, by more for a larger depth: so most are small.
float random_depth(Region region, Extremes extremes, Random& random) {
  if (region == Region::extreme && extremes == Extremes::integers && random.below(2) == 0) {
    return random_extreme(128, random);
  }
  constexpr std::array kSome = {0.0f, 8.0f, 9.0f, -1.0f, 0x1p-20f, 1e-30f};
  if (random.below(4) != 0) return random.uniform(0.0f, 0.5f);
  return random.below(2) == 0 ? 0.1f : kSome[random.below(kSome.size())];
}

// A component of the slope that gullies run down: mostly of hills, often flat or nearly so, where gullies rotate fast,
// and now and then at an end or beyond.
float random_slope(Region region, Random& random) {
  if (region == Region::extreme && random.below(2) == 0) return random_extreme(128, random);
  constexpr std::array kSome = {8.0f, -8.0f, 9.5f, -100.0f};
  switch (random.below(8)) {
    case 0:
      return 0.0f;
    case 1:
      return random_magnitude(-20, -2, random);
    case 2:
      return random.below(2) == 0 ? kSome[random.below(kSome.size())] : random.uniform(-9.0f, 9.0f);
    default:
      return random.uniform(-3.0f, 3.0f);
  }
}

// Seldom more than a few: points are drawn in groups, and a group takes as long as the point with the most.
std::uint32_t extreme_octaves(Extremes extremes, Random& random) {
  constexpr std::array<std::uint32_t, 6> kEdges = {0xFFFFFFFFu, 0x80000000u, 31u, 32u, 33u, 0x7FFFFFFFu};
  const bool edge = extremes == Extremes::integers && random.below(512) == 0;
  return edge ? kEdges[random.below(kEdges.size())] : random.below(6);
}

// 2 keeps positions of few bits exact, so that nothing but the noise itself may err; the others round.
float random_lacunarity(Random& random) {
  constexpr std::array kValues = {2.0f, 2.0f, 2.0f, 1.5f, 1.9f, 2.3f};
  return kValues[random.below(kValues.size())];
}

float random_gain(Random& random) {
  constexpr std::array kValues = {0.5f, 0.5f, 0.25f, 0.7f, 1.0f, 0.0f};
  return kValues[random.below(kValues.size())];
}

// A position of few bits: a multiple of 1/32.
float coarse(float position) { return std::floor(position * 32.0f) * 0.03125f; }

// Whose octaves have Jacobians. With HN_PRECISE their bits are defined while those are below 2^60.
bool has_jacobian(const Function& function) {
  return function.bound == "fbm_d" || function.bound == "warp_progressive";
}

// Octave sums of integers have values for all settings; those of floats for these, and at a tiny position for a
// lacunarity of any size, or of any that a Jacobian allows.
float random_setting(const Function& function, std::string_view name, Region region, Extremes extremes,
                     Random& random) {
  if (name == "detail") return random_detail(region, extremes, random);
  if (name == "footprint") return random_footprint(region, extremes, random);
  if (name == "strength") return random_strength(function, region, extremes, random);
  if (name == "amplitude") return random_amplitude(function, region, extremes, random);
  if (name == "depth") return random_depth(region, extremes, random);
  if (region == Region::steep && name == "lacunarity")
    return random_magnitude(20, has_jacobian(function) ? 29 : 126, random);
  if (region == Region::extreme && extremes == Extremes::integers && random.below(2) == 0) {
    return random.below(2) == 0 ? random_extreme(128, random) : random.uniform(-1.0f, 256.0f);
  }
  return name == "lacunarity" ? random_lacunarity(random) : random_gain(random);
}

// In turns: none, quarters, where components of gradients change places, so small or so large that few of its bits
// count, of either sign, and anything.
float random_phase(Region region, Random& random) {
  if (region == Region::extreme) return random_extreme(128, random);
  switch (random.below(6)) {
    case 0:
      return 0.0f;
    case 1:
      return static_cast<float>(random.below(33)) * 0.25f - 4.0f;
    case 2:
      return random_magnitude(-40, -20, random);
    case 3:
      return random.uniform(-65536.0f, 65536.0f);
    case 4:
      return random.uniform(-1.0f, 0.0f);
    default:
      return random.uniform(0.0f, 1.0f);
  }
}

// Draws waves per cell: mostly where they are not cut off, often none or a whole number, and now and then at a limit or
// beyond.
float random_wave(Region region, Random& random) {
  if (region == Region::extreme) return random_extreme(128, random);
  switch (random.below(8)) {
    case 0:
      return 0.0f;
    case 1:
      return static_cast<float>(random.below(33)) - 16.0f;
    case 2:
      return random_magnitude(-20, 4, random);
    case 3:
      return random.uniform(-20.0f, 20.0f);
    default:
      return random.uniform(-8.0f, 8.0f);
  }
}

// Mostly from 0 to 1, and often at one of the ends; rarely outside. On a regular lattice, with 0, many places are
// equally near to several points.
float random_jitter(Region region, Random& random) {
  if (region == Region::extreme && random.below(2) == 0) return random_extreme(128, random);
  switch (random.below(8)) {
    case 0:
      return 0.0f;
    case 1:
    case 2:
      return 1.0f;
    case 3:
      return random.below(4) == 0 ? random.uniform(-1.0f, 2.0f) : random.uniform(0.0f, 0.01f);
    default:
      return random.uniform(0.0f, 1.0f);
  }
}

// Rarely a number that is no metric.
std::uint32_t random_metric(Random& random) {
  constexpr std::array<std::uint32_t, 5> kOthers = {0u, 6u, 7u, 0xFFFFFFFDu, 0x7FFFFFFFu};
  return random.below(16) == 0 ? kOthers[random.below(kOthers.size())] : 1 + random.below(5);
}

float random_coordinate(Region region, bool octave_sum, Extremes extremes, Random& random) {
  if (region == Region::steep) return random_tiny(random);
  if (region == Region::extreme) {
    return random_extreme(octave_sum && extremes == Extremes::floats ? 96 : 128, random);
  }
  const float value = random_position(region, random);
  return octave_sum && region != Region::lattice && extremes == Extremes::none ? coarse(value) : value;
}

bool is_period(const Column& column) { return column.name.size() == 2 && column.name.front() == 'p'; }

// None, the smallest, powers of two and others, up to the largest; now and then a negative number, which is none. Those
// of octave sums grow with each octave.
std::uint32_t random_period(bool octave_sum, Random& random) {
  constexpr std::array<std::uint32_t, 12> kPeriods = {0,  1,  2,       3,       7,        5,
                                                      64, 48, 1000003, 1 << 20, 1u << 30, 0x7FFFFFFFu};
  if (random.below(32) == 0) return 0x80000000u | random.word();
  return kPeriods[random.below(octave_sum ? 8 : kPeriods.size())];
}

// Draws the scale of whole-numbered positions: how many cells are how many units long.
std::uint32_t random_scale(Random& random) {
  constexpr std::array<std::uint32_t, 8> kScales = {1, 2, 3, 7, 100, 1024, 65535, 65536};
  return random.below(2) == 0 ? kScales[random.below(kScales.size())] : 1 + random.below(65536);
}

std::uint32_t random_whole(const Column& column, const Function& function, Region region, Extremes extremes,
                           Random& random) {
  if (is_period(column)) return random_period(function.is_octave_sum(), random);
  if (column.name == "cells" || column.name == "units") return random_scale(random);
  if (column.name == "metric") return random_metric(random);
  if (column.name == "spread") return random.below(20);  // one that is none at either end
  if (column.name != "octaves") return random_cell(region, random);
  if (region == Region::steep) return 1 + random.below(2);  // the position of a third octave would overflow
  return extremes == Extremes::none ? random_octaves(function, region, random) : extreme_octaves(extremes, random);
}

// Draws a value or its distribution: mostly where it has no end, often at an end, and now and then far beyond. A
// number of octaves is one of what hn_distribution_fbm takes.
float random_of_distribution(std::string_view name, Region region, Random& random) {
  if (region == Region::extreme && random.below(2) == 0) return random_extreme(128, random);
  constexpr std::array kEnds = {0.0f, -0.0f, 1.0f, -1.0f, 3.0f, 0.0625f};
  if (random.below(16) == 0) return kEnds[random.below(kEnds.size())];
  if (name == "detail")
    return random.below(2) == 0 ? random.uniform(1.0f, 9.0f) : 1.0f + static_cast<float>(random.below(32));
  if (name == "noise") return random.uniform(-1.0f, 1.0f);
  return name == "reach" ? random.uniform(0.1f, 1.5f) : random.uniform(0.0f, 1.0f);
}

bool is_setting(std::string_view name) {
  constexpr std::array<std::string_view, 7> kSettings = {"lacunarity", "gain",   "strength", "amplitude",
                                                         "footprint",  "detail", "depth"};
  return std::ranges::find(kSettings, name) != kSettings.end();
}

float random_float(const Column& column, const Function& function, Region region, Extremes extremes, Random& random) {
  if (function.family == Family::distribution) return random_of_distribution(column.name, region, random);
  if (is_setting(column.name)) return random_setting(function, column.name, region, extremes, random);
  if (column.name == "phase") return random_phase(region, random);
  if (column.name.starts_with("k")) return random_wave(region, random);
  if (column.name == "jitter") return random_jitter(region, random);
  if (column.name == "ex" || column.name == "ey") return random_slope(region, random);
  if (!column.name.starts_with("f")) return random_coordinate(region, function.is_octave_sum(), extremes, random);
  return region == Region::extreme ? extreme_fraction(extremes, random) : random_fraction(random);
}

std::uint32_t random_input(const Column& column, const Function& function, Region region, Extremes extremes,
                           Random& random) {
  switch (column.type) {
    case WordType::u32:
      return column.name == "n" ? random_count(random) : random_word(random);
    case WordType::i32:
      return random_whole(column, function, region, extremes, random);
    case WordType::f32:
      return std::bit_cast<std::uint32_t>(random_float(column, function, region, extremes, random));
    case WordType::f64:
      break;
  }
  throw std::logic_error(fmt::format("no point has a column of the type of {}", column.name));
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view name) : state_(fnv1a64(name, seed)) {}

std::uint64_t Random::next() {
  state_ += 0x9E3779B97F4A7C15ull;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

float Random::uniform(float low, float high) {
  // 24 bits fill a float; the product may still round up to 1, which next below high corrects.
  const float value = low + (high - low) * (static_cast<float>(next() >> 40) * 0x1p-24f);
  return value < high ? value : std::nextafter(high, low);
}

Extremes defined_extremes(const Configuration& configuration) {
  switch (configuration.arithmetic) {
    case Arithmetic::precise:
      return Extremes::floats;
    case Arithmetic::fixed:
      return Extremes::integers;
    case Arithmetic::fast:
      break;
  }
  return Extremes::none;
}

namespace {

// Every other coordinate with a period goes beside a multiple of it, where the seam is.
void go_to_seams(const Function& function, std::span<std::uint32_t> words, Random& random) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(function.axes); ++axis) {
    const auto period = static_cast<std::int32_t>(words[static_cast<std::size_t>(function.period_word()) + axis]);
    if (period <= 0 || random.below(2) == 0) continue;
    if (function.starts_from_integers()) {
      // Wherever that is, modulo 2^32: with a large period, few multiples are ints.
      const std::uint32_t multiple = static_cast<std::uint32_t>(period) * (random.below(9) - 4u);
      words[axis] = multiple + random.below(3) - 1u;
    } else if (period <= 1 << 20) {
      const float multiple = static_cast<float>(period) * (static_cast<float>(random.below(9)) - 4.0f);
      words[axis] = std::bit_cast<std::uint32_t>(multiple + coarse(random.uniform(-1.0f, 1.0f)));
    }
  }
}

// Every other item is one of those that are there, often the first or the last; the others count modulo their number.
void go_to_items(const Function& function, std::span<std::uint32_t> words, Random& random) {
  const std::uint32_t n = words[static_cast<std::size_t>(function.input("n"))];
  std::uint32_t& item = words[static_cast<std::size_t>(function.input("i"))];
  if (n == 0 || random.below(2) == 0) return;
  const std::uint32_t end = random.below(8);
  item = end == 0 ? n - 1u : end == 1 ? n : item % n;
}

// Where the noise in four dimensions, whose gradients have components of 0, is 2^-96 or -2^-96 with HN_PRECISE, and
// where x is one float less, so that the noise is below and becomes 0. Random numbers do not find these; a bisection
// along x did, with the default hash. unit.Twin holds that they are what they are here for.
void add_least_results(std::span<std::uint32_t> words) {
  constexpr std::array<std::array<std::uint32_t, 5>, 4> kPoints = {{{0x31988C69u, 0x37820000u, 0, 0, 99},
                                                                    {0x31988C68u, 0x37820000u, 0, 0, 99},
                                                                    {0x365E7CF6u, 0x37820000u, 0, 0, 404},
                                                                    {0x365E7CF5u, 0x37820000u, 0, 0, 404}}};
  for (std::size_t i = 0; i < kPoints.size() && (i + 1) * kInputWords <= words.size(); ++i) {
    std::copy(kPoints[i].begin(), kPoints[i].end(), words.begin() + static_cast<std::ptrdiff_t>(i * kInputWords));
  }
}

// Feature points are about the centres of cells. Every eighth coordinate goes to the middle of its cell, as far as
// floats hold that, or to a float beside it. Coordinates on lattice lines are on the walls.
void go_to_middles(const Function& function, std::span<std::uint32_t> words, Random& random) {
  const auto axes = static_cast<std::size_t>(function.axes);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    if (random.below(8) != 0) continue;
    const std::size_t word = function.takes_cell() ? axes + axis : axis;
    const float middle = function.takes_cell() ? 0.5f : std::floor(std::bit_cast<float>(words[word])) + 0.5f;
    const std::uint32_t side = random.below(3);
    if (std::fabs(middle) >= 4194304.0f) continue;  // a float beyond has no half
    words[word] = std::bit_cast<std::uint32_t>(side == 0 ? middle : std::nextafter(middle, side == 1 ? 3e38f : -3e38f));
  }
}

}  // namespace

std::vector<std::uint32_t> random_points(const Function& function, std::size_t count, Random random,
                                         Extremes extremes) {
  const std::uint32_t regions = regions_of(function, extremes);
  std::vector<std::uint32_t> words(count * kInputWords);
  for (std::size_t i = 0; i < count; ++i) {
    const auto region = static_cast<Region>(random.below(regions));
    for (std::size_t column = 0; column < function.inputs.size(); ++column) {
      words[i * kInputWords + column] = random_input(function.inputs[column], function, region, extremes, random);
    }
    if (region == Region::extreme || region == Region::steep) continue;
    const auto point = std::span(words).subspan(i * kInputWords, kInputWords);
    if (function.takes_count()) go_to_items(function, point, random);
    if (function.takes_period()) go_to_seams(function, point, random);
    if (function.is_cellular()) go_to_middles(function, point, random);
  }
  if (extremes == Extremes::floats && function.id == "noise4d.perlin") add_least_results(words);
  return words;
}

}  // namespace hn
