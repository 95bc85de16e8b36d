"""The mutants that compute the same as the library, or nothing that the contract distinguishes from the right
values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from base.tree import included_from
from check.mutation.mutants import Mutant
from translate.single_file.files import INCLUDE, in_order, parts


@dataclass(frozen=True)
class Equivalence:
    """Mutants that keep the contract: those in which a piece of a file reads as one of `new`, wherever it stands."""
    file: str
    old: str
    new: Sequence[str]

    def covers(self, mutant: Mutant) -> bool:
        """Whether the mutant is one of these: the piece is where the change is, and is now one of those."""
        at = mutant.original.find(self.old, max(mutant.end - len(self.old), 0)) if mutant.file == self.file else -1
        while 0 <= at <= mutant.start:
            rest = at + len(self.old)
            if mutant.end <= rest:
                piece = mutant.original[at:mutant.start] + mutant.new + mutant.original[mutant.end:rest]
                if piece in self.new:
                    return True
            at = mutant.original.find(self.old, at + 1)
        return False


def alike(file: str, *pieces: Sequence[str]) -> list[Equivalence]:
    """Equivalences of a file that have their reason in common: each the piece, and what it may read as instead."""
    return [Equivalence(file, old, new) for old, *new in pieces]


EQUIVALENT: tuple[Equivalence, ...] = (
    # A candidate two cells on is more than a cell away along that axis, which counts as a cell, and no reach is longer.
    # The word of the cell next to it does not change that.
    *alike("scatter.glsl", ("i <= 1", "i <= 2"), ("j <= 1", "j <= 2"), ("k <= 1", "k <= 2"),
           ("i = -1", "i = -2"), ("j = -1", "j = -2"), ("k = -1", "k = -2")),

    # These move the fixed-point argument of the sine by no more than 1 unit of 2^-32 turns, which is 1.5e-9 radians, of
    # the 2^-19 (1.9e-6) that the contract allows: the changed bit is multiplied by less than 2^16 and shifted out by
    # 16, or it is the unit itself.
    *alike("detail/sine_gradient.glsl",
           ("low = m & 0xFFFFu", "low = m & 0xFFFEu"),
           ("high * 0x054Au", "high * 0x054Bu", "high * 0x0549u"),
           ("low * 0x9391u", "low * 0x9392u", "low * 0x9390u")),

    # So do these. An angle of a phase is a multiple of 4, and this does not take it over a step of the sine.
    *alike("detail/sine.glsl",
           ("angle & 0x7FFFFFFFu", "angle & 0x7FFFFFFEu"),
           ("min(q, 0x80000000u - q)", "min(q, 0x80000001u - q)")),

    # With either the sine is off by 1.67e-6 at most, of the 1.91e-6 that the contract allows: all 2^32 words were
    # compared with sin(float(int)) in double, in C++.
    *alike("detail/sine_gradient.glsl", ("high * 0x054Au", "high + 0x054Au", "rounds * 0x054Au")),

    # Values that pass these are subnormal, and the drivers that have HN_PRECISE here flush it by themselves. (The test
    # unit.Twin runs the text with and without that.) The sign plays no part.
    *alike("detail/octave.glsl", ("& 0x7F800000u) == 0u", "& 0x7F800001u) == 0u", "& 0x7F800000u) == 1u",
            "| 0x7F800000u) == 0u"),
           ("floatBitsToUint(p)", "floatBitsToUint(-p)")),

    # It is 0 all the same.
    *(Equivalence(file, zero, (f"-{zero}",)) for file, zero in (
        ("detail/cell2d.glsl", "ivec2(0, 0)"), ("place.glsl", "ivec3(0, 0, 0)"), ("place.glsl", "ivec4(0, 0, 0, 0)"))),

    # Memory without a write is 0 on the drivers here, and in C++.
    *(each for file in ("fbm_d2d.glsl", "fbm_d3d.glsl", "warp2d.glsl", "warp3d.glsl")
      for each in alike(file, *((f"s.{axis} = HN_I_NO_WEIGHT;", "") for axis in ("xyz" if "3d" in file else "xy")))),
    *alike("detail/octave.glsl", ("s.value = HN_I_NO_WEIGHT;", ""), ("s.footprint = HN_I_NO_WEIGHT;", ""), ("s.at = 0;", "")),

    # Nothing reads this position: hn_next and the warps ask is_fixed_point before, and hn_octaves writes the position
    # where it makes is_fixed_point false. (It is written so that no part of the struct that is returned is undefined.)
    *alike("octaves1d.glsl", ("o.p = 0.0f;", "", "o.p = 0.015625f;")),
    *(Equivalence(f"octaves{n}d.glsl", f"o.p = vec{n}({', '.join(['0.0f'] * n)});",
                  ("", *(f"o.p = vec{n}({', '.join('0.015625f' if i == axis else '0.0f' for i in range(n))});"
                         for axis in range(n))))
      for n in (2, 3, 4)),

    # Without a tile only the names of cells read a period, and those are in 2D and 3D.
    *alike("place.glsl",
           ("place.period = 0;", "place.period = 1;", ""),
           ("place.period = ivec4(0, 0, 0, 0);", "place.period = ivec4(1, 0, 0, 0);", "place.period = ivec4(0, 1, 0, 0);",
            "place.period = ivec4(0, 0, 1, 0);", "place.period = ivec4(0, 0, 0, 1);", "")),

    # All three components are the same: they are of one point.
    *alike("detail/feature_points2d.glsl",
           *((f"cell(d.{axis}, {axis})), jitter).x", f"cell(d.{axis}, {axis})), jitter).y") for axis in "xy")),

    # It compares them.
    *alike("detail/feature_points3d.glsl", *((f"(axis, {n}", f"({n}, axis") for n in (0, 2))),

    # The lowest bit of these words is 0: all that direction4d.glsl passes is shifted left by 9 or 10 bits, and no other
    # file calls its functions with words.
    *alike("detail/direction4d.glsl",
           ("(h & 0x80000000u) != 0u, -x, x)", "(h & 0x80000001u) != 0u, -x, x)"),
           ("floatBitsToUint(x) ^ (h & 0x80000000u)", "floatBitsToUint(x) ^ (h & 0x80000001u)")),

    # The absolute value is the same.
    *alike("detail/arithmetic.glsl", ("abs(x)", "abs(-x)"), ("abs(n)", "abs(-n)"), ("x < 0, -x, x", "x <= 0, -x, x")),
    *alike("detail/direction.glsl", ("abs(x)", "abs(-x)")),

    # So is the square, and the other components are not used.
    *alike("detail/square_root.glsl", *((f"ivec3({axis}, 0, 0)", f"ivec3(-{axis}, 0, 0)", f"ivec3({axis}, 1, 0)", f"ivec3({axis}, 0, 1)")
                          for axis in "xyz")),

    # So are these, which are sums of squares or of absolute values of two axes that count alike.
    *alike("cell_border2d.glsl",
           ("s(from_x, from_y)", "s(-from_x, from_y)", "s(from_x, -from_y)", "s(from_y, from_x)")),
    *alike("cell_border3d.glsl", ("hn_i_offset_difference(u, from.x), hn_i_offset_difference(v, from.y)",
                                  "hn_i_offset_difference(v, from.y), hn_i_offset_difference(u, from.x)")),
    *alike("detail/falloff.glsl", *((f"hn_i_magnitude({a}), hn_i_magnitude({b})",
                                      f"hn_i_magnitude({b}), hn_i_magnitude({a})")
                                    for a, b in ("xy", "yz", "zw"))),
    *(each for file in ("cell_border3d.glsl", "detail/feature_points3d.glsl")
      for each in alike(file, ("s(u, v, w)", "s(-u, v, w)", "s(u, -v, w)", "s(u, v, -w)", "s(v, u, w)"))),

    # So is a falloff's, modulo 2^32: uint(-t) is 2^32 - t.
    *alike("detail/falloff.glsl", ("square(t)", "square(-t)")),
    *alike("simplex3d.glsl", ("z, t, false)", "z, -t, false)")),
    *alike("simplex_phase3d.glsl", *((f"z, t, {turned})", f"z, -t, {turned})") for turned in ("false", "true"))),

    # HLSL alone has these. (Its thorough tests, hlsl.dxc and hlsl.fxc, compare golden values.)
    *alike("detail/word.glsl", ("n | 0)", "n | 1)"), ("n | 0u)", "n | 1u)")),

    # Only the first component is taken.
    *alike("detail/arithmetic.glsl", ("vec2(floor(p), 0.0f)", "vec2(floor(p), 0.015625f)")),
    *alike("detail/falloff.glsl", ("vec2(x, 0.0f)", "vec2(x, 0.015625f)")),

    # The fixed fade is the same for every fraction with either (all of them were compared by the oracle's tests). The
    # last two would round a square another way that is 2^15 or 2^15 - 1 modulo 2^16, and there is none.
    *alike("detail/arithmetic.glsl", ("+ 4u, 524287u)", "+ 4u, 524286u)"), ("1572864u", "1572865u"),
           ("(square + 32768u)", "(square + 32767u)", "(square + 32769u)")),

    # Only the highest bit of the second argument counts.
    *(each for file, word in (("phasor", "angle"), ("direction_turning", "angle"), ("sphere", "h"))
      for each in alike(f"detail/{file}.glsl", ("0x40000000u, 0u)", "0x40000000u, 1u)"), (f"({word}, 0u)", f"({word}, 1u)"))),

    # The three smallest ranks of a neighbourhood take the places of these.
    *alike("detail/feature_points.glsl",
           ("0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0u", "0xFFFFFFFEu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0u",
            "0xFFFFFFFFu, 0xFFFFFFFEu, 0xFFFFFFFFu, 0u", "0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFEu, 0u")),

    # Only a word beside a third of all words could distinguish these, and it never gets here: bit 20 chooses the second
    # pair, and it is set in 0x55555554 and 0x55555555, and clear in 0xAAAAAAA9 and 0xAAAAAAAA.
    *alike("detail/direction4d.glsl",
           ("h < 0x55555555u, y,", "h < 0x55555554u, y,", "h <= 0x55555555u, y,"),
           ("h < 0xAAAAAAAAu, w, z)", "h < 0xAAAAAAABu, w, z)", "h <= 0xAAAAAAAAu, w, z)")),

    # These add both, so their order does not matter.
    *alike("detail/sine_gradient.glsl",
           *((f"key({k}, {y})", f"key({y}, {k})") for k in ("k0", "k1") for y in ("c0.y", "c1.y"))),
    *alike("gradient.glsl", ("key(column, c.y)", "key(c.y, column)")),
    *alike("detail/hashes.glsl",
           ("step(h, k & 255u)", "step(k & 255u, h)"),
           ("step(h, (k >> 8u) & 255u)", "step((k >> 8u) & 255u, h)"),
           ("step(h, (k >> 16u) & 255u)", "step((k >> 16u) & 255u, h)"),
           ("step(h, k >> 24u)", "step(k >> 24u, h)"),
           ("step(0u, k)", "step(k, 0u)")),

    # The third distance is a continuous function of the place, and so is the least over the cells of either choice.
    # Each is right on its side, so on the line between both are right. (3 million places on these lines had the same
    # bits in every arithmetic, on the plane, and 375,000 in space.)
    *alike("cellular_three2d.glsl",
           ("hn_i_magnitude(d.x) >= hn_i_magnitude(d.y)", "hn_i_magnitude(d.x) > hn_i_magnitude(d.y)")),
    *alike("cellular_three3d.glsl", ("x >= max(y, z)", "x > max(y, z)"), ("y >= z", "y > z")),

    # A row more on either side has the words of the row beside it, so its points are those of that row, one step on.
    # None makes the nearest border: in 20,000 climbs, each over where the place is and where all points are in their
    # cells, another border stayed nearer, by 0.139 of a cell or more.
    *alike("cell_border3d.glsl", ("n = -1; n <= 1", "n = -2; n <= 1", "n = -1; n <= 2")),

    # The factors of a product may change places. 0 is its own negative.
    *alike("curl3d.glsl", ("(a.y, b.z, a.z, b.y)", "(b.z, a.y, a.z, b.y)", "(a.y, b.z, b.y, a.z)"),
           ("(a.z, b.x, a.x, b.z)", "(b.x, a.z, a.x, b.z)", "(a.z, b.x, b.z, a.x)"),
           ("(a.x, b.y, a.y, b.x)", "(b.y, a.x, a.y, b.x)", "(a.x, b.y, b.x, a.y)")),
    *alike("detail/feature_points3d.glsl", ("(axis == 0", "(-axis == 0"),
           # With numbers in place of words it is called with 0 alone.
           ("hn_i_vector(hn_i_select(axis == which", "hn_i_vector(hn_i_select(-axis == which")),
    *alike("detail/feature_points.glsl", ("(d == 0", "(-d == 0")),
    *alike("cellular_three2d.glsl", ("(axis == 0", "(-axis == 0"), ("hn_i_if_axis(axis", "hn_i_if_axis(-axis")),

    # A remainder by 1 is taken by the mask, since 1 is a power of two; and so is no period, whose size is 0.
    *alike("detail/cell2d.glsl", ("max(size, 1u)", "max(size, 2u)", "max(size, 0u)")),

    # There is no version 129 of GLSL, none between 150 and 330 or 330 and 400, and of GLSL ES none between 100 and 300
    # or 310 and 320.
    *alike("config.glsl",
           ("#if HN_I_VERSION < 130", "#if HN_I_VERSION < 129"),
           ("#if HN_I_VERSION < 300", "#if HN_I_VERSION < 299"),
           ("HN_I_VERSION >= 330", "HN_I_VERSION >= 329"),
           ("HN_I_VERSION >= 320", "HN_I_VERSION >= 319"),
           ("HN_I_VERSION >= 400", "HN_I_VERSION >= 399")),

    # With bit casts or without, the same bits come out of each function that has them, for all that it may get. (All
    # were compared, bit by bit.) So it does not matter who goes without; and only whether HN_I_BITCAST is 0 is ever
    # tested.
    *alike("config.glsl",
           ("HN_I_VERSION >= 330", "HN_I_VERSION >= 331", "HN_I_VERSION > 330"),
           ("#define HN_I_BITCAST 1", "#define HN_I_BITCAST 0", "#define HN_I_BITCAST 2")),

    # No driver is without __VERSION__, speaks HLSL, or is GCC's preprocessor. (Tests of the text are.)
    *alike("config.glsl",
           ("#define HN_I_VERSION 460", "", "#define HN_I_VERSION 461", "#define HN_I_VERSION 459"),
           ("|| defined(__GNUC__) ||", "&& defined(__GNUC__) ||"),
           ("|| defined(HN_I_HLSL)", "&& defined(HN_I_HLSL)")),

    # A file included twice then has only macros, and these may be defined twice if they are the same; or
    # nothing but #include, of files with guards of their own.
    *(Equivalence(f"{name}.glsl", f"#define HN_{name.upper()}_GLSL", ("",)) for name in (
        "config", "hashnoise", "fbm", "fbm_d", "warp", "curl", "noise1d", "noise2d", "noise3d", "noise4d")),
)


library_parts = cache(parts)


@cache
def of_file(file: str) -> list[Equivalence]:
    return [equivalence for equivalence in EQUIVALENT if equivalence.file == file]


@cache
def included_anyhow(file: str) -> frozenset[str]:
    """Includes of a file that another of its includes brings as well."""
    library = library_parts()
    includes = library[file].includes
    return frozenset(name for name in includes
                     if any(name in in_order(other, library) for other in includes if other != name))


# Text before two arguments that may change places.
#
# - A number and its weight: in floats their product is the same, and in HN_FIXED the product of the low 9 bits
#   of both is dropped.
# - Both factors of a product's upper half, which is exact: with digits of 16 bits none of its sums passes 2^32.
# - The first two components whose squares are summed: a sum of two floats is the same in either order, and in HN_FIXED
#   the whole sum is exact. Where a driver contracts it, HN_FAST is within its bound with either square rounded.
COMMUTES = re.compile(r"\bhn_i_(?:(?:with|summed)\([\w.]+, |multiply_high\(|squared?\()$")
# Text before a number whose sign plays no part: its absolute value is taken, or it is squared, in HN_FIXED after its
# absolute value is taken or with a product that has no more than 32 bits. The noise of an octave is cut off and rounded
# alike on both sides of 0.
SQUARED = re.compile(r"\bhn_i_(?:magnitudes?|squared?|triangle_falloff|ridge|add_(?:turbulence|billow|ridged))\("
                     r"(?:hn_i_(?:bounded_)?octave\(|(?:[^(),]*, )*)$")


def is_equivalent(mutant: Mutant) -> bool:
    line = mutant.original[mutant.original.rfind("\n", 0, mutant.start) + 1:].partition("\n")[0]
    if (include := INCLUDE.match(line)) and mutant.file in library_parts():
        return included_from(mutant.file, include[1]) in included_anyhow(mutant.file)
    if mutant.rule == "argument" and COMMUTES.search(mutant.original, 0, mutant.start):
        return True
    if mutant.rule == "sign" and SQUARED.search(mutant.original, 0, mutant.start):
        return True
    return any(equivalence.covers(mutant) for equivalence in of_file(mutant.file))
