// The text over lanes that round otherwise, with their ways by number (conformance/roundings). Where they decide
// otherwise, each goes its own way (leader.hpp).
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <hashnoise/glsl.hpp>
#include <utility>

#include "leader.hpp"
#include "roundings/ways.hpp"
#define HN_I_OWN_FLOATS "roundings/floats.hpp"
#include <hashnoise/lanes.hpp>

#include "search.hpp"

namespace hashnoise {
namespace own {

#ifdef ERRORS_OWN
#include "own_lanes.hpp"
#endif
// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
#ifdef ERRORS_OWN
#include "own.hpp"
#endif

namespace {

Float float_of(Uint bits) { return uintBitsToFloat(bits); }
Uint bits_of(const Float& value) { return floatBitsToUint(value); }

#define SEEDED(s) , s
#define SEED(s) s
#define FUNCTION(...) \
  [](uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, [[maybe_unused]] uvec4 d) -> uvec4 { __VA_ARGS__ },
using Body = uvec4 (*)(uvec4, uvec4, uvec4, uvec4);
const Body kBodies[] = {
#include "rounded.inc"
};
#undef float
#undef int

}  // namespace
}  // namespace own
}  // namespace hashnoise

std::uint32_t run_lanes(int function, const std::uint32_t* way_words, const Words& words, Results& results) {
  using namespace hashnoise::lanes;
  using hn::roundings::leader;
  const auto four = [&](std::size_t i) {
    return uvec4(Uint::load(words[i].data()), Uint::load(words[i + 1].data()), Uint::load(words[i + 2].data()),
                 Uint::load(words[i + 3].data()));
  };
  std::uint32_t operations = 0;
  leader.restart();
  while (leader.begin()) {
    hn::roundings::ways = {.words = way_words, .end = kOperations};
    std::fesetround(FE_DOWNWARD);
    const uvec4 found = kBodies[function](four(0), four(4), four(8), four(12));
    std::fesetround(FE_TONEAREST);
    operations = std::max(operations, hn::roundings::ways.operation);
    const std::uint32_t stayed = leader.end();
    for (std::uint32_t lane = 0; lane < hn::roundings::kLanes; ++lane) {
      if ((stayed >> lane & 1u) == 0) continue;
      const int i = static_cast<int>(lane);
      results[0][lane] = found.x[i], results[1][lane] = found.y[i];
      results[2][lane] = found.z[i], results[3][lane] = found.w[i];
    }
  }
  return operations;
}
