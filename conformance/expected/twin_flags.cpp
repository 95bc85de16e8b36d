// Prints digests of the C++ twin's results at a few points and at many, a line per function that depends on the
// arithmetic, or on compilers' ways with floats; with the argument "few" only the first of the two. twin_flags_test.py
// compiles this with many flags; some let a compiler change the values of floats, so only the twin computes in floats
// here.
//
// With HN_TEST_EVERY_FORM all functions are tried, and with HN_TEST_KERNELS the kernels of kernels.cu in their place.
// With HN_TEST_KNOWN_INTEGERS all integer inputs are constants, the cell and the seed among them, and with
// HN_TEST_KNOWN_FLOATS all floats are: compilers evaluate constants themselves.
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
#include <string_view>

namespace {

using namespace hashnoise;

constexpr int kFew = 1 << 12;  // points of each function; without optimization it takes 30 times as long
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

// A number of either sign, with a biased exponent from low to high: 0 is subnormal, 254 huge.
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

// In [0, 1], or anywhere below 2^64: from about 2^100 on the waves of phasor noise in floats are infinite, and their
// angle is a NaN, which fits no integer.
float fraction() { return word() % 4 == 0 ? number(0, 190) : std::bit_cast<float>(word() % 0x3F800001u); }

// The settings of an octave sum: what people use, and anything.
float setting(std::string_view name) {
  if (name == "detail") return static_cast<float>(word() % 17) * 0.5f - 1.0f;
  if (name == "strength" || name == "amplitude" || name == "footprint")
    return word() % 4 == 0 ? coordinate() : number(117, 129);
  if (word() % 2 == 0) return name == "gain" ? 0.5f : 2.0f;
  return name == "gain" ? number(110, 128) : number(120, 135);
}

constexpr uint kMetrics = 0
#define METRIC(name, number) +1
#include "library/metrics.inc"
    ;

struct Column {
  std::string_view name;
  char kind;  // of f32, i32 or u32
};

// An input word of a column.
uint input(Column column) {
  const std::string_view name = column.name;
  if (name == "metric") return word() % (kMetrics + 2);
  if (column.kind != 'f') return name == "octaves" ? word() % 8 - 1u : word();
  for (const std::string_view known : {"gain", "lacunarity", "detail", "strength", "amplitude", "footprint"}) {
    if (name == known) return std::bit_cast<uint>(setting(name));
  }
  return std::bit_cast<uint>(name.front() == 'f' || name == "jitter" ? fraction() : coordinate());
}

float float_of(uint bits) { return std::bit_cast<float>(bits); }
uint bits_of(float value) { return std::bit_cast<uint>(value); }

// The kind of the columns whose words are constants: nothing if none is.
#if defined(HN_TEST_KNOWN_INTEGERS)
constexpr std::string_view kKnown = "iu";
#elif defined(HN_TEST_KNOWN_FLOATS)
constexpr std::string_view kKnown = "f";
#else
constexpr std::string_view kKnown;
#endif

// The constant of a column of that kind: small integers, and fractions whose last bits are set.
constexpr uint known(std::size_t column) {
  return kKnown == "f" ? 0x3E4CCCCDu + static_cast<uint>(column) * 0x0012A4C7u : 5u + static_cast<uint>(column) * 7u;
}

// Whether the word of a column is such a constant.
template <typename Row>
constexpr bool is_known(std::size_t column) {
  return column < Row::inputs().size() && kKnown.find(Row::inputs()[column].kind) != kKnown.npos;
}

// Row::inputs() are the columns that go in.
template <typename Row, std::size_t kColumn>
uint word_of(const uint* words) {
  if constexpr (is_known<Row>(kColumn)) return known(kColumn);
  return words[kColumn];
}
template <typename Row, std::size_t kColumn>
uvec4 words_from(const uint* words) {
  return uvec4(word_of<Row, kColumn>(words), word_of<Row, kColumn + 1>(words), word_of<Row, kColumn + 2>(words),
               word_of<Row, kColumn + 3>(words));
}

#ifdef HN_TEST_EVERY_FORM
constexpr bool kEveryForm = true;
#else
constexpr bool kEveryForm = false;
#endif

template <typename Row, typename Evaluate>
void digest(std::string_view id, std::string_view family, Evaluate evaluate) {
  // Exact functions have no arithmetic, and of the two kinds of gradients only the selected one is evaluated.
  if (!kEveryForm && (family == "independent" || family == "hash" || family == "sine_gradient")) return;
  state = functions++ << 32;
  std::uint64_t hash = 14695981039346656037u;
  std::printf("%.*s", static_cast<int>(id.size()), id.data());
  for (int i = 0; i < (few_only ? kFew : kMany); ++i) {
    if (i == kFew) std::printf(" %016llx", static_cast<unsigned long long>(hash));
    uint words[16] = {};
    std::size_t count = 0;
    for (const Column column : Row::inputs()) words[count++] = input(column);
    const uvec4 value = evaluate(words_from<Row, 0>(words), words_from<Row, 4>(words), words_from<Row, 8>(words),
                                 words_from<Row, 12>(words));
    for (const uint bits : {value.x, value.y, value.z, value.w}) hash = (hash ^ bits) * 1099511628211u;
  }
  std::printf(" %016llx\n", static_cast<unsigned long long>(hash));
}

constexpr bool is_tried(std::string_view id) {
  if (kEveryForm) return true;
  if (!kKnown.empty()) {  // what takes a cell, and by default what has ramps
    if (!id.starts_with("noise") || !id.ends_with("_cell") || id.find("cell") != id.rfind("cell")) return false;
#ifdef HN_TEST_EACH_KIND
    const std::string_view name = id.substr(id.find('.') + 1);
    return id[5] != '1' && id[5] != '4' && (name == "perlin_cell" || name == "perlin_d_cell" || name == "simplex_cell");
#else
    return true;
#endif
  }
// Each noise, and sums of the two kinds, on the plane alone: a function not inlined in one is in all.
#ifdef HN_TEST_EACH_KIND
  if (id.starts_with("fbm.")) return id == "fbm.clouds3" || id == "fbm.ping_pong2";
  if (id.find("_phase") != id.npos) return id == "noise2d.simplex_phase";
  if (id.starts_with("noise") && !id.starts_with("noise2d.")) return id == "noise3d.perlin_cell";
  return id == "gradient.lattice2" ||
         (id.find("2") != id.npos && id.find("_cell") == id.npos && id.find("_period") == id.npos);
#endif
  if (id.starts_with("noise2d.") || id == "noise3d.perlin_cell" || id == "fbm.fbm2_cell") return true;
  if (id == "warp.warp_progressive2_cell") return true;
  return id.find("_cell") == id.npos && id.find("_period") == id.npos;
}

}  // namespace

#define SEEDED(s) , s
#define SEED(s) s
#ifdef HN_TEST_KERNELS
extern "C" void hn_test_kernel(int line, const uint* in, uint* out);
static uvec4 of_kernel(int line, uvec4 a, uvec4 b, uvec4 c, uvec4 d) {
  const uint in[] = {a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, c.x, c.y, c.z, c.w, d.x, d.y, d.z, d.w};
  uint out[4];
  hn_test_kernel(line, in, out);
  return uvec4(out[0], out[1], out[2], out[3]);
}
#define BODY(...) return of_kernel(__LINE__, a, b, c, d);
#else
#define BODY(...) __VA_ARGS__
#endif

int main(int argc, char**) {
  few_only = argc > 1;
#ifdef HN_TEST_OVERFLOW
  std::printf("%d\n", static_cast<int>(word() >> 1) * static_cast<int>(word() >> 1));
#elif defined(HN_TEST_REORDERED)
  // Exact as it is written. Taken apart it is 36 - a - b, and beyond 16 a float has a bit less.
  std::uint64_t hash = 0;
  for (int i = 0; i < kFew; ++i) {
    const float a = float_of(0x41400000u + (word() & 0xFFFFFu)), b = float_of(0x41400000u + (word() & 0xFFFFFu));
    hash = hash * 1099511628211u + bits_of((12.0f - (a - 12.0f)) - (b - 12.0f));
  }
  std::printf("reordered %016llx\n", static_cast<unsigned long long>(hash));
#else
// Compilers take long to inline them all, so forms of the same text are tried once, on the plane.
#define UNPACKED(...) __VA_ARGS__
#define COLUMN(name, type) Column{name, #type[0]},
#define FUNCTION(id, family, configurations, columns, ...)                                       \
  if constexpr (is_tried(id)) {                                                                  \
    struct Row {                                                                                 \
      static constexpr auto inputs() { return std::to_array<Column>({UNPACKED columns}); }       \
    };                                                                                           \
    digest<Row>(id, #family,                                                                     \
                []([[maybe_unused]] uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, \
                   [[maybe_unused]] uvec4 d) -> uvec4 { BODY(__VA_ARGS__) });                    \
  }
#include "library/bodies.inc"
#endif
}
