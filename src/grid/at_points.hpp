// Perlin and simplex noise at points that share nothing. Numbers are those of the library, and so are the bits. Three
// parts are computed in another way:
//   - gradients, by instructions that GPUs have not
//   - the second join of a hash, whose low 24 bits count: it is the sum of a product of each coordinate of the cell
//   - the hashes of simplex noise: a step to the next point of the lattice changes both joins of a hash by a term of
//     one
//     axis alone. So each axis is shifted once, and the code chooses between changes, not between coordinates
#pragma once

#include "loops.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {
namespace HN_LANES {
namespace {

// hn_i_direction2: the two bits that choose a component of four are an index. Its sign is that of the table.
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
HN_I_INLINE hn_i_num along3(Uint word, Float x, Float y, Float z) {
  const Float a = hn_i_select(word < 0xAAAAAAAAu, x, y), b = hn_i_select(word < 0x55555555u, y, z);
#if HN_ARITHMETIC == HN_FIXED
  return hn_i_beyond_12(signed_by(a, word, 9u) + 12.0f + signed_by(b, word, 10u));
#else
  return signed_by(a, word, 9u) + signed_by(b, word, 10u);
#endif
}

// The sum, or the exclusive or, where the condition holds. AVX-512 does it in one step, and others do without a choice,
// which takes them up to three.
HN_I_INLINE Uint plus_where(Mask condition, Uint a, Uint b) {
  return kCount == 16 ? hn_i_select(condition, a + b, a) : a + hn_i_select(condition, b, Uint(0u));
}
HN_I_INLINE Uint flipped_where(Mask condition, Uint a, Uint b) {
  return kCount == 16 ? hn_i_select(condition, a ^ b, a) : a ^ hn_i_select(condition, b, Uint(0u));
}

// By how much the second join of a word grows along each axis, and what it is at the origin.
#define HN_GRID_ODD_X hn_i_odd_x(Uint(HN_I_STEP_X), Uint(0u))
#define HN_GRID_ODD_Y hn_i_odd_y(Uint(HN_I_STEP_Y), Uint(0u))
#define HN_GRID_ODD_Z hn_i_odd_z(Uint(HN_I_STEP_Z), Uint(0u))
HN_I_INLINE Uint odd_of(uvec2 c, Uint s) {
  return c.x * HN_GRID_ODD_X + c.y * HN_GRID_ODD_Y + hn_i_odd(s + HN_I_ORIGIN_X);
}
HN_I_INLINE Uint odd_of(uvec3 c, Uint s) { return odd_of(uvec2(c.x, c.y), s) + c.z * HN_GRID_ODD_Z; }

// The words of the corners of a square, as hn_i_corners has them.
HN_I_INLINE uvec4 corners_of(uvec2 lower, uvec2 upper, Uint join, Uint odd) {
  const Uint a = lower.y ^ join, b = upper.y ^ join;
  return uvec4(hn_i_word(lower.x ^ a, odd), hn_i_word(upper.x ^ a, odd + HN_GRID_ODD_X),
               hn_i_word(lower.x ^ b, odd + HN_GRID_ODD_Y),
               hn_i_word(upper.x ^ b, odd + (HN_GRID_ODD_X + HN_GRID_ODD_Y)));
}

HN_I_INLINE hn_i_num perlin_at(const Place<2>& place, Uint seed) {
  const auto f = place.fraction;
  const auto t = hn_i_fade(f);
  const Uint s = hn_i_mix(seed);
  const auto box = hn_i_box(place);
  const uvec4 h =
      corners_of(hn_i_high(box.lower), hn_i_high(box.upper), hn_i_seed_join(s), odd_of(uvec2(place.cell), s));
  const hn_i_num x1 = hn_i_minus_one(f.x), y1 = hn_i_minus_one(f.y);
  return hn_i_scaled2(hn_i_face2(
      hn_i_vector(along2(h.x, f.x, f.y), along2(h.y, x1, f.y), along2(h.z, f.x, y1), along2(h.w, x1, y1)), t.x, t.y));
}
HN_I_INLINE hn_i_num perlin_at(const Place<3>& place, Uint seed) {
  const auto f = place.fraction;
  const auto t = hn_i_fade(f);
  const Uint s = hn_i_mix(seed);
  const auto box = hn_i_box(place);
  const uvec3 lower = hn_i_high(box.lower), upper = hn_i_high(box.upper);
  const Uint odd = odd_of(uvec3(place.cell), s);
  const Float x = hn_i_offset(f.x), x1 = hn_i_far(x);
  const Float y = hn_i_offset(f.y), y1 = hn_i_far(y);
  const auto face = [&](Uint high, Uint second, hn_i_num along) HN_I_INLINED {
    const uvec4 h = corners_of(uvec2(lower.x, lower.y), uvec2(upper.x, upper.y), high ^ hn_i_seed_join(s), second);
    const Float z = hn_i_offset(along);
    return hn_i_face3(
        hn_i_vector(along3(h.x, x, y, z), along3(h.y, x1, y, z), along3(h.z, x, y1, z), along3(h.w, x1, y1, z)), t.x,
        t.y);
  };
  const hn_i_num front = face(lower.z, odd, f.z);
  return hn_i_scaled3(hn_i_lerp(front, face(upper.z, odd + HN_GRID_ODD_Z, hn_i_minus_one(f.z)), t.z));
}

HN_I_INLINE hn_i_num simplex_at(const Place<2>& place, Uint seed) {
  const hn_i_num2 skewed = hn_i_skewed(place.fraction);
  const Int row = hn_i_floor(skewed.y);
  const Mask is_odd = (row & 1) != 0, is_along = hn_i_fract(skewed.x) > hn_i_fract(skewed.y);
  const uvec2 point(hn_i_doubled(Uint(place.cell.x), hn_i_column_of(skewed)), hn_i_doubled(Uint(place.cell.y), row));
  const uvec2 first = hn_i_spread(point);
  const uvec2 next = hn_i_upper(first);
  const Uint s = hn_i_mix(seed);
  const Uint lower = hn_i_high(first).y ^ hn_i_seed_join(s), upper = hn_i_high(next).y ^ hn_i_seed_join(s);
  const Uint step_x = HN_GRID_ODD_X, odd = odd_of(point, s);
  const Uint last = plus_where(is_odd, first.x, Uint(HN_I_STEP_X));
  const Uint last_odd = plus_where(is_odd, odd + HN_GRID_ODD_Y, step_x);
  const Uint middle = hn_i_select(is_along, next.x, last - HN_I_STEP_X);
  const Uint middle_odd = hn_i_select(is_along, odd + step_x, last_odd - step_x);
  const hn_i_num3 x = hn_i_triangle_x(skewed), y = hn_i_triangle_y(skewed), t = hn_i_triangle_falloff(x, y);
  const auto weighted = [](Uint word, hn_i_num along_x, hn_i_num along_y, hn_i_num near_by) HN_I_INLINED {
    return hn_i_weighted_ramp(hn_i_ramp_of2(along2(word, along_x, along_y)), hn_i_weight_plane(near_by));
  };
  hn_i_num n = weighted(hn_i_word(hn_i_high(first.x) ^ lower, odd), x.x, y.x, t.x);
  const Uint middle_join = hn_i_high(middle) ^ hn_i_select(is_along, lower, upper);
  n = hn_i_plus(n, weighted(hn_i_word(middle_join, middle_odd), x.y, y.y, t.y));
  return hn_i_scaled_simplex2(hn_i_plus(n, weighted(hn_i_word(hn_i_high(last) ^ upper, last_odd), x.z, y.z, t.z)));
}

HN_I_INLINE hn_i_num simplex_at(const Place<3>& place, Uint seed) {
  const hn_i_num3 f = place.fraction;
  const hn_i_block3 block = hn_i_block(place);
  hn_i_num4 x, y, z, t;
  hn_i_four_points(hn_i_block3{}, f, Uint(0u), x, y, z, t);  // without the words
  const hn_i_num3 size = hn_i_vector(hn_i_size(x.x), hn_i_size(y.x), hn_i_size(z.x));
  const hn_i_num a = hn_i_largest(size), b = hn_i_smallest(size);
  const Uint s = hn_i_mix(seed);
  const uvec3 here = hn_i_high(block.cell), ahead = hn_i_high(block.following), before = hn_i_high(block.previous);
  const Uint cell = here.x ^ here.y ^ here.z ^ hn_i_seed_join(s), odd = odd_of(uvec3(place.cell), s);
  Uint corner = cell, corner_odd = odd;
  const auto to_corner = [&](hn_i_num along, Uint high, Uint high_ahead, Uint step) HN_I_INLINED {
    corner = flipped_where(along > hn_i_quarters(2), corner, high ^ high_ahead);
    corner_odd = plus_where(along > hn_i_quarters(2), corner_odd, step);
  };
  to_corner(f.x, here.x, ahead.x, HN_GRID_ODD_X);
  to_corner(f.y, here.y, ahead.y, HN_GRID_ODD_Y);
  to_corner(f.z, here.z, ahead.z, HN_GRID_ODD_Z);
  const Uint centre = cell ^ HN_I_CENTRE_JOIN, centre_odd = hn_i_odd_x(Uint(HN_I_CENTRE_SUM), odd);
  Uint next_corner = corner, next_corner_odd = corner_odd, next_centre = centre, next_centre_odd = centre_odd;
  const auto to_next = [&](hn_i_num along, hn_i_num size_along, Uint high, Uint high_ahead, Uint high_before,
                           Uint step) HN_I_INLINED {
    const Mask is_far = along > hn_i_quarters(2);
    next_corner = flipped_where(size_along >= a, next_corner, high ^ high_ahead);
    next_corner_odd = plus_where(size_along >= a, next_corner_odd, hn_i_select(is_far, 0u - step, step));
    next_centre = flipped_where(size_along <= b, next_centre, high ^ hn_i_select(is_far, high_ahead, high_before));
    next_centre_odd = plus_where(size_along <= b, next_centre_odd, hn_i_select(is_far, step, 0u - step));
  };
  to_next(f.x, size.x, here.x, ahead.x, before.x, HN_GRID_ODD_X);
  to_next(f.y, size.y, here.y, ahead.y, before.y, HN_GRID_ODD_Y);
  to_next(f.z, size.z, here.z, ahead.z, before.z, HN_GRID_ODD_Z);
  const auto weighted = [](Uint join, Uint second, hn_i_num along_x, hn_i_num along_y, hn_i_num along_z,
                           hn_i_num near_by) HN_I_INLINED {
    const hn_i_num n =
        along3(hn_i_word(join, second), hn_i_offset(along_x), hn_i_offset(along_y), hn_i_offset(along_z));
    return hn_i_weighted_ramp(hn_i_ramp_of3(n), hn_i_weight4(near_by));
  };
  hn_i_num n = weighted(corner, corner_odd, x.x, y.x, z.x, t.x);
  n = hn_i_plus(n, weighted(next_corner, next_corner_odd, x.y, y.y, z.y, t.y));
  n = hn_i_plus(n, weighted(centre, centre_odd, x.z, y.z, z.z, t.z));
  return hn_i_scaled_simplex3(hn_i_plus(n, weighted(next_centre, next_centre_odd, x.w, y.w, z.w, t.w)));
}

}  // namespace
}  // namespace HN_LANES
}  // namespace hashnoise
