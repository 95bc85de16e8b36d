"""Fixed arithmetic gives the values of a C program that was written from the contract, on integers that wrap."""

from __future__ import annotations

import unittest
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from golden.generator import INT_MAX, INT_MIN, to_f32
from oracle import noises, sums
from oracle.curl import CURL
from oracle.gradients import Knobs
from oracle.integers import NOISE_UNIT
from oracle.lattice import Choice
from oracle.nearest import NEAREST, OFFSET
from oracle.noises import Noise

POINT, SEED = tuple(map(to_f32, (-12.34375, 5.7, 0.8125, -3.3))), 0xDEADBEEF
CELL, FRACTION, CELL_SEED = (INT_MAX, INT_MIN, -7, 46), tuple(map(to_f32, (0.1875, 1.0, 0.640625, 0.9))), 5
PERIODS = (48, 1000003, 7, 3)
PHASE, CELL_PHASE = to_f32(-0.3), 1000.4375
# Of octave sums, with the strength of ping-pong; by the same index that of the weighted sum, a number of octaves, which
# is not whole, and a footprint.
SETTINGS = (sums.Options(5, to_f32(1.9), to_f32(0.7), to_f32(2.3)), sums.Options(33, 3.5, to_f32(0.9), to_f32(41.7)))
WEIGHTED, DETAILS, FOOTPRINTS = tuple(map(to_f32, (0.8, 0.3))), (33.5, to_f32(6.7)), tuple(map(to_f32, (0.07, 0.001)))

# By hash, dimensions, and whether there are periods: of each noise what it returns at the point, then what it returns
# for the cell and the fraction.
VECTORS: dict[tuple[str, int, bool], dict[str, tuple[int, ...]]] = {
    ("lattice", 1, False): {"perlin": (-350244, 173864), "value": (934856, 358490), "value_cubic": (729236, 183014),
        "perlin_d": (-350244, -125484, 173864, 267844), "value_d": (934856, 141626, 358490, -139721)},
    ("lattice", 1, True): {"perlin": (294804, 297884), "value": (-1403596, 554452), "value_cubic": (-1433289, 22537),
        "perlin_d": (294804, 404836, 297884, 499596), "value_d": (-1403596, 41317, 554452, -272384)},
    ("lattice", 2, False): {"perlin": (1011577, -342815), "value": (-128768, -992258), "value_cubic": (665192, -912736),
        "perlin_d": (1011577, -214596, 308698, -342815, -349088, -538170), "value_d": (-128768, -749673, -837303,
        -992258, 117632, 0), "simplex": (-1286650, -736365), "simplex_smooth": (-1368937, -806912), "simplex_d":
        (-1286650, 135898, -793808, -736365, -1765662, -1343302), "curl": (-793808, -135898, -1343302, 1765662),
        "perlin_phase": (-286413, 420439), "perlin_d_phase": (-286413, -662462, 773201, 420439, 354809, 308821),
        "simplex_phase": (323681, 1136175), "simplex_d_phase": (323681, -419384, -914688, 1136175, 1802236, 1310946),
        "cellular": (403576, 848332, 266556, 558620), "cellular_three": (403576, 848332, 1047216, 266556, 558620,
        1024432), "cellular_d": (807152, -1548451, 1414357, 533112, -555892, -2022158), "cellular_smooth": (200914,
        118951), "cell_border": (19057, 9134)},
    ("lattice", 2, True): {"perlin": (-21, -229365), "value": (-27925, -377521), "value_cubic": (123024, 190820),
        "perlin_d": (-21, 698669, -124474, -229365, -464471, 614719), "value_d": (-27925, 695738, -646311, -377521,
        307697, 0), "simplex": (214086, 562348), "simplex_smooth": (236540, 494378), "simplex_d": (214086, 513706,
        856534, 562348, -1251134, 209552), "curl": (856534, -513706, 209552, 1251134), "perlin_phase": (210333, 8382),
        "perlin_d_phase": (210333, -81178, 790527, 8382, 148548, -625287), "simplex_phase": (-1286358, -768208),
        "simplex_d_phase": (-1286358, 263792, -1043190, -768208, 768266, 429590), "cellular": (416212, 982368, 297632,
        644100), "cellular_three": (416212, 982368, 1074004, 297632, 644100, 666956), "cellular_d": (832424, -1068035,
        1804823, 595264, -2085201, 223672), "cellular_smooth": (207958, 135299), "cell_border": (21038, 11542)},
    ("lattice", 3, False): {"perlin": (163715, -832543), "value": (-175458, -991895), "value_cubic": (140763, -508820),
        "perlin_d": (163715, 375387, 353918, 211736, -832543, -352438, -40493, 169555), "value_d": (-175458, 294506,
        -595991, -8544, -991895, 92536, 0, -506533), "simplex": (652791, -915771), "simplex_smooth": (881001, -1030854),
        "simplex_d": (652791, 1233594, 173245, 394700, -915771, 416566, -293931, -1576851), "curl": (-284336, 3013896,
        -434208, 612088, 2433296, -291880), "perlin_phase": (-226506, 646199), "perlin_d_phase": (-226506, -131631,
        50094, 180605, 646199, 439893, -5209, -121968), "simplex_phase": (-831131, 631695), "simplex_d_phase": (-831131,
        -377390, 337803, 987643, 631695, -18979, 189580, 1214808), "cellular": (588996, 636876, 337800, 451460),
        "cellular_three": (588996, 636876, 716948, 337800, 451460, 762476), "cellular_d": (1177992, 933377, -1477362,
        1159430, 675600, -1411312, 940875, 1233309), "cellular_smooth": (253749, 129288), "cell_border": (1915, 5660)},
    ("lattice", 3, True): {"perlin": (1162180, 451264), "value": (-5197, -880980), "value_cubic": (-358, -301202),
        "perlin_d": (1162180, -283181, -261363, 497520, 451264, 207556, 411430, -316450), "value_d": (-5197, -491801,
        563329, 4157, -880980, 187484, 0, -266819), "simplex": (217092, 76710), "simplex_smooth": (446009, 119186),
        "simplex_d": (217092, 1762159, 944938, 733081, 76710, 90017, 938548, 169986), "curl": (-1760928, 3488776,
        -264152, -217200, 167848, -811712), "perlin_phase": (-67905, -494337), "perlin_d_phase": (-67905, -322602,
        177540, -291312, -494337, -366536, -339129, 132931), "simplex_phase": (765392, -258219), "simplex_d_phase":
        (765392, -1110420, -1059862, -1210984, -258219, -142872, -909855, -545515), "cellular": (534208, 564132, 607828,
        673768), "cellular_three": (534208, 564132, 1110284, 607828, 673768, 1014388), "cellular_d": (1068416, 828107,
        -141502, -1921530, 1215656, -1830117, 1003384, 204916), "cellular_smooth": (226777, 279173), "cell_border":
        (952, 2760)},
    ("lattice", 4, False): {"perlin": (252817, -218993), "value": (1164338, -1447141), "perlin_d": (252817, 46738,
        -146211, 486272, -300377, -218993, -517081, 325528, -334488, -124474), "value_d": (1164338, 398251, 25305,
        297182, 670087, -1447141, 158444, 0, -308077, -126695), "simplex": (-44793, -454379), "simplex_d": (-44793,
        643105, 181087, 271613, -365968, -454379, -224000, 608201, -793434, -205599)},
    ("lattice", 4, True): {"perlin": (522248, 635067), "value": (-27374, -1562487), "perlin_d": (522248, 597233, 212,
        76839, -102634, 635067, -16458, -133535, 103319, 171588), "value_d": (-27374, -422703, 397740, -31432, 44973,
        -1562487, 493326, 0, -261897, -116295), "simplex": (859029, 1329811), "simplex_d": (859029, 548918, -221280,
        -713619, 244247, 1329811, -536780, -1545, 1607234, 612247)},
    ("fnv1", 2, False): {"perlin": (296546, 433494), "value": (-666279, 1649049), "value_cubic": (-605652, 1229399),
        "perlin_d": (296546, 436139, 595089, 433494, 399020, -119264), "value_d": (-666279, -109906, -147299, 1649049,
        -178555, 0), "simplex": (-524526, -623040), "simplex_smooth": (-526710, -564330), "simplex_d": (-524526,
        -1295774, 86914, -623040, 1032146, 161808), "curl": (86914, 1295774, 161808, -1032146), "perlin_phase": (540321,
        -319519), "perlin_d_phase": (540321, -930527, -10136, -319519, -195296, 361024), "simplex_phase": (572859,
        292666), "simplex_d_phase": (572859, 647032, -2013764, 292666, -1437814, -747826), "cellular": (664120, 852388,
        582440, 808668), "cellular_three": (664120, 852388, 893960, 582440, 808668, 864324), "cellular_d": (1328240,
        1852840, 982360, 1164880, 770592, 1950447), "cellular_smooth": (327107, 285521), "cell_border": (5911, 9322)},
    ("fnv1", 2, True): {"perlin": (-634309, -481091), "value": (830941, -1994550), "value_cubic": (346680, -542972),
        "perlin_d": (-634309, 505383, -556509, -481091, -516495, -37348), "value_d": (830941, 524814, 709899, -1994550,
        311427, 0), "simplex": (-739467, -1543059), "simplex_smooth": (-816515, -1611519), "simplex_d": (-739467,
        1629890, -698778, -1543059, -2006582, -503080), "curl": (-698778, -1629890, -503080, 2006582), "perlin_phase":
        (1239044, 404016), "perlin_d_phase": (1239044, 930, -142099, 404016, 342871, -221959), "simplex_phase":
        (-841090, 1585807), "simplex_d_phase": (-841090, -752536, 319096, 1585807, 1896482, 170508), "cellular":
        (403240, 531268, 555984, 849196), "cellular_three": (403240, 531268, 785496, 555984, 849196, 975740),
        "cellular_d": (806480, -1453881, 1511396, 1111968, 730010, -1966008), "cellular_smooth": (170697, 276033),
        "cell_border": (22545, 13509)},
}

OF_VECTORS = ("fbm", "turbulence", "clouds", "billow", "ridged", "ping_pong", "weighted")
# With either settings all seven sums at the point, then all in the cell, then fBm at the point with as many octaves as
# DETAILS says, and with the footprint.
SUM_VECTORS: dict[tuple[str, int, bool], tuple[int, ...]] = {
    ("lattice", 2, False): (73335, 897488, 506617, -302176, 462816, 515911, 231338, -114321, 399058, 113281, -1299036,
        1378621, -573249, -107927, 126530, 129021, 57489, 563133, 465798, -970886, 714000, -300734, 35042, 2772, 308190,
        333930, -1480772, 1509947, 604623, -6014, 11542, 15515),
    ("lattice", 2, True): (36732, 109759, 413979, -1877634, 1887340, -669892, 13551, -442741, 621165, 0, -854822,
        724201, -691304, -303282, -27781, 32355, -29779, 505361, 263285, -1086430, 886172, -272255, -56792, -259194,
        520305, 64, -1056542, 802516, -105857, -129846, -114125, -86218),
    ("lattice", 3, False): (-255349, 373422, 270, -1350308, 1382201, -595420, -59116, -294183, 450657, 0, -1195838,
        1219788, 108777, -283378, -185356, -251625, -69495, 270223, 186339, -1556706, 1583422, 509541, -19111, -170332,
        477962, 45430, -1141228, 1093996, -266252, -120624, -43136, -37818),
    ("lattice", 3, True): (326189, 566671, 1239714, -963810, 832226, -674390, 333325, 64534, 353996, 483807, -1389160,
        1454658, -285318, 87781, 262291, 329272, 70741, 487467, 499866, -1122218, 1024518, 225060, 108397, 34937,
        473171, 409614, -1150810, 1084096, 234309, 106333, 127355, 87400),
    ("fnv1", 2, False): (404047, 438569, 1463847, -1220014, 1259077, 633885, 259723, 114891, 383394, 618405, -1330364,
        1405409, 168816, 160353, 382252, 411163, -191499, 495558, 27286, -1106036, 923097, -37895, -84529, 74402,
        515640, 509419, -1065872, 862843, 291785, 92088, -160308, -84496),
    ("fnv1", 2, True): (-410417, 447711, 0, -1201730, 1265649, -534706, -280695, 256940, 632940, 1032928, -831272,
        775017, -724446, 8957, -341223, -418104, -94011, 486465, 144459, -1124222, 988529, 150637, -79335, 34741,
        357443, 409143, -1382266, 1392532, -141348, 18095, -61115, -27392),
}

# Cellular noise by the dimensions, whether there are periods, and the metric, with this jitter: the three distances in
# units of 2^-20, the cell of the nearest point, and where it is, in the same units; at the point, then in the cell.
JITTER = to_f32(0.7)
CHOSEN: dict[tuple[int, bool, int], tuple[int, ...]] = {
    (2, False, 1): (299416, 959588, 979348, -13, 5, 159436, -253440, 368156, 524992, 1157456, 2147483647, -2147483647,
        147763, 337203),
    (2, False, 2): (85498, 878158, 914694, -13, 5, 159436, -253440, 129260, 262849, 1277643, 2147483647, -2147483647,
        147763, 337203),
    (2, False, 3): (412876, 1042022, 1356594, -13, 5, 159436, -253440, 484966, 562177, 1533542, 2147483647, -2147483647,
        147763, 337203),
    (2, False, 4): (253440, 696217, 977203, -13, 5, 159436, -253440, 337203, 523572, 1032704, 2147483647, -2147483647,
        147763, 337203),
    (2, False, 5): (498374, 1956716, 2234752, -13, 5, 159436, -253440, 614226, 825026, 2811186, 2147483647, -2147483647,
        147763, 337203),
    (2, True, 1): (328968, 997596, 1034748, 35, 5, 99225, -313651, 354296, 695348, 709292, 31, 522796, 305459, -179508),
    (2, True, 2): (103209, 949102, 1021104, 35, 5, 99225, -313651, 119713, 461114, 479793, 31, 522796, 305459, -179508),
    (2, True, 3): (412876, 1369702, 1403903, 35, 5, 99225, -313651, 484967, 878183, 968500, 31, 522796, 305459,
        -179508),
    (2, True, 4): (313651, 853913, 908390, 35, 5, 99225, -313651, 305459, 569447, 681473, 31, 522796, 305459, -179508),
    (2, True, 5): (516085, 2318804, 2425007, 35, 5, 99225, -313651, 604680, 1357976, 1429614, 31, 522796, 305459,
        -179508),
    (3, False, 1): (559112, 674120, 718148, -13, 5, 0, -46285, -414720, -372122, 411380, 494044, 786020, 2147483647,
        -2147483648, -7, 257433, -263373, -183296),
    (3, False, 2): (298127, 433390, 491850, -13, 5, 0, -46285, -414720, -372122, 161394, 232775, 589211, 2147483647,
        -2147483648, -7, 257433, -263373, -183296),
    (3, False, 3): (833127, 1071514, 1101005, -13, 5, 0, -46285, -414720, -372122, 704102, 818790, 1223476, 2147483647,
        -2147483648, -7, 257433, -263373, -183296),
    (3, False, 4): (414720, 542105, 601907, -13, 5, 0, -46285, -414720, -372122, 263373, 386662, 623206, 2147483647,
        -2147483648, -7, 257433, -263373, -183296),
    (3, False, 5): (1131254, 1534395, 1563364, -13, 5, 0, -46285, -414720, -372122, 865496, 1051565, 1812687,
        2147483647, -2147483648, -7, 257433, -263373, -183296),
    (3, True, 1): (496736, 593736, 1093160, 35, 5, 0, 75571, -232653, -432333, 598424, 634476, 962980, 31, 522796, 0,
        469606, -360858, -85812),
    (3, True, 2): (235319, 336192, 1139642, 35, 5, 0, 75571, -232653, -432333, 341522, 383914, 884371, 31, 522796, 0,
        469606, -360858, -85812),
    (3, True, 3): (740557, 793396, 1665844, 35, 5, 0, 75571, -232653, -432333, 916276, 968293, 1515110, 31, 522796, 0,
        469606, -360858, -85812),
    (3, True, 4): (432333, 558899, 708403, 35, 5, 0, 75571, -232653, -432333, 469606, 554393, 663553, 31, 522796, 0,
        469606, -360858, -85812),
    (3, True, 5): (975876, 1129588, 2805486, 35, 5, 0, 75571, -232653, -432333, 1257798, 1352207, 2529129, 31, 522796,
        0, 469606, -360858, -85812),
}


def units(noise: Noise, numbers: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """As the integers that they are."""
    return tuple(x * unit for x, unit in zip(numbers, noise.units))


class Vectors(unittest.TestCase):
    def test_noises(self) -> None:
        for (hash_name, n, has_periods), vectors in VECTORS.items():
            periods = PERIODS[:n] if has_periods else ()
            for name in vectors:
                noise, knobs = CURL if name == CURL.name else noises.find(name), Knobs(hash_name)
                at_point, in_cell = (noise if noise.phase is None else noise.turned(phase)
                                     for phase in (PHASE, CELL_PHASE))
                found = (*units(noise, at_point.fixed(knobs, POINT[:n], SEED, periods)),
                         *units(noise, in_cell.fixed_cell(knobs, CELL[:n], FRACTION[:n], CELL_SEED, periods)))
                self.assertEqual(found, vectors[name], (name, hash_name, n, periods))

    def test_choices(self) -> None:
        for (n, has_periods, metric), expected in CHOSEN.items():
            found: list[Fraction | int] = []
            for of, place in (("fixed", (POINT[:n], SEED)), ("fixed_cell", (CELL[:n], FRACTION[:n], CELL_SEED))):
                for noise in (noises.find("cellular_three"), NEAREST, OFFSET):
                    chosen = noise.chosen(Choice(JITTER, metric))
                    numbers = getattr(chosen, of)(Knobs("lattice"), *place, PERIODS[:n] if has_periods else ())
                    found += units(noise, numbers)
            self.assertEqual(tuple(found), expected, (n, has_periods, metric))

    def test_sums(self) -> None:
        """Others have tests by hand in sums_test.py."""
        perlin = noises.find("perlin")
        point, cell = sums.fixed_at_position(POINT), sums.fixed_in_cell(CELL, FRACTION)
        for (hash_name, n, has_periods), expected in SUM_VECTORS.items():
            periods, found = PERIODS[:n] if has_periods else (), []

            def add(name: str, place: sums.FixedPlace, options: sums.Options, seed: int) -> None:
                found.append(sums.fixed(name, perlin, Knobs(hash_name), place[:n], options, seed, periods))

            for options, strength, octaves, footprint in zip(SETTINGS, WEIGHTED, DETAILS, FOOTPRINTS):
                for place, seed in ((point, SEED), (cell, CELL_SEED)):
                    for name in OF_VECTORS:
                        add(name, place, replace(options, strength=strength) if name == "weighted" else options, seed)
                add("fbm", point, replace(options, octaves=octaves), SEED)
                add("fbm", point, replace(options, footprint=footprint), SEED)
            self.assertEqual(tuple(x * NOISE_UNIT for x in found), expected, (hash_name, n, periods))

    def test_every_noise_has_some_or_a_test_of_its_own(self) -> None:
        found = {name for vectors in VECTORS.values() for name in vectors}
        of_their_own = {path.stem.removesuffix("_test") for path in Path(noises.__file__).parent.glob("*_test.py")}
        self.assertEqual(found | of_their_own, {*noises.names(), CURL.name} | of_their_own)
