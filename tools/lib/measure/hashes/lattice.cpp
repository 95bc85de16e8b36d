// Evaluates the C++ twin for tools/measure hashes: reads points, writes raw words. Compiled once per setting of knobs.
//   lattice word|gradient|noise|stage|NAME 2|3 < points > values
// word      hn_i_point(cell, seed), that the gradient is made of: a point is the cell and the seed, 32-bit integers; a
//           value is a word
// gradient  hn_gradient(cell, seed): the same points; a value is the floats of the gradient
// noise     hn_perlin(p, seed): a point is the floats of p and the seed; a value is a float
// stage     hn_gradient2(word), hn_gradient3(word): a point is a word; a value is the floats of the gradient
// further   hn_i_words_of_y(word), and in space hn_i_words_of_z(word) as well: a point is a word; a value is the words
//           of the components of a vector but the first
// value_vector, perlin_vector
//           hn_value_vector(p, seed), hn_perlin_vector(p, seed): a point is the floats of p and the seed; a value is
//           the floats of the vector
// NAME      hn_NAME(hn_tile(p, period), seed), with the same period along each axis: a point is the floats of p, the
//           period as an integer, and the seed; a value is a float
// perlin_worley
//           the same of hn_perlin_worley(hn_tile(p, period), 1, 2, 1, seed), in space
// phasor    hn_phasor(hn_tile(p, period), wave, 0, seed): a point is the floats of p, the period as an integer, the
//           floats of the wave, and the seed; a value is the floats of the value and the quadrature
// sum       hn_fbm(hn_place(cell, f), octaves, lacunarity, gain, seed): a point is the cell, the floats of f, the
//           octaves as an integer, the floats of lacunarity and gain, and the seed; a value is a float
// tiled_sum hn_fbm(hn_tile(hn_place(cell, f), period), octaves, lacunarity, gain, seed): the same points, with the
//           period before the seed
//
// All are little-endian, without anything between them.
// Exit status: 0 done, 2 bad usage, or input or output that broke off.
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
#include <string_view>
#include <vector>

namespace {

static_assert(std::endian::native == std::endian::little);

using Word = std::uint32_t;
using hashnoise::ivec2;
using hashnoise::ivec3;
using hashnoise::ivec4;
using hashnoise::uvec4;
using hashnoise::vec2;
using hashnoise::vec3;
using hashnoise::vec4;

constexpr std::size_t kBatch = 1 << 16;  // points at a time: half a megabyte, which stays in the cache

int integer(Word w) { return std::bit_cast<int>(w); }
float real(Word w) { return std::bit_cast<float>(w); }

// A place: the words of a cell, then those of the fraction in it.
auto place2(const Word* in) {
  return hashnoise::hn_place(ivec2(integer(in[0]), integer(in[1])), vec2(real(in[2]), real(in[3])));
}
auto place3(const Word* in) {
  return hashnoise::hn_place(ivec3(integer(in[0]), integer(in[1]), integer(in[2])),
                             vec3(real(in[3]), real(in[4]), real(in[5])));
}
auto place4(const Word* in) {
  return hashnoise::hn_place(ivec4(integer(in[0]), integer(in[1]), integer(in[2]), integer(in[3])),
                             vec4(real(in[4]), real(in[5]), real(in[6]), real(in[7])));
}

void put(vec2 g, Word* out) {
  out[0] = std::bit_cast<Word>(g.x);
  out[1] = std::bit_cast<Word>(g.y);
}

void put(vec3 g, Word* out) {
  out[0] = std::bit_cast<Word>(g.x);
  out[1] = std::bit_cast<Word>(g.y);
  out[2] = std::bit_cast<Word>(g.z);
}

struct Quantity {
  std::string_view name;
  char dimensions;
  std::size_t reads, writes;  // words per point and per value
  void (*evaluate)(const Word* in, Word* out);
};

// Two initializers, which clang-format takes for statements.
// clang-format off
#define TILED(name)                                                                                                  \
  {#name, '2', 4, 1, [](const Word* in, Word* out) {                                                                 \
     const vec2 p(real(in[0]), real(in[1]));                                                                         \
     *out = std::bit_cast<Word>(hashnoise::hn_##name(hashnoise::hn_tile(p, ivec2(integer(in[2]))), in[3]));          \
   }},                                                                                                               \
  {#name, '3', 5, 1, [](const Word* in, Word* out) {                                                                 \
     const vec3 p(real(in[0]), real(in[1]), real(in[2]));                                                            \
     *out = std::bit_cast<Word>(hashnoise::hn_##name(hashnoise::hn_tile(p, ivec3(integer(in[3]))), in[4]));          \
   }}
#define PHASE(name)                                                                                                  \
  {#name "_phase", '2', 5, 1,                                                                                        \
   [](const Word* in, Word* out) {                                                                                   \
     const auto tile = hashnoise::hn_tile(vec2(real(in[0]), real(in[1])), ivec2(integer(in[3])));                    \
     *out = std::bit_cast<Word>(hashnoise::hn_##name(tile, real(in[2]), in[4]));                                     \
   }},                                                                                                               \
  {#name "_phase", '3', 6, 1, [](const Word* in, Word* out) {                                                        \
     const auto tile = hashnoise::hn_tile(vec3(real(in[0]), real(in[1]), real(in[2])), ivec3(integer(in[4])));       \
     *out = std::bit_cast<Word>(hashnoise::hn_##name(tile, real(in[3]), in[5]));                                     \
   }}
// clang-format on

constexpr auto kQuantities = std::to_array<Quantity>({
  {"word", '2', 3, 1,
   [](const Word* in, Word* out) { *out = hashnoise::hn_i_point(hashnoise::uvec2(in[0], in[1]), in[2]); }},
      {"word", '3', 4, 1,
       [](const Word* in, Word* out) { *out = hashnoise::hn_i_point(hashnoise::uvec3(in[0], in[1], in[2]), in[3]); }},
      {"gradient", '2', 3, 2,
       [](const Word* in, Word* out) {
         put(hashnoise::hn_gradient(ivec2(integer(in[0]), integer(in[1])), in[2]), out);
       }},
      {"gradient", '3', 4, 3,
       [](const Word* in, Word* out) {
         put(hashnoise::hn_gradient(ivec3(integer(in[0]), integer(in[1]), integer(in[2])), in[3]), out);
       }},
      {"noise", '2', 3, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_perlin(vec2(real(in[0]), real(in[1])), in[2]));
       }},
      {"noise", '3', 4, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_perlin(vec3(real(in[0]), real(in[1]), real(in[2])), in[3]));
       }},
      {"stage", '2', 1, 2, [](const Word* in, Word* out) { put(hashnoise::hn_gradient2(*in), out); }},
      {"stage", '3', 1, 3, [](const Word* in, Word* out) { put(hashnoise::hn_gradient3(*in), out); }},
      {"further", '2', 1, 1, [](const Word* in, Word* out) { *out = hashnoise::hn_i_words_of_y(uvec4(*in)).x; }},
      {"further", '3', 1, 2,
       [](const Word* in, Word* out) {
         out[0] = hashnoise::hn_i_words_of_y(uvec4(*in)).x;
         out[1] = hashnoise::hn_i_words_of_z(uvec4(*in)).x;
       }},
      {"value_vector", '2', 3, 2,
       [](const Word* in, Word* out) { put(hashnoise::hn_value_vector(vec2(real(in[0]), real(in[1])), in[2]), out); }},
      {"value_vector", '3', 4, 3,
       [](const Word* in, Word* out) {
         put(hashnoise::hn_value_vector(vec3(real(in[0]), real(in[1]), real(in[2])), in[3]), out);
       }},
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL  // the paper's gradient has no vectors
      {"perlin_vector", '2', 3, 2,
       [](const Word* in, Word* out) { put(hashnoise::hn_perlin_vector(vec2(real(in[0]), real(in[1])), in[2]), out); }},
      {"perlin_vector", '3', 4, 3,
       [](const Word* in, Word* out) {
         put(hashnoise::hn_perlin_vector(vec3(real(in[0]), real(in[1]), real(in[2])), in[3]), out);
       }},
#endif
      {"sum", '2', 8, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_fbm(place2(in), integer(in[4]), real(in[5]), real(in[6]), in[7]));
       }},
      {"sum", '3', 10, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_fbm(place3(in), integer(in[6]), real(in[7]), real(in[8]), in[9]));
       }},
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL  // the only one that has noise in 4D
      {"sum", '4', 12, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_fbm(place4(in), integer(in[8]), real(in[9]), real(in[10]), in[11]));
       }},
#endif
      {"tiled_sum", '2', 9, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_fbm(hashnoise::hn_tile(place2(in), ivec2(integer(in[7]))),
                                                      integer(in[4]), real(in[5]), real(in[6]), in[8]));
       }},
      {"tiled_sum", '3', 11, 1,
       [](const Word* in, Word* out) {
         *out = std::bit_cast<Word>(hashnoise::hn_fbm(hashnoise::hn_tile(place3(in), ivec3(integer(in[9]))),
                                                      integer(in[6]), real(in[7]), real(in[8]), in[10]));
       }},
      TILED(perlin), TILED(value), TILED(value_cubic), TILED(simplex), TILED(simplex_smooth),
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL  // the paper's gradient has no phase
      PHASE(perlin), PHASE(simplex),
#endif
      {"phasor", '2', 6, 2,
       [](const Word* in, Word* out) {
         const vec2 p(real(in[0]), real(in[1]));
         put(hashnoise::hn_phasor(hashnoise::hn_tile(p, ivec2(integer(in[2]))), vec2(real(in[3]), real(in[4])), 0.0f,
                                  in[5]),
             out);
       }},
      {"phasor", '3', 8, 2,
       [](const Word* in, Word* out) {
         const vec3 p(real(in[0]), real(in[1]), real(in[2]));
         put(hashnoise::hn_phasor(hashnoise::hn_tile(p, ivec3(integer(in[3]))),
                                  vec3(real(in[4]), real(in[5]), real(in[6])), 0.0f, in[7]),
             out);
       }},
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL  // the paper's gradient has none
      {"perlin_worley", '3', 5, 1, [](const Word* in, Word* out) {
         const vec3 p(real(in[0]), real(in[1]), real(in[2]));
         *out = std::bit_cast<Word>(
             hashnoise::hn_perlin_worley(hashnoise::hn_tile(p, ivec3(integer(in[3]))), 1, 2.0f, 1.0f, in[4]));
       }},
#endif
});
#undef TILED
#undef PHASE

const Quantity* find(int argc, char** argv) {
  if (argc != 3) return nullptr;
  for (const Quantity& quantity : kQuantities) {
    if (quantity.name == argv[1] && std::string_view(argv[2]) == std::string_view(&quantity.dimensions, 1)) {
      return &quantity;
    }
  }
  return nullptr;
}

// Whether all of the input was whole points and all of the output was written.
bool stream(const Quantity& quantity) {
  std::vector<Word> points(kBatch * quantity.reads), values(kBatch * quantity.writes);
  while (true) {
    const std::size_t read = std::fread(points.data(), sizeof(Word), points.size(), stdin);
    const std::size_t count = read / quantity.reads;
    for (std::size_t i = 0; i < count; ++i) {
      quantity.evaluate(&points[i * quantity.reads], &values[i * quantity.writes]);
    }
    const std::size_t words = count * quantity.writes;
    if (std::fwrite(values.data(), sizeof(Word), words, stdout) != words) return false;
    if (read < points.size()) return read % quantity.reads == 0 && !std::ferror(stdin) && std::fflush(stdout) == 0;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Quantity* quantity = find(argc, argv);
  if (quantity == nullptr) {
    std::fputs("usage: lattice word|gradient|noise|stage|NAME 2|3 < points > values\n", stderr);
    return 2;
  }
  if (!stream(*quantity)) {
    std::fputs("lattice: input or output broke off\n", stderr);
    return 2;
  }
  return 0;
}
