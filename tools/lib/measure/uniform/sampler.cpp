// Samples noises for tools/measure uniform, at random cells, fractions and seeds, so that each value is independent: a
// shared library, whose functions know a noise by its number in subjects.inc. With HN_GRADIENT_SINE it has the noises
// of that. HN_SUBJECTS may name another such file.

#include <algorithm>
#include <cstdint>
#include <hashnoise/hashnoise.hpp>

namespace {

using namespace hashnoise;

constexpr int kBins = 1 << 16;
constexpr float kPerValue = kBins / 3.0f;

// Vigna's splitmix64.
struct Random {
  std::uint64_t state;
  std::uint32_t word() {
    std::uint64_t z = state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30u)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27u)) * 0x94D049BB133111EBu;
    return static_cast<std::uint32_t>((z ^ (z >> 31u)) >> 32u);
  }
  int cell() { return static_cast<int>(word()); }
  float fraction() { return hn_unorm(word()); }
};

template <int Axes>
auto place(Random& random) {
  const ivec4 cell(random.cell(), random.cell(), random.cell(), random.cell());
  const vec4 f(random.fraction(), random.fraction(), random.fraction(), random.fraction());
  if constexpr (Axes == 1) {
    return hn_place(cell.x, f.x);
  } else if constexpr (Axes == 2) {
    return hn_place(ivec2(cell.x, cell.y), vec2(f.x, f.y));
  } else if constexpr (Axes == 3) {
    return hn_place(ivec3(cell.x, cell.y, cell.z), vec3(f.x, f.y, f.z));
  } else {
    return hn_place(cell, f);
  }
}

// The sum is made as hn_fbm is, at a place, where octaves may be fractional, too.
template <int Axes, typename Noise>
float sum(Random& random, Noise noise, float detail, float gain) {
  const int count = hn_i_whole_octaves(detail);
  auto o = hn_octaves(place<Axes>(random), count, 2.0f, gain, random.word());
  o.sum.part = hn_i_last_part(detail, count);
  do hn_add_detail(o, noise(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o);
}

template <int Axes, typename Noise>
void count_values(int number, Noise noise, long points, long* bins) {
  Random random{static_cast<std::uint64_t>(number)};
  for (long i = 0; i < points; ++i) {
    const auto where = place<Axes>(random);
    const float value = noise(where, random.word());
    ++bins[std::clamp(static_cast<int>((value + 1.5f) * kPerValue), 0, kBins - 1)];
  }
}

template <int Axes, typename Noise>
void count_uniform(int number, Noise noise, float octaves, float gain, vec4 spread, long points, long* bins) {
  const bool single = octaves == 1.0f;
  if (!single) spread = hn_distribution_fbm(spread, octaves, gain);
  Random random{static_cast<std::uint64_t>(number) << 32u};
  for (long i = 0; i < points; ++i) {
    float value = 0.0f;
    if (single) {
      const auto where = place<Axes>(random);
      value = noise(where, random.word());
    } else {
      value = sum<Axes>(random, noise, octaves, gain);
    }
    ++bins[std::clamp(static_cast<int>(hn_uniform(value, spread) * kBins), 0, kBins - 1)];
  }
}

vec4 read(const float* numbers) { return vec4(numbers[0], numbers[1], numbers[2], numbers[3]); }

#if HN_GRADIENT == HN_GRADIENT_SINE
#define SUBJECT(...)
#define SINE_SUBJECT(...) USE(__VA_ARGS__)
#else
#define SUBJECT(...) USE(__VA_ARGS__)
#define SINE_SUBJECT(...)
#endif

#ifndef HN_SUBJECTS
#define HN_SUBJECTS "subjects.inc"
#endif

#define NOISE(function) [](auto where, std::uint32_t seed) { return function(where, seed); }

}  // namespace

extern "C" {

// How many values of a noise are in each of kBins parts of [-3/2, 3/2].
void values(int wanted, long points, long* bins) {
#define USE(number, name, axes, function) \
  if (wanted == number) count_values<axes>(number, NOISE(function), points, bins);
#include HN_SUBJECTS
#undef USE
}

// How many results of hn_uniform are in each of kBins parts of [0, 1], for a sum of a noise with this spread.
void uniforms(int wanted, float octaves, float gain, const float* spread, long points, long* bins) {
#define USE(number, name, axes, function) \
  if (wanted == number) count_uniform<axes>(number, NOISE(function), octaves, gain, read(spread), points, bins);
#include HN_SUBJECTS
#undef USE
}

}  // extern "C"
