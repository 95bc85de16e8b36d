// Rows of points so near each other that many of them lie in one piece of a lattice, such as a cell, but that cross the
// lattice in any direction: the rows of rotated octaves. Numbers of a piece are computed once for a run of points in
// it,
// many runs at a time, and a point finds them by the number of its run. Numbers and their order are those of the
// library,
// and so are the bits.
#pragma once

#include "windows.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

#ifdef HN_GRID_HAS_WINDOWS

constexpr int kMostVectors = kPointsAtOnce / kCount;
constexpr int kMostRuns = kPointsAtOnce + kCount;  // a vector of them is kept at a time

// For each byte, eight bytes of numbers. Functions of std are not used here: their code could be linked from here into
// parts that are compiled for other processors.
struct BytesOfByte {
  std::uint64_t of[256];
};
// How many bits are set up to each one.
constexpr BytesOfByte table_of_counts() {
  BytesOfByte table{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    std::uint64_t count = 0;
    for (unsigned i = 0; i < 8; ++i) {
      count += bits >> i & 1u;
      table.of[bits] |= count << (8 * i);
    }
  }
  return table;
}
constexpr BytesOfByte table_of_set_bits() {
  BytesOfByte table{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    unsigned to = 0;
    for (unsigned i = 0; i < 8; ++i) {
      if (bits >> i & 1u) table.of[bits] |= std::uint64_t{i} << (8 * to++);
    }
  }
  return table;
}
constexpr BytesOfByte kCounts = table_of_counts();
[[maybe_unused]] constexpr BytesOfByte kSetBits = table_of_set_bits();  // AVX-512 has an instruction in its place

// At which lanes a run begins.
class RunStarts {
 public:
  HN_I_INLINE RunStarts() : bits_(0u) {}
  // Where the lanes differ from the ones before them; the first lane follows the last one of `before`.
  HN_I_INLINE RunStarts(Uint lanes, Uint before) {
#if defined(__AVX512F__)
    // GCC 12 warns of the forms without a mask that they use what has no value.
    bits_ = _mm512_cmpneq_epi32_mask(__m512i(lanes.v),
                                     _mm512_maskz_alignr_epi32(0xFFFF, __m512i(lanes.v), __m512i(before.v), 15));
#elif defined(__AVX2__)
    const __m256i middle = _mm256_permute2x128_si256(__m256i(before.v), __m256i(lanes.v), 0x21);
    const __m256i equal = _mm256_cmpeq_epi32(__m256i(lanes.v), _mm256_alignr_epi8(__m256i(lanes.v), middle, 12));
    bits_ = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(equal))) ^ 0xFFu;
#elif defined(__SSE4_1__)
    const __m128i equal = _mm_cmpeq_epi32(__m128i(lanes.v), _mm_alignr_epi8(__m128i(lanes.v), __m128i(before.v), 12));
    bits_ = static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(equal))) ^ 0xFu;
#else
    const uint32x4_t weight = {1u, 2u, 4u, 8u};
    const uint32x4_t equal = vceqq_u32(uint32x4_t(lanes.v), vextq_u32(uint32x4_t(before.v), uint32x4_t(lanes.v), 3));
    bits_ = vaddvq_u32(vbicq_u32(weight, equal));
#endif
  }
  HN_I_INLINE void set_first() { bits_ |= 1u; }
  HN_I_INLINE bool first() const { return (bits_ & 1u) != 0u; }
  HN_I_INLINE int count() const { return static_cast<int>((kCounts.of[bits_ & 0xFFu] + kCounts.of[bits_ >> 8]) >> 56); }

  // The lanes at which a run begins, moved to the front.
  template <typename S>
  HN_I_INLINE Lanes<S> of(Lanes<S> lanes) const {
#if defined(__AVX512F__)
    using Vector = typename Lanes<S>::Vector;
    return Lanes<S>(Vector(_mm512_maskz_compress_epi32(static_cast<__mmask16>(bits_), __m512i(lanes.v))));
#elif defined(__AVX2__)
    using Vector = typename Lanes<S>::Vector;
    return Lanes<S>(Vector(_mm256_permutevar8x32_epi32(__m256i(lanes.v), __m256i(spread(kSetBits.of[bits_]).v))));
#else
    S numbers[kCount];
    lanes.store(numbers);
    return Window(spread(kSetBits.of[bits_])).of(numbers);
#endif
  }
  // For each lane, how many runs begin up to there behind the first lane.
  HN_I_INLINE Int index() const {
    const unsigned behind = bits_ & ~1u;
#if defined(__AVX512F__)
    const std::uint64_t low = kCounts.of[behind & 0xFFu];
    const std::uint64_t high = kCounts.of[behind >> 8] + (low >> 56) * 0x0101010101010101u;
    return Int(detail::IntVector(_mm512_maskz_cvtepu8_epi32(
        0xFFFF, _mm_set_epi64x(static_cast<std::int64_t>(high), static_cast<std::int64_t>(low)))));
#else
    return spread(kCounts.of[behind]);
#endif
  }

 private:
#if !defined(__AVX512F__)
  // The lowest bytes, as numbers.
  HN_I_INLINE static Int spread(std::uint64_t bytes) {
#if defined(__AVX2__)
    return Int(detail::IntVector(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<std::int64_t>(bytes)))));
#elif defined(__SSE4_1__)
    return Int(detail::IntVector(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(bytes)))));
#else
    return Int(detail::IntVector(vmovl_u16(vget_low_u16(vmovl_u8(vcreate_u8(bytes))))));
#endif
  }
#endif

  unsigned bits_;
};

// Each noise has
//
//   kMostStep               up to this distance of points they gain
//   key(place)              a word that differs between pieces that are near each other
//   put(run, place, seed)   keeps, for some runs, what the pieces have in which the places are
//   noise(run, index, place)
//                           the noise of points that are in runs so far behind that one
//
// For cells the word has 8 bits for each axis, and more for the last one.
template <int D>
HN_I_INLINE Uint key_of(const Cell<D>& cell) {
  const Uint key = Uint(cell.x) + (Uint(cell.y) << 8u);
  if constexpr (D == 2) {
    return key;
  } else {
    return key + (Uint(cell.z) << 16u);
  }
}

// The gradients of all corners of a cell, or their numbers.
template <bool kIsPerlin, int D>
class CornerPieces {
 public:
  static constexpr double kMostStep = !kIsPerlin || (D == 3 && kCount == 8) ? 0.5 : D == 3 && kCount == 16 ? 0.12 : 0.2;

  HN_I_INLINE static Uint key(const Place<D>& place) { return key_of<D>(place.cell); }
  HN_I_INLINE void put(int run, const Place<D>& place, Uint seed) {
    const auto corners = hn_i_cell_corners(place);
    const auto put_one = [&](int i, Uint word) HN_I_INLINED {
      if constexpr (kIsPerlin) {
        corners_[i].put(run, direction<D>(word, false));
      } else {
        corners_[i].put(run, hn_i_number(word));
      }
    };
    const auto put_face = [&](int i, const uvec4& h) HN_I_INLINED {
      put_one(i, h.x);
      put_one(i + 1, h.y);
      put_one(i + 2, h.z);
      put_one(i + 3, h.w);
    };
    if constexpr (D == 2) {
      put_face(0, hn_i_corner_hashes(corners, seed));
    } else {
      put_face(0, hn_i_corner_hashes(corners, false, seed));
      put_face(4, hn_i_corner_hashes(corners, true, seed));
    }
  }
  HN_I_INLINE hn_i_num noise(int run, Int index, const Place<D>& place) const {
    const auto corner = [](int i) HN_I_INLINED { return i; };
    return between_corners<kIsPerlin, D>(place, corner, [&](int i, [[maybe_unused]] auto... offset) HN_I_INLINED {
      if constexpr (kIsPerlin) {
        return along<D>(corners_[i].of(run, index), offset...);
      } else {
        return corners_[i].of(run, index);
      }
    });
  }

 private:
  Corners<kIsPerlin ? D : 1, kMostRuns, std::conditional_t<kIsPerlin, float, Number>> corners_[1 << D];
};

// Some vectors of points on a line: uses the noise at each, whose place place_at gives.
template <typename Pieces, typename PlaceAt, typename Use>
HN_I_INLINE void over_runs(Pieces& pieces, int vectors, Uint seed, const PlaceAt& place_at, const Use& use) {
  using Place = decltype(place_at(0));
  constexpr int kAxes = sizeof(Place::cell) / sizeof(Int);
  RunStarts starts[kMostVectors];
  int run[kMostVectors];
  std::int32_t cell[kAxes][kMostRuns];  // of the places that begin a run
  Number fraction[kAxes][kMostRuns];
  int runs = 0;
  Uint before(0u);
  for (int v = 0; v < vectors; ++v) {
    const Place place = place_at(v);
    const Uint key = Pieces::key(place);
    starts[v] = RunStarts(key, before);
    before = key;
    if (v == 0) starts[v].set_first();
    run[v] = starts[v].first() ? runs : runs - 1;
    each_axis<0, kAxes>([&](auto axis) HN_I_INLINED {
      starts[v].of(along_axis<axis>(place.cell)).store(cell[axis] + runs);
      starts[v].of(along_axis<axis>(place.fraction)).store(fraction[axis] + runs);
    });
    runs += starts[v].count();
  }
  for (int i = 0; i < runs; i += kCount) {
    Place place{};
    each_axis<0, kAxes>([&](auto axis) HN_I_INLINED {
      along_axis<axis>(place.cell) = Int::load(cell[axis] + i);
      along_axis<axis>(place.fraction) = hn_i_num::load(fraction[axis] + i);
    });
    pieces.put(i, place, seed);
  }
  for (int v = 0; v < vectors; ++v) use(v, pieces.noise(run[v], starts[v].index(), place_at(v)));
}

#endif

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
