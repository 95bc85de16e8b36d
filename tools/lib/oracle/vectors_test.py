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
    ("lattice", 2, False): {"perlin": (-1140697, 316288), "value": (318433, 1050640), "value_cubic": (-416698, 766763),
        "perlin_d": (-1140697, 511608, -265615, 316288, 235996, -461997), "value_d": (318433, 746820, 840411, 1050640,
        -41642, 0), "simplex": (437246, -1365154), "simplex_smooth": (561660, -1375728), "simplex_d": (437246, -1794054,
        917246, -1365154, -708694, 453602), "curl": (917246, 1794054, 453602, 708694), "perlin_phase": (901753,
        -115489), "perlin_d_phase": (901753, 23701, -664590, -115489, 60966, 626252), "simplex_phase": (750276,
        1432179), "simplex_d_phase": (750276, 760224, -1080156, 1432179, 1257528, -957024), "cellular": (483132, 538588,
        579784, 649508), "cellular_three": (483132, 538588, 837708, 579784, 649508, 937088), "cellular_d": (966264,
        -1773523, 1119230, 1159568, 766715, -1951975), "cellular_smooth": (202233, 263413), "cell_border": (1834,
        3149)},
    ("lattice", 2, True): {"perlin": (-617439, -200404), "value": (487786, -810613), "value_cubic": (426899, -74030),
        "perlin_d": (-617439, -790095, 435022, -200404, -92775, 538189), "value_d": (487786, 29229, -218502, -810613,
        -11385, 0), "simplex": (717888, -1306026), "simplex_smooth": (640480, -1323080), "simplex_d": (717888, 426766,
        -1279842, -1306026, -826064, 632862), "curl": (-1279842, -426766, 632862, 826064), "perlin_phase": (-644152,
        -12474), "perlin_d_phase": (-644152, 706044, -453449, -12474, -215619, -640465), "simplex_phase": (402515,
        1309572), "simplex_d_phase": (402515, 345274, 1834744, 1309572, 1328638, -1060806), "cellular": (107684, 405664,
        509848, 856160), "cellular_three": (107684, 405664, 1088552, 509848, 856160, 923064), "cellular_d": (215368,
        -1256374, -1679158, 1019696, 1512110, -1453142), "cellular_smooth": (30037, 253416), "cell_border": (13913,
        12994)},
    ("lattice", 3, False): {"perlin": (-521142, -253256), "value": (358741, -501037), "value_cubic": (145064, -342339),
        "perlin_d": (-521142, -422041, 31930, -105586, -253256, -214751, 240280, -290504), "value_d": (358741, 34307,
        -101553, 7374, -501037, 241895, 0, -326047), "simplex": (-875311, -706070), "simplex_smooth": (-1040630,
        -570476), "simplex_d": (-875311, -536931, -1002182, 493956, -706070, 991582, 210189, -1111754), "curl":
        (4319728, -3160872, -1717504, -358896, -1203832, -547696), "perlin_phase": (661355, 27870), "perlin_d_phase":
        (661355, -334896, 12973, 367297, 27870, 199675, -405900, 351884), "simplex_phase": (1246953, 424689),
        "simplex_d_phase": (1246953, -534544, -437816, -853856, 424689, -634634, -255396, 685846), "cellular": (501484,
        536740, 494640, 513576), "cellular_three": (501484, 536740, 859120, 494640, 513576, 1044556), "cellular_d":
        (1002968, 1892757, 534424, 727983, 989280, -989863, 1189573, 1415331), "cellular_smooth": (207979, 200271),
        "cell_border": (1326, 689)},
    ("lattice", 3, True): {"perlin": (371971, 407816), "value": (-1690500, 774439), "value_cubic": (-632907, 245533),
        "perlin_d": (371971, 226743, 118305, -142388, 407816, 11769, -235941, -166571), "value_d": (-1690500, -110880,
        -445019, -398605, 774439, -244180, 0, 840021), "simplex": (-315347, 522071), "simplex_smooth": (-255729,
        669677), "simplex_d": (-315347, 1204671, 1292250, 743475, 522071, -365751, -652098, 658873), "curl": (3346080,
        -2297544, -1428328, 2322248, -524928, 769584), "perlin_phase": (-566312, -200701), "perlin_d_phase": (-566312,
        -579280, 555128, -264469, -200701, -81398, 323465, 163633), "simplex_phase": (484384, -170294),
        "simplex_d_phase": (484384, -1283383, -1811164, -1758309, -170294, -53420, 635686, -125869), "cellular":
        (405652, 625856, 818280, 834672), "cellular_three": (405652, 625856, 919088, 818280, 834672, 938620),
        "cellular_d": (811304, 592917, 2005330, 158817, 1636560, 2036524, -246692, 435648), "cellular_smooth": (188532,
        389002), "cell_border": (13969, 578)},
    ("lattice", 4, False): {"perlin": (750651, 341695), "value": (-220556, -1309740), "perlin_d": (750651, -266922,
        131756, 251264, -62139, 341695, 262775, 110935, 387689, -327568), "value_d": (-220556, -245047, -25711, 161790,
        -112308, -1309740, 178976, 0, -904093, -10326), "simplex": (291374, 698274), "simplex_d": (291374, 38262,
        868767, 226048, 484734, 698274, 10006, 1545, 1182722, -289947)},
    ("lattice", 4, True): {"perlin": (-511698, -751452), "value": (-1465536, -381879), "perlin_d": (-511698, -386594,
        73340, -9396, 77833, -751452, 414704, -337288, 521764, 10185), "value_d": (-1465536, -103000, -281723, -323357,
        -456245, -381879, 298648, 0, 377476, -108339), "simplex": (-419424, -878874), "simplex_d": (-419424, -403072,
        -274266, -490140, 109750, -878874, 783982, -608201, -741371, -416570)},
    ("fnv1", 2, False): {"perlin": (852109, 366740), "value": (-1334423, 1504904), "value_cubic": (-849108, 709035),
        "perlin_d": (852109, 43128, -500094, 366740, 223353, -251893), "value_d": (-1334423, -335090, -175048, 1504904,
        -40109, 0), "simplex": (542623, -905715), "simplex_smooth": (569788, -933926), "simplex_d": (542623, -1680508,
        288398, -905715, -922412, -1375406), "curl": (288398, 1680508, -1375406, 922412), "perlin_phase": (-720909,
        -294699), "perlin_d_phase": (-720909, 410015, 186533, -294699, -203892, 478910), "simplex_phase": (559910,
        964159), "simplex_d_phase": (559910, 1409118, -1544610, 964159, 337270, 1031514), "cellular": (329636, 475892,
        803120, 982836), "cellular_three": (329636, 475892, 749936, 803120, 982836, 1159304), "cellular_d": (659272,
        -1882751, 923784, 1606240, -1847683, -992026), "cellular_smooth": (129636, 398994), "cell_border": (13449,
        8564)},
    ("fnv1", 2, True): {"perlin": (256969, 183619), "value": (553303, 560437), "value_cubic": (-45674, 271432),
        "perlin_d": (256969, 411540, -508159, 183619, 216360, -577408), "value_d": (553303, 69667, 772703, 560437,
        -110688, 0), "simplex": (-182280, 252059), "simplex_smooth": (-275730, 257012), "simplex_d": (-182280, -482286,
        -1807554, 252059, 194926, 963064), "curl": (-1807554, 482286, 963064, -194926), "perlin_phase": (1286856,
        48223), "perlin_d_phase": (1286856, -570455, -35061, 48223, 140184, 625626), "simplex_phase": (833004, -867115),
        "simplex_d_phase": (833004, 1036452, -479348, -867115, -927694, -807118), "cellular": (572420, 692276, 498772,
        661388), "cellular_three": (572420, 692276, 850304, 498772, 661388, 856160), "cellular_d": (1144840, -2097137,
        -8254, 997544, -2002076, -624303), "cellular_smooth": (267703, 232807), "cell_border": (3810, 5181)},
}

OF_VECTORS = ("fbm", "turbulence", "clouds", "billow", "ridged", "ping_pong", "weighted")
# With either settings all seven sums at the point, then all in the cell, then fBm at the point with as many octaves as
# DETAILS says, and with the footprint.
SUM_VECTORS: dict[tuple[str, int, bool], tuple[int, ...]] = {
    ("lattice", 2, False): (-801884, 806028, 0, -485096, 393085, 570175, -512972, 42318, 317898, 427713, -1461356,
        1492907, 94325, 107875, -667966, -802739, -31089, 613195, 260579, -870762, 434031, 463130, -17295, 128125,
        515683, 655241, -1065786, 946503, -376588, 8551, 94531, 88040),
    ("lattice", 2, True): (-184354, 663174, 32913, -770804, 809206, -366380, -260323, -178616, 336921, 37801, -1423310,
        1474125, -709824, -96034, -130656, -176160, -97312, 484488, 139185, -1128176, 1151297, -132456, -80700, 282611,
        368952, 1109936, -1359248, 1413108, 161549, 144138, -206392, -105835),
    ("lattice", 3, False): (-335593, 475059, 0, -1147034, 1270252, -615732, -236288, -104805, 215722, 127480, -1665708,
        1694839, -1131417, -86068, -250912, -364340, 86290, 426023, 540800, -1245106, 1303501, 287024, 8020, 30700,
        348001, 399329, -1401150, 1457597, 196962, -12322, -10500, -25830),
    ("lattice", 3, True): (241805, 266600, 987551, -1563952, 1606930, 273442, 189542, -88111, 433566, 154144, -1230020,
        1239238, 351015, -12165, 211202, 243251, 56523, 314478, 463320, -1468196, 1437062, 325346, 80009, 132828,
        390237, 668461, -1316678, 1357593, -494575, 76050, 208067, 111677),
    ("fnv1", 2, False): (616561, 624020, 1949866, -849112, 912375, 680412, 417581, 257443, 369307, 1034464, -1358538,
        1378326, -96286, 169921, 445155, 579647, 168258, 531180, 769926, -1034792, 966330, 53939, 187654, -123528,
        585607, 100265, -925938, 514286, 407924, 9093, 419910, 218910),
    ("fnv1", 2, True): (-155752, 433804, 60390, -1229544, 1285004, -89987, -33787, 321637, 387656, 1226273, -1321840,
        1403049, 713905, 193687, -180858, -148282, -186676, 427723, 31033, -1241706, 1179878, 29105, -63315, 92467,
        365357, 557318, -1366438, 1383421, 158076, 94091, -169732, -76346),
}

# Cellular noise by the dimensions, whether there are periods, and the metric, with this jitter: the three distances in
# units of 2^-20, the cell of the nearest point, and where it is, in the same units; at the point, then in the cell.
JITTER = to_f32(0.7)
CHOSEN: dict[tuple[int, bool, int], tuple[int, ...]] = {
    (2, False, 1): (436348, 602752, 966724, -13, 5, -424039, -102912, 617344, 647480, 866528, 2147483647, -2147483647,
        513331, 342937),
    (2, False, 2): (181579, 346483, 891262, -13, 5, -424039, -102912, 363459, 399812, 716089, 2147483647, -2147483647,
        513331, 342937),
    (2, False, 3): (526951, 794829, 1055130, -13, 5, -424039, -102912, 856268, 899686, 1218969, 2147483647, -2147483647,
        513331, 342937),
    (2, False, 4): (424039, 551424, 962253, -13, 5, -424039, -102912, 513331, 535039, 672460, 2147483647, -2147483647,
        513331, 342937),
    (2, False, 5): (708530, 1141312, 1946392, -13, 5, -424039, -102912, 1219727, 1299498, 1935058, 2147483647,
        -2147483647, 513331, 342937),
    (2, True, 1): (4740, 540372, 1117288, 35, 5, -3994, -2560, 622884, 772908, 815140, 30, 522797, -473601, 404582),
    (2, True, 2): (21, 278477, 1190505, 35, 5, -3994, -2560, 370010, 569715, 633674, 30, 522797, -473601, 404582),
    (2, True, 3): (6554, 635700, 1176167, 35, 5, -3994, -2560, 878183, 936549, 1140122, 30, 522797, -473601, 404582),
    (2, True, 4): (3994, 529920, 1023898, 35, 5, -3994, -2560, 473601, 655257, 750079, 30, 522797, -473601, 404582),
    (2, True, 5): (6575, 914177, 2366672, 35, 5, -3994, -2560, 1248193, 1506264, 1773796, 30, 522797, -473601, 404582),
    (3, False, 1): (453460, 598732, 875836, -13, 5, 0, -365978, -152372, -220161, 520420, 528156, 1010800, 2147483647,
        -2147483648, -7, 261734, -353690, -277914),
    (3, False, 2): (196102, 341873, 731558, -13, 5, 0, -365978, -152372, -220161, 258290, 266028, 974389, 2147483647,
        -2147483648, -7, 261734, -353690, -277914),
    (3, False, 3): (727450, 738511, 1194803, -13, 5, 1, -14746, -128000, 584704, 799128, 893338, 1464729, 2147483647,
        -2147483647, -7, 268902, 446873, 83353),
    (3, False, 4): (365978, 584704, 787251, -13, 5, 0, -365978, -152372, -220161, 353690, 446873, 779674, 2147483647,
        -2147483648, -7, 261734, -353690, -277914),
    (3, False, 5): (934613, 1069323, 1926361, -13, 5, 0, -365978, -152372, -220161, 1065156, 1151628, 2439118,
        2147483647, -2147483647, -7, 268902, 446873, 83353),
    (3, True, 1): (378096, 654860, 984296, 35, 5, 0, -129434, -334439, -119809, 820900, 842420, 879600, 30, 522797, 0,
        -772506, 224665, -163226),
    (3, True, 2): (136334, 408977, 923962, 35, 5, 0, -129434, -334439, -119809, 642664, 676801, 737860, 30, 522797, 0,
        -772506, 224665, -163226),
    (3, True, 3): (583682, 1074381, 1448346, 35, 5, 0, -129434, -334439, -119809, 1160397, 1289011, 1300480, 30, 522797,
        0, -772506, 224665, -163226),
    (3, True, 4): (334439, 527360, 841728, 35, 5, 0, -129434, -334439, -119809, 616039, 726631, 762265, 31, 522796, 0,
        564223, -616039, -108749),
    (3, True, 5): (720016, 1483358, 2372308, 35, 5, 0, -129434, -334439, -119809, 1803061, 1965812, 2038340, 30, 522797,
        0, -772506, 224665, -163226),
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
