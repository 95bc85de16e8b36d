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

// hn_i_direction2: the two bits that choose a component of four are an index. Its sign is the table's.
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
HN_I_INLINE vec2 direction2(Uint word) { return hn_i_direction2(word); }
#endif
HN_I_INLINE hn_i_num along2(Uint word, hn_i_num x, hn_i_num y) {
  return hn_i_along2(direction2(word), hn_i_offset(x), hn_i_offset(y));
}

// hn_i_along3: the signs are flipped in place of being multiplied, and where a choice takes more than one step, it is
// made of what two offsets differ by.
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
HN_I_INLINE hn_i_num along3(Uint word, Float x, Float y, Float z) {
  const Float a = hn_i_select(is_below(word, 0xAAAAAAAAu), x, y), b = hn_i_select(is_below(word, 0x55555555u), y, z);
#if HN_ARITHMETIC == HN_FIXED
  return hn_i_beyond_12(signed_by(a, word, 9u) + 12.0f + signed_by(b, word, 10u));
#else
  return signed_by(a, word, 9u) + signed_by(b, word, 10u);
#endif
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
  return kCount == 16 ? hn_i_select(condition, a + b, a) : a + where(condition, b);
}
template <typename S>
HN_I_INLINE Lanes<S> minus_where(Mask condition, Lanes<S> a, Lanes<S> b) {
  return kCount == 16 ? hn_i_select(condition, a - b, a) : a - where(condition, b);
}
HN_I_INLINE Uint joined(Uint a, Uint b, Uint c) {
#if defined(__AVX512F__)
  return Uint(detail::UintVector(_mm512_ternarylogic_epi32(__m512i(a.v), __m512i(b.v), __m512i(c.v), 0x96)));
#else
  return a ^ (b ^ c);
#endif
}
HN_I_INLINE Uint joined_where(Mask condition, Uint a, Uint b, Uint c) {
  return kCount == 16 ? hn_i_select(condition, joined(a, b, c), a) : a ^ where(condition, b ^ c);
}
// The first number where the condition holds, else the second.
HN_I_INLINE Uint either(Mask condition, Uint a, Uint b) {
  return kCount == 16 ? hn_i_select(condition, a, b) : b + where(condition, a - b);
}
template <typename S>
HN_I_INLINE Lanes<S> one_of(Mask condition, Lanes<S> a, Lanes<S> b) {
  if (kCount == 16) return hn_i_select(condition, a, b);
  const auto bits = [](Lanes<S> n) HN_I_INLINED { return __builtin_bit_cast(detail::UintVector, n.v); };
  const Uint change(bits(a) ^ bits(b));
  return Lanes<S>(__builtin_bit_cast(typename Lanes<S>::Vector, bits(b) ^ where(condition, change).v));
}

// By how much the second join of a word grows along each axis, and what it is at the origin.
#define HN_GRID_ODD_X hn_i_odd_x(Uint(HN_I_STEP_X), Uint(0u))
#define HN_GRID_ODD_Y hn_i_odd_y(Uint(HN_I_STEP_Y), Uint(0u))
#define HN_GRID_ODD_Z hn_i_odd_z(Uint(HN_I_STEP_Z), Uint(0u))
HN_I_INLINE Uint odd_of(uvec2 c, Uint s) {
  return c.x * HN_GRID_ODD_X + c.y * HN_GRID_ODD_Y + hn_i_odd(s + HN_I_ORIGIN_X);
}
HN_I_INLINE Uint odd_of(uvec3 c, Uint s) { return odd_of(uvec2(c.x, c.y), s) + c.z * HN_GRID_ODD_Z; }

// Calls a function with both joins of each corner of a square, and returns the four results. With hn_i_point_hash they
// are the words that hn_i_corner_hashes has.
template <typename Function>
HN_I_INLINE auto corners_of(uvec2 lower, uvec2 upper, Uint join, Uint odd, const Function& of) {
  return Vector4<decltype(of(join, odd))>(of(joined(lower.x, lower.y, join), odd),
                                          of(joined(upper.x, lower.y, join), odd + HN_GRID_ODD_X),
                                          of(joined(lower.x, upper.y, join), odd + HN_GRID_ODD_Y),
                                          of(joined(upper.x, upper.y, join), odd + (HN_GRID_ODD_X + HN_GRID_ODD_Y)));
}
HN_I_INLINE uvec4 corners_of(uvec2 lower, uvec2 upper, Uint join, Uint odd) {
  return corners_of(lower, upper, join, odd, [](Uint a, Uint b) HN_I_INLINED { return hn_i_point_hash(a, b); });
}

// The numbers of the corners. They are the low 23 bits of a word, and the second join need not be cut off to 24 for
// these: the low bits of a product are made of low bits alone.
static_assert(HN_HASH == HN_HASH_LATTICE);
HN_I_INLINE hn_i_num4 numbers_of(uvec2 lower, uvec2 upper, Uint join, Uint odd) {
  return corners_of(lower, upper, join, odd, [](Uint a, Uint b) HN_I_INLINED { return hn_i_number(a * b); });
}
HN_I_INLINE hn_i_num value_at(const Place<2>& place, Uint seed) {
  const auto t = hn_i_fade(place.fraction);
  const Uint s = hn_i_scramble(seed);
  const auto corners = hn_i_cell_corners(place);
  return hn_i_noise_of_numbers(hn_i_lerp(
      numbers_of(hn_i_high(corners.lower), hn_i_high(corners.upper), hn_i_seed_join(s), odd_of(uvec2(place.cell), s)),
      t.x, t.y));
}
HN_I_INLINE hn_i_num value_at(const Place<3>& place, Uint seed) {
  const auto t = hn_i_fade(place.fraction);
  const Uint s = hn_i_scramble(seed);
  const auto corners = hn_i_cell_corners(place);
  const uvec3 lower = hn_i_high(corners.lower), upper = hn_i_high(corners.upper);
  const Uint odd = odd_of(uvec3(place.cell), s);
  const auto face = [&](Uint high, Uint second) HN_I_INLINED {
    return hn_i_lerp(numbers_of(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), high ^ hn_i_seed_join(s), second),
                     t.x, t.y);
  };
  return hn_i_noise_of_numbers(hn_i_lerp(face(lower.z, odd), face(upper.z, odd + HN_GRID_ODD_Z), t.z));
}

HN_I_INLINE hn_i_num perlin_at(const Place<2>& place, Uint seed) {
  const auto f = place.fraction;
  const auto t = hn_i_fade(f);
  const Uint s = hn_i_scramble(seed);
  const auto corners = hn_i_cell_corners(place);
  const uvec4 h =
      corners_of(hn_i_high(corners.lower), hn_i_high(corners.upper), hn_i_seed_join(s), odd_of(uvec2(place.cell), s));
  const hn_i_num x1 = hn_i_minus_one(f.x), y1 = hn_i_minus_one(f.y);
  return hn_i_scaled2(hn_i_bilerp_ramps2(
      hn_i_vector(along2(h.x, f.x, f.y), along2(h.y, x1, f.y), along2(h.z, f.x, y1), along2(h.w, x1, y1)), t.x, t.y));
}
HN_I_INLINE hn_i_num perlin_at(const Place<3>& place, Uint seed) {
  const auto f = place.fraction;
  const auto t = hn_i_fade(f);
  const Uint s = hn_i_scramble(seed);
  const auto corners = hn_i_cell_corners(place);
  const uvec3 lower = hn_i_high(corners.lower), upper = hn_i_high(corners.upper);
  const Uint odd = odd_of(uvec3(place.cell), s);
  const Float x = hn_i_offset(f.x), x1 = hn_i_far(x);
  const Float y = hn_i_offset(f.y), y1 = hn_i_far(y);
  const auto face = [&](Uint high, Uint second, hn_i_num along) HN_I_INLINED {
    const uvec4 h = corners_of(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), high ^ hn_i_seed_join(s), second);
    const Float z = hn_i_offset(along);
    return hn_i_bilerp_ramps3(
        hn_i_vector(along3(h.x, x, y, z), along3(h.y, x1, y, z), along3(h.z, x, y1, z), along3(h.w, x1, y1, z)), t.x,
        t.y);
  };
  const hn_i_num front = face(lower.z, odd, f.z);
  return hn_i_scaled3(hn_i_lerp(front, face(upper.z, odd + HN_GRID_ODD_Z, hn_i_minus_one(f.z)), t.z));
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
    const auto beyond = [](Int x, Int) HN_I_INLINED { return hn_i_fract(x); };
#else
    const auto beyond = [](Float x, Int whole) HN_I_INLINED { return x - Float(whole); };
#endif
    const Int column = hn_i_truncate(skewed.x);
    u = beyond(skewed.x, column);
#if HN_ARITHMETIC == HN_FAST
    // A fraction of 1 is the upper end of the second row, and not the first place of a third. It is the same place.
    is_odd = place.fraction.y >= 0.5f;
    v = minus_where(is_odd, skewed.y, Float(1.0f));
    first = uvec2(doubled.x + minus_where(is_odd, Uint(column), Uint(1u)), plus_where(is_odd, doubled.y, Uint(1u)));
#else
    const Int row = hn_i_truncate(skewed.y);
    v = beyond(skewed.y, row);
    is_odd = (row & 1) != 0;
    first = uvec2(doubled.x + Uint(column) - Uint(min(row, Int(1))), doubled.y + Uint(row));
#endif
  }
};

HN_I_INLINE hn_i_num simplex_at(const Place<2>& place, Uint seed) {
  const Skewed at(place);
  const uvec2 first = hn_i_spread(at.first);
  const uvec2 next = hn_i_upper(first);
  const Uint s = hn_i_scramble(seed);
  const Uint lower = hn_i_high(first).y ^ hn_i_seed_join(s), upper = hn_i_high(next).y ^ hn_i_seed_join(s);
  const Uint step_x = HN_GRID_ODD_X, odd = odd_of(at.first, s);
  const Uint last = plus_where(at.is_odd, first.x, Uint(HN_I_STEP_X));
  const Uint last_odd = plus_where(at.is_odd, odd + HN_GRID_ODD_Y, step_x);
  const Mask is_along = at.u > at.v;
  const Uint middle = either(is_along, next.x, last - HN_I_STEP_X);
  const Uint middle_odd = either(is_along, odd + step_x, last_odd - step_x);
  const auto corner = [](Uint join, Uint second, hn_i_num x, hn_i_num y) HN_I_INLINED {
#if HN_ARITHMETIC == HN_FAST  // rounded four times, as hn_i_falloff of hn_i_square is, or twice where steps are fused
    const Float t = max(HN_I_TRIANGLE_RADIUS / 1024.0f - x * x - y * y, Float(0.0f));
#else
    const hn_i_num t = hn_i_falloff(hn_i_square(x, y), HN_I_TRIANGLE_RADIUS, 1);
#endif
    return hn_i_weighted_ramp(hn_i_ramp_of2(along2(hn_i_point_hash(join, second), x, y)), hn_i_weight_plane(t));
  };
  const hn_i_num x = hn_i_minus(at.u, hn_i_half(at.v)), one = HN_I_ONE, half = hn_i_quarters(2);
  const hn_i_num y = hn_i_minus(at.v, one);
  hn_i_num n = corner(hn_i_high(first.x) ^ lower, odd, x, at.v);
  n = hn_i_plus(n, corner(hn_i_high(middle) ^ either(is_along, lower, upper), middle_odd,
                          hn_i_plus(x, one_of(is_along, -one, half)),
                          kCount == 16 ? hn_i_select(is_along, at.v, y) : minus_where(at.u <= at.v, at.v, one)));
  return hn_i_scaled_simplex2(hn_i_plus(n, corner(hn_i_high(last) ^ upper, last_odd, hn_i_minus(x, half), y)));
}

HN_I_INLINE hn_i_num simplex_at(const Place<3>& place, Uint seed) {
  const hn_i_num3 f = place.fraction;
  const hn_i_num one = HN_I_ONE, half = hn_i_quarters(2);
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
    a.inner = hn_i_minus(along, half);
    a.size = hn_i_magnitude(a.near_by);
    a.other = one_of(a.is_far, one, -one);
    a.here = cell >> high;
    a.ahead = (cell + step) >> high;
    a.before = (cell - step) >> high;
    a.step = one_of(a.is_far, 0u - odd_step, odd_step);
    return a;
  };
  const uvec3 cell = hn_i_spread(uvec3(place.cell));
  const Axis ax = axis_of(f.x, cell.x, Uint(HN_I_STEP_X), HN_I_HIGH_X, HN_GRID_ODD_X);
  const Axis ay = axis_of(f.y, cell.y, Uint(HN_I_STEP_Y), HN_I_HIGH_Y, HN_GRID_ODD_Y);
  const Axis az = axis_of(f.z, cell.z, Uint(HN_I_STEP_Z), HN_I_HIGH_Z, HN_GRID_ODD_Z);
  const Uint s = hn_i_scramble(seed);
  Uint corner = joined(ax.here, ay.here, az.here ^ hn_i_seed_join(s)), corner_odd = odd_of(uvec3(place.cell), s);
  Uint centre = corner ^ HN_I_CENTRE_JOIN, centre_odd = hn_i_odd_x(Uint(HN_I_CENTRE_SUM), corner_odd);
  const auto to_corner = [&](const Axis& a, Uint odd_step) HN_I_INLINED {
    corner = joined_where(a.is_far, corner, a.here, a.ahead);
    corner_odd = plus_where(a.is_far, corner_odd, odd_step);
  };
  to_corner(ax, HN_GRID_ODD_X);
  to_corner(ay, HN_GRID_ODD_Y);
  to_corner(az, HN_GRID_ODD_Z);
  const hn_i_num3 size = hn_i_vector(ax.size, ay.size, az.size);
  const hn_i_num largest = hn_i_largest(size), smallest = hn_i_smallest(size);
  const hn_i_num sum = hn_i_plus(hn_i_plus(size.x, size.y), size.z);
  const auto q = hn_i_square(ax.near_by, ay.near_by, az.near_by);
  // The falloffs of hn_i_four_points. None is rounded more often here, nor where it is larger: so the error of HN_FAST
  // keeps its proven bound. Differences from 1/2 and 3/4 are rounded as those of the text, and then doubled as those.
#if HN_ARITHMETIC == HN_FAST
  const auto positive = [](Float t) HN_I_INLINED { return max(t, Float(0.0f)); };
  const Float t_corner = 1.0f - 2.0f * q, t_centre = t_corner + 2.0f * (sum - 0.75f);
  const vec4 t(positive(t_corner), positive(t_corner + 4.0f * (largest - 0.5f)), positive(t_centre),
               positive(t_centre - 4.0f * smallest));
#else
  const auto q_centre = hn_i_square_plus(q, hn_i_minus(hn_i_quarters(3), sum));
  const hn_i_num4 t =
      hn_i_vector(hn_i_falloff(q, 1024, 2),
                  hn_i_falloff(hn_i_square_plus(q, hn_i_minus(one, hn_i_plus(largest, largest))), 1024, 2),
                  hn_i_falloff(q_centre, 1024, 2),
                  hn_i_falloff(hn_i_square_plus(q_centre, hn_i_plus(smallest, smallest)), 1024, 2));
#endif
  const auto weighted = [](Uint join, Uint second, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num near_by) HN_I_INLINED {
    const hn_i_num n = along3(hn_i_point_hash(join, second), hn_i_offset(x), hn_i_offset(y), hn_i_offset(z));
    return hn_i_weighted_ramp(hn_i_ramp_of3(n), hn_i_weight4(near_by));
  };
  hn_i_num n = weighted(corner, corner_odd, ax.near_by, ay.near_by, az.near_by, t.x);
  const auto to_next = [&](const Axis& a) HN_I_INLINED {
    const Mask is_next = a.size >= largest;
    corner = joined_where(is_next, corner, a.here, a.ahead);
    corner_odd = plus_where(is_next, corner_odd, a.step);
    return plus_where(is_next, a.near_by, a.other);
  };
  const hn_i_num x = to_next(ax), y = to_next(ay), z = to_next(az);
  n = hn_i_plus(n, weighted(corner, corner_odd, x, y, z, t.y));
  n = hn_i_plus(n, weighted(centre, centre_odd, ax.inner, ay.inner, az.inner, t.z));
  const auto to_next_centre = [&](const Axis& a) HN_I_INLINED {
    const Mask is_next = a.size <= smallest;
    centre = joined_where(is_next, centre, a.here, hn_i_select(a.is_far, a.ahead, a.before));
    centre_odd = minus_where(is_next, centre_odd, a.step);
    // With a constant of its own GCC keeps fewer masks. A processor has seven registers for them.
    return kCount == 16 ? plus_where(is_next, a.inner, one_of(a.is_far, -one, one))
                        : minus_where(is_next, a.inner, a.other);
  };
  const hn_i_num cx = to_next_centre(ax), cy = to_next_centre(ay), cz = to_next_centre(az);
  return hn_i_scaled_simplex3(hn_i_plus(n, weighted(centre, centre_odd, cx, cy, cz, t.w)));
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
