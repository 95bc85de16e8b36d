// Evaluates the C++ twin for tools/measure hashes: reads points, writes raw words. Compiled once per setting of knobs.
//   lattice NAME2|NAME3 < points > values
// word       hn_i_point(cell, seed): a point is the cell and the seed
// further    the words of the components of a vector but the first: a point is the word of the first
// NAME       hn_NAME(hn_tile(p, period), seed), with the same period along each axis: a point is p, the period, the
// seed NAME_phase the same with a phase: a point is p, the phase, the period, the seed perlin_worley  of one octave, in
// space phasor     hn_phasor(hn_tile(p, period), wave, 0, seed): a point is p, the period, the wave, the seed; a value
// is the
//            value and the quadrature
// fbm        hn_fbm(hn_place(cell, f), octaves, 2, 1/2, seed): a point is the cell, f, the octaves, the seed
// tiled_fbm  the same with a period: a point is the cell, f, the octaves, the period, the seed
//
// Each number has 32 bits, little-endian: an integer or a float.
// Exit status: 0 done, 2 bad usage, or input or output that broke off.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <hashnoise/hashnoise.hpp>
#include <iterator>
#include <string_view>
#include <vector>

namespace {

using namespace hashnoise;

static_assert(std::endian::native == std::endian::little);

using Word = std::uint32_t;
using In = const Word*;
using Out = Word*;

constexpr std::size_t kBatch = 1 << 16;  // points at a time: half a megabyte, which stays in the cache

int integer(Word w) { return std::bit_cast<int>(w); }
float real(Word w) { return std::bit_cast<float>(w); }

template <int N, typename Vec2, typename Vec3, typename Component>
auto vector(In in, Component component) {
  if constexpr (N == 2)
    return Vec2(component(in[0]), component(in[1]));
  else
    return Vec3(component(in[0]), component(in[1]), component(in[2]));
}
template <int N>
auto words(In in) {
  return vector<N, uvec2, uvec3>(in, std::identity());
}
template <int N>
auto reals(In in) {
  return vector<N, vec2, vec3>(in, real);
}
template <int N>
auto integers(In in) {
  return vector<N, ivec2, ivec3>(in, integer);
}
template <int N>
auto all(Word period) {
  const Word periods[] = {period, period, period};
  return integers<N>(periods);
}
template <int N>
auto tile(In in, Word period) {
  return hn_tile(reals<N>(in), all<N>(period));
}
template <int N>
auto place(In in) {
  return hn_place(integers<N>(in), reals<N>(in + N));
}

void put(Word w, Out out) { *out = w; }
void put(float x, Out out) { *out = std::bit_cast<Word>(x); }
void put(vec2 v, Out out) {
  put(v.x, out);
  put(v.y, out + 1);
}

struct Quantity {
  std::string_view name;      // with the dimensions
  std::size_t reads, writes;  // words per point and per value
  void (*evaluate)(In in, Out out);
};

// clang-format off
#define TILED(name, N) {#name #N, N + 2, 1, [](In in, Out out) { put(hn_##name(tile<N>(in, in[N]), in[N + 1]), out); }}
#define PHASE(name, N)                                                                                                 \
  {#name "_phase" #N, N + 3, 1,                                                                                        \
   [](In in, Out out) { put(hn_##name(tile<N>(in, in[N + 1]), real(in[N]), in[N + 2]), out); }}
#define OF(N)                                                                                                          \
  {"word" #N, N + 1, 1, [](In in, Out out) { put(hn_i_point(words<N>(in), in[N]), out); }},                            \
  TILED(perlin, N), TILED(simplex, N), TILED(simplex_smooth, N), TILED(value, N), TILED(value_cubic, N),               \
  PHASE(perlin, N), PHASE(simplex, N),                                                                                 \
  {"phasor" #N, 2 * N + 2, 2,                                                                                          \
   [](In in, Out out) { put(hn_phasor(tile<N>(in, in[N]), reals<N>(in + N + 1), 0.0f, in[2 * N + 1]), out); }},        \
  {"fbm" #N, 2 * N + 2, 1,                                                                                             \
   [](In in, Out out) { put(hn_fbm(place<N>(in), integer(in[2 * N]), 2.0f, 0.5f, in[2 * N + 1]), out); }},             \
  {"tiled_fbm" #N, 2 * N + 3, 1, [](In in, Out out) {                                                                  \
     put(hn_fbm(hn_tile(place<N>(in), all<N>(in[2 * N + 1])), integer(in[2 * N]), 2.0f, 0.5f, in[2 * N + 2]), out);    \
   }}
constexpr Quantity kQuantities[] = {
  OF(2), OF(3),
  {"further2", 1, 1, [](In in, Out out) { put(hn_i_words_of_y(uvec4(*in)).x, out); }},
  {"further3", 1, 2,
   [](In in, Out out) {
     put(hn_i_words_of_y(uvec4(*in)).x, out);
     put(hn_i_words_of_z(uvec4(*in)).x, out + 1);
   }},
  {"perlin_worley3", 5, 1,
   [](In in, Out out) { put(hn_perlin_worley(tile<3>(in, in[3]), 1, 2.0f, 1.0f, in[4]), out); }},
};
// clang-format on

const Quantity* find(int argc, char** argv) {
  const auto* found = std::find_if(std::begin(kQuantities), std::end(kQuantities),
                                   [&](const Quantity& quantity) { return argc == 2 && quantity.name == argv[1]; });
  return found == std::end(kQuantities) ? nullptr : found;
}

// Whether all of the input was whole points and all of the output was written.
bool stream(const Quantity& quantity) {
  std::vector<Word> points(kBatch * quantity.reads), values(kBatch * quantity.writes);
  while (true) {
    const std::size_t read = std::fread(points.data(), sizeof(Word), points.size(), stdin);
    const std::size_t count = read / quantity.reads;
    for (std::size_t i = 0; i < count; ++i) {
      quantity.evaluate(points.data() + i * quantity.reads, values.data() + i * quantity.writes);
    }
    const std::size_t written = count * quantity.writes;
    if (std::fwrite(values.data(), sizeof(Word), written, stdout) != written) return false;
    if (read < points.size()) return read % quantity.reads == 0 && !std::ferror(stdin) && std::fflush(stdout) == 0;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Quantity* quantity = find(argc, argv);
  if (quantity == nullptr) {
    std::fputs("usage: lattice NAME2|NAME3 < points > values\n", stderr);
    return 2;
  }
  if (!stream(*quantity)) {
    std::fputs("lattice: input or output broke off\n", stderr);
    return 2;
  }
  return 0;
}
