// The scalar functions with one HN_ARITHMETIC, by name.
//
// Every function of the library is forced inline, and a sum contains its noise. A sum over each noise would take
// minutes to compile. So the sums here are made, by the public macros, over one noise that calls whichever was chosen.
// It is a call, so nothing of a sum and its noise can be computed together, and the bits are those of a sum over the
// noise itself.
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <array>
#include <hashnoise/hashnoise.hpp>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "twin.hpp"

namespace hashnoise {
namespace {

constexpr Arithmetic kArithmetic = static_cast<Arithmetic>(HN_ARITHMETIC);

// The types of GLSL in so many dimensions, and the first D numbers of an array as one.
template <int D>
using Floats = std::tuple_element_t<D - 1, std::tuple<float, vec2, vec3, vec4>>;
template <int D>
using Ints = std::tuple_element_t<D - 1, std::tuple<int, ivec2, ivec3, ivec4>>;
template <int D>
using Place = decltype(hn_place(Ints<D>{}, Floats<D>{}));
template <int D, typename Array>
auto glsl(const Array& a) {
  using T = typename Array::value_type;
  if constexpr (D == 1) return a[0];
  if constexpr (D == 2) return Vector2<T>{a[0], a[1]};
  if constexpr (D == 3) return Vector3<T>{a[0], a[1], a[2]};
  if constexpr (D == 4) return Vector4<T>{a[0], a[1], a[2], a[3]};
}

// Writes the components of a result, and returns how many there are.
template <typename Result>
int put(const Result& result, float* values) {
  constexpr int kComponents = sizeof(Result) / sizeof(float);
  const auto numbers = __builtin_bit_cast(std::array<float, kComponents>, result);
  std::ranges::copy(numbers, values);
  return kComponents;
}

// The noise of the settings at a position or a place, by its inputs. With a phase cellular noise takes no metric, and a
// noise with a wave always has a phase.
#define WITH(name, ...) return put(hn_##name(where, __VA_ARGS__), values);
#define WITH_kNothing(name) WITH(name, seed)
#define WITH_kJitter(name) WITH(name, twin::jitter_of(s), seed)
#define WITH_kJitterAndMetric(name) WITH(name, twin::jitter_of(s), twin::metric_of(s), seed)
#define WITH_kPhase(name)                   \
  if constexpr (D == 2 || D == 3) {         \
    if (s.phase) WITH(name, *s.phase, seed) \
  }                                         \
  WITH(name, seed)
#define WITH_kJitterAndMetricAndPhase(name)                           \
  if (s.phase) WITH(name##_phase, *s.phase, twin::jitter_of(s), seed) \
  WITH_kJitterAndMetric(name)
#define WITH_kBandwidthAndPhaseAndWave(name) WITH(name, glsl<D>(twin::wave_of(s)), s.phase.value_or(0.0f), seed)
template <int D, typename Where>
int put_noise(const Settings& s, grid::NoiseId noise, Where where, std::uint32_t seed, float* values) {
#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes) \
  if constexpr (first <= D && D <= last) {                    \
    if (noise == grid::k##Id) {                               \
      WITH_##takes(name)                                      \
    }                                                         \
  }
#include "grid/catalog.inc"
  throw std::logic_error("the twin has no noise " + s.noise);
}

// Sums, whose loops call that noise for each octave.
template <int D, typename Where>
int put_sum(const Settings& settings, grid::NoiseId noise, Where where, float* values) {
  const int octaves = twin::octaves_of(settings);
  const float lacunarity = twin::lacunarity_of(settings), gain = twin::gain_of(settings);
  [[maybe_unused]] const float strength = twin::strength_of(settings);
  if constexpr (D == 3) {
    if (settings.fractal == "perlin_worley") {
      return put(hn_perlin_worley(where, octaves, lacunarity, gain, settings.seed), values);
    }
  }
  if constexpr (D == 2 || D == 3) {
    if (settings.fractal == "curl_fbm" && settings.phase) {
      return put(hn_curl_fbm(where, *settings.phase, octaves, lacunarity, gain, settings.seed), values);
    }
    if (settings.fractal == "curl_fbm") {
      return put(hn_curl_fbm(where, octaves, lacunarity, gain, settings.seed), values);
    }
  }
  auto o = hn_octaves(where, octaves, lacunarity, gain, settings.seed);
  if constexpr (std::is_same_v<Where, Floats<D>>) {
    if (settings.detail) o = hn_octaves(where, *settings.detail, lacunarity, gain, settings.seed);
    if (settings.footprint) o = hn_octaves(where, *settings.footprint, octaves, lacunarity, gain, settings.seed);
  }
  std::array<float, grid::kMostComponents> n{};
  const auto call_noise = [&] { put_noise<D>(settings, noise, o.place, o.seed, n.data()); };
#define LOOP(...) \
  do {            \
    call_noise(); \
    __VA_ARGS__;  \
  } while (hn_next(o))
  if (settings.detail || settings.footprint) {
    LOOP(settings.detail ? hn_add_detail(o, n[0]) : hn_add_footprint(o, n[0]));
    return put(hn_mean(o), values);
  }
  // Sums of values by their steps in the catalog. Golden files verify these.
#define HN_CATALOG_STEP(Id, name, step, end)                                     \
  if (settings.fractal == #name) {                                               \
    LOOP([&, n = n[0]] { step; }());                                             \
    return put(hn_i_value([mean = hn_i_mean(o.sum)] { return end; }()), values); \
  }
#include "grid/catalog.inc"
  if constexpr (D == 2 || D == 3) {
    if (settings.fractal == "fbm_d" || settings.fractal == "eroded") {
      auto slopes = hn_slopes(o);
      if (settings.fractal == "fbm_d") {
        LOOP(hn_add(o, slopes, glsl<D + 1>(n)));
        return put(hn_mean(o, slopes), values);
      }
      LOOP(hn_add_eroded(o, slopes, glsl<D + 1>(n), strength));
      return put(hn_mean(o), values);
    }
    auto shifts = hn_shifts(o, twin::amplitude_of(settings));
    if (settings.fractal == "warp") {
      LOOP(hn_add(o, shifts, glsl<D>(n)));
    } else {
      LOOP(hn_add_progressive(o, shifts, glsl<D>(n)));
    }
    return put(hn_mean(o, shifts), values);
  }
  throw std::logic_error("the twin has no sum " + settings.fractal);
}

template <int D>
twin::Function<D> of_settings(const Settings& s) {
  // A sum over noises of its own chooses none.
  const grid::NoiseId noise = s.noise.empty() ? grid::kNoises : grid::noise_named(s.noise);
  const bool is_noise = s.fractal.empty();
  const auto write = [=, &s](const auto& where, float* values) {
    return is_noise ? put_noise<D>(s, noise, where, s.seed, values) : put_sum<D>(s, noise, where, values);
  };
  const bool tiled = twin::has_period(s, D);
  const Ints<D> period = glsl<D>(s.period);
  std::array<float, grid::kMostComponents> values;
  return {write(Floats<D>{}, values.data()),
          [=](const std::array<float, D>& p, float* to) {
            const Floats<D> position = glsl<D>(p);
            tiled ? write(hn_tile(position, period), to) : write(position, to);
          },
          [=](const std::array<std::int32_t, D>& cell, const std::array<float, D>& f, float* to) {
            const Place<D> place = hn_place(glsl<D>(cell), glsl<D>(f));
            write(tiled ? hn_tile(place, period) : place, to);
          }};
}

}  // namespace

namespace twin {

#define HN_TWIN(D)                                                    \
  template <>                                                         \
  Function<D> function_of<D, kArithmetic>(const Settings& settings) { \
    return of_settings<D>(settings);                                  \
  }
HN_TWIN(1)
HN_TWIN(2)
HN_TWIN(3)
HN_TWIN(4)

}  // namespace twin
}  // namespace hashnoise
