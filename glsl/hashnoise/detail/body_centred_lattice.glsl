// hashnoise: the body-centred lattice of simplex noise in three and four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_BODY_CENTRED_LATTICE_GLSL
#define HN_BODY_CENTRED_LATTICE_GLSL

#include "block.glsl"
#include "direction3d.glsl"
#include "direction4d.glsl"
#include "falloff.glsl"

// The points are the corners of all cells and their centres: so a cell has two points. In space this is the lattice of
// classic simplex noise, without its skew. Every whole period fits, and the coordinates are halves, so they are exact.
//
// A corner has the hash of its cell. A centre has the hash of its cell with one coordinate more, which is 1. It is
// spread with the fifth prime of xxHash, and its high 24 bits count. So it adds constants to both joins of the hash.
#define HN_I_CENTRE_SUM 0x165667B1u
#define HN_I_CENTRE_JOIN 0x00165667u

// Chooses b along each axis where the place is nearer to the far end of the cell, else a.
HN_FN hn_uvec3 hn_i_nearer(hn_i_num3 f, hn_uvec3 a, hn_uvec3 b) {
  hn_i_num middle = hn_i_quarters(2);
  return uvec3(hn_i_select(f.x > middle, b.x, a.x), hn_i_select(f.y > middle, b.y, a.y),
               hn_i_select(f.z > middle, b.z, a.z));
}
HN_FN hn_uvec4 hn_i_nearer(hn_i_num4 f, hn_uvec4 a, hn_uvec4 b) {
  return uvec4(hn_i_nearer(hn_i_vector(f.x, f.y, f.z), uvec3(a.x, a.y, a.z), uvec3(b.x, b.y, b.z)),
               hn_i_select(f.w > hn_i_quarters(2), b.w, a.w));
}

// The offsets along one axis: from the nearest corner of the cell, from the farthest, from the centre of the cell, and
// from the nearest centre of another cell.
HN_FN hn_i_num4 hn_i_offsets(hn_i_num f) {
  hn_i_num middle = hn_i_quarters(2);
  hn_i_num ahead = hn_i_minus_one(f);
  hn_i_num inner = hn_i_minus(f, middle);
  return hn_i_vector(hn_i_select(f > middle, ahead, f), hn_i_select(f > middle, f, ahead), inner,
                     hn_i_select(f > middle, hn_i_minus(inner, HN_I_ONE), hn_i_minus(inner, -HN_I_ONE)));
}

// The ramp of a point in space, before it is weighted. The gradient may be rotated by a sixth of a turn.
HN_FN hn_i_num hn_i_ramp_of(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num z, bool turned) {
  return hn_i_ramp_of3(hn_i_along3(h, hn_i_offset(x), hn_i_offset(y), hn_i_offset(z), turned));
}

// A sum of weighted ramps is at most 1024 / 4918 in space, and 1024 / 4298 in four dimensions (tools/make bounds).
HN_FN hn_i_num hn_i_scaled_simplex3(hn_i_num n) { return hn_i_scaled(n, 4918); }
HN_FN hn_i_num hn_i_scaled_simplex4(hn_i_num n) { return hn_i_scaled_ramps(n, 4298); }

// ---------------------------------------------------------------------------------------------------------------------
// The points of a small kernel. At a place within 1/2 of a point along every axis, only that point and its neighbour
// along the largest offset are nearer than the square root of 1/2. For another neighbour, along an axis with the offset
// b, the squared distance is (1 - b)^2 and at least b^2 from the largest offset: that is 1/2 or more. So two points of
// each kind are enough: the nearest corner, the next one, the nearest centre and the next one. Ties need no care: where
// two offsets are the largest, both neighbours are at the radius or beyond it.

HN_FN hn_i_num hn_i_largest(hn_i_num3 size) { return max(max(size.x, size.y), size.z); }
HN_FN hn_i_num hn_i_smallest(hn_i_num3 size) { return min(min(size.x, size.y), size.z); }
HN_FN hn_i_num hn_i_largest(hn_i_num4 size) { return max(max(size.x, size.y), max(size.z, size.w)); }
HN_FN hn_i_num hn_i_smallest(hn_i_num4 size) { return min(min(size.x, size.y), min(size.z, size.w)); }

// The hashes of the four points of a cell and, through the out parameters, the offsets from them along each axis and
// how near they are. The size of an offset from a centre is 1/2 less that from a corner: so it is the largest where
// that is the smallest. The squares of the distances differ by sums of sizes alone.
HN_FN hn_uvec4 hn_i_four_points(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_uint seed, HN_I_OUT(hn_i_num4) x,
                                HN_I_OUT(hn_i_num4) y, HN_I_OUT(hn_i_num4) z, HN_I_OUT(hn_i_num4) near_by) {
  hn_i_num4 dx = hn_i_offsets(f.x);
  hn_i_num4 dy = hn_i_offsets(f.y);
  hn_i_num4 dz = hn_i_offsets(f.z);
  hn_i_num3 size = hn_i_vector(hn_i_magnitude(dx.x), hn_i_magnitude(dy.x), hn_i_magnitude(dz.x));
  hn_i_num a = hn_i_largest(size);
  hn_i_num b = hn_i_smallest(size);
  x = hn_i_vector(dx.x, hn_i_select(size.x >= a, dx.y, dx.x), dx.z, hn_i_select(size.x <= b, dx.w, dx.z));
  y = hn_i_vector(dy.x, hn_i_select(size.y >= a, dy.y, dy.x), dy.z, hn_i_select(size.y <= b, dy.w, dy.z));
  z = hn_i_vector(dz.x, hn_i_select(size.z >= a, dz.y, dz.x), dz.z, hn_i_select(size.z <= b, dz.w, dz.z));
  hn_i_square_number q = hn_i_square(dx.x, dy.x, dz.x);
  hn_i_num sum = hn_i_plus(hn_i_plus(size.x, size.y), size.z);
  hn_i_square_number q_centre = hn_i_square_plus(q, hn_i_minus(hn_i_quarters(3), sum));
  near_by = hn_i_vector(
      hn_i_falloff(q, 1024, 2), hn_i_falloff(hn_i_square_plus(q, hn_i_minus(HN_I_ONE, hn_i_plus(a, a))), 1024, 2),
      hn_i_falloff(q_centre, 1024, 2), hn_i_falloff(hn_i_square_plus(q_centre, hn_i_plus(b, b)), 1024, 2));
  hn_uvec3 cell = cells.cell;
  hn_uvec3 corner = hn_i_nearer(f, cell, cells.following);
  hn_uvec3 opposite = hn_i_nearer(f, cells.following, cell);
  hn_uvec3 next_centre = hn_i_nearer(f, cells.previous, cells.following);
  hn_uint s = hn_i_scramble(seed);
  return uvec4(hn_i_seeded_hash(corner, s),
               hn_i_seeded_hash(
                   uvec3(hn_i_select(size.x >= a, opposite.x, corner.x), hn_i_select(size.y >= a, opposite.y, corner.y),
                         hn_i_select(size.z >= a, opposite.z, corner.z)),
                   s),
               hn_i_point_hash(cell, hn_i_seed_join(s) ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM),
               hn_i_point_hash(uvec3(hn_i_select(size.x <= b, next_centre.x, cell.x),
                                     hn_i_select(size.y <= b, next_centre.y, cell.y),
                                     hn_i_select(size.z <= b, next_centre.z, cell.z)),
                               hn_i_seed_join(s) ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM));
}

HN_FN hn_uvec4 hn_i_four_points(hn_i_neighbourhood4 cells, hn_i_num4 f, hn_uint seed, HN_I_OUT(hn_i_num4) x,
                                HN_I_OUT(hn_i_num4) y, HN_I_OUT(hn_i_num4) z, HN_I_OUT(hn_i_num4) w,
                                HN_I_OUT(hn_i_num4) near_by) {
  hn_i_num4 dx = hn_i_offsets(f.x);
  hn_i_num4 dy = hn_i_offsets(f.y);
  hn_i_num4 dz = hn_i_offsets(f.z);
  hn_i_num4 dw = hn_i_offsets(f.w);
  hn_i_num4 size = hn_i_vector(hn_i_magnitude(dx.x), hn_i_magnitude(dy.x), hn_i_magnitude(dz.x), hn_i_magnitude(dw.x));
  hn_i_num a = hn_i_largest(size);
  hn_i_num b = hn_i_smallest(size);
  x = hn_i_vector(dx.x, hn_i_select(size.x >= a, dx.y, dx.x), dx.z, hn_i_select(size.x <= b, dx.w, dx.z));
  y = hn_i_vector(dy.x, hn_i_select(size.y >= a, dy.y, dy.x), dy.z, hn_i_select(size.y <= b, dy.w, dy.z));
  z = hn_i_vector(dz.x, hn_i_select(size.z >= a, dz.y, dz.x), dz.z, hn_i_select(size.z <= b, dz.w, dz.z));
  w = hn_i_vector(dw.x, hn_i_select(size.w >= a, dw.y, dw.x), dw.z, hn_i_select(size.w <= b, dw.w, dw.z));
  hn_i_square_number q = hn_i_square(dx.x, dy.x, dz.x, dw.x);
  hn_i_num sum = hn_i_plus(hn_i_plus(size.x, size.y), hn_i_plus(size.z, size.w));
  hn_i_square_number q_centre = hn_i_square_plus(q, hn_i_minus(HN_I_ONE, sum));
  near_by = hn_i_vector(
      hn_i_falloff(q, 1024, 2), hn_i_falloff(hn_i_square_plus(q, hn_i_minus(HN_I_ONE, hn_i_plus(a, a))), 1024, 2),
      hn_i_falloff(q_centre, 1024, 2), hn_i_falloff(hn_i_square_plus(q_centre, hn_i_plus(b, b)), 1024, 2));
  hn_uvec4 cell = cells.cell;
  hn_uvec4 corner = hn_i_nearer(f, cell, cells.following);
  hn_uvec4 opposite = hn_i_nearer(f, cells.following, cell);
  hn_uvec4 next_centre = hn_i_nearer(f, cells.previous, cells.following);
  hn_uint s = hn_i_scramble(seed);
  return uvec4(
      hn_i_seeded_hash(corner, s),
      hn_i_seeded_hash(
          uvec4(hn_i_select(size.x >= a, opposite.x, corner.x), hn_i_select(size.y >= a, opposite.y, corner.y),
                hn_i_select(size.z >= a, opposite.z, corner.z), hn_i_select(size.w >= a, opposite.w, corner.w)),
          s),
      hn_i_point_hash(cell, hn_i_seed_join(s) ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM),
      hn_i_point_hash(
          uvec4(hn_i_select(size.x <= b, next_centre.x, cell.x), hn_i_select(size.y <= b, next_centre.y, cell.y),
                hn_i_select(size.z <= b, next_centre.z, cell.z), hn_i_select(size.w <= b, next_centre.w, cell.w)),
          hn_i_seed_join(s) ^ HN_I_CENTRE_JOIN, s + HN_I_CENTRE_SUM));
}

#endif
