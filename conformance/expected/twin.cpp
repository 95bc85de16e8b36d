// Compiled once per configuration, with its macros and HN_TWIN, its index, defined: the bodies of all functions as C++.
// Used with HN_HASH_CUSTOM only; the same in configurations.cpp.
#define HN_HASH_FN(k) (((k) ^ ((k) >> 16u)) * 0x045D9F3Bu)
#include <hashnoise/hashnoise.hpp>

#include "expected/twin_table.hpp"
#include "library/shaders.hpp"

#define HN_TWIN_PASTE_TOKENS(a, b) a##b
#define HN_TWIN_PASTE(a, b) HN_TWIN_PASTE_TOKENS(a, b)
#define HN_TWIN_NAMESPACE HN_TWIN_PASTE(twin, HN_TWIN)

namespace hashnoise {
namespace HN_TWIN_NAMESPACE {
namespace {

float float_of(uint bits) { return uintBitsToFloat(bits); }
uint bits_of(float value) { return floatBitsToUint(value); }

#define SEEDED(s) , s
#define SEED(s) s

template <auto body>
void evaluate_all(const std::uint32_t* in, std::uint32_t* out, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i, in += hn::kInputWords, out += hn::kOutputWords) {
    const uvec4 result = body(uvec4(in[0], in[1], in[2], in[3]), uvec4(in[4], in[5], in[6], in[7]),
                              uvec4(in[8], in[9], in[10], in[11]), uvec4(in[12], in[13], in[14], in[15]));
    out[0] = result.x;
    out[1] = result.y;
    out[2] = result.z;
    out[3] = result.w;
  }
}

// Only functions with values in the configuration are compiled to code.
constexpr hn::TwinEntry kEntries[] = {
#define FUNCTION(id, family, configurations, columns, ...)                                                 \
  {id, (configurations >> HN_TWIN & 1u) != 0                                                               \
           ? evaluate_all<[]([[maybe_unused]] uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, \
                             [[maybe_unused]] uvec4 d) -> uvec4 { __VA_ARGS__ }>                           \
           : nullptr},
#include "library/bodies.inc"
};

}  // namespace
}  // namespace HN_TWIN_NAMESPACE
}  // namespace hashnoise

template <>
std::span<const hn::TwinEntry> hn::twin_entries<HN_TWIN>() {
  return hashnoise::HN_TWIN_NAMESPACE::kEntries;
}
