// Evaluates the C++ twin for tools/measure hashes: a shared library, compiled once per setting of knobs. Each function
// reads so many points and writes a value for each.
//
// wordN       hn_i_point(cell, seed): a point is the cell and the seed
// furtherN    the words of the components of a vector but the first: a point is the word of the first
// NAMEN       hn_NAME(hn_tile(p, period), seed), with the same period along each axis: a point is p, the period, the
// seed NAME_phaseN the same with a phase: a point is p, the phase, the period, the seed perlin_worley3  of one octave,
// like NAMEN phasorN     hn_phasor(hn_tile(p, period), wave, 0, seed): a point is p, the period, the wave, the seed; a
// value is the
//             value and the quadrature
// fbmN        hn_fbm(hn_place(cell, f), octaves, 2, 1/2, seed): a point is the cell, f, the octaves, the seed
// tiled_fbmN  the same with a period: a point is the cell, f, the octaves, the period, the seed
//
// Each number has 32 bits: an integer or a float.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <hashnoise/hashnoise.hpp>

namespace {

using namespace hashnoise;

using Word = std::uint32_t;
using In = const Word*;
using Out = Word*;

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

}  // namespace

// clang-format off
// A function of points that have so many numbers, and of values that have so many.
#define EVALUATES(name, reads, writes, value)                                  \
  extern "C" void name(In in, Out out, std::size_t count) {                    \
    for (std::size_t i = 0; i < count; ++i, in += (reads), out += (writes)) {  \
      value;                                                                   \
    }                                                                          \
  }
#define TILED(name, N) EVALUATES(name##N, N + 2, 1, put(hn_##name(tile<N>(in, in[N]), in[N + 1]), out))
#define PHASE(name, N)                                                                                       \
  EVALUATES(name##_phase##N, N + 3, 1, put(hn_##name(tile<N>(in, in[N + 1]), real(in[N]), in[N + 2]), out))
#define OF(N)                                                                                                     \
  EVALUATES(word##N, N + 1, 1, put(hn_i_point(words<N>(in), in[N]), out))                                         \
  TILED(perlin, N) TILED(simplex, N) TILED(simplex_smooth, N) TILED(value, N) TILED(value_cubic, N)               \
  PHASE(perlin, N) PHASE(simplex, N)                                                                              \
  EVALUATES(phasor##N, 2 * N + 2, 2,                                                                              \
            put(hn_phasor(tile<N>(in, in[N]), reals<N>(in + N + 1), 0.0f, in[2 * N + 1]), out))                   \
  EVALUATES(fbm##N, 2 * N + 2, 1, put(hn_fbm(place<N>(in), integer(in[2 * N]), 2.0f, 0.5f, in[2 * N + 1]), out))  \
  EVALUATES(tiled_fbm##N, 2 * N + 3, 1,                                                                           \
            put(hn_fbm(hn_tile(place<N>(in), all<N>(in[2 * N + 1])), integer(in[2 * N]), 2.0f, 0.5f,              \
                       in[2 * N + 2]), out))
OF(2)
OF(3)
EVALUATES(further2, 1, 1, put(hn_i_hashes_of_y(uvec4(*in)).x, out))
EVALUATES(further3, 1, 2, put(hn_i_hashes_of_y(uvec4(*in)).x, out); put(hn_i_hashes_of_z(uvec4(*in)).x, out + 1))
EVALUATES(perlin_worley3, 5, 1, put(hn_perlin_worley(tile<3>(in, in[3]), 1, 2.0f, 1.0f, in[4]), out))
// clang-format on
