// The checks, on a library with a fault that each of them must catch.
#include <set>

#include "cases/faulty_library_fixture.hpp"

namespace hn {
namespace {

constexpr LibraryFault kFaults[] = {
    // A function that does not repeat, on each of the ways that a noise can go.
    {"noise2d.perlin_period.lattice.fast.fragment.gl330.period", "perlin2d.glsl", kMacro,
     "hn_perlin(t, args) (hn_perlin(t, args) + 0.00001 * p.x)"},
    {"noise2d.perlin_period.lattice.fast.fragment.es300.period", "perlin2d.glsl", kMacro,
     "hn_perlin(t, args) (hn_perlin(t, args) + 0.00001 * p.x)"},
    {"noise3d.perlin_cell_period.lattice.fast.fragment.gl330.period", "perlin3d.glsl", kMacro,
     "hn_perlin(t, args) (hn_perlin(t, args) + float(cell.z))"},
    {"noise2d.perlin_cell_period.lattice+sine.fast.fragment.gl330.period", "perlin2d.glsl", kMacro,
     "hn_perlin(t, args) (hn_perlin(t, args) + 0.001 * float(cell.y & 64))"},
    // A seam that is one cell late.
    {"noise1d.value_cell_period.lattice.fixed.fragment.gl330.period", "value1d.glsl", kMacro,
     "hn_value(t, args) hn_value(hn_tile(t, period + int(period > 0)), args)"},
    {"noise4d.perlin_d_cell_period.lattice.fast.fragment.gl330.period", "perlin_d4d.glsl", kMacro,
     "hn_perlin_d(t, args) hn_perlin_d(hn_tile(t, ivec4(period.x, period.y, period.z, 0)), args)"},
    {"fbm.clouds3_cell_period.lattice.fast.fragment.gl330.period", "fbm3d.glsl", kMacro,
     "hn_clouds(t, o, l, g, args) (hn_clouds(t, o, l, g, args) + 0.00001 * float(cell.z))"},
    {"fbm.fbm2_period.lattice.fixed.fragment.gl330.period", "fbm2d.glsl", kMacro,
     "hn_fbm(t, o, l, g, args) (hn_fbm(t, o, l, g, args) + 0.0000005 * p.x)"},
    // Only many octaves come to so large a cell.
    {"fbm.fbm2_period.lattice.fixed.fragment.gl330.period", "octaves2d.glsl", "ivec2(o.x.x, o.y.x)",
     "clamp(ivec2(o.x.x, o.y.x), -8388608, 8388607)"},
    {"fbm.billow2_cell_period.lattice.fast.fragment.gl330.period", "detail/octave.glsl",
     "return int(uint(period) * uint(lacunarity));", "return int(uint(period) * uint(lacunarity)) + int(period > 0);"},
    // A tile with axes that change places.
    {"warp.warp_progressive2_cell_period.lattice.fixed.fragment.gl330.period", "octaves2d.glsl", "(x, HN_I_SHIFT_X)",
     "(y, HN_I_SHIFT_X)"},
    // A sum from a cell, in every arithmetic and with a period: the fraction, and a step of only one of the two.
    {"fbm.fbm2_cell.lattice.fast.fragment.gl330.from_cell", "octaves2d.glsl", "place.fraction.x, place.rest.x",
     "0.999f * place.fraction.x, place.rest.x"},
    {"fbm.ridged3_cell.lattice.fixed.fragment.gl330.from_cell", "place.glsl", "(f),", "(f) ^ 256,"},
    {"warp.warp_progressive2_cell.lattice.fast.fragment.gl330.from_cell", "detail/jacobian.glsl", "(n, cells)",
     "(0.5f * n, 0.5f * cells)"},
    {"fbm.fbm2_cell_period.lattice.precise.fragment.gl400.from_cell", "detail/cell2d.glsl", "(f),", "(0.999f * f),"},
    // A whole detail that is no number of octaves.
    {"fbm.fbm2_detail.lattice.fast.fragment.gl330.whole_detail", "detail/octave.glsl", "float(octaves - 1));",
     "float(octaves - 1) + 0.01f);"},
    {"fbm.fbm3_detail.lattice.precise.fragment.gl400.whole_detail", "detail/octave.glsl", "float(octaves - 1));",
     "float(octaves - 1) + 0.00001f);"},
    {"fbm.fbm3_detail.lattice.fixed.fragment.gl330.whole_detail", "detail/octave.glsl", "detail), 32.0f",
     "detail), 31.0f"},
    // A small footprint that fades octaves.
    {"fbm.fbm2_footprint.lattice.fast.fragment.gl330.small_footprint", "detail/octave.glsl", "(1.5f, footprint)",
     "(1.4f, footprint)"},
    {"fbm.fbm3_footprint.lattice.fixed.fragment.gl330.small_footprint", "detail/octave.glsl",
     "3 * HN_I_UNITS_WEIGHT / 2 - (footprint >> 6)", "3 * HN_I_UNITS_WEIGHT / 2 - 16 - (footprint >> 6)"},
    {"fbm.fbm3_footprint.lattice.precise.fragment.gl400.small_footprint", "detail/octave.glsl",
     "(footprint, max(lacunarity, 1.0f))", "(footprint, 2.0f * max(lacunarity, 1.0f))"},
    // A form that is not the one without periods, which is under test as well: so only calls of the one may be wrong.
    // A period of 0 that is one of 2^20, and a large one that counts as none.
    {"noise2d.perlin_cell_period.lattice.fast.fragment.gl330.wrapped", "perlin2d.glsl", "(place)",
     "(hn_tile(place, ivec2(place.tiled && place.period.x == 0 ? 1048576 : place.period.x, place.period.y)))"},
    {"noise3d.value_cell_period.lattice.fixed.fragment.gl330.wrapped", "value3d.glsl", "(place)",
     "(hn_tile(place, ivec3(place.period.xy, place.period.z > 1073741824 ? 0 : place.period.z)))"},
    // Cells below 0 count towards it.
    {"noise2d.value_cubic_cell_period.lattice.precise.fragment.gl400.wrapped", "detail/cell2d.glsl",
     "(c < 0, mask - rest, rest)", "(c < 0, rest, rest)"},
    {"noise1d.perlin_d_cell_period.lattice.fast.fragment.gl330.wrapped", "perlin_d1d.glsl", "place.fraction",
     "place.fraction + (place.tiled ? 0.001 : 0.0)"},
    // Derivatives in every dimension and arithmetic: a sign, a factor, components in another order, and what the
    // slope of the fade curve adds.
    {"noise1d.perlin_d.lattice.fast.fragment.gl330.derivative", "perlin_d1d.glsl", kMacro,
     "hn_perlin_d(args) (vec2(1.0, -1.0) * hn_perlin_d(args))"},
    {"noise2d.value_d.lattice.fast.fragment.gl330.derivative", "value_d2d.glsl", kMacro,
     "hn_value_d(args) (vec3(1.0, 1.0, 1.01) * hn_value_d(args))"},
    {"noise2d.perlin_d_cell.lattice.fixed.fragment.gl330.derivative", "perlin_d2d.glsl", kMacro,
     "hn_perlin_d(c, args) (vec3(1.0, 1.01, 1.0) * hn_perlin_d(c, args))"},
    {"noise3d.perlin_d.lattice.precise.fragment.gl400.derivative", "perlin_d3d.glsl", kMacro,
     "hn_perlin_d(args) hn_perlin_d(args).xzyw"},
    {"noise3d.value_d_cell_period.lattice.fixed.fragment.gl330.derivative", "value_d3d.glsl", kMacro,
     "hn_value_d(t, args) hn_value_d(t, args).xzyw"},
    {"noise4d.perlin_d.lattice.fast.fragment.gl330.derivative", "detail/derivative.glsl", "return s;",
     "return 0.0 * s;"},
    {"noise2d.perlin_d.lattice.fast.fragment.gl330.derivative", "detail/derivative.glsl", "return s;",
     "return 0.0 * s;"},
    {"noise3d.value_d.lattice.fixed.fragment.gl330.derivative", "detail/derivative.glsl", "+ 4096u) >> 13u)",
     "+ 4096u) >> 13u) / 128 * 127"},
    // Derivatives of sums: a sign, components in another order, an octave that does not grow, and a rotation in the
    // other direction.
    {"fbm_d.fbm_d2.lattice.fast.fragment.gl330.derivative", "detail/jacobian.glsl", "(k.y, g.x)", "(k.y, -g.x)"},
    {"fbm_d.fbm_d2.lattice.fast.fragment.es300.derivative", "fbm_d2d.glsl", "(n.z)", "(n.y)"},
    {"fbm_d.fbm_d3_cell.lattice.fast.fragment.gl330.derivative", "detail/jacobian.glsl",
     "(z, y, HN_I_COS_YZ, HN_I_SIN_YZ)", "(z, y, HN_I_COS_YZ, -HN_I_SIN_YZ)"},
    {"fbm_d.fbm_d2_cell_period.lattice.precise.fragment.gl400.derivative", "detail/jacobian.glsl", "(k, growth)",
     "(k, 1.0f)"},
    {"fbm_d.fbm_d3_cell_period.lattice.fast.fragment.gl330.derivative", "detail/jacobian.glsl", "(k.y, growth)",
     "(k.y, 1.2f * growth)"},
    // A sum without strength that is no fBm.
    {"fbm_d.eroded2.lattice.fast.fragment.gl330.zero_strength", "detail/jacobian.glsl", "(square, strength, 1.0f)",
     "(square, strength + 0.001f, 1.0f)"},
    {"fbm_d.eroded3_cell.lattice.precise.fragment.gl400.zero_strength", "fbm_d3d.glsl", "(n.x),", "(n.y),"},
    {"fbm_d.eroded2_cell_period.lattice.fixed.fragment.gl330.zero_strength", "detail/jacobian.glsl", "divisor = 65536u",
     "divisor = 65537u"},
    // Another value beside the derivative.
    {"fbm_d.fbm_d3_cell.lattice.fixed.fragment.gl330.derivative_value", "fbm_d3d.glsl", "(o.sum, n.x)",
     "(o.sum, n.x + 0.000001f)"},
    {"noise2d.perlin_d.lattice.fast.fragment.gl330.derivative_value", "perlin_d2d.glsl", kMacro,
     "hn_perlin_d(args) (vec3(0.0001, 0.0, 0.0) + hn_perlin_d(args))"},
    {"noise3d.value_d_cell.lattice.fixed.fragment.gl330.derivative_value", "value_d3d.glsl", kMacro,
     "hn_value_d(c, args) (vec4(0.0000005, 0.0, 0.0, 0.0) + hn_value_d(c, args))"},
    {"noise4d.perlin_d_cell_period_value.lattice.precise.fragment.gl400.derivative_value", "perlin_d4d.glsl",
     "n.value = ", "n.value = 1.0000001f * "},
    // A jump at the border of a cell: the polynomial through a cell's values has the derivative of the noise on
    // both sides.
    {"noise2d.value_d_cell.lattice.fast.fragment.gl330.derivative", "value_d2d.glsl", kMacro,
     "hn_value_d(c, args) (hn_value_d(c, args) + vec3(0.0, f.x == 1.0 ? 0.02 : 0.0, 0.0))"},
    // Noise that is not zero at lattice points; of simplex noise also at points that are no corners of cells.
    {"noise1d.perlin.lattice.fast.fragment.gl330.zero", "perlin1d.glsl", kMacro,
     "hn_perlin(args) (hn_perlin(args) + 0.00001)"},
    {"noise4d.perlin_d_value.lattice.fixed.fragment.gl330.zero", "perlin_d4d.glsl",
     "n.value = ", "n.value = 0.00001f + "},
    {"noise2d.simplex.lattice.fast.fragment.gl330.zero", "simplex2d.glsl", kMacro,
     "hn_simplex(args) (hn_simplex(args) + (fract(p.x) == 0.75 ? 0.00001 : 0.0))"},
    {"noise2d.simplex_smooth.lattice.fixed.fragment.gl330.zero", "simplex_smooth2d.glsl", kMacro,
     "hn_simplex_smooth(args) (hn_simplex_smooth(args) + (fract(p) == vec2(0.5, 0.0) ? 0.00001 : 0.0))"},
    {"noise3d.simplex.lattice.fast.fragment.gl330.zero", "simplex3d.glsl", kMacro,
     "hn_simplex(args) (hn_simplex(args) + (fract(p.y) == 0.5 ? 0.00001 : 0.0))"},
    // A sum that is infinite at a large position.
    {"fbm.fbm3.lattice.fast.fragment.gl330.finite", "fbm3d.glsl", kMacro,
     "hn_fbm(q, o, l, args) (abs(p.x) > 1.0e28 ? uintBitsToFloat(0x7F800000u) : hn_fbm(q, o, l, args))"},
    {"fbm.fbm3.lattice.fixed.fragment.gl330.finite", "fbm3d.glsl", kMacro,
     "hn_fbm(q, o, l, args) (abs(p.x) > 1.0e28 ? uintBitsToFloat(0x7F800000u) : hn_fbm(q, o, l, args))"},
    // A sum without the limit of a position, of a setting, or of a mean that is no number.
    {"fbm.fbm2.lattice.fixed.fragment.gl330.finite", "detail/arithmetic.glsl", "return q - trunc(q);",
     "return p - trunc(p);"},
    {"fbm.fbm2_cell.lattice.fixed.fragment.gl330.finite", "detail/octave.glsl", "min(max(0.0f, x), most)", "x"},
    {"fbm.turbulence3.lattice.fast.fragment.gl330.finite", "detail/octave.glsl", "abs(mean) < 1.0e38f", "true"},
    // A value that lies in the range of an fBm and beyond that of other sums.
    {"fbm.turbulence2.lattice.fast.fragment.gl330.range", "fbm2d.glsl", kMacro,
     "hn_turbulence(q, o, l, args) (hn_turbulence(q, o, l, args) - 0.2)"},
    {"fbm.ridged2.lattice.fast.fragment.gl330.range", "fbm2d.glsl", kMacro,
     "hn_ridged(q, o, l, args) (hn_ridged(q, o, l, args) - 0.3)"},
    {"fbm.ridged2_cell.lattice.fixed.fragment.gl330.range", "fbm2d.glsl", kMacro,
     "hn_ridged(c, o, l, g, args) (hn_ridged(c, o, l, g, args) + 0.2)"},
    {"fbm.billow2.lattice.precise.fragment.gl400.range", "fbm2d.glsl", kMacro,
     "hn_billow(q, o, l, args) (hn_billow(q, o, l, args) - 0.2)"},
    {"fbm.ping_pong2.lattice.fast.fragment.gl330.range", "fbm2d.glsl", kMacro,
     "hn_ping_pong(q, o, l, g, s, args) (hn_ping_pong(q, o, l, g, s, args) + 0.001)"},
    {"fbm.ping_pong2_cell.lattice.fixed.fragment.gl330.range", "fbm2d.glsl", kMacro,
     "hn_ping_pong(c, o, l, g, s, args) (hn_ping_pong(c, o, l, g, s, args) - 0.0000005)"},
    {"fbm.weighted2.lattice.fast.fragment.gl330.range", "fbm2d.glsl", kMacro,
     "hn_weighted(q, o, l, g, s, args) (hn_weighted(q, o, l, g, s, args) * 1.5)"},
    // Ranges that depend on settings, which decide how far a shift can be, and how steep a sum.
    {"warp.warp2.lattice.fast.fragment.gl330.range", "warp2d.glsl", kMacro,
     "hn_warp(q, o, l, g, s, args) (hn_warp(q, o, l, g, s, args) * 1.2)"},
    {"warp.warp_progressive3_cell.lattice.fixed.fragment.gl330.range", "warp3d.glsl", kMacro,
     "hn_warp_progressive(c, o, l, g, s, args) (hn_warp_progressive(c, o, l, g, s, args) * 1.2)"},
    {"curl.curl_fbm2.lattice.fast.fragment.gl330.range", "curl_fbm2d.glsl", kMacro,
     "hn_curl_fbm(q, o, l, args) (2.0 * hn_curl_fbm(q, o, l, args))"},
    {"fbm_d.fbm_d2.lattice.fast.fragment.gl330.range", "fbm_d2d.glsl", kMacro,
     "hn_fbm_d(q, o, l, args) (hn_fbm_d(q, o, l, args) * vec3(1.0, 1.0, 2.0))"},
    {"fbm_d.fbm_d3.lattice.fixed.fragment.gl330.finite", "fbm_d3d.glsl", kMacro,
     "hn_fbm_d(q, o, l, args) (hn_fbm_d(q, o, l, args) * vec4(1.0, 1.0, 1.0, 5000.0))"},
    {"noise2d.gullies.lattice.fast.fragment.gl330.range", "gullies2d.glsl", kMacro,
     "hn_gullies(q, e, o, l, g, d, args) (3.0 * hn_gullies(q, e, o, l, g, d, args))"},
    {"noise3d.perlin_worley.lattice.fast.fragment.gl330.range", "perlin_worley3d.glsl", kMacro,
     "hn_perlin_worley(q, o, l, args) (0.5 + hn_perlin_worley(q, o, l, args))"},
    // A sum over another noise that is not that sum: not the noise, the octaves' weights, or a sum's step of each
    // octave.
    {"fbm.fbm2.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "(s.value, n, weight)",
     "(s.value, n, HN_I_WEIGHT_ONE)"},
    {"fbm.ridged3_cell.lattice.fixed.fragment.gl330.other_noise", "detail/octave.glsl", "next.feedback = min(",
     "next.feedback = max("},
    {"fbm.ping_pong2_cell_period.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "floor(t * 0.5f)",
     "floor(t)"},
    {"fbm.weighted2.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "(0.5f - 0.5f * n)",
     "(0.5f + 0.5f * n)"},
    {"fbm.ridged4.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "(ridge, ridge), HN_I_WEIGHT_ONE",
     "(ridge, 0.0f), HN_I_WEIGHT_ONE"},
    {"fbm_d.fbm_d2_cell.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "(k.y, g.x)", "(k.y, -g.x)"},
    {"fbm_d.fbm_d2.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
     "min(max(-4.0f, g), 4.0f)"},
    {"fbm_d.fbm_d3.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
     "min(max(-50.0f, g), 50.0f)"},
    {"fbm_d.fbm_d2.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
     "min(max(-128.0f, g), 130.0f)"},
    {"fbm_d.fbm_d3.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "min(max(-128.0f, g), 128.0f)",
     "min(max(-130.0f, g), 128.0f)"},
    {"fbm_d.eroded3.lattice.fixed.fragment.gl330.other_noise", "detail/jacobian.glsl", "(g) >> 7", "(g) >> 8"},
    {"fbm_d.eroded2_cell_period.lattice.fast.fragment.gl330.other_noise", "detail/jacobian.glsl", "hn_i_num2 next = e;",
     "hn_i_num2 next = e.yx;"},
    {"fbm.hybrid2.lattice.fixed.fragment.gl330.other_noise", "detail/octave.glsl",
     "int(min(max(-1.0f, n), 1.0f) * HN_I_FLOAT_UNITS_VALUE)",
     "int(min(max(-1.0f, n), 1.015625f) * HN_I_FLOAT_UNITS_VALUE)"},
    {"fbm.ping_pong3.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl",
     "(hn_float n) { return min(max(-1.0f, n), 1.0f); }", "(hn_float n) { return min(max(-1.015625f, n), 1.0f); }"},
    {"warp.warp3.lattice.fast.fragment.gl330.other_noise", "detail/jacobian.glsl", "(s, sum, total))",
     "(s, sum, total + 1.0))"},
    {"warp.warp_progressive2_cell_period.lattice.fixed.fragment.gl330.other_noise", "warp2d.glsl", "(s.y, ", "(s.x, "},
    {"fbm.fbm3_detail.lattice.fast.fragment.gl330.other_noise", "detail/octave.glsl", "hn_float total = part",
     "hn_float total = 1.0f"},
    // The position of a place that is outside of its cell.
    {"fbm.fbm2.lattice.fast.fragment.gl330.other_noise", "detail/cell2d.glsl", ") + (fraction + ", ") - (fraction + "},
    {"fbm.fbm3_cell.lattice.fixed.fragment.gl330.other_noise", "detail/cell2d.glsl", "fraction * 16 + rest",
     "fraction * 32 + rest"},
    // A position that is no number.
    {"noise2d.perlin.lattice.fixed.fragment.gl330.finite", "perlin2d.glsl", kMacro,
     "hn_perlin(args) (isinf(p.x) ? p.x : hn_perlin(args))"},
    // The last bit of a fraction, a corner that is beside the corner, a first octave in the cell behind the place,
    // and a number of cells in the place of a position.
    {"place.all.lattice.fixed.vertex.gl330.positions", "octaves1d.glsl", "HN_I_REST(o.x.y & 15)",
     "HN_I_REST(o.x.y & 14)"},
    {"place.all.lattice.fixed.vertex.gl330.positions", "octaves4d.glsl", "HN_I_REST(o.w.y & 15)",
     "HN_I_REST(o.w.y & 14)"},
    {"place.all.lattice.fast.vertex.gl330.positions", "place.glsl", "vec3(0.0f, 0.0f, 0.0f)",
     "vec3(0.0f, 0.0f, 0.015625f)"},
    {"place.all.lattice.fixed.vertex.gl330.positions", "place.glsl", "vec3(0.0f, 0.0f, 0.0f)",
     "vec3(0.0f, 0.0f, 0.015625f)"},
    {"place.all.lattice.fixed.vertex.gl330.positions", "place.glsl", "(p.y))", "(0.0f))"},
    {"place.all.lattice.fast.vertex.gl330.positions", "position.glsl",
     "hn_place(hn_int position, hn_int cells, hn_int units) {\n  return hn_place(hn_cell(position, cells, units), "
     "hn_fraction(position, cells, units));",
     "hn_place(hn_int position, hn_int cells, hn_int units) {\n  return hn_place(hn_cell(position, cells, units), "
     "hn_fraction(cells, position, units));"},
    {"place.all.lattice.fixed.vertex.gl330.positions", "position.glsl", "hn_fraction(position.w, cells, units)",
     "hn_fraction(position.w + 1, cells, units)"},
    {"place.all.lattice.fast.vertex.gl330.positions", "octaves2d.glsl", "ivec2(o.x.x, o.y.x)",
     "ivec2(o.x.x, o.y.x + (o.y.y >> 24))"},
    {"place.all.lattice.fixed.vertex.gl330.positions", "octaves2d.glsl", "ivec2(o.x.x, o.y.x)",
     "ivec2(o.x.x, o.y.x + (o.y.y >> 24))"},
    // A block of cells that is too small by a row, or has the wrong ones.
    {"noise2d.cellular.lattice.fast.fragment.gl330.search", "detail/feature_points2d.glsl",
     "cells, cells.following.y, s)", "cells, cells.cell.y, s)"},
    {"noise2d.cellular_cell_nearest.lattice.fixed.fragment.gl330.search", "detail/feature_points2d.glsl",
     "cells, cells.previous.y, s)", "cells, cells.cell.y, s)"},
    {"noise3d.cellular_offset.lattice.precise.fragment.gl400.search", "detail/feature_points3d.glsl",
     "joins.z, odds.z, x", "joins.y, odds.y, x"},
    {"noise2d.cellular_three.lattice.fast.fragment.gl330.search", "cellular_three2d.glsl", "metric), HN_I_NO_CODE",
     "metric) + 9.0f, HN_I_NO_CODE"},
    {"noise2d.cellular_three_full.lattice.fixed.fragment.gl330.search", "detail/feature_points.glsl",
     "(d > HN_I_NO_OFFSET, 2, -2)", "(d > HN_I_NO_OFFSET, 2, 2)"},
    {"noise3d.cellular_three_cell_full.lattice.fast.vertex.gl330.search", "cellular_three3d.glsl",
     "(d, axis, steps, n), jitter", "(d, axis, steps, -n), jitter"},
    {"noise3d.cellular_three_cell_full.lattice.fixed.fragment.gl330.search", "cellular_three3d.glsl", "n <= 1",
     "n < 1"},
    {"noise2d.cell_border.lattice.fast.fragment.gl330.search", "cell_border2d.glsl", "(y.z), jitter",
     "(y.z + 9.0), jitter"},
    {"noise2d.cell_border_cell.lattice.fixed.fragment.gl330.search", "cell_border2d.glsl", "(y.x), jitter",
     "(y.y), jitter"},
    {"noise3d.cell_border.lattice.fixed.fragment.gl330.search", "cell_border3d.glsl", "slab = -1;", "slab = 0;"},
    // Another metric, and another jitter.
    {"noise2d.cellular_full.lattice.fast.fragment.gl330.search", "detail/feature_points2d.glsl",
     "HN_METRIC_MANHATTAN) return", "HN_METRIC_MANHATTAN) return max(a, b); else return"},
    {"noise3d.cellular_three_cell_full.lattice.fixed.fragment.gl330.search", "detail/feature_points3d.glsl",
     "metric == HN_METRIC_CHEBYSHEV) return", "metric == HN_METRIC_CHEBYSHEV || metric == 6) return"},
    {"noise3d.cellular_smooth_full.lattice.fast.fragment.gl330.search", "detail/feature_points.glsl",
     "max(0.0f, jitter), 1.0f)", "max(0.0f, jitter), 1.5f)"},
    {"noise2d.cellular_d_full.lattice.fixed.fragment.gl330.search", "detail/feature_points.glsl",
     "min(max(0.0f, jitter), 1.0f)", "min(max(0.01f, jitter), 1.0f)"},
    // The name, the way and the distance of different points, a name beyond the period, and a value of its own.
    {"noise2d.cellular_cell_nearest.lattice.fast.fragment.gl330.cell_names", "detail/feature_points2d.glsl",
     "(c, place.period);\n  return ivec2", "(c, ivec2(0, 0));\n  return ivec2"},
    {"noise3d.cellular_cell_nearest.lattice.fixed.fragment.gl330.cell_names", "cellular3d.glsl",
     "offset = ", "offset = -"},
    {"noise2d.cellular_cell_nearest.lattice.precise.fragment.gl400.cell_names", "cellular2d.glsl", "best.w));\n",
     "best.w));\n  metric = HN_METRIC_SQUARED;\n"},
    {"noise2d.cell_border_nearest.lattice.fast.fragment.gl330.cell_names", "cell_border2d.glsl",
     "nearest = ", "nearest = ivec2(0, 1) + "},
    // A value of its own beside the nearest point.
    {"noise2d.cell_border_nearest.lattice.fast.fragment.gl330.returned", "cell_border2d.glsl",
     "d, jitter, seed, best);", "d, jitter, seed, best) * -1.0f;"},
    {"noise3d.cell_border_cell_offset.lattice.fixed.fragment.gl330.returned", "cell_border3d.glsl",
     "(jitter), seed, nearest, offset);", "(0.5f), seed, nearest, offset);"},
    {"noise2d.cellular_phase_nearest.lattice.precise.fragment.gl400.returned", "cellular_phase2d.glsl",
     "(best, HN_METRIC_EUCLIDEAN);", "(best, HN_METRIC_SQUARED);"},
    // Another of two equally near points.
    {"noise2d.cellular_nearest.lattice.fixed.fragment.gl330.search", "detail/feature_points.glsl", "(rank < best.x,",
     "(rank <= best.x,"},
    // Borders in the wrong place.
    {"noise2d.cell_border.lattice.fast.fragment.gl330.border", "cell_border2d.glsl", kMacro,
     "hn_cell_border(args) (hn_cell_border(args) * 4.0)"},
    {"noise3d.cell_border_cell.lattice.fixed.fragment.gl330.border", "cell_border3d.glsl", kMacro,
     "hn_cell_border(c, args) (hn_cell_border(c, args) + 0.02)"},
    {"noise3d.cell_border.lattice.precise.fragment.gl400.border", "cell_border3d.glsl", "nearest.w);\n}",
     "nearest.w * 0.0f);\n}"},
    // Derivatives of cellular noise: a length that is not 1, and a direction that is another.
    {"noise2d.cellular_d.lattice.fast.fragment.gl330.derivative", "cellular_d2d.glsl", kMacro,
     "hn_cellular_d(args) (vec3(1.0, 1.001, 1.001) * hn_cellular_d(args))"},
    {"noise3d.cellular_d_cell_full.lattice.fixed.fragment.gl330.derivative", "cellular_d3d.glsl", kMacro,
     "hn_cellular_d(t, j, args) hn_cellular_d(t, j, args).xzyw"},
    // A jump where the block of cells changes: at a wall, and in the middle of a cell.
    {"noise2d.cellular.lattice.fast.fragment.gl330.seams", "cellular2d.glsl", kMacro,
     "hn_cellular(args) (hn_cellular(args) + (fract(p.x) < 0.5 ? 0.001 : 0.0))"},
    {"noise3d.cell_border_cell.lattice.fixed.fragment.gl330.seams", "cell_border3d.glsl", kMacro,
     "hn_cell_border(c, args) (hn_cell_border(c, args) + (f.z > 0.5 ? 0.05 : 0.0))"},
    {"noise2d.cellular_d_cell.lattice.precise.fragment.gl400.seams", "cellular_d2d.glsl", kMacro,
     "hn_cellular_d(c, args) (hn_cellular_d(c, args) * (cell.y % 2 == 0 ? vec3(1.0) : vec3(1.0, -1.0, 1.0)))"},
    // Fields that are alike.
    {"noise2d.cellular.lattice.fast.fragment.gl330.seeds", "cellular2d.glsl", "HN_METRIC_EUCLIDEAN, seed);",
     "HN_METRIC_EUCLIDEAN, seed & 0x7FFFFFFFu);"},
    {"noise3d.cellular.lattice.fast.fragment.gl330.mirror", "cellular3d.glsl", "hn_cellular(hn_place(p), seed)",
     "hn_cellular(hn_place(abs(p)), seed)"},
    // A nearest point that is wrong. With rounded floats every output but those that jump is compared, and an
    // undecided point is no excuse elsewhere.
    {"noise2d.cellular_nearest.lattice.fast.fragment.gl330.twin", "detail/feature_points.glsl", "(rank < best.x,",
     "(rank < best.x + 0.002f,"},
    // Derivatives of simplex noise: a sign, a factor, components in another order, and a term that is missing.
    {"noise2d.simplex_d.lattice.fast.fragment.gl330.derivative", "simplex_d2d.glsl", kMacro,
     "hn_simplex_d(args) (vec3(1.0, 1.0, 1.01) * hn_simplex_d(args))"},
    {"noise2d.simplex_d_cell.lattice.fixed.fragment.gl330.derivative", "simplex_d2d.glsl", kMacro,
     "hn_simplex_d(c, args) (vec3(1.0, 1.02, 1.0) * hn_simplex_d(c, args))"},
    {"noise3d.simplex_d.lattice.precise.fragment.gl400.derivative", "simplex_d3d.glsl", kMacro,
     "hn_simplex_d(args) (vec4(1.0, 1.01, 1.0, 1.0) * hn_simplex_d(args))"},
    {"noise3d.simplex_d_cell_period.lattice.fixed.fragment.gl330.derivative", "simplex_d3d.glsl", kMacro,
     "hn_simplex_d(t, args) hn_simplex_d(t, args).xzyw"},
    {"noise2d.simplex_d_phase.lattice.fast.fragment.gl330.derivative", "simplex_phase2d.glsl", kMacro,
     "hn_simplex_d(p, t, args) (vec3(1.0, -1.0, 1.0) * hn_simplex_d(p, t, args))"},
    {"noise3d.perlin_d_phase.lattice.fast.fragment.gl330.derivative", "perlin_phase3d.glsl", kMacro,
     "hn_perlin_d(p, t, args) (vec4(1.0, 1.0, 1.0, 1.01) * hn_perlin_d(p, t, args))"},
    {"noise4d.simplex_d.lattice.fast.fragment.gl330.derivative", "detail/falloff.glsl", "hn_float d = g * w - k * x;",
     "hn_float d = g * w;"},
    {"noise2d.simplex_d.lattice.fast.fragment.gl330.derivative", "detail/falloff.glsl", "hn_float d = g * w - k * x;",
     "hn_float d = g * w - 0.99 * k * x;"},
    {"noise2d.phasor_d.lattice.fast.fragment.gl330.derivative", "detail/phasor.glsl", "(n.y, k))", "(n.y, -k))"},
    {"noise3d.phasor_d.lattice.fast.fragment.gl330.derivative", "detail/phasor.glsl", "(n, -x);", "(n, x);"},
    {"noise2d.phasor_d_bandwidth.lattice.fast.fragment.gl330.derivative", "detail/phasor.glsl", "(turning.y, s)",
     "(turning.x, s)"},
    {"noise3d.phasor_d_bandwidth.lattice.fast.fragment.gl330.derivative", "phasor_d3d.glsl", "(s.waves.n, k.z)",
     "(s.waves.n, k.y)"},
    {"noise2d.phasor_bandwidth.lattice.fast.fragment.gl330.zero_bandwidth", "detail/phasor.glsl", "max(0.0f, b)",
     "max(0.001f, b)"},
    {"noise2d.phasor_bandwidth_cell_period.lattice.fixed.fragment.gl330.zero_bandwidth", "detail/phasor.glsl",
     "max(0.0f, b)", "max(0.001f, b)"},
    // A field of the wrong size: on the plane one without periods repeats after 2^31 cells.
    {"noise2d.simplex_cell_period.lattice.fast.fragment.gl330.period", "simplex2d.glsl", kMacro,
     "hn_simplex(t, args) (hn_simplex(t, args) + (period.x <= 0 && cell.x < 0 ? 0.00001 : 0.0))"},
    // A phase that does not loop.
    {"noise2d.simplex_phase.lattice.fast.fragment.gl330.loop", "detail/sine.glsl", "(turns - trunc(turns))",
     "(turns - 0.99999f * trunc(turns))"},
    {"noise3d.simplex_d_phase_cell_period.lattice.fixed.fragment.gl330.loop", "detail/sine.glsl",
     "(turns - trunc(turns))", "(turns - trunc(turns) + 0.0000001f * trunc(turns))"},
    // A negative phase that rotates the other way.
    {"noise3d.perlin_phase_cell.lattice.precise.fragment.gl400.loop", "detail/sine.glsl", "(turns - trunc(turns))",
     "abs(turns - trunc(turns))"},
    {"noise2d.phasor.lattice.fixed.fragment.gl330.loop", "detail/sine.glsl", "(turns - trunc(turns))",
     "(turns - trunc(turns) + 0.0000001f * trunc(turns))"},
    // Half a turn that does not negate.
    {"noise2d.perlin_phase.lattice.fast.fragment.gl330.half_turn", "perlin_phase2d.glsl", kMacro,
     "hn_perlin(p, t, args) (hn_perlin(p, t, args) + 0.0001)"},
    {"noise3d.simplex_phase_cell.lattice.fixed.fragment.gl330.half_turn", "simplex_phase3d.glsl", kMacro,
     "hn_simplex(c, t, args) abs(hn_simplex(c, t, args))"},
    {"noise2d.simplex_d_phase.lattice.fast.fragment.gl330.half_turn", "detail/sine.glsl",
     "hn_uint q = angle & 0x7FFFFFFFu;", "hn_uint q = (angle + (angle >> 10u)) & 0x7FFFFFFFu;"},
    {"curl.curl3_phase.lattice.fast.fragment.gl330.half_turn", "curl_phase3d.glsl", "angle << 1u", "angle"},
    {"curl.curl_fbm2_phase.lattice.fixed.fragment.gl330.half_turn", "curl_fbm2d.glsl", "hn_i_new_curl_rotation2(phase)",
     "hn_i_new_curl_rotation2(phase * phase)"},
    // Another noise at phase zero.
    {"curl.curl3_phase_cell.lattice.fixed.fragment.gl330.phase_zero", "curl_phase3d.glsl", kMacro,
     "hn_curl(c, t, args) (1.01 * hn_curl(c, t, args))"},
    {"noise2d.simplex_phase.lattice.fast.fragment.gl330.phase_zero", "simplex_phase2d.glsl", kMacro,
     "hn_simplex(p, t, args) hn_simplex(p, t + 0.001, args)"},
    {"noise2d.perlin_d_phase_cell.lattice.precise.fragment.gl400.phase_zero", "perlin_phase2d.glsl", kMacro,
     "hn_perlin_d(c, t, args) (vec3(1.0, 1.0, 1.001) * hn_perlin_d(c, t, args))"},
    {"noise3d.perlin_phase.lattice.fixed.fragment.gl330.phase_zero", "perlin_phase3d.glsl", kMacro,
     "hn_perlin(p, t, args) (1.01 * hn_perlin(p, t, args))"},
    // A field with a divergence.
    {"curl.curl2.lattice.fast.fragment.gl330.divergence", "curl2d.glsl", kMacro,
     "hn_curl(args) (vec2(1.0, -1.0) * hn_curl(args))"},
    {"curl.curl2_cell.lattice.fixed.fragment.gl330.divergence", "curl2d.glsl", kMacro,
     "hn_curl(c, args) normalize(hn_curl(c, args))"},
    {"curl.curl3.lattice.fast.fragment.gl330.divergence", "curl3d.glsl", kMacro,
     "hn_curl(args) normalize(hn_curl(args))"},
    {"curl.curl3.lattice.precise.fragment.gl400.divergence", "curl3d.glsl", kMacro, "hn_curl(args) hn_curl(args).yxz"},
    {"curl.curl3_cell.lattice.fixed.fragment.gl330.divergence", "curl3d.glsl", kMacro,
     "hn_curl(c, args) (vec3(1.0, 1.0, -1.0) * hn_curl(c, args))"},
    {"curl.curl3_phase.lattice.fast.fragment.gl330.divergence", "curl_phase3d.glsl", kMacro,
     "hn_curl(p, t, args) normalize(hn_curl(p, t, args))"},
    // Octaves that are not rotated back, and one that is cut off.
    {"curl.curl_fbm2.lattice.fast.fragment.gl330.divergence", "curl_fbm2d.glsl",
     "u = hn_i_transposed_times(s.cofactors, u);", ""},
    {"curl.curl_fbm3_cell.lattice.fixed.fragment.gl330.divergence", "curl_fbm3d.glsl",
     "hn_i_next_cofactors(s.cofactors, s.gain, o.place.tiled)", "s.cofactors"},
    {"curl.curl_fbm3_phase.lattice.fast.fragment.gl330.divergence", "detail/jacobian.glsl", "{ return g; }",
     "{ return min(max(-1.0f, g), 1.0f); }"},
    // A kernel that is too large: where another point takes over, the one that is left behind still has a weight.
    {"noise2d.simplex.lattice.fast.fragment.gl330.seams", "detail/triangular_lattice.glsl", "HN_I_TRIANGLE_RADIUS 819",
     "HN_I_TRIANGLE_RADIUS 922"},
    {"noise2d.simplex_d_cell.lattice.fixed.fragment.gl330.seams", "detail/triangular_lattice.glsl",
     "HN_I_TRIANGLE_RADIUS 819", "HN_I_TRIANGLE_RADIUS 870"},
    {"noise3d.simplex.lattice.fast.fragment.gl330.seams", "detail/body_centred_lattice.glsl", "1024, 2", "1229, 2"},
    {"noise3d.simplex_phase_cell.lattice.fixed.fragment.gl330.seams", "detail/body_centred_lattice.glsl", "1024, 2",
     "1229, 2"},
    {"noise4d.simplex.lattice.precise.fragment.gl400.seams", "detail/body_centred_lattice.glsl", "1024, 2", "1229, 2"},
    {"noise2d.simplex_smooth.lattice.fast.fragment.gl330.seams", "simplex_smooth2d.glsl", "1024, 1", "1229, 1"},
    {"noise3d.simplex_smooth.lattice.fast.fragment.gl330.seams", "simplex_smooth3d.glsl", "768, 1", "1024, 1"},
};

std::set<std::string> checks() {
  std::set<std::string> names;
  for (const LibraryFault& fault : kFaults) names.emplace(fault.check());
  return names;
}

class Check : public FaultyLibrary, public testing::WithParamInterface<std::string> {};

TEST_P(Check, CatchesItsFaults) {
  for (const LibraryFault& fault : kFaults) {
    if (fault.check() == GetParam()) expect_caught(fault);
  }
}

INSTANTIATE_TEST_SUITE_P(Named, Check, testing::ValuesIn(checks()), [](const auto& named) { return named.param; });

// In every arithmetic: numbers that are none, a value where no axis has a fraction, and one beyond the range at a tiny
// position.
TEST_F(FaultyLibrary, AWrongValueWhereFloatsEndIsCaught) {
  for (const std::string_view arithmetic : {"fast.fragment.gl330", "precise.fragment.gl400", "fixed.fragment.gl330"}) {
    const auto catches = [&](std::string_view check, std::string_view where, std::string_view value) {
      const std::string fault = fmt::format("hn_perlin(args) ({} ? {} : hn_perlin(args))", where, value);
      expect_caught({fmt::format("noise2d.perlin.lattice.{}.{}", arithmetic, check), "perlin2d.glsl", kMacro, fault});
    };
    catches("finite", "abs(p.x) > 3.0e38", "uintBitsToFloat(0x7FC00000u)");
    catches("finite", "abs(p.x) > 3.0e38", "uintBitsToFloat(0x7F800000u)");
    catches("finite", "min(abs(p.x), abs(p.y)) > 1.0e9", "1.0e-6 + hn_perlin(args)");
    catches("finite", "p.x != 0.0 && abs(p.x) < 1.0e-30", "1.5");
    if (arithmetic.starts_with("fast")) continue;
    // Ordinary points would hide both: a subnormal position is seen, and it counts.
    catches("twin", "abs(p.x) > 1.0e30", "0.123");
    catches("twin", "p.x != 0.0 && abs(p.x) < 1.0e-30", "0.123");
  }
}

// Each kind of plane on its own, from both sides.
TEST_F(FaultyLibrary, AJumpAtEachPlaneIsCaught) {
  struct Plane {
    std::string_view id;
    std::string_view file;
    std::string_view name;
    std::string_view side;  // a condition that changes there
  };
  constexpr Plane kPlanes[] = {
      {"noise2d.simplex", "simplex2d.glsl", "hn_simplex", "fract(p.x + p.y * 0.5) < 0.5"},
      {"noise2d.simplex", "simplex2d.glsl", "hn_simplex", "fract(p.x - p.y * 0.5) >= 0.5"},
      {"noise2d.simplex", "simplex2d.glsl", "hn_simplex", "fract(p.y) < 0.5"},
      {"noise2d.simplex_smooth", "simplex_smooth2d.glsl", "hn_simplex_smooth", "fract(2.0 * p.x - 0.5) < 0.5"},
      {"noise3d.simplex", "simplex3d.glsl", "hn_simplex", "fract(p.y) <= 0.5"},
      {"noise3d.simplex", "simplex3d.glsl", "hn_simplex", "abs(fract(p.x + 0.5) - 0.5) < abs(fract(p.z + 0.5) - 0.5)"},
      {"noise4d.simplex", "simplex4d.glsl", "hn_simplex", "abs(fract(p.w + 0.5) - 0.5) <= abs(fract(p.y + 0.5) - 0.5)"},
      {"noise3d.simplex_smooth", "simplex_smooth3d.glsl", "hn_simplex_smooth",
       "abs(fract(p.x + 0.5) - 0.5) + abs(fract(p.y + 0.5) - 0.5) < abs(fract(p.z + 0.5) - 0.5)"},
      {"noise3d.simplex_smooth", "simplex_smooth3d.glsl", "hn_simplex_smooth",
       "abs(fract(p.x + 0.5) - 0.5) + abs(fract(p.z + 0.5) - 0.5) - abs(fract(p.y + 0.5) - 0.5) <= 0.5"},
      {"noise3d.perlin", "perlin3d.glsl", "hn_perlin", "fract(p.z) < 0.5"},
      {"noise1d.value", "value1d.glsl", "hn_value", "fract(p) < 0.5"}};
  for (const Plane& plane : kPlanes) {
    const std::string fault =
        fmt::format("{}(args) ({}(args) + (({}) ? 0.001 : 0.0))", plane.name, plane.name, plane.side);
    expect_caught({fmt::format("{}.lattice.fast.fragment.gl330.seams", plane.id), plane.file, kMacro, fault});
  }
}

}  // namespace
}  // namespace hn
