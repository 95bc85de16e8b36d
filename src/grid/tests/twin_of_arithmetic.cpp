// The scalar functions with one HN_ARITHMETIC, by name.
//
// Every function of the library is forced inline, and a sum contains its noise. A sum over each noise would take
// minutes to compile. So the sums here are made, by the public macros, over one noise that calls whichever was chosen.
// It is a call, so nothing of a sum and its noise can be computed together, and the bits are those of a sum over the
// noise itself.
// SPDX-License-Identifier: MIT

#include "twin_of_arithmetic.hpp"

#include <algorithm>
#include <hashnoise/hashnoise.hpp>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace hashnoise {
namespace {

constexpr Arithmetic kArithmetic = static_cast<Arithmetic>(HN_ARITHMETIC);

// ---------------------------------------------------------------------------------------------------------------------
// The types of GLSL in so many dimensions.

template <int D>
struct Types;
template <>
struct Types<1> {
  using Floats = float;
  using Ints = int;
};
template <>
struct Types<2> {
  using Floats = vec2;
  using Ints = ivec2;
};
template <>
struct Types<3> {
  using Floats = vec3;
  using Ints = ivec3;
};
template <>
struct Types<4> {
  using Floats = vec4;
  using Ints = ivec4;
};
template <int D>
using Floats = typename Types<D>::Floats;
template <int D>
using Ints = typename Types<D>::Ints;

// The first D numbers of an array.
template <int D, typename Array>
auto glsl(const Array& a) {
  using T = typename Array::value_type;
  if constexpr (D == 1) return a[0];
  if constexpr (D == 2) return Vector2<T>{a[0], a[1]};
  if constexpr (D == 3) return Vector3<T>{a[0], a[1], a[2]};
  if constexpr (D == 4) return Vector4<T>{a[0], a[1], a[2], a[3]};
}

// The components of a function's result.
void store(float v, float* values) { *values = v; }
void store(vec2 v, float* values) { std::ranges::copy(std::array{v.x, v.y}, values); }
void store(vec3 v, float* values) { std::ranges::copy(std::array{v.x, v.y, v.z}, values); }
void store(vec4 v, float* values) { std::ranges::copy(std::array{v.x, v.y, v.z, v.w}, values); }
void store(const hn_derivatives4& v, float* values) {
  *values = v.value;
  store(v.gradient, values + 1);
}

template <typename T>
constexpr int kComponents = sizeof(T) / sizeof(float);

// ---------------------------------------------------------------------------------------------------------------------
// Noises.

#define CALL(name)                                                        \
  struct name {                                                           \
    static auto of(auto... arguments) { return hn_##name(arguments...); } \
  };
namespace call {
#define HN_CATALOG_NOISE(Id, name, ...) CALL(name)
#include "grid/catalog.inc"
CALL(cellular_phase)  // of the setting `phase` of cellular
}  // namespace call
#undef CALL

// The arguments of a noise between its place and its seed. With a phase cellular noise takes no metric.
enum class Options {
  kNothing,
  kPhase,
  kJitter,
  kJitterAndMetric,
  kJitterAndMetricAndPhase,
  kJitterAndPhase,
  kPhaseAndWave
};

template <int D>
using Place = decltype(hn_place(Ints<D>{}, Floats<D>{}));

template <int D, typename Call, Options O>
auto called([[maybe_unused]] const Settings& s, std::uint32_t seed, auto where) {
  if constexpr (O == Options::kNothing) {
    return Call::of(where, seed);
  } else if constexpr (O == Options::kPhase) {
    return Call::of(where, *s.phase, seed);
  } else if constexpr (O == Options::kJitter) {
    return Call::of(where, twin::jitter_of(s), seed);
  } else if constexpr (O == Options::kJitterAndPhase) {
    return Call::of(where, *s.phase, twin::jitter_of(s), seed);
  } else if constexpr (O == Options::kPhaseAndWave) {
    return Call::of(where, glsl<D>(twin::wave_of(s)), s.phase.value_or(0.0f), seed);
  } else {
    return Call::of(where, twin::jitter_of(s), twin::metric_of(s), seed);
  }
}

template <int D>
struct NoiseEntry {
  std::string_view name;
  bool has_phase;
  int components;
  void (*at)(const Settings&, Floats<D> p, std::uint32_t seed, float* values);
  void (*in)(const Settings&, Place<D> place, std::uint32_t seed, float* values);
};

template <int D, typename Call, Options O = Options::kNothing>
NoiseEntry<D> entry(std::string_view name) {
  NoiseEntry<D> e;
  e.name = name;
  e.has_phase = O == Options::kPhase || O == Options::kJitterAndPhase;
  e.components = kComponents<decltype(called<D, Call, O>(std::declval<Settings>(), 0u, Floats<D>{}))>;
  e.at = [](const Settings& s, Floats<D> p, std::uint32_t seed, float* values) {
    store(called<D, Call, O>(s, seed, p), values);
  };
  e.in = [](const Settings& s, Place<D> place, std::uint32_t seed, float* values) {
    store(called<D, Call, O>(s, seed, place), values);
  };
  return e;
}

// With a phase there are two forms, in 2D and 3D. A noise with a wave has one, and without a phase it is 0.
template <int D, typename Call, Options O>
void add(std::vector<NoiseEntry<D>>& all, std::string_view name) {
  if constexpr (O == Options::kPhase) {
    all.push_back(entry<D, Call>(name));
    if constexpr (D == 2 || D == 3) all.push_back(entry<D, Call, Options::kPhase>(name));
  } else if constexpr (O == Options::kJitterAndMetricAndPhase) {
    all.push_back(entry<D, Call, Options::kJitterAndMetric>(name));
    all.push_back(entry<D, call::cellular_phase, Options::kJitterAndPhase>(name));
  } else if constexpr (O == Options::kPhaseAndWave) {
    all.push_back(entry<D, Call, O>(name));
    all.push_back(all.back());
    all.back().has_phase = true;
  } else {
    all.push_back(entry<D, Call, O>(name));
  }
}

template <int D>
std::vector<NoiseEntry<D>> noise_entries() {
  std::vector<NoiseEntry<D>> all;
#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes) \
  if constexpr (first <= D && D <= last) add<D, call::name, Options::takes>(all, #name);
#include "grid/catalog.inc"
  return all;
}

template <int D>
const NoiseEntry<D>& noise_entry(std::string_view name, bool has_phase) {
  static const std::vector<NoiseEntry<D>> all = noise_entries<D>();
  const auto found =
      std::ranges::find_if(all, [&](const auto& e) { return e.name == name && e.has_phase == has_phase; });
  if (found == all.end()) throw std::logic_error("the twin has no noise " + std::string(name));
  return *found;
}

// ---------------------------------------------------------------------------------------------------------------------
// Sums. They add up `chosen`, with a value, or `chosen_d`, with derivatives, or `chosen_vector`, in 2D and 3D.

template <int D>
struct Choice {
  const NoiseEntry<D>* noise = nullptr;
  const Settings* settings = nullptr;
};
template <int D>
thread_local Choice<D> choice;

template <int D>
std::array<float, 5> of_choice(Place<D> place, std::uint32_t seed) {
  std::array<float, 5> values{};
  choice<D>.noise->in(*choice<D>.settings, place, seed, values.data());
  return values;
}

#define CHOSEN(D) \
  float chosen(Place<D> place, std::uint32_t seed) { return of_choice<D>(place, seed)[0]; }
#define CHOSEN_D(D) \
  Floats<D + 1> chosen_d(Place<D> place, std::uint32_t seed) { return glsl<D + 1>(of_choice<D>(place, seed)); }
#define CHOSEN_VECTOR(D) \
  Floats<D> chosen_vector(Place<D> place, std::uint32_t seed) { return glsl<D>(of_choice<D>(place, seed)); }
CHOSEN(1)
CHOSEN(2)
CHOSEN(3)
CHOSEN(4)
CHOSEN_D(2)
CHOSEN_D(3)
CHOSEN_VECTOR(2)
CHOSEN_VECTOR(3)

template <typename Octaves>
float n_of(const Octaves& o) {
  return chosen(o.place, o.seed);
}

// A sum, at a position or a place: its loop over the octaves o.
#define SUM(name, ...)                                                                                               \
  struct name##_call {                                                                                               \
    static auto of(const Settings& settings, auto where) {                                                           \
      auto o = hn_octaves(where, twin::octaves_of(settings), twin::lacunarity_of(settings), twin::gain_of(settings), \
                          settings.seed);                                                                            \
      __VA_ARGS__                                                                                                    \
    }                                                                                                                \
  };
// Sums of values by their steps in the catalog. Golden files verify these.
#define HN_CATALOG_STEP(Id, name, step, end)                                          \
  SUM(                                                                                \
      name, [[maybe_unused]] const float strength = twin::strength_of(settings); do { \
        const hn_i_octave_sum s = o.sum;                                              \
        const float n = n_of(o);                                                      \
        o.sum = step;                                                                 \
      } while (hn_next(o));                                                           \
      const hn_i_num mean = hn_i_mean(o.sum); return hn_i_value(end);)
#include "grid/catalog.inc"
SUM(fbm_d, auto d = hn_slopes(o); do hn_add(o, d, chosen_d(o.place, o.seed)); while (hn_next(o)); return hn_mean(o, d);)
SUM(eroded, auto d = hn_slopes(o); do hn_add_eroded(o, d, chosen_d(o.place, o.seed), twin::strength_of(settings));
    while (hn_next(o)); return hn_mean(o);)
SUM(warp, auto w = hn_shifts(o, twin::amplitude_of(settings)); do hn_add(o, w, chosen_vector(o.place, o.seed));
    while (hn_next(o)); return hn_mean(o, w);)
SUM(warp_progressive, auto w = hn_shifts(o, twin::amplitude_of(settings));
    do hn_add_progressive(o, w, chosen_vector(o.place, o.seed)); while (hn_next(o)); return hn_mean(o, w);)
#undef SUM
struct perlin_worley_call {
  static auto of(const Settings& s, auto where) {
    return hn_perlin_worley(where, twin::octaves_of(s), twin::lacunarity_of(s), twin::gain_of(s), s.seed);
  }
};

template <int D>
twin::Function<D> of_noise(const Settings& s) {
  const NoiseEntry<D>* noise = &noise_entry<D>(s.noise, s.phase.has_value());
  const Ints<D> period = glsl<D>(s.period);
  twin::Function<D> function;
  function.components = noise->components;
  if (twin::has_period(s, D)) {
    function.at = [=, &s](const std::array<float, D>& p, float* values) {
      noise->in(s, hn_tile(glsl<D>(p), period), s.seed, values);
    };
    function.in = [=, &s](const std::array<std::int32_t, D>& cell, const std::array<float, D>& f, float* values) {
      noise->in(s, hn_tile(hn_place(glsl<D>(cell), glsl<D>(f)), period), s.seed, values);
    };
  } else {
    function.at = [=, &s](const std::array<float, D>& p, float* values) { noise->at(s, glsl<D>(p), s.seed, values); };
    function.in = [=, &s](const std::array<std::int32_t, D>& cell, const std::array<float, D>& f, float* values) {
      noise->in(s, hn_place(glsl<D>(cell), glsl<D>(f)), s.seed, values);
    };
  }
  return function;
}

template <int D, typename Call>
twin::Function<D> of_sum(const Settings& s) {
  // A sum over noises of its own chooses none.
  const NoiseEntry<D>* noise = s.noise.empty() ? nullptr : &noise_entry<D>(s.noise, false);
  const Ints<D> period = glsl<D>(s.period);
  const bool tile = twin::has_period(s, D);
  twin::Function<D> function;
  function.components = kComponents<decltype(Call::of(s, Floats<D>{}))>;
  function.at = [=, &s](const std::array<float, D>& p, float* values) {
    choice<D> = {noise, &s};
    store(tile ? Call::of(s, hn_tile(glsl<D>(p), period)) : Call::of(s, glsl<D>(p)), values);
  };
  function.in = [=, &s](const std::array<std::int32_t, D>& cell, const std::array<float, D>& f, float* values) {
    choice<D> = {noise, &s};
    const Place<D> place = hn_place(glsl<D>(cell), glsl<D>(f));
    store(Call::of(s, tile ? hn_tile(place, period) : place), values);
  };
  return function;
}

template <int D>
twin::Function<D> of_limited(const Settings& s) {
  const NoiseEntry<D>* noise = &noise_entry<D>(s.noise, false);
  twin::Function<D> function;
  function.components = 1;
  function.at = [=, &s](const std::array<float, D>& p, float* values) {
    choice<D> = {noise, &s};
    const Floats<D> q = glsl<D>(p);
    const float lacunarity = twin::lacunarity_of(s);
    const float gain = twin::gain_of(s);
    auto o = s.detail ? hn_octaves(q, *s.detail, lacunarity, gain, s.seed)
                      : hn_octaves(q, *s.footprint, twin::octaves_of(s), lacunarity, gain, s.seed);
    do {
      if (s.detail) {
        hn_add_detail(o, n_of(o));
      } else {
        hn_add_footprint(o, n_of(o));
      }
    } while (hn_next(o));
    *values = hn_mean(o);
  };
  return function;
}

template <int D>
twin::Function<D> of_settings(const Settings& s) {
  if (s.fractal.empty()) return of_noise<D>(s);
  if (s.detail || s.footprint) return of_limited<D>(s);
#define SUM(name) \
  if (s.fractal == #name) return of_sum<D, name##_call>(s);
#define HN_CATALOG_STEP(Id, name, step, end) SUM(name)
#include "grid/catalog.inc"
  if constexpr (D == 2 || D == 3) {
    SUM(fbm_d)
    SUM(eroded)
    SUM(warp)
    SUM(warp_progressive)
  }
  if constexpr (D == 3) {
    SUM(perlin_worley)
  }
#undef SUM
  throw std::logic_error("the twin has no sum " + s.fractal);
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
