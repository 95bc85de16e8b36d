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
    ("lattice", 1, False): {"perlin": (561088, 597288), "value": (-934681, 2055314), "value_cubic": (-833097,
        1834182), "perlin_d": (561088, -639448, 597288, 415032), "value_d": (-934681, -335743, 2055314,
        -35276)},
    ("lattice", 1, True): {"perlin": (1194380, -473912), "value": (47804, -1811046), "value_cubic": (-97209,
        -1170154), "perlin_d": (1194380, -610360, -473912, -247068), "value_d": (47804, 284345, -1811046,
        360419)},
    ("lattice", 2, False): {"perlin": (576409, -230064), "value": (1189463, -1444589), "value_cubic": (982048,
        -659906), "perlin_d": (576409, -286149, 169511, -230064, -189514, 598230), "value_d": (1189463, -151464, 68628,
        -1444589, 23189, 0), "simplex": (-505872, 1059032),
        "simplex_smooth": (-645056, 1045610), "simplex_d": (-505872, -225800, -1811860, 1059032, 88358, 198282), "curl":
        (-1811860, 225800, 198282, -88358), "perlin_phase": (351277, 89602), "perlin_d_phase": (351277, 285920, -113706,
        89602, 117291, -692444), "simplex_phase": (1104471, -656980), "simplex_d_phase": (1104471, 266882, 321934,
        -656980, 683530, 354202),
        "cellular": (543216, 549020, 285344, 786496), "cellular_three": (543216, 549020, 820208, 285344,
        786496, 856160), "cellular_d": (1086432, -106738, 2094445, 570688, -338667, 2069635),
        "cellular_smooth": (223762, 140871), "cell_border": (182, 17999)},
    ("lattice", 2, True): {"perlin": (851237, 313681), "value": (687629, -291964), "value_cubic": (298922, 61218),
        "perlin_d": (851237, 325856, -580861, 313681, 129502, 354921), "value_d": (687629, -93103, 568796, -291964,
        417448, 0), "simplex": (-161264, -81006),
        "simplex_smooth": (-268797, -85217), "simplex_d": (-161264, -575810, -1709458, -81006, -118434, 1083094),
        "curl": (-1709458, 575810, 1083094, 118434), "perlin_phase": (-159766, -397650), "perlin_d_phase": (-159766,
        270049, 550007, -397650, -253914, -99026), "simplex_phase": (775351, -601917), "simplex_d_phase": (775351,
        1148440, -725992, -601917, -657062, -1012708),
        "cellular": (448172, 652288, 532780, 684056), "cellular_three": (448172, 652288, 860052, 532780,
        684056, 800344), "cellular_d": (896344, 1087704, -1793036, 1065560, 1850097, -987524),
        "cellular_smooth": (209841, 248510), "cell_border": (7432, 8361)},
    ("lattice", 3, False): {"perlin": (-277372, 259050), "value": (-193137, 1584299), "value_cubic": (420690,
        574709), "perlin_d": (-277372, -285982, 63254, 365659, 259050, -73726, 475963, 127949), "value_d": (-193137,
        -504363, -718417, -253001, 1584299, -420511, 0, -12581),
        "simplex": (824368, 681714), "simplex_smooth": (851050, 734965), "simplex_d": (824368, -973669, -1128590,
        -1512306, 681714, -599679, 668177, 1071526), "curl": (2973688, -1061224, -1122592, 778312, 1353376, -408352),
        "perlin_phase": (-475286, -285292), "perlin_d_phase": (-475286, -443342, 255275, 46463, -285292, 88135, -325614,
        -257153), "simplex_phase": (-827486, -921994), "simplex_d_phase": (-827486, -160734, 572180, 226806, -921994,
        786604, -411254, -1363557),
        "cellular": (520048, 597760, 564452, 878600), "cellular_three": (520048, 597760, 795676, 564452,
        878600, 984584), "cellular_d": (1040096, 1247077, 895252, -1428770, 1128904, 213054, 1849009, 966354),
        "cellular_smooth": (226553, 280975), "cell_border": (2813, 14231)},
    ("lattice", 3, True): {"perlin": (-558150, 688579), "value": (-615266, 1024542), "value_cubic": (-224660,
        389037), "perlin_d": (-558150, -244449, 334697, 407850, 688579, -112053, 169394, -15650), "value_d": (-615266,
        103333, -117831, -238416, 1024542, -248330, 0, 697700),
        "simplex": (12126, 1105864), "simplex_smooth": (-74073, 1360519), "simplex_d": (12126, -1393058,
        -311985, -441358, 1105864, -572296, -106711, 1686424), "curl": (338584, 1363016, -2032160, -195592, 1295944,
        15632), "perlin_phase": (63429, -446951), "perlin_d_phase": (63429, 393090, 95753, -305417, -446951, -127132,
        -160043, -239254), "simplex_phase": (604953, -906814), "simplex_d_phase": (604953, 290876, 68241, -1056885,
        -906814, 205672, 209521, -1501104),
        "cellular": (430484, 774752, 374764, 917980), "cellular_three": (430484, 774752, 865352, 374764,
        917980, 944624), "cellular_d": (860968, 628555, 1360870, -1466628, 749528, -1902436, 882455, 11460),
        "cellular_smooth": (211589, 187091), "cell_border": (13096, 18789)},
    ("lattice", 4, False): {"perlin": (-131600, -297913), "value": (-1502453, 947589), "perlin_d": (-131600,
        -281187, 459443, -27276, 284716, -297913, -103382, 367918, -173286, 167289), "value_d": (-1502453, 35752,
        -431406, -513654, -166590, 947589, -2760, 0, 1152953, 19440), "simplex": (-276701, -870949), "simplex_d":
        (-276701, 657040, 413028, 16336, 331517, -870949, 733833, 608201, -909598, -389808)},
    ("lattice", 4, True): {"perlin": (-1065975, 673883), "value": (-729676, 572672), "perlin_d": (-1065975, -235097,
        314717, -116035, 148843, 673883, -333282, -341263, -342633, 43425), "value_d": (-729676, -4912, -126664,
        -211421, 232028, 572672, -142741, 0, 299817, -49843), "simplex": (758681, 877094), "simplex_d": (758681,
        -1356036, -1407679, -1366143, -942152, 877094, -774261, -608201, 779818, 412138)},
    ("fnv1", 2, False): {"perlin": (-195787, 356492), "value": (559055, 1556863), "value_cubic": (48842, 708018),
        "perlin_d": (-195787, 807547, -361690, 356492, 285488, -353108), "value_d": (559055, 1102169, 110794, 1556863,
        -402571, 0), "simplex": (-561309, 456805),
        "simplex_smooth": (-619557, 410171), "simplex_d": (-561309, 1539368, 81342, 456805, -833232, -563424), "curl":
        (81342, -1539368, -563424, 833232), "perlin_phase": (994530, -183569), "perlin_d_phase": (994530, -38839,
        -236289, -183569, -19803, 545198), "simplex_phase": (-529769, 5661), "simplex_d_phase": (-529769, -1583426,
        1520866, 5661, 1322382, 979122),
        "cellular": (630904, 671284, 595752, 709400), "cellular_three": (630904, 671284, 985616, 595752,
        709400, 949300), "cellular_d": (1261808, -1712121, 1211078, 1191504, 789420, -1942911),
        "cellular_smooth": (286683, 281427), "cell_border": (1466, 5176)},
    ("fnv1", 2, True): {"perlin": (-597462, -370637), "value": (247330, 90533), "value_cubic": (221465, -407159),
        "perlin_d": (-597462, -516759, 336203, -370637, -194014, -146860), "value_d": (247330, -399335, -17038, 90533,
        -384872, 0), "simplex": (907583, 756982),
        "simplex_smooth": (878405, 732910), "simplex_d": (907583, 1259694, -781942, 756982, -245670, -241200), "curl":
        (-781942, -1259694, -241200, 245670), "perlin_phase": (717212, 389084), "perlin_d_phase": (717212, 366057,
        -935572, 389084, 240661, -122559), "simplex_phase": (-442153, -288209), "simplex_d_phase": (-442153, -24732,
        2228052, -288209, 927212, 687342),
        "cellular": (577732, 617348, 341248, 435952), "cellular_three": (577732, 617348, 1055884, 341248,
        435952, 1058212), "cellular_d": (1155464, 2070420, 333794, 682496, -2095578, 81809),
        "cellular_smooth": (255102, 128796), "cell_border": (1502, 3710)},
}

OF_VECTORS = ("fbm", "turbulence", "clouds", "billow", "ridged", "ping_pong", "weighted")
# With either settings all seven sums at the point, then all in the cell, then fBm at the point with as many octaves as
# DETAILS says, and with the footprint.
SUM_VECTORS: dict[tuple[str, int, bool], tuple[int, ...]] = {
    ("lattice", 2, False): (269963, 611487, 1071998, -874178, 924472, 622767, 298346, 121195, 290764, 635891, -1515624,
        1566669, -281358, -5991, 287396, 267057, -194882, 516741, 24782, -1063670, 795506, -362259, -78711, -121598,
        487008, 102941, -1123136, 806365, 455801, -119036, -389574, -188727),
    ("lattice", 2, True): (42459, 598898, 428066, -899356, 917160, -181678, 186541, 375838, 510773, 1384266, -1075606,
        989436, -219893, 283342, -290, 36805, 18802, 589743, 370973, -917666, 766765, -105962, 58900, 114907, 448418,
        618452, -1200316, 1177970, -64537, 70942, 105598, 101354),
    ("lattice", 3, False): (-115983, 366661, 110895, -1363830, 1434484, -722277, -84283, 231347, 286212, 956283,
        -1524728, 1573973, 225334, 147225, -72905, -99995, -117955, 342050, 108040, -1413052, 1450405, 198304, -71143,
        82432, 387263, 530565, -1322626, 1388315, 42371, -2306, -185616, -73084),
    ("lattice", 3, True): (130160, 532710, 660993, -1031732, 1095735, 60120, -98868, 598713, 615962, 1919556, -865228,
        866203, 911130, 490578, 128647, 121383, -49043, 398059, 224629, -1301034, 1365040, 296858, -36706, 80111,
        449595, 524387, -1197962, 1239415, 22023, 70833, -78214, -47360),
    ("fnv1", 2, False): (156232, 357038, 735140, -1383076, 1442313, -224327, 44923, -45508, 459297, 231550, -1178558,
        1197957, 517971, 94058, 126464, 158453, 160001, 493217, 746021, -1110718, 907459, -69880, 74445, -123054,
        504768, 100928, -1087616, 929923, -311564, -80461, 179935, 47293),
    ("fnv1", 2, True): (98212, 548772, 572797, -999608, 1064532, -24563, -104141, -335993, 374942, 0, -1347268, 1415586,
        -1412821, -212063, 93869, 95726, 83241, 446936, 532675, -1203280, 1237626, -461031, 22851, 23607, 548928,
        382330, -999296, 786825, 301903, 37461, 101064, 30437),
}

# Cellular noise by the dimensions, whether there are periods, and the metric, with this jitter: the three distances in
# units of 2^-20, the cell of the nearest point, and where it is, in the same units; at the point, then in the cell.
JITTER = to_f32(0.7)
CHOSEN: dict[tuple[int, bool, int], tuple[int, ...]] = {
    (2, False, 1): (443676, 633144, 942696, -13, 5, -29799, -442675, 377688, 772908, 799388, 2147483647,
        -2147483648, 130560, -354407),
    (2, False, 2): (187729, 382300, 847512, -13, 5, -29799, -442675, 136041, 569715, 609422, 2147483647,
        -2147483648, 130560, -354407),
    (2, False, 3): (472474, 635700, 1055131, -13, 5, -29799, -442675, 484967, 936549, 1117595, 2147483647,
        -2147483648, 130560, -354407),
    (2, False, 4): (442675, 633139, 830976, -13, 5, -29799, -442675, 354407, 643994, 750079, 2147483647,
        -2147483648, 130560, -354407),
    (2, False, 5): (660203, 1018000, 1902643, -13, 5, -29799, -442675, 621008, 1506264, 1727017, 2147483647,
        -2147483648, 130560, -354407),
    (2, True, 1): (536032, 561396, 848640, 35, 5, -289280, -451277, 638868, 718288, 727032, 30, 522797, -545281,
        332902),
    (2, True, 2): (274022, 300567, 686832, 35, 5, -289280, -451277, 389247, 492041, 504092, 30, 522797, -545281,
        332902),
    (2, True, 3): (731751, 740557, 954572, 35, 6, -211866, 519885, 878183, 878184, 1013965, 30, 522797, -545281,
        332902),
    (2, True, 4): (451277, 519885, 841011, 35, 5, -289280, -451277, 545281, 592179, 666931, 30, 522797, -545281,
        332902),
    (2, True, 5): (1014579, 1032318, 1641404, 35, 5, -289280, -451277, 1267430, 1370225, 1518057, 30, 522797,
        -545281, 332902),
    (3, False, 1): (529580, 577732, 889612, -13, 5, 0, 19660, -259891, -461005, 557028, 871748, 876284,
        2147483647, -2147483648, -7, 58163, -505652, -226304),
    (3, False, 2): (267463, 318313, 754749, -13, 5, 0, 19660, -259891, -461005, 295906, 724742, 732303,
        2147483647, -2147483648, -7, 58163, -505652, -226304),
    (3, False, 3): (740556, 948224, 1344717, -13, 5, 0, 19660, -259891, -461005, 790119, 1352090, 1458587,
        2147483647, -2147483648, -7, 58163, -505652, -226304),
    (3, False, 4): (461005, 464281, 722739, -13, 5, 0, 19660, -259891, -461005, 505652, 666420, 746701,
        2147483647, -2147483648, -7, 58163, -505652, -226304),
    (3, False, 5): (1008019, 1266537, 2104855, -13, 5, 0, 19660, -259891, -461005, 1086025, 2084393, 2183329,
        2147483647, -2147483648, -7, 58163, -505652, -226304),
    (3, True, 1): (518252, 665644, 998076, 35, 5, 1, -139469, -258458, 427008, 432224, 844604, 894140, 31, 522796,
        0, 336281, -267674, -45671),
    (3, True, 2): (256145, 422560, 950008, 35, 5, 1, -139469, -258458, 427008, 178165, 680310, 762453, 31, 522796,
        0, 336281, -267674, -45671),
    (3, True, 3): (824935, 1059636, 1382812, 35, 5, 1, -139469, -258458, 427008, 649626, 1162854, 1350042, 31,
        522796, 0, 336281, -267674, -45671),
    (3, True, 4): (427008, 561357, 844595, 35, 5, 1, -139469, -258458, 427008, 336281, 673588, 724787, 31, 522796,
        0, 336281, -267674, -45671),
    (3, True, 5): (1081080, 1482196, 2332820, 35, 5, 1, -139469, -258458, 427008, 827791, 1843164, 2112495, 31,
        522796, 0, 336281, -267674, -45671),
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
