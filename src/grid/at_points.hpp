// Value, Perlin and simplex noise at points that share nothing. Numbers are the library's, and so are the bits
// of HN_PRECISE and HN_FIXED. Some parts are computed in another way:
//   - gradients, by instructions that GPUs have not
//   - the second join of a hash, whose low 24 bits count: it is the sum of a product of each coordinate of the cell
//   - the hashes of simplex noise: a step to the next point of the lattice changes both joins of a hash by a term of
//     one axis alone. So each axis is shifted once, and the code chooses between changes, not between coordinates
//   - the falloffs of simplex noise with HN_FAST, by fewer steps
#pragma once

#include "loops.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// Directions on the plane: the two bits that choose a component of four are an index. Its sign is the table's.
#if defined(__AVX2__)
HN_I_INLINE Float of_four(Uint index, float a, float b, float c, float d) {
#if defined(__AVX512F__)
  return Float(detail::FloatVector(_mm512_maskz_permutevar_ps(0xFFFF, _mm512_setr4_ps(a, b, c, d), __m512i(index.v))));
#else
  return Float(detail::FloatVector(_mm256_permutevar_ps(_mm256_setr_ps(a, b, c, d, a, b, c, d), __m256i(index.v))));
#endif
}
HN_I_INLINE vec2 direction2(Uint word) {
  const Uint index = word >> 21u;
  return vec2(of_four(index, -0.75f, -0.25f, 0.25f, 0.75f),
              hn_i_signed(of_four(index, 0.25f, 0.75f, 0.75f, 0.25f), word));
}
#else
HN_I_INLINE vec2 direction2(Uint word) { return direction<2>(word); }
#endif
HN_I_INLINE hn_i_num along_hashed(Uint word, Float x, Float y) { return along<2>(direction2(word), x, y); }

// Ramps in space: the signs are flipped in place of being multiplied, and where a choice takes more than one step, it
// is made of what two offsets differ by.
HN_I_INLINE Float signed_by(Float x, Uint word, std::uint32_t shift) {
  return uintBitsToFloat(floatBitsToUint(x) ^ ((word << shift) & 0x80000000u));
}
// SSE and AVX2 compare numbers with a sign alone, and GCC makes two steps of each other comparison.
HN_I_INLINE Mask is_below(Uint word, std::uint32_t n) {
#if defined(__SSE4_1__) && !defined(__AVX512F__)
  return Int(word ^ 0x80000000u) < static_cast<std::int32_t>(n ^ 0x80000000u);
#else
  return word < n;
#endif
}
HN_I_INLINE hn_i_num along_hashed(Uint word, Float x, Float y, Float z) {
  const Float a = select(is_below(word, 0xAAAAAAAAu), x, y), b = select(is_below(word, 0x55555555u), y, z);
  const Float first = signed_by(a, word, 9u), second = signed_by(b, word, 10u);
  return HN_ARITHMETIC == HN_FIXED ? beyond<3>(first + kBeyond<3> + second) : beyond<3>(first + second);
}

// The numbers where the condition holds, else 0: by their bits, since GCC makes of it the choice that it replaces.
template <typename S>
HN_I_INLINE Lanes<S> where(Mask condition, Lanes<S> n) {
  const auto bits = __builtin_bit_cast(detail::UintVector, n.v) & detail::converted<detail::UintVector>(condition.v);
  return Lanes<S>(__builtin_bit_cast(typename Lanes<S>::Vector, bits));
}
// Sums, differences and exclusive ors where the condition holds, else the first number. AVX-512 does it in one step,
// and others do without a choice, which takes them up to three.
template <typename S>
HN_I_INLINE Lanes<S> plus_where(Mask condition, Lanes<S> a, Lanes<S> b) {
  return kCount == 16 ? select(condition, a + b, a) : a + where(condition, b);
}
template <typename S>
HN_I_INLINE Lanes<S> minus_where(Mask condition, Lanes<S> a, Lanes<S> b) {
  return kCount == 16 ? select(condition, a - b, a) : a - where(condition, b);
}
HN_I_INLINE Uint joined(Uint a, Uint b, Uint c) {
#if defined(__AVX512F__)
  return Uint(detail::UintVector(_mm512_ternarylogic_epi32(__m512i(a.v), __m512i(b.v), __m512i(c.v), 0x96)));
#else
  return a ^ (b ^ c);
#endif
}
HN_I_INLINE Uint joined_where(Mask condition, Uint a, Uint b, Uint c) {
  return kCount == 16 ? select(condition, joined(a, b, c), a) : a ^ where(condition, b ^ c);
}
// The first number where the condition holds, else the second.
HN_I_INLINE Uint either(Mask condition, Uint a, Uint b) {
  return kCount == 16 ? select(condition, a, b) : b + where(condition, a - b);
}
template <typename S>
HN_I_INLINE Lanes<S> one_of(Mask condition, Lanes<S> a, Lanes<S> b) {
  if (kCount == 16) return select(condition, a, b);
  const auto bits = [](Lanes<S> n) HN_I_INLINED { return __builtin_bit_cast(detail::UintVector, n.v); };
  const Uint change(bits(a) ^ bits(b));
  return Lanes<S>(__builtin_bit_cast(typename Lanes<S>::Vector, bits(b) ^ where(condition, change).v));
}

// By how much the second join of a word grows along each axis, and what it is in a cell.
constexpr std::uint32_t kOddX = (HN_I_STEP_X & 0x00FFFFFFu) * HN_I_ODD_X,
                        kOddY = (HN_I_STEP_Y & 0x00FFFFFFu) * HN_I_ODD_Y,
                        kOddZ = (HN_I_STEP_Z & 0x00FFFFFFu) * HN_I_ODD_Z;
template <typename Cells>
HN_I_INLINE Uint odd_of(const Cells& c, Uint s) {
  const Uint odd = Uint(c.x) * kOddX + Uint(c.y) * kOddY + hn_i_odd(s + HN_I_ORIGIN_X);
  if constexpr (requires { c.z; }) {
    return odd + Uint(c.z) * kOddZ;
  } else {
    return odd;
  }
}

// Perlin and value noise. The numbers of value noise are the low 23 bits of a word, and the second join need not be cut
// off to 24 for these: the low bits of a product are made of low bits alone.
static_assert(HN_HASH == HN_HASH_LATTICE);
template <bool kIsPerlin, int D>
HN_I_INLINE hn_i_num lattice_noise_at(const Place<D>& place, Uint seed) {
  const Uint s = hn_i_scramble(seed);
  const auto corners = hn_i_cell_corners(place);
  const auto lower = hn_i_high(corners.lower), upper = hn_i_high(corners.upper);
  const Uint odd = odd_of(place.cell, s);
  const auto corner = [&](int i) HN_I_INLINED {
    const bool x = (i & 1) != 0, y = (i & 2) != 0, z = (i & 4) != 0;
    Uint others = hn_i_seed_join(s), second = z ? odd + kOddZ : odd;
    if constexpr (D == 3) others ^= z ? upper.z : lower.z;
    const Uint join = joined(x ? upper.x : lower.x, y ? upper.y : lower.y, others);
    second += (x ? kOddX : 0u) + (y ? kOddY : 0u);
    return kIsPerlin ? hn_i_point_hash(join, second) : join * second;
  };
  return between_corners<kIsPerlin, D>(place, corner, [](Uint word, [[maybe_unused]] auto... offset) HN_I_INLINED {
    if constexpr (kIsPerlin) {
      return along_hashed(word, offset...);
    } else {
      return hn_i_number(word);
    }
  });
}

// A place in the skewed coordinates of triangular_lattice.glsl: what u and v have beyond whole numbers, and the first
// corner of the triangle, as the integer lattice has it. A fraction is in [0, 1], so to convert it in steps is to round
// it down. Floats that are more have no value.
struct Skewed {
  hn_i_num u, v;
  uvec2 first;
  Mask is_odd;  // the row

  HN_I_INLINE explicit Skewed(const Place<2>& place) {
    const hn_i_num2 skewed = hn_i_skewed(place.fraction);
    const uvec2 doubled(Uint(place.cell.x) + Uint(place.cell.x), Uint(place.cell.y) + Uint(place.cell.y));
#if HN_ARITHMETIC == HN_FIXED
    const auto rest = [](Int x, Int) HN_I_INLINED { return hn_i_fract(x); };
#else
    const auto rest = [](Float x, Int whole) HN_I_INLINED { return x - Float(whole); };
#endif
    const Int column = hn_i_truncate(skewed.x);
    u = rest(skewed.x, column);
#if HN_ARITHMETIC == HN_FAST
    // A fraction of 1 is the upper end of the second row, and not the first place of a third. It is the same place.
    is_odd = place.fraction.y >= 0.5f;
    v = minus_where(is_odd, skewed.y, Float(1.0f));
    first = uvec2(doubled.x + minus_where(is_odd, Uint(column), Uint(1u)), plus_where(is_odd, doubled.y, Uint(1u)));
#else
    const Int row = hn_i_truncate(skewed.y);
    v = rest(skewed.y, row);
    is_odd = (row & 1) != 0;
    first = uvec2(doubled.x + Uint(column) - Uint(min(row, Int(1))), doubled.y + Uint(row));
#endif
  }
};

HN_I_INLINE hn_i_num simplex_at(const Place<2>& place, Uint seed) {
  const Skewed at(place);
  const uvec2 first = hn_i_spread(at.first);
  const uvec2 next(first.x + HN_I_STEP_X, first.y + HN_I_STEP_Y);
  const Uint s = hn_i_scramble(seed);
  const Uint lower = hn_i_high(first).y ^ hn_i_seed_join(s), upper = hn_i_high(next).y ^ hn_i_seed_join(s);
  const Uint odd = odd_of(at.first, s);
  const Uint last = plus_where(at.is_odd, first.x, Uint(HN_I_STEP_X));
  const Uint last_odd = plus_where(at.is_odd, odd + kOddY, Uint(kOddX));
  const Mask is_along = at.u > at.v;
  const Uint middle = either(is_along, next.x, last - HN_I_STEP_X);
  const Uint middle_odd = either(is_along, odd + kOddX, last_odd - kOddX);
  const auto corner = [](Uint join, Uint second, hn_i_num x, hn_i_num y) HN_I_INLINED {
#if HN_ARITHMETIC == HN_FAST  // rounded four times, as hn_i_falloff of hn_i_square is, or twice where steps are fused
    const Float t = max(HN_I_TRIANGLE_RADIUS / 1024.0f - x * x - y * y, Float(0.0f));
#else
    const hn_i_num t = hn_i_falloff(hn_i_square(x, y), HN_I_TRIANGLE_RADIUS, 1);
#endif
    return weighted_ramp<2>(hn_i_weight_plane(t),
                            along_hashed(hn_i_point_hash(join, second), hn_i_offset(x), hn_i_offset(y)));
  };
  const hn_i_num x = at.u - hn_i_half(at.v), one = HN_I_ONE, half = HN_I_ONE / 2;
  const hn_i_num y = at.v - one;
  hn_i_num n = corner(hn_i_high(first.x) ^ lower, odd, x, at.v);
  n += corner(hn_i_high(middle) ^ either(is_along, lower, upper), middle_odd, x + one_of(is_along, -one, half),
              kCount == 16 ? select(is_along, at.v, y) : minus_where(at.u <= at.v, at.v, one));
  return scaled_simplex<2>(n + corner(hn_i_high(last) ^ upper, last_odd, x - half, y));
}

HN_I_INLINE hn_i_num simplex_at(const Place<3>& place, Uint seed) {
  const hn_i_num3 f = place.fraction;
  const hn_i_num one = HN_I_ONE, half = HN_I_ONE / 2;
  struct Axis {
    Mask is_far;               // from the lower corner of the cell
    hn_i_num near_by, inner;   // the offsets from the nearest corner and from the centre
    hn_i_num size;             // of the first
    hn_i_num other;            // what takes the first to the next corner
    Uint here, ahead, before;  // the shares of the first join: of the cell, and of those beside it
    Uint step;                 // of the second join, from the nearest corner to the next
  };
  const auto axis_of = [&](hn_i_num along, Uint cell, Uint step, std::uint32_t high, Uint odd_step) HN_I_INLINED {
    Axis a;
    a.is_far = along > half;
    a.near_by = minus_where(a.is_far, along, one);
    a.inner = along - half;
    a.size = hn_i_magnitude(a.near_by);
    a.other = one_of(a.is_far, one, -one);
    a.here = cell >> high;
    a.ahead = (cell + step) >> high;
    a.before = (cell - step) >> high;
    a.step = one_of(a.is_far, 0u - odd_step, odd_step);
    return a;
  };
  const uvec3 cell = hn_i_spread(uvec3(place.cell));
  const Axis ax = axis_of(f.x, cell.x, Uint(HN_I_STEP_X), HN_I_HIGH_X, kOddX);
  const Axis ay = axis_of(f.y, cell.y, Uint(HN_I_STEP_Y), HN_I_HIGH_Y, kOddY);
  const Axis az = axis_of(f.z, cell.z, Uint(HN_I_STEP_Z), HN_I_HIGH_Z, kOddZ);
  const Uint s = hn_i_scramble(seed);
  Uint corner = joined(ax.here, ay.here, az.here ^ hn_i_seed_join(s)), corner_odd = odd_of(place.cell, s);
  Uint centre = corner ^ HN_I_CENTRE_JOIN, centre_odd = corner_odd + (HN_I_CENTRE_SUM & 0x00FFFFFFu) * HN_I_ODD_X;
  const auto to_corner = [&](const Axis& a, Uint odd_step) HN_I_INLINED {
    corner = joined_where(a.is_far, corner, a.here, a.ahead);
    corner_odd = plus_where(a.is_far, corner_odd, odd_step);
  };
  to_corner(ax, kOddX);
  to_corner(ay, kOddY);
  to_corner(az, kOddZ);
  const hn_i_num largest = max(max(ax.size, ay.size), az.size), smallest = min(min(ax.size, ay.size), az.size);
  const hn_i_num sum = ax.size + ay.size + az.size;
  const auto q = hn_i_square(ax.near_by, ay.near_by, az.near_by);
  // The falloffs of body_centred_lattice.glsl. None is rounded more often here, nor where it is larger: so the error of
  // HN_FAST keeps its proven bound. Differences from 1/2 and 3/4 are rounded as those of the text, and then doubled as
  // those.
#if HN_ARITHMETIC == HN_FAST
  const auto positive = [](Float t) HN_I_INLINED { return max(t, Float(0.0f)); };
  const Float t_corner = 1.0f - 2.0f * q, t_centre = t_corner + 2.0f * (sum - 0.75f);
  const vec4 t(positive(t_corner), positive(t_corner + 4.0f * (largest - 0.5f)), positive(t_centre),
               positive(t_centre - 4.0f * smallest));
#else
  const auto q_centre = hn_i_square_plus(q, HN_I_ONE * 3 / 4 - sum);
  const hn_i_num4 t(hn_i_falloff(q, 1024, 2), hn_i_falloff(hn_i_square_plus(q, one - (largest + largest)), 1024, 2),
                    hn_i_falloff(q_centre, 1024, 2),
                    hn_i_falloff(hn_i_square_plus(q_centre, smallest + smallest), 1024, 2));
#endif
  const auto weighted = [](Uint join, Uint second, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num near_by) HN_I_INLINED {
    return weighted_ramp<3>(hn_i_weight4(near_by), along_hashed(hn_i_point_hash(join, second), hn_i_offset(x),
                                                                hn_i_offset(y), hn_i_offset(z)));
  };
  hn_i_num n = weighted(corner, corner_odd, ax.near_by, ay.near_by, az.near_by, t.x);
  const auto to_next = [&](const Axis& a) HN_I_INLINED {
    const Mask is_next = a.size >= largest;
    corner = joined_where(is_next, corner, a.here, a.ahead);
    corner_odd = plus_where(is_next, corner_odd, a.step);
    return plus_where(is_next, a.near_by, a.other);
  };
  const hn_i_num x = to_next(ax), y = to_next(ay), z = to_next(az);
  n += weighted(corner, corner_odd, x, y, z, t.y);
  n += weighted(centre, centre_odd, ax.inner, ay.inner, az.inner, t.z);
  const auto to_next_centre = [&](const Axis& a) HN_I_INLINED {
    const Mask is_next = a.size <= smallest;
    centre = joined_where(is_next, centre, a.here, select(a.is_far, a.ahead, a.before));
    centre_odd = minus_where(is_next, centre_odd, a.step);
    // With a constant of its own GCC keeps fewer masks. A processor has seven registers for them.
    return kCount == 16 ? plus_where(is_next, a.inner, one_of(a.is_far, -one, one))
                        : minus_where(is_next, a.inner, a.other);
  };
  const hn_i_num cx = to_next_centre(ax), cy = to_next_centre(ay), cz = to_next_centre(az);
  return scaled_simplex<3>(n + weighted(centre, centre_odd, cx, cy, cz, t.w));
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
