// Samples noises for tools/measure uniform: at random cells, fractions and seeds, so that each value is independent.
//
//   sampler values POINTS     a histogram of the values of each noise, of one octave
//   sampler measure POINTS    for each line "number octaves gain reach a b c" of the input how far the results of
//                             hn_uniform are from uniform: the largest difference of the two distributions. The spread
//                             is that of the noise
//   sampler spreads           the spreads of hn_distribution
//   sampler sums              for each line as above the spread of the sum
//   sampler map               for each line "value reach a b c" the results of hn_uniform_d
//
// It writes lines that begin with a number of subjects.inc. With HN_GRADIENT_SINE it knows the noises of that.
// HN_SUBJECTS may name another such file.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <hashnoise/hashnoise.hpp>
#include <vector>

namespace {

using namespace hashnoise;

// Values are in [-3/2, 3/2].
constexpr int kBins = 1 << 16;
constexpr float kPerValue = kBins / 3.0f;
constexpr int kUniformBins = 1 << 16;

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
void write_values(int number, Noise noise, long points) {
  std::vector<long> bins(kBins);
  Random random{static_cast<std::uint64_t>(number)};
  for (long i = 0; i < points; ++i) {
    const auto where = place<Axes>(random);
    const float value = noise(where, random.word());
    ++bins[static_cast<std::size_t>(std::clamp(static_cast<int>((value + 1.5f) * kPerValue), 0, kBins - 1))];
  }
  std::printf("%d", number);
  for (const long count : bins) std::printf(" %ld", count);
  std::printf("\n");
}

struct Line {
  int number;
  float octaves, gain;
  vec4 spread;
};

template <int Axes, typename Noise>
void write_error(const Line& line, Noise noise, long points) {
  const bool single = line.octaves == 1.0f;
  const vec4 spread = single ? line.spread : hn_distribution_fbm(line.spread, line.octaves, line.gain);
  std::vector<long> bins(kUniformBins);
  Random random{static_cast<std::uint64_t>(line.number) << 32u};
  for (long i = 0; i < points; ++i) {
    float value = 0.0f;
    if (single) {
      const auto where = place<Axes>(random);
      value = noise(where, random.word());
    } else {
      value = sum<Axes>(random, noise, line.octaves, line.gain);
    }
    const float u = hn_uniform(value, spread);
    ++bins[static_cast<std::size_t>(std::clamp(static_cast<int>(u * kUniformBins), 0, kUniformBins - 1))];
  }
  double error = 0.0;
  long below = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    below += bins[i];
    const double edge = static_cast<double>(i + 1) / kUniformBins;
    error = std::max(error, std::fabs(static_cast<double>(below) / static_cast<double>(points) - edge));
  }
  std::printf("%d %.6f\n", line.number, error);
}

void write(int number, vec4 spread) {
  std::printf("%d %.9g %.9g %.9g %.9g\n", number, spread.x, spread.y, spread.z, spread.w);
}

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

int main(int count, char** arguments) {
  if (count < 2) return 2;
  const char* const mode = arguments[1];
  const long points = count > 2 ? std::atol(arguments[2]) : 0;
  if (std::strcmp(mode, "values") == 0) {
#define USE(number, name, axes, function) write_values<axes>(number, NOISE(function), points);
#include HN_SUBJECTS
#undef USE
    return 0;
  }
  if (std::strcmp(mode, "spreads") == 0) {
#define USE(number, name, axes, function) write(HN_DISTRIBUTION_##name, hn_distribution(HN_DISTRIBUTION_##name));
#include HN_SUBJECTS
#undef USE
    return 0;
  }
  if (std::strcmp(mode, "map") == 0) {
    float value = 0.0f;
    vec4 spread;
    while (std::scanf("%f %f %f %f %f", &value, &spread.x, &spread.y, &spread.z, &spread.w) == 5) {
      const vec2 u = hn_uniform_d(value, spread);
      if (u.x != hn_uniform(value, spread)) return 1;
      std::printf("0 %.9g %.9g\n", u.x, u.y);
    }
    return 0;
  }
  Line line{};
  while (std::scanf("%d %f %f %f %f %f %f", &line.number, &line.octaves, &line.gain, &line.spread.x, &line.spread.y,
                    &line.spread.z, &line.spread.w) == 7) {
    if (std::strcmp(mode, "sums") == 0) {
      write(line.number, hn_distribution_fbm(line.spread, line.octaves, line.gain));
      continue;
    }
    switch (line.number) {
#define USE(number, name, axes, function)             \
  case number:                                        \
    write_error<axes>(line, NOISE(function), points); \
    break;
#include HN_SUBJECTS
      default:
        return 2;
    }
    std::fflush(stdout);
  }
  return 0;
}
