// hashnoise: positions that are integers, as a cell and the place in it.
// SPDX-License-Identifier: MIT
//
// A float that was divided or multiplied need not have the same bits on two machines, and then not even HN_FIXED can
// return the same noise on both. These functions compute in integers, so a server and its clients agree:
//
//   hn_perlin(hn_place(p, 3, 100), seed)    // p counts units; 3 cells are 100 units long

#ifndef HN_POSITION_GLSL
#define HN_POSITION_GLSL

#include "place.glsl"

// The cell along one axis, and what is left, in units of 1 / units of a cell. The division is rounded down. GLSL leaves
// / and % of negative numbers open, so these count back from -1.
HN_FN hn_uvec2 hn_i_divided(hn_int position, hn_int cells, hn_int units) {
  hn_uint factor = uint(min(max(cells, 1), 65536));
  hn_uint size = uint(min(max(units, 1), 65536));
  hn_uint sign = uint(position >> 31);  // all bits of a negative number
  hn_uint m = uint(position) ^ sign;
  hn_uint whole = m / size;
  hn_uint rest = m - whole * size;
  rest = (rest ^ sign) + (size & sign);
  rest *= factor;  // below 2^32
  hn_uint more = rest / size;
  return uvec2((whole ^ sign) * factor + more, rest - more * size);
}

// A rest below 2^16 as a fraction, in two digits of 12 bits, since a division of floats is not exact in GLSL.
HN_FN hn_float hn_i_fraction_of_units(hn_uint rest, hn_int units) {
  hn_uint size = uint(min(max(units, 1), 65536));
  hn_uint high = (rest << 12u) / size;
  hn_uint low = (((rest << 12u) - high * size) << 12u) / size;
  return HN_I_NOT_WHOLE(hn_i_float((high << 12u) | low) * (1.0f / HN_I_FLOAT_UNITS_POSITION));
}

// The cell of a position that is a whole number of units, in a world where so many cells are so many units long.
//   position  a whole number of units: int, ivec2, ivec3 or ivec4
//   cells     how many, 1 to 65536, usually 1; numbers outside count as the nearer end
//   units     how many units they are long, 1 to 65536; numbers outside count as the nearer end
//   example   ivec2 cell = hn_cell(ivec2(640, -320), 1, 64);
//   returns   floor(position * cells / units), modulo 2^32
//   error     none: integers on every driver, and the same in C++
//   cost      2 divisions of integers per axis; with constants, compilers make products or shifts of them
//   source    docs/reference/contract.md, section 12
HN_FN hn_int hn_cell(hn_int position, hn_int cells, hn_int units) {
  return int(hn_i_divided(position, cells, units).x);
}
HN_FN hn_ivec2 hn_cell(hn_ivec2 position, hn_int cells, hn_int units) {
  return ivec2(hn_cell(position.x, cells, units), hn_cell(position.y, cells, units));
}
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_ivec3 hn_cell(hn_ivec3 position, hn_int cells, hn_int units) {
  return ivec3(hn_cell(position.x, cells, units), hn_cell(position.y, cells, units), hn_cell(position.z, cells, units));
}
HN_FN hn_ivec4 hn_cell(hn_ivec4 position, hn_int cells, hn_int units) {
  return ivec4(hn_cell(position.x, cells, units), hn_cell(position.y, cells, units), hn_cell(position.z, cells, units),
               hn_cell(position.w, cells, units));
}

// The fraction within its cell of a position that is a whole number of units, in a world where so many cells are
// so many units long.
//   (parameters as for hn_cell)
//   example   vec2 f = hn_fraction(ivec2(640, -320), 1, 64);
//   returns   position * cells / units less its floor, cut off to a multiple of 2^-24, in [0, 1)
//   error     less than 2^-24, and the same bits everywhere
//   cost      2 more divisions of integers per axis
//   source    docs/reference/contract.md, section 12
HN_FN hn_float hn_fraction(hn_int position, hn_int cells, hn_int units) {
  return hn_i_fraction_of_units(hn_i_divided(position, cells, units).y, units);
}
HN_FN hn_vec2 hn_fraction(hn_ivec2 position, hn_int cells, hn_int units) {
  return vec2(hn_fraction(position.x, cells, units), hn_fraction(position.y, cells, units));
}
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_vec3 hn_fraction(hn_ivec3 position, hn_int cells, hn_int units) {
  return vec3(hn_fraction(position.x, cells, units), hn_fraction(position.y, cells, units),
              hn_fraction(position.z, cells, units));
}
HN_FN hn_vec4 hn_fraction(hn_ivec4 position, hn_int cells, hn_int units) {
  return vec4(hn_fraction(position.x, cells, units), hn_fraction(position.y, cells, units),
              hn_fraction(position.z, cells, units), hn_fraction(position.w, cells, units));
}

// The place of a position that is a whole number of units, in a world where so many cells are so many units long.
//   (parameters, error and source as for hn_cell and hn_fraction)
//   example   float n = hn_perlin(hn_place(ivec2(640, -320), 1, 64), 7u);
//   returns   hn_place(hn_cell(position, cells, units), hn_fraction(position, cells, units))
//   cost      4 divisions of integers per axis; compilers share what both have in common
HN_FN hn_place2 hn_place(hn_ivec2 position, hn_int cells, hn_int units) {
  return hn_place(hn_cell(position, cells, units), hn_fraction(position, cells, units));
}
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_place1 hn_place(hn_int position, hn_int cells, hn_int units) {
  return hn_place(hn_cell(position, cells, units), hn_fraction(position, cells, units));
}
HN_FN hn_place3 hn_place(hn_ivec3 position, hn_int cells, hn_int units) {
  return hn_place(hn_cell(position, cells, units), hn_fraction(position, cells, units));
}
HN_FN hn_place4 hn_place(hn_ivec4 position, hn_int cells, hn_int units) {
  return hn_place(hn_cell(position, cells, units), hn_fraction(position, cells, units));
}

#endif
