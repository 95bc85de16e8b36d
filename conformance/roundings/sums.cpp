// Compiled once for each gradient that the suite has sums of, with its macros and HN_ROUNDINGS, the function that it
// makes.
#include "roundings/sums.hpp"

#include <cfenv>
#include <cmath>
#include <hashnoise/glsl.hpp>
#include <unordered_map>

#define HN_I_OWN_FLOATS "roundings/floats.hpp"
#include <hashnoise/lanes.hpp>

namespace hashnoise {
namespace own {
namespace {

Float float_of(Uint bits) { return uintBitsToFloat(bits); }
Uint bits_of(const Float& value) { return floatBitsToUint(value); }

#define SEEDED(s) , s
#define SEED(s) s
// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
using Body = uvec4 (*)(uvec4, uvec4, uvec4, uvec4);
const std::unordered_map<std::string_view, Body> kBodies = {
#define FUNCTION(...)
#define SUM_FUNCTION(id, family, configurations, columns, ...)                                              \
  {id, [](uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, [[maybe_unused]] uvec4 d) -> uvec4 { \
     __VA_ARGS__                                                                                            \
   }},
#include "library/bodies.inc"
};
#undef float
#undef int

const std::array<std::uint32_t, hn::roundings::kWays + hn::roundings::kLanes> kRandomWays = [] {
  std::array<std::uint32_t, hn::roundings::kWays + hn::roundings::kLanes> ways{};
  std::uint64_t state = 1;
  for (std::uint32_t& way : ways) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    way = static_cast<std::uint32_t>((state >> 63u) << 31u | (state >> 62u & 1u));  // the highest bits are the best
  }
  return ways;
}();

class RoundingDown {
 public:
  RoundingDown() : before_(std::fegetround()) { std::fesetround(FE_DOWNWARD); }
  ~RoundingDown() { std::fesetround(before_); }
  RoundingDown(const RoundingDown&) = delete;
  RoundingDown& operator=(const RoundingDown&) = delete;

 private:
  int before_;
};

}  // namespace
}  // namespace own
}  // namespace hashnoise

hn::roundings::Results hn::roundings::HN_ROUNDINGS(std::string_view id, const Words& words, std::uint32_t seed) {
  using namespace hashnoise::lanes;
  const RoundingDown rounding;
  ways = {.words = kRandomWays.data(), .by_value = true, .seed = seed};
  const auto four = [&](std::size_t i) {
    return uvec4(Uint::load(words[i].data()), Uint::load(words[i + 1].data()), Uint::load(words[i + 2].data()),
                 Uint::load(words[i + 3].data()));
  };
  const uvec4 found = kBodies.at(id)(four(0), four(4), four(8), four(12));
  Results results;
  found.x.store(results[0].data());
  found.y.store(results[1].data());
  found.z.store(results[2].data());
  found.w.store(results[3].data());
  return results;
}
