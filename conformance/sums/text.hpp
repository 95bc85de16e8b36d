// The text of sums over numbers that count how far they are off. Its noises are summaries: any number of their range,
// that is off by an error of its own, and by as much as the noise changes where its place is off.
#pragma once

// Before the first header of C++, as the library's own text: functions of the text need not be inlined.
#define HN_I_CALLED
#include <hashnoise/glsl.hpp>

#include "config.glsl"
#include "sums/numbers.hpp"
#include "sums/sums.hpp"

namespace hn::sums {

#include "names.hpp"

// Functions of the text are templates: those that nothing calls are not compiled, and a function of ours is called in
// place of one with the same name and parameters.
#undef HN_FN
#define HN_FN         \
  template <auto = 0> \
  static

// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
#include "place.glsl"
#undef float
#undef int
#include "sums/summaries.hpp"
#ifdef SUMS_OWN  // of other noises
#include "summaries.inc"
#endif
#define float Float
#define int Int
#include "curl_fbm.glsl"
#include "fbm.glsl"
#include "fbm_d.glsl"
#include "gullies.glsl"
#include "perlin_worley.glsl"
#include "warp.glsl"
#undef float
#undef int
#include "sums/lemmas.hpp"

#ifdef SUMS_OWN  // sums in somebody else's text
#include "own.inc"
#endif

}  // namespace hn::sums
