// Prints digests of what the C++ twin computes at a few points and at many, a line per function of functions.inc that
// depends on the arithmetic, or on compilers' ways with floats; with the argument "few" only the first of the two.
// twin_flags_test.py compiles it with many flags, of which some let a compiler make of floats what it likes: so nothing
// here but the twin computes in them.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
#include <string_view>

namespace {

using namespace hashnoise;

constexpr int kFew = 1 << 12;  // points of each function; what is not optimised takes 30 times as long
constexpr int kMany = 1 << 15;

bool few_only = false;
std::uint64_t functions = 1;  // before this one; each has points of its own

// SplitMix64
std::uint64_t state = 1;
uint word() {
  state += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return static_cast<uint>((z ^ (z >> 31)) >> 32);
}

// Of either sign, with a biased exponent from low to high: 0 is subnormal, 254 huge.
float number(uint low, uint high) {
  const uint exponent = low + word() % (high - low + 1);
  return std::bit_cast<float>((exponent << 23) | (word() & 0x807FFFFFu));
}

float coordinate() {
  switch (word() % 6) {
    case 0:
      return number(0, 254);
    case 1:
      return number(0, 0);
    case 2:
      return number(90, 126);  // from 2^-37 to 1
    case 3:
      return std::bit_cast<float>(word() & 0x80000000u);  // 0 and -0
    default:
      return number(127, 152);  // from 1 to 2^26
  }
}

// In [0, 1], or anywhere.
float fraction() { return word() % 4 == 0 ? coordinate() : std::bit_cast<float>(word() % 0x3F800001u); }

// The settings of an octave sum: what people use, and anything.
float setting(std::string_view name) {
  if (name == "detail") return static_cast<float>(word() % 17) * 0.5f - 1.0f;
  if (name == "strength" || name == "amplitude" || name == "footprint")
    return word() % 4 == 0 ? coordinate() : number(117, 129);
  if (word() % 2 == 0) return name == "gain" ? 0.5f : 2.0f;
  return name == "gain" ? number(110, 128) : number(120, 135);
}

// An input word of a column, "x:f32" say.
uint input(std::string_view column) {
  const auto colon = column.find(':');
  const std::string_view name = column.substr(0, colon);
  if (name == "metric") return word() % 7;
  if (column.substr(colon) != ":f32") return name == "octaves" ? word() % 8 - 1u : word();
  for (const std::string_view known : {"gain", "lacunarity", "detail", "strength", "amplitude", "footprint"}) {
    if (name == known) return std::bit_cast<uint>(setting(name));
  }
  return std::bit_cast<uint>(name.front() == 'f' || name == "jitter" ? fraction() : coordinate());
}

float float_of(uint bits) { return std::bit_cast<float>(bits); }
uint bits_of(float value) { return std::bit_cast<uint>(value); }

template <typename Evaluate>
void digest(std::string_view id, std::string_view family, std::string_view columns, Evaluate evaluate) {
  // What is exact has no arithmetic, and of the two kinds of gradients the one that is selected is evaluated.
  if (family == "independent" || family == "hash" || family == "sine_gradient") return;
  const std::string_view inputs = columns.substr(0, columns.find(" = "));
  state = functions++ << 32;
  std::uint64_t hash = 14695981039346656037u;
  std::printf("%.*s", static_cast<int>(id.size()), id.data());
  for (int i = 0; i < (few_only ? kFew : kMany); ++i) {
    if (i == kFew) std::printf(" %016llx", static_cast<unsigned long long>(hash));
    uint words[16] = {};
    std::size_t count = 0;
    for (std::string_view rest = inputs; !rest.empty(); ++count) {
      const auto end = rest.find(' ') < rest.size() ? rest.find(' ') : rest.size();
      words[count] = input(rest.substr(0, end));
      rest.remove_prefix(end < rest.size() ? end + 1 : end);
    }
    const uvec4 value =
        evaluate(uvec4(words[0], words[1], words[2], words[3]), uvec4(words[4], words[5], words[6], words[7]),
                 uvec4(words[8], words[9], words[10], words[11]), uvec4(words[12], words[13], words[14], words[15]));
    for (const uint bits : {value.x, value.y, value.z, value.w}) hash = (hash ^ bits) * 1099511628211u;
  }
  std::printf(" %016llx\n", static_cast<unsigned long long>(hash));
}

constexpr bool is_tried(std::string_view id) {
#ifdef HN_TEST_EACH_KIND  // each noise, and sums of the two kinds, on the plane alone; what is not inlined in one is in all
  if (id.starts_with("fbm.")) return id == "fbm.clouds3" || id == "fbm.ping_pong2";
  if (id.find("_phase") != id.npos) return id == "noise2d.simplex_phase";
  if (id.starts_with("noise") && !id.starts_with("noise2d.")) return id == "noise3d.perlin_cell";
  return id == "gradient.lattice2" || (id.find("2") != id.npos && id.find("_cell") == id.npos && id.find("_period") == id.npos);
#endif
  if (id.starts_with("noise2d.") || id == "noise3d.perlin_cell" || id == "fbm.fbm2_cell") return true;
  if (id == "warp.warp_progressive2_cell") return true;
  return id.find("_cell") == id.npos && id.find("_period") == id.npos;
}

}  // namespace

#define SEEDED(s) , s
#define SEED(s) s

int main(int argc, char**) {
  few_only = argc > 1;
#ifdef HN_TEST_OVERFLOW
  std::printf("%d\n", static_cast<int>(word() >> 1) * static_cast<int>(word() >> 1));
#else
// Compilers take long to inline them all, so forms of the same text are tried once, on the plane.
#define TRIED(id, family, columns, ...)                                                     \
  if constexpr (is_tried(id)) {                                                             \
    digest(id, family, columns,                                                             \
           []([[maybe_unused]] uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, \
              [[maybe_unused]] uvec4 d) -> uvec4 { __VA_ARGS__ });                          \
  }
// Some families are not declared with the sine gradient.
#if HN_GRADIENT == HN_GRADIENT_SINE
#define OF_octahedral_noise(...)
#define OF_octahedral_octave_sum(...)
#else
#define OF_octahedral_noise TRIED
#define OF_octahedral_octave_sum TRIED
#endif
#define OF_independent TRIED
#define OF_hash TRIED
#define OF_gradient TRIED
#define OF_sine_gradient TRIED
#define OF_gradient_noise TRIED
#define OF_lattice_noise TRIED
#define OF_octave_sum TRIED
#define OF_further_gradient_noise TRIED
#define OF_further_lattice_noise TRIED
#define OF_further_octave_sum TRIED
#define OF_simplex_noise TRIED
#define OF_curl TRIED
#define OF_cellular TRIED
#define OF_further_cellular TRIED
#define OF_utility TRIED
#define OF_distribution TRIED
#define FUNCTION(id, file, family, bound, columns, call, ...) OF_##family(id, #family, columns, __VA_ARGS__)
#include "library/functions.inc"
#endif
}
