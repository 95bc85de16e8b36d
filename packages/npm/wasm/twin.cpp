// The twin in WebAssembly: noises and sums with HN_FIXED, four points at a time. index.js writes settings and points
// into `settings` and `batch`, and calls `run`.
//
// It is small, since every page loads it: functions are called and not inlined, a noise has one form (in a tile, whose
// period may be none), and the sums of a dimension are one loop. tools/lib/ship/npm/twin.py has the flags.
#define HN_ARITHMETIC HN_FIXED
#define HN_I_CALLED

#include <hashnoise/glsl.hpp>
#undef HN_I_INLINE
#define HN_I_INLINE inline
#include <hashnoise/lanes.hpp>
#include <type_traits>

namespace hashnoise {
namespace HN_LANES {
namespace {

constexpr int kBatch = 1024;  // points at most
constexpr int kComponents = 4;

// As index.js writes them.
struct Settings {
  std::int32_t dimensions;
  std::int32_t noise;  // the number of a row below
  std::int32_t sum;    // -1 for none
  std::int32_t tiled;
  std::uint32_t seed;
  std::int32_t period[3];
  float jitter;
  std::int32_t metric;
  std::int32_t octaves;
  float lacunarity;
  float gain;
  float strength;  // or amplitude
};
struct Batch {
  std::int32_t cell[3][kBatch];
  float place[3][kBatch];  // in the cell, or the position
  float value[kComponents][kBatch];
};
Settings settings;
Batch batch;

// ---------------------------------------------------------------------------------------------------------------------
// Noises. Numbers are passed one by one, so that they stay in registers.

using Numbers = Float[kComponents];
template <int D>
using Kernel = void (*)(CellOf<D> cell, CellOf<D> fraction, CellOf<D> period, Uint seed, Numbers& n);
template <int D>
using Place = decltype(hn_place(CellOf<D>(), PlaceOf<D>()));

HN_I_INLINE void put(Numbers& n, Float v) { n[0] = v; }
HN_I_INLINE void put(Numbers& n, vec2 v) {
  n[0] = v.x;
  n[1] = v.y;
}
HN_I_INLINE void put(Numbers& n, vec3 v) {
  n[0] = v.x;
  n[1] = v.y;
  n[2] = v.z;
}
HN_I_INLINE void put(Numbers& n, vec4 v) {
  n[0] = v.x;
  n[1] = v.y;
  n[2] = v.z;
  n[3] = v.w;
}

// Nothing for a noise that these dimensions do not have.
template <int D, typename Noise>
constexpr Kernel<D> kernel(Noise noise) {
  if constexpr (std::is_convertible_v<Noise, Kernel<D>>) return noise;
  return nullptr;
}
#define TWIN_CALL(name, ...) \
  put(n, hn_##name(hn_tile(hn_i_place(cell, fraction, decltype(cell)()), period), __VA_ARGS__))
#define TWIN_NOISE(name, ...)                                    \
  kernel<D>([](auto cell, auto fraction, auto period, Uint seed, \
               Numbers& n) -> decltype(TWIN_CALL(name, __VA_ARGS__)) { TWIN_CALL(name, __VA_ARGS__); })

// By their numbers in index.js: kNoises<D> has the kernels of noises, and Sum the names of sums. twin.py makes it.
#include "tables.inc"

// ---------------------------------------------------------------------------------------------------------------------
// Sums, in one loop. A noise without a period is one whose period is 0, so only the way to the next octave differs in a
// tile.

// Once for all dimensions: what adds to octaves would be there for each.
[[gnu::noinline]] hn_i_octave_sum with_value(hn_i_octave_sum sum, Float n) {
  const float& strength = settings.strength;
  hn_octaves1 o{};
  o.sum = sum;
  switch (static_cast<Sum>(settings.sum)) {
#define HN_CATALOG_STEP(Id, name, step, ...) \
  case k##Id:                                \
    step;                                    \
    break;
#include "../../../src/grid/catalog.inc"
    case kFbmD:
    case kEroded:
    case kWarp:
    case kWarpProgressive:
      break;
  }
  return o.sum;
}

Int finished(Int mean) {
  switch (static_cast<Sum>(settings.sum)) {
#define HN_CATALOG_STEP(Id, name, step, end) \
  case k##Id:                                \
    return end;
#include "../../../src/grid/catalog.inc"
    case kFbmD:
    case kEroded:
    case kWarp:
    case kWarpProgressive:
      return mean;
  }
}

bool is_warp() { return settings.sum == kWarp || settings.sum == kWarpProgressive; }

HN_I_INLINE vec3 slopes_of(hn_octaves2, const Numbers& n) { return vec3(n[0], n[1], n[2]); }
HN_I_INLINE vec4 slopes_of(hn_octaves3, const Numbers& n) { return vec4(n[0], n[1], n[2], n[3]); }
HN_I_INLINE vec2 shift_of(hn_octaves2, const Numbers& n) { return vec2(n[0], n[1]); }
HN_I_INLINE vec3 shift_of(hn_octaves3, const Numbers& n) { return vec3(n[0], n[1], n[2]); }

template <int D>
void noise(const Place<D>& place, Uint seed, Numbers& n) {
  kNoises<D>[settings.noise](place.cell, place.fraction, place.period, seed, n);
}

template <int D>
Float octave(const Place<D>& place, Uint seed, Numbers& n) {
  noise<D>(place, seed, n);
  return n[0];
}

template <int D>
void sum(const Place<D>& place, Numbers& n) {
  auto o =
      hn_octaves(place, Int(settings.octaves), Float(settings.lacunarity), Float(settings.gain), Uint(settings.seed));
  if constexpr (D == 1) {
    do o.sum = with_value(o.sum, octave<D>(o.place, o.seed, n));
    while (hn_next(o));
  } else {
    auto slopes = hn_slopes(o);
    auto shifts = hn_shifts(o, settings.strength);
    do {
      const Float value = octave<D>(o.place, o.seed, n);
      if (settings.sum == kWarpProgressive) {
        hn_add_progressive(o, shifts, shift_of(o, n));
      } else if (settings.sum == kWarp) {
        hn_add(o, shifts, shift_of(o, n));
      } else if (settings.sum == kFbmD) {
        hn_add(o, slopes, slopes_of(o, n));
      } else if (settings.sum == kEroded) {
        hn_add_eroded(o, slopes, slopes_of(o, n), settings.strength);
      } else {
        o.sum = with_value(o.sum, value);
      }
    } while (hn_next(o));
    if (is_warp()) return put(n, hn_mean(o, shifts));
    if (settings.sum == kFbmD) return put(n, hn_mean(o, slopes));
  }
  put(n, hn_i_value(finished(hn_i_mean(o.sum))));
}

// ---------------------------------------------------------------------------------------------------------------------

template <int D>
void run_points(int count) {
  const CellOf<D> period = vector_of<CellOf<D>, D>([&](int axis) { return Int(settings.period[axis]); });
  for (int i = 0; i < count; i += kCount) {
    const CellOf<D> cell = vector_of<CellOf<D>, D>([&](int axis) { return Int::load(batch.cell[axis] + i); });
    const PlaceOf<D> f = vector_of<PlaceOf<D>, D>([&](int axis) { return Float::load(batch.place[axis] + i); });
    Place<D> place = hn_place(cell, f);
    place.period = period;
    place.tiled = settings.tiled != 0;
    Numbers n;
    if (settings.sum < 0) {
      noise<D>(place, settings.seed, n);
    } else {
      sum<D>(place, n);
    }
    for (int k = 0; k < kComponents; ++k) n[k].store(batch.value[k] + i);
  }
}

}  // namespace
}  // namespace HN_LANES

// ---------------------------------------------------------------------------------------------------------------------
// Functions that index.js calls.

#define TWIN_EXPORT(name) extern "C" __attribute__((export_name(#name)))
using namespace HN_LANES;

TWIN_EXPORT(settings) void* settings_at() { return &settings; }
TWIN_EXPORT(batch) void* batch_at() { return &batch; }

// Cells, and places in them, of positions along an axis. A sum keeps 24 bits of a place, and a noise 20.
TWIN_EXPORT(split) void split(int axis, int count) {
  for (int i = 0; i < count; i += kCount) {
    const hn_place1 place = hn_place(Float::load(batch.place[axis] + i));
    const auto whole = hn_i_fixed_position(place.cell, place.fraction, settings.sum < 0 ? Int(0) : place.rest);
    whole.x.store(batch.cell[axis] + i);
    (Float(whole.y) * (1.0f / 16777216.0f)).store(batch.place[axis] + i);
  }
}

TWIN_EXPORT(run) void run(int count) {
  switch (settings.dimensions) {
    case 1:
      return run_points<1>(count);
    case 2:
      return run_points<2>(count);
    default:
      return run_points<3>(count);
  }
}

// The first component at a position; all of them are the first values of the batch.
TWIN_EXPORT(at) float at(float x, float y, float z) {
  const float position[] = {x, y, z};
  for (int axis = 0; axis < settings.dimensions; ++axis) {
    batch.place[axis][0] = position[axis];
    split(axis, 1);
  }
  run(1);
  return batch.value[0][0];
}

}  // namespace hashnoise
