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

// The gradients of all corners of a cell.
template <int D>
class PerlinPieces {
 public:
  static constexpr double kMostStep = D == 3 && kCount == 8 ? 0.5 : D == 3 && kCount == 16 ? 0.12 : 0.2;

  HN_I_INLINE static Uint key(const Place<D>& place) { return key_of<D>(place.cell); }
  HN_I_INLINE void put(int run, const Place<D>& place, Uint seed) {
    const auto corners = hn_i_cell_corners(place);
    const auto put_face = [&](int i, const uvec4& h) HN_I_INLINED {
      corners_[i].put(run, gradient(h.x));
      corners_[i + 1].put(run, gradient(h.y));
      corners_[i + 2].put(run, gradient(h.z));
      corners_[i + 3].put(run, gradient(h.w));
    };
    if constexpr (D == 2) {
      put_face(0, hn_i_corner_hashes(corners, seed));
    } else {
      put_face(0, hn_i_corner_hashes(corners, false, seed));
      put_face(4, hn_i_corner_hashes(corners, true, seed));
    }
  }
  HN_I_INLINE hn_i_num noise(int run, Int index, const Place<D>& place) const {
    const auto f = place.fraction;
    const auto t = hn_i_fade(f);
    const Float x = hn_i_offset(f.x), y = hn_i_offset(f.y);
    const Float x1 = hn_i_far(x), y1 = hn_i_far(y);
    const auto ramp = [&](int i, Float along_x, Float along_y, auto... z) HN_I_INLINED {
      const auto g = corners_[i].of(run, index);
      if constexpr (D == 2) {
        return hn_i_along2(g, along_x, along_y);
      } else {
        return hn_i_along3(g, along_x, along_y, z...);
      }
    };
    const auto face = [&](int i, auto... z) HN_I_INLINED {
      return hn_i_vector(ramp(i, x, y, z...), ramp(i + 1, x1, y, z...), ramp(i + 2, x, y1, z...),
                         ramp(i + 3, x1, y1, z...));
    };
    if constexpr (D == 2) {
      return hn_i_scaled2(hn_i_bilerp_ramps2(face(0), t.x, t.y));
    } else {
      const Float z = hn_i_offset(f.z);
      return hn_i_scaled3(
          hn_i_lerp(hn_i_bilerp_ramps3(face(0, z), t.x, t.y), hn_i_bilerp_ramps3(face(4, hn_i_far(z)), t.x, t.y), t.z));
    }
  }

 private:
  HN_I_INLINE static auto gradient(Uint word) {
    if constexpr (D == 2) {
      return hn_i_direction2(word);
    } else {
      return hn_i_direction3(word, false);
    }
  }

  Corners<D, kMostRuns> corners_[D == 2 ? 4 : 8];
};

// The numbers of all corners of a cell.
template <int D>
class ValuePieces {
 public:
  static constexpr double kMostStep = 0.5;

  HN_I_INLINE static Uint key(const Place<D>& place) { return key_of<D>(place.cell); }
  HN_I_INLINE void put(int run, const Place<D>& place, Uint seed) {
    const auto corners = hn_i_cell_corners(place);
    const auto put_face = [&](int i, const uvec4& h) HN_I_INLINED {
      numbers_[i].put(run, hn_i_number(h.x));
      numbers_[i + 1].put(run, hn_i_number(h.y));
      numbers_[i + 2].put(run, hn_i_number(h.z));
      numbers_[i + 3].put(run, hn_i_number(h.w));
    };
    if constexpr (D == 2) {
      put_face(0, hn_i_corner_hashes(corners, seed));
    } else {
      put_face(0, hn_i_corner_hashes(corners, false, seed));
      put_face(4, hn_i_corner_hashes(corners, true, seed));
    }
  }
  HN_I_INLINE hn_i_num noise(int run, Int index, const Place<D>& place) const {
    const auto t = hn_i_fade(place.fraction);
    const auto face = [&](int i) HN_I_INLINED {
      return hn_i_lerp(hn_i_vector(numbers_[i].of(run, index), numbers_[i + 1].of(run, index),
                                   numbers_[i + 2].of(run, index), numbers_[i + 3].of(run, index)),
                       t.x, t.y);
    };
    if constexpr (D == 2) {
      return hn_i_noise_of_numbers(face(0));
    } else {
      return hn_i_noise_of_numbers(hn_i_lerp(face(0), face(4), t.z));
    }
  }

 private:
  Corners<1, kMostRuns, Number> numbers_[D == 2 ? 4 : 8];
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
    const auto keep = [&](int axis, Int c, hn_i_num f) HN_I_INLINED {
      starts[v].of(c).store(cell[axis] + runs);
      starts[v].of(f).store(fraction[axis] + runs);
    };
    keep(0, place.cell.x, place.fraction.x);
    keep(1, place.cell.y, place.fraction.y);
    if constexpr (kAxes == 3) keep(2, place.cell.z, place.fraction.z);
    runs += starts[v].count();
  }
  for (int i = 0; i < runs; i += kCount) {
    Place place{};
    const auto put = [&](int axis, Int& c, hn_i_num& f) HN_I_INLINED {
      c = Int::load(cell[axis] + i);
      f = hn_i_num::load(fraction[axis] + i);
    };
    put(0, place.cell.x, place.fraction.x);
    put(1, place.cell.y, place.fraction.y);
    if constexpr (kAxes == 3) put(2, place.cell.z, place.fraction.z);
    pieces.put(i, place, seed);
  }
  for (int v = 0; v < vectors; ++v) use(v, pieces.noise(run[v], starts[v].index(), place_at(v)));
}

#endif

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
