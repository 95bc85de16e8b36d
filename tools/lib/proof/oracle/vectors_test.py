"""Fixed arithmetic gives the values of a C program that was written from the contract, on integers that wrap."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from proof.golden.generator import INT_MAX, INT_MIN, to_f32
from proof.oracle import noises, sums
from proof.oracle.gradients import Knobs
from proof.oracle.hashes import MASK
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.lattice import Choice
from proof.oracle.nearest import NEAREST, OFFSET
from proof.oracle.noises import Noise
from proof.oracle.self_check import self_check
from proof.oracle.testing import METRICS

POINT, SEED = tuple(map(to_f32, (-12.34375, 5.7, 0.8125, -3.3))), 0xDEADBEEF
CELL, FRACTION, CELL_SEED = (INT_MAX, INT_MIN, -7, 46), tuple(map(to_f32, (0.1875, 1.0, 0.640625, 0.9))), 5
PERIODS = (48, 1000003, 7, 3)
PHASE, CELL_PHASE = to_f32(-0.3), 1000.4375
# Of octave sums, with the strength of ping-pong; by the same index that of the weighted sum, a number of octaves, which
# is not whole, and a footprint.
SETTINGS = (sums.Options(5, to_f32(1.9), to_f32(0.7), to_f32(2.3)), sums.Options(33, 3.5, to_f32(0.9), to_f32(41.7)))
WEIGHTED, DETAILS, FOOTPRINTS = tuple(map(to_f32, (0.8, 0.3))), (33.5, to_f32(6.7)), tuple(map(to_f32, (0.07, 0.001)))

# By dimensions, and whether there are periods: each noise's numbers at the point, then for the cell and the fraction.
# (hashes_test.py has words of other hashes.)
VECTORS: dict[tuple[int, bool], dict[str, tuple[int, ...]]] = {
    (1, False): {"perlin": (-350244, 173864), "value": (934856, 358490), "value_cubic": (729236, 183014),
        "perlin_d": (-350244, -125484, 173864, 267844), "value_d": (934856, 141626, 358490, -139721)},
    (1, True): {"perlin": (294804, 297884), "value": (-1403596, 554452), "value_cubic": (-1433289, 22537),
        "perlin_d": (294804, 404836, 297884, 499596), "value_d": (-1403596, 41317, 554452, -272384)},
    (2, False): {"perlin": (-1214904, 464459), "value": (318433, 1050640), "value_cubic": (-416698, 766763),
        "perlin_d": (-1214904, 582430, -293990, 464459, 455869, -188647), "value_d": (318433, 746820, 840411, 1050640,
        -41642, 0), "simplex": (546216, -1333272), "simplex_smooth": (688471, -1349418), "simplex_d": (546216, -2067240,
        1035286, -1333272, -711816, 975946), "curl": (1035286, 2067240, 975946, 711816), "perlin_phase": (1021423,
        -322474), "perlin_d_phase": (1021423, 197115, -737879, -322474, -208473, 434609), "simplex_phase": (865001,
        1311808), "simplex_d_phase": (865001, 910650, -1209622, 1311808, 1369482, -1421920), "cellular": (483132,
        538588, 579784, 649508), "cellular_three": (483132, 538588, 837708, 579784, 649508, 937088), "cellular_d":
        (966264, -1773523, 1119230, 1159568, 766715, -1951975), "cellular_smooth": (202233, 263413), "cell_border":
        (1834, 3149)},
    (2, True): {"perlin": (-590294, -130055), "value": (487786, -810613), "value_cubic": (426899, -74030),
        "perlin_d": (-590294, -806752, 352400, -130055, -71187, 634520), "value_d": (487786, 29229, -218502, -810613,
        -11385, 0), "simplex": (510037, -1333272), "simplex_smooth": (393995, -1349418), "simplex_d": (510037, 142856,
        -1895564, -1333272, -711816, 975946), "curl": (-1895564, -142856, 975946, 711816), "perlin_phase": (-677177,
        -114455), "perlin_d_phase": (-677177, 652043, -349374, -114455, -294144, -675922), "simplex_phase": (927014,
        1311808), "simplex_d_phase": (927014, 502192, 1797956, 1311808, 1369482, -1421920), "cellular": (107684, 405664,
        509848, 856160), "cellular_three": (107684, 405664, 1088552, 509848, 856160, 923064), "cellular_d": (215368,
        -1256374, -1679158, 1019696, 1512110, -1453142), "cellular_smooth": (30037, 253416), "cell_border": (13913,
        12994)},
    (3, False): {"perlin": (496773, 766397), "value": (358741, -501037), "value_cubic": (145064, -342339),
        "perlin_d": (496773, -114445, -377213, 245361, 766397, 334631, 119885, 185832), "value_d": (358741, 34307,
        -101553, 7374, -501037, 241895, 0, -326047), "simplex": (-639388, 1137576), "simplex_smooth": (-679208,
        1411777), "simplex_d": (-639388, 284812, 616306, 1719283, 1137576, -624250, 355, 1851272), "curl": (3411840,
        -1995728, 150208, -3237912, 1417384, -1092096), "perlin_phase": (-411084, -523889), "perlin_d_phase": (-411084,
        305382, -37000, 102786, -523889, -138810, 61844, -278878), "simplex_phase": (992464, -1100604),
        "simplex_d_phase": (992464, -920370, -942649, -1242887, -1100604, 878559, 225099, -1808512), "cellular":
        (501484, 536740, 494640, 513576), "cellular_three": (501484, 536740, 859120, 494640, 513576, 1044556),
        "cellular_d": (1002968, 1892757, 534424, 727983, 989280, -989863, 1189573, 1415331), "cellular_smooth": (207979,
        200271), "cell_border": (1326, 689)},
    (3, True): {"perlin": (-816882, 40866), "value": (-1690500, 774439), "value_cubic": (-632907, 245533),
        "perlin_d": (-816882, 344333, -183412, -118400, 40866, -207023, 24596, 11545), "value_d": (-1690500, -110880,
        -445019, -398605, 774439, -244180, 0, 840021), "simplex": (-213933, 378311), "simplex_smooth": (-480100,
        530822), "simplex_d": (-213933, -1249960, -1683061, -569806, 378311, -759015, 64530, 186029), "curl": (-4707728,
        1313208, 6448272, 5936, -475760, 189256), "perlin_phase": (242597, -92704), "perlin_d_phase": (242597,
        568881, -330461, -133134, -92704, 196446, 164043, -93811), "simplex_phase": (-37330, -596474),
        "simplex_d_phase": (-37330, 1608229, 703849, 307237, -596474, 853771, -23524, -585607), "cellular": (405652,
        625856, 818280, 834672), "cellular_three": (405652, 625856, 919088, 818280, 834672, 938620), "cellular_d":
        (811304, 592917, 2005330, 158817, 1636560, 2036524, -246692, 435648), "cellular_smooth": (188532, 389002),
        "cell_border": (13969, 578)},
    (4, False): {"perlin": (280759, 1150), "value": (-220556, -1309740), "perlin_d": (280759, 238056,
        -694339, -110433, -57686, 1150, 118809, 110935, 172266, 343765), "value_d": (-220556, -245047, -25711, 161790,
        -112308, -1309740, 178976, 0, -904093, -10326), "simplex": (-95748, 211710), "simplex_d": (-95748, 567017,
        -503521, 104126, 43534, 211710, 430186, 1545, 377401, 702337)},
    (4, True): {"perlin": (-630290, 830633), "value": (-1465536, -381879), "perlin_d": (-630290, 15989,
        190701, -68448, -185921, 830633, 126574, 335296, -350756, 104592), "value_d": (-1465536, -103000, -281723,
        -323357, -456245, -381879, 298648, 0, 377476, -108339), "simplex": (744427, 877631), "simplex_d": (744427,
        -1318647, -1446193, -1390218, -1062194, 877631, -776142, 608201, 768116, 415513)},
}

OF_VECTORS = ("fbm", "turbulence", "clouds", "billow", "ridged", "ping_pong", "weighted")
# With either settings all seven sums at the point, then all in the cell, then fBm at the point with DETAILS octaves,
# and with the footprint.
SUM_VECTORS: dict[tuple[int, bool], tuple[int, ...]] = {
    (2, False): (-828422, 887732, 0, -321688, 296144, 847954, -541617, 79370, 423728, 522447, -1249696,
        1329110, 519926, 157946, -701735, -840648, -25826, 629769, 271525, -837614, 364636, -45502, -21500, 193534,
        555155, 843880, -986842, 841218, 52772, 48803, 78584, 84485),
    (2, True): (-222962, 663652, 8576, -769848, 768278, -578923, -266901, -241554, 322491, 2414, -1452170,
        1521476, -1014141, -119875, -151513, -214049, -133069, 494671, 87504, -1107810, 1103987, -164365, -95046,
        299010, 389809, 1158985, -1317534, 1341763, 184121, 164448, -252311, -121182),
    (3, False): (-44668, 402949, 233202, -1291254, 1374874, 40318, 120208, 298039, 524820, 1156071, -1047512,
        1124185, 487665, 334245, -86735, -20560, -49833, 404215, 223105, -1288722, 1355351, 118755, -36514, 306073,
        522133, 1180027, -1052886, 961274, 589507, 223767, -117308, -64905),
    (3, True): (-26204, 864100, 270743, -368952, 492142, 364844, -159508, 133035, 324069, 669049, -1449014,
        1461667, -294705, 114602, -24822, 328, -106852, 503190, 124366, -1090772, 1027338, 51158, -20272, -186201,
        521356, 31410, -1054440, 702653, -589896, -144548, 37795, 51705),
}

# Cellular noise by the dimensions and the metric, with this jitter, and in space with periods: the three distances in
# units of 2^-20, the cell of the nearest point, and where it is, in the same units; at the point, then in the cell.
JITTER = to_f32(0.7)
CHOSEN: dict[tuple[int, int], tuple[int, ...]] = {
    (2, 1): (436348, 602752, 966724, -13, 5, -424039, -102912, 617344, 647480, 866528, 2147483647, -2147483647, 513331,
        342937),
    (2, 2): (181579, 346483, 891262, -13, 5, -424039, -102912, 363459, 399812, 716089, 2147483647, -2147483647, 513331,
        342937),
    (2, 3): (526951, 794829, 1055130, -13, 5, -424039, -102912, 856268, 899686, 1218969, 2147483647, -2147483647,
        513331, 342937),
    (2, 4): (424039, 551424, 962253, -13, 5, -424039, -102912, 513331, 535039, 672460, 2147483647, -2147483647, 513331,
        342937),
    (2, 5): (708530, 1141312, 1946392, -13, 5, -424039, -102912, 1219727, 1299498, 1935058, 2147483647, -2147483647,
        513331, 342937),
    (3, 1): (378096, 654860, 984296, 35, 5, 0, -129434, -334439, -119809, 820900, 842420, 879600, 30, 522797, 0,
        -772506, 224665, -163226),
    (3, 2): (136334, 408977, 923962, 35, 5, 0, -129434, -334439, -119809, 642664, 676801, 737860, 30, 522797, 0,
        -772506, 224665, -163226),
    (3, 3): (583682, 1074381, 1448346, 35, 5, 0, -129434, -334439, -119809, 1160397, 1289011, 1300480, 30, 522797, 0,
        -772506, 224665, -163226),
    (3, 4): (334439, 527360, 841728, 35, 5, 0, -129434, -334439, -119809, 616039, 726631, 762265, 31, 522796, 0, 564223,
        -616039, -108749),
    (3, 5): (720016, 1483358, 2372308, 35, 5, 0, -129434, -334439, -119809, 1803061, 1965812, 2038340, 30, 522797, 0,
        -772506, 224665, -163226),
}


def units(noise: Noise, numbers: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """As the integers that they are."""
    return tuple(x * unit for x, unit in zip(numbers, noise.units))


# hn_perlin with the sine gradient, by the dimensions.
SINES = {2: (630731, -259344), 3: (447805, 534313)}
# hn_self_check by the hash and its argument.
SELF_CHECKS = {("lattice", 0): 464614027, ("lattice", 1): 2867596985, ("lattice", MASK): 783962384,
               ("pcg", 0): 2027622782}


class Vectors(unittest.TestCase):
    """Any bit of fixed arithmetic that differs from a program that knows nothing of the oracle."""

    def test_noises(self) -> None:
        with_sine = {(n, False): {"perlin": vectors} for n, vectors in SINES.items()}
        for sine, ((n, has_periods), vectors) in (
                *((False, row) for row in VECTORS.items()), *((True, row) for row in with_sine.items())):
            periods = PERIODS[:n] if has_periods else ()
            for name in vectors:
                noise, knobs = noises.find(name), Knobs("lattice", sine)
                at_point, in_cell = (noise if noise.phase is None else noise.rotated(phase)
                                     for phase in (PHASE, CELL_PHASE))
                found = (*units(noise, at_point.fixed(knobs, POINT[:n], SEED, periods)),
                         *units(noise, in_cell.fixed_cell(knobs, CELL[:n], FRACTION[:n], CELL_SEED, periods)))
                self.assertEqual(found, vectors[name], (name, knobs, n, periods))

    def test_choices(self) -> None:
        for (n, metric), expected in CHOSEN.items():
            found: list[Fraction | int] = []
            for of, place in (("fixed", (POINT[:n], SEED)), ("fixed_cell", (CELL[:n], FRACTION[:n], CELL_SEED))):
                for noise in (noises.find("cellular_three"), NEAREST, OFFSET):
                    chosen = noise.chosen(Choice(JITTER, metric))
                    numbers = getattr(chosen, of)(Knobs("lattice"), *place, PERIODS[:n] if n == 3 else ())
                    found += units(noise, numbers)
            self.assertEqual(tuple(found), expected, (n, metric))
        self.assertEqual({*CHOSEN}, {*itertools.product((2, 3), METRICS)}, "a metric needs values of another program")

    def test_sums(self) -> None:
        """Others have tests by hand in sums_test.py."""
        perlin = noises.find("perlin")
        point, cell = sums.fixed_at_position(POINT), sums.fixed_in_cell(CELL, FRACTION)
        for (n, has_periods), expected in SUM_VECTORS.items():
            periods, found = PERIODS[:n] if has_periods else (), []

            def add(name: str, place: sums.FixedPlace, options: sums.Options, seed: int) -> None:
                found.append(sums.fixed(name, perlin, Knobs("lattice"), place[:n], options, seed, periods))

            for options, strength, octaves, footprint in zip(SETTINGS, WEIGHTED, DETAILS, FOOTPRINTS):
                for place, seed in ((point, SEED), (cell, CELL_SEED)):
                    for name in OF_VECTORS:
                        add(name, place, replace(options, strength=strength) if name == "weighted" else options, seed)
                add("fbm", point, replace(options, octaves=octaves), SEED)
                add("fbm", point, replace(options, footprint=footprint), SEED)
            self.assertEqual(tuple(x * NOISE_UNIT for x in found), expected, (n, periods))

    def test_self_check(self) -> None:
        self.assertEqual({key: self_check(*key) for key in SELF_CHECKS}, SELF_CHECKS)

    def test_every_noise_has_some_or_a_test_of_its_own(self) -> None:
        found = {name for vectors in VECTORS.values() for name in vectors}
        found |= {f"{name}_vector" for name in ("perlin", "value")}  # components_test.py has what they are of those
        found |= {"phasor_bandwidth", "phasor_d", "phasor_d_bandwidth"}  # in phasor_test.py
        found |= {"curl_phase", "cellular_phase", "hex_tiling"}  # in curl_test.py and so on
        of_their_own = {path.stem.removesuffix("_test") for path in Path(noises.__file__).parent.glob("*_test.py")}
        self.assertLessEqual({*noises.names()}, found | of_their_own)
