"""Tests of exact.py.

The published vectors say that the hashes are the ones they are named after, the properties that the noise is what the
contract promises.
"""

from __future__ import annotations

import itertools
import math
import unittest
from collections import Counter
from collections.abc import Callable, Sequence
from fractions import Fraction

from golden import rows as golden_rows
from oracle import exact as oracle


def generator(name: str):
    """A generator of test inputs of its own for each test."""
    return golden_rows.Generator(golden_rows.fnv1a64(name.encode()))


def murmurhash2(data: bytes, seed: int) -> int:
    """MurmurHash2, 32 bit, after Appleby; only to pin the oracle's murmur to it."""
    m = 0x5BD1E995
    h = seed ^ len(data)
    tail = len(data) // 4 * 4
    for i in range(0, tail, 4):
        k = int.from_bytes(data[i:i + 4], "little") * m & oracle.MASK
        h = h * m & oracle.MASK ^ (k ^ k >> 24) * m & oracle.MASK
    if tail < len(data):
        h = (h ^ int.from_bytes(data[tail:], "little")) * m & oracle.MASK
    return murmurhash2_avalanche(h)


def murmurhash2_avalanche(h: int) -> int:
    """The last three lines of MurmurHash2."""
    h = (h ^ h >> 13) * 0x5BD1E995 & oracle.MASK
    return h ^ h >> 15


def smhasher_verification(function: Callable[[bytes, int], int]) -> int:
    """SMHasher's VerificationTest of a 32-bit hash: the hash of its hashes of (), (0), (0, 1), ... with 256 seeds."""
    hashes = b"".join(oracle.word_bytes(function(bytes(range(i)), 256 - i)) for i in range(256))
    return function(hashes, 0)


def interpolated_perlin(name: str, p: Sequence[float], seed: int) -> Fraction:
    """The noise in exact arithmetic too, but as nested interpolations rather than as a weighted sum."""
    cell = [math.floor(x) for x in p]
    f = [Fraction(x) - c for x, c in zip(p, cell)]

    def value(corner: tuple[int, ...]) -> Fraction:
        if len(corner) == len(f):
            gradient = oracle.gradient(name, [c + o for c, o in zip(cell, corner)], seed)
            return sum(Fraction(g) * (x - o) for g, x, o in zip(gradient, f, corner))
        t = f[len(corner)]
        low, high = value((*corner, 0)), value((*corner, 1))
        return low + (high - low) * t**3 * (t * (t * 6 - 15) + 10)

    return value(()) * oracle.scale(name, len(f))


class PublishedVectors(unittest.TestCase):
    def test_fnv1(self) -> None:
        # test_fnv.c of Landon Curt Noll; also php-src, ext/hash/tests/fnv132.phpt.
        vectors = {
            b"": 0x811C9DC5, b"a": 0x050C5D7E, b"foo": 0x408F5E13, b"foob": 0xB4B1178B, b"foobar": 0x31F0B262,
            b"foo\0": 0xB4B117E9, b"chon": 0xFCC8100F, b"cho\0": 0xFCC81061, b"curd": 0xE184FF97,
            b"chongo was here!\n": 0xDD002F35,
        }
        for data, value in vectors.items():
            self.assertEqual(oracle.fnv1(data), value, data)

    def test_one_at_a_time(self) -> None:
        # Wikipedia, "Jenkins hash function".
        self.assertEqual(oracle.one_at_a_time(b"a"), 0xCA2E9442)
        self.assertEqual(oracle.one_at_a_time(b"The quick brown fox jumps over the lazy dog"), 0x519E91F5)

    def test_xxh32(self) -> None:
        # Cyan4973/xxHash, cli/xsum_sanity_check.c: (length, seed, value) on its test buffer.
        prime32, prime64 = 2654435761, 11400714785074694797
        buffer = bytes(prime32 * prime64**i >> 56 & 0xFF for i in range(14))
        vectors = [
            (0, 0, 0x02CC5D05), (0, prime32, 0x36B78AE7), (1, 0, 0xCF65B03E), (1, prime32, 0xB4545AA4),
            (14, 0, 0x1208E7E2), (14, prime32, 0x6AF1D1FE),
        ]
        for length, seed, value in vectors:
            self.assertEqual(oracle.xxh32(buffer[:length], seed), value, (length, seed))

    def test_xxh32_of_text(self) -> None:
        # pierrec/lz4, internal/xxh32/xxh32zero_test.go.
        vectors = {
            b"a": 0x550D7456, b"ab": 0x4999FC53, b"abc": 0x32D153FF, b"abcd": 0xA3643705, b"abcde": 0x9738F19B,
            b"abcdefgh": 0x0BB3C6BB, b"abcdefghij": 0x8B988CFE,
        }
        for data, value in vectors.items():
            self.assertEqual(oracle.xxh32(data), value, data)

    def test_murmurhash2(self) -> None:
        # aappleby/smhasher, main.cpp: the verification value of MurmurHash2.
        self.assertEqual(smhasher_verification(murmurhash2), 0x27864C1E)

    def test_pcg(self) -> None:
        # imneme/pcg-c, test-low/expected/check-oneseq-32-rxs-m-xs-32.out: the generator seeded with 42. pcg_hash(k)
        # is the output of the state that follows k; seeding ends with adding 42 to the increment, and one step.
        state, values = 2891336453 + 42, []
        for _ in range(6):
            values.append(oracle.pcg(state))
            state = (state * 747796405 + 2891336453) & oracle.MASK
        self.assertEqual(values, [0x256B5357, 0xA5EFAD32, 0x170B7830, 0x334A5B22, 0x3DE5C680, 0x9B47B7B3])

    def test_splitmix64(self) -> None:
        # Rosetta Code, "Pseudo-random numbers/Splitmix64".
        numbers = golden_rows.Generator(1234567)
        self.assertEqual([numbers.next() for _ in range(3)],
                         [6457827717110365317, 3203168211198807973, 9817491932198370423])

    def test_fnv1a64(self) -> None:
        # test_fnv.c of Landon Curt Noll.
        vectors = {b"": 0xCBF29CE484222325, b"a": 0xAF63DC4C8601EC8C, b"foobar": 0x85944171F73967E8}
        for data, value in vectors.items():
            self.assertEqual(golden_rows.fnv1a64(data), value, data)


class Hashes(unittest.TestCase):
    def test_byte_order(self) -> None:
        for name, function in (("fnv1", oracle.fnv1), ("jenkins", oracle.one_at_a_time), ("xxhash32", oracle.xxh32)):
            self.assertEqual(oracle.hash_words(name, [0x04030201]), function(b"\1\2\3\4"), name)

    def test_partial_hashes_agree_with_whole_ones_on_bytes(self) -> None:
        for byte in range(256):
            self.assertEqual(oracle.hash_words("partial_jenkins", [byte]), oracle.one_at_a_time(bytes([byte])))
            self.assertEqual(oracle.hash_words("partial_fnv1", [byte]), oracle.fnv1(bytes([byte, byte])))

    def test_murmur_is_murmurhash2_before_its_avalanche(self) -> None:
        numbers = generator("murmur")
        for word in [0, 1, oracle.MASK] + [numbers.word() for _ in range(100)]:
            expected = murmurhash2(oracle.word_bytes(word), 10 ^ 4)
            self.assertEqual(murmurhash2_avalanche(oracle.murmur(word)), expected)

    def test_xxh32_of_a_word_in_one_formula(self) -> None:
        # The contract gives this form as well.
        numbers = generator("xxh32")
        for word in [0, 1, oracle.MASK] + [numbers.word() for _ in range(100)]:
            h = oracle.rotl((374761397 + word * 3266489917) & oracle.MASK, 17) * 668265263 & oracle.MASK
            h = (h ^ h >> 15) * 2246822519 & oracle.MASK
            h = (h ^ h >> 13) * 3266489917 & oracle.MASK
            self.assertEqual(oracle.hash_words("xxhash32", [word]), h ^ h >> 16)

    def test_no_long_xxh32(self) -> None:
        with self.assertRaises(ValueError):
            oracle.xxh32(bytes(16))

    def test_custom(self) -> None:
        self.assertEqual(oracle.custom(1), 0x045D9F3B)
        self.assertEqual(oracle.custom(0x10000), 0xA3989F3B)

    def test_mixer(self) -> None:
        # Values of a C program around the published lines of prospector32.
        vectors = {0x00000001: 0xED345605, 0x80000000: 0x12F4F1B9, 0xDEADBEEF: 0xB19C7922}
        for word, value in vectors.items():
            self.assertEqual(oracle.mix(word), value)

    def test_spread_by_hand(self) -> None:
        self.assertEqual(oracle.spread((0, 0, 0, 0)), [0x165667B1, 0, 0, 0])
        self.assertEqual(oracle.spread((1, 1, 1, 1)), [0xB48DE162, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F])
        self.assertEqual(oracle.spread((-1, -1, -1, -1)), [0x781EEE00, 0x7A143589, 0x3D4D51C3, 0xD82B14D1])

    def test_fold_by_hand(self) -> None:
        self.assertEqual(oracle.fold([0xB48DE162, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F]),
                         [0xB48DCC41, 0x85EB8882, 0xC2B2B66B, 0x27D4E952])
        self.assertEqual(oracle.fold([0x80000000] * 4), [0x80002000, 0x80004000, 0x80001000, 0x80000800])

    def test_word_of_a_lattice_point_by_hand(self) -> None:
        # Without a seed, s is 0: J = X, M = 2 x' + 1.
        self.assertEqual(oracle.point_word("lattice", (1,)), 0xB48DCC41 * 0x691BC2C5 % 2**32)
        # The exclusive or of the four folded coordinates; the four spread ones add up to 0x225014545.
        self.assertEqual(oracle.point_word("lattice", (1,) * 4), 0xD4001BFA * 0x4A028A8B % 2**32)

    def test_word_of_a_lattice_point(self) -> None:
        # Values of a C program written from the contract: of one to four ones, then with signs and a seed.
        vectors = {
            ("lattice", (1, 1, 1, 1), 0): (0x99C27005, 0xECF95959, 0x10CCC788, 0xA717F4BE),
            ("fnv1", (1, 1, 1, 1), 0): (0x1407360D, 0xD76A2009, 0x190DEFD0, 0x2D6F78F0),
            ("lattice", (5, -6, 7, -8), 0xDEADBEEF): (0x1ED44B3E, 0xD33AE404, 0x6F232CD9, 0x7783C7FA),
            ("fnv1", (5, -6, 7, -8), 0xDEADBEEF): (0x34754068, 0xB677810E, 0x8DB3BAAA, 0x482BBF26),
            ("lattice", (0, 0, 0, 0), 0): (0x9CF30FEC,) * 4,
        }
        for (name, point, seed), words in vectors.items():
            found = tuple(oracle.point_word(name, point[:n], seed) for n in (1, 2, 3, 4))
            self.assertEqual(found, words, (name, point))

    def test_lattice_mixes_the_word(self) -> None:
        mixed = (0x54FF433B, 0xA6189E7A, 0x9BE6CEA5, 0x7A4B1B15)  # of the same C program
        self.assertEqual(tuple(oracle.lattice("lattice", (5, -6, 7, -8)[:n], 0xDEADBEEF) for n in (1, 2, 3, 4)), mixed)
        for name in oracle.HASHES:
            self.assertEqual(oracle.lattice(name, (1, 2), 3), oracle.mix(oracle.point_word(name, (1, 2), 3)), name)

    def test_every_hash_takes_one_join(self) -> None:
        # With LATTICE the word is J * M; where J is odd, that gives M.
        for seed in range(8):
            j = oracle.mix(seed)
            for folded in oracle.fold(oracle.spread((5, -6, 7))):
                j ^= folded
            if j % 2:
                m = oracle.point_word("lattice", (5, -6, 7), seed) * pow(j, -1, 2**32)
                for name, function in oracle.WORD_HASHES.items():
                    self.assertEqual(oracle.point_word(name, (5, -6, 7), seed), function(j) * m % 2**32, name)

    def test_low_bit_is_that_of_the_hash(self) -> None:
        # Which the contract says not to be good.
        for x, y in itertools.product(range(8), repeat=2):
            first, second = oracle.fold(oracle.spread((x, y)))
            self.assertEqual(oracle.point_word("lattice", (x, y)) % 2, (first ^ second) % 2)
            self.assertEqual(oracle.point_word("pcg", (x, y)) % 2, oracle.pcg(first ^ second) % 2)

    def test_hash_of_words_under_lattice_is_that_of_the_point(self) -> None:
        self.assertEqual(oracle.hash_words("lattice", (1, 2, 3)), oracle.lattice("lattice", (1, 2, 3), 0))

    def test_bijections_do_not_collide(self) -> None:
        # A random function would collide here about eight times.
        keys = range(2**18)
        for function in (oracle.pcg, oracle.murmur, oracle.mix):
            self.assertEqual(len(set(map(function, keys))), len(keys), function.__name__)

    def test_words_chain(self) -> None:
        for name, function in oracle.WORD_HASHES.items():
            last = function(function(function(function(5) + 6 & oracle.MASK) + 7 & oracle.MASK) + 8 & oracle.MASK)
            self.assertEqual(oracle.hash_words(name, (5, 6, 7, 8)), last, name)

    def test_coordinates_are_twos_complement_and_wrap(self) -> None:
        for name in oracle.HASHES:
            self.assertEqual(oracle.lattice(name, (-1, 2**31), 3), oracle.lattice(name, (2**32 - 1, -2**31), 3))

    def test_order_of_coordinates_matters(self) -> None:
        for name in oracle.HASHES:
            self.assertNotEqual(oracle.lattice(name, (1, 2)), oracle.lattice(name, (2, 1)), name)

    def test_seeds_differ(self) -> None:
        for name in oracle.HASHES:
            self.assertEqual(len({oracle.lattice(name, (1, 2, 3), seed) for seed in range(256)}), 256, name)

    def test_results_are_words(self) -> None:
        numbers = generator("words")
        for name in oracle.HASHES:
            for _ in range(100):
                self.assertIn(oracle.hash_words(name, [numbers.word() for _ in range(4)]), range(2**32))


class NearTheOrigin(unittest.TestCase):
    """Why a lattice point is spread: people look at the origin, and there no hash may show its weakness."""

    # Of n = 4096 values of a random function, n (n - 1) / 2 / 2^32 = 0.002 pairs are equal; that three are, by chance
    # 0.002^3 / 6, a billionth, would be a weakness.
    SIDE, LIMIT = range(-32, 32), 2

    def values(self, name: str) -> dict[tuple[int, int], int]:
        """The hashes of the points of all four quadrants."""
        return {point: oracle.lattice(name, point) for point in itertools.product(self.SIDE, repeat=2)}

    def test_few_points_collide(self) -> None:
        for name in oracle.HASHES:
            counts = Counter(self.values(name).values())
            self.assertLessEqual(sum(math.comb(count, 2) for count in counts.values()), self.LIMIT, name)

    def test_opposite_points_differ(self) -> None:
        for name in oracle.HASHES:
            values = self.values(name)
            equal = sum(values.get((-x, -y)) == value for (x, y), value in values.items() if (x, y) > (0, 0))
            self.assertLessEqual(equal, self.LIMIT, name)

    def test_origin_is_not_zero(self) -> None:
        for name, n in itertools.product(oracle.HASHES, (1, 2, 3, 4)):
            self.assertNotEqual(oracle.lattice(name, (0,) * n, 0), 0, (name, n))


class Floats(unittest.TestCase):
    WORDS = [word for word, in golden_rows.gradient_rows(generator("gradients"))]

    def test_gradients_by_hand(self) -> None:
        # Of 512 intervals in the plane, 256 along p and q in space; e is half an interval.
        e = 1 / 512
        self.assertEqual(oracle.gradient2(0x00000000), (-1 + e, e))
        self.assertEqual(oracle.gradient2(0x003FFFFF), (-1 + e, e))
        self.assertEqual(oracle.gradient2(0x80400000), (-1 + 3 * e, -3 * e))
        self.assertEqual(oracle.gradient2(0x3FC00000), (-e, 1 - e))
        self.assertEqual(oracle.gradient2(0xC0000000), (e, -1 + e))
        self.assertEqual(oracle.gradient2(0x7FFFFFFF), (1 - e, e))
        e = 1 / 256
        self.assertEqual(oracle.gradient3(0x00000000), (-1 + e, 0, e))
        self.assertEqual(oracle.gradient3(0x00007FFF), (-1 + e, 0, e))
        self.assertEqual(oracle.gradient3(0x00008000), (-1 + 2 * e, -e, e))
        self.assertEqual(oracle.gradient3(0x80800000), (-1 + 2 * e, e, -e))
        self.assertEqual(oracle.gradient3(0x7F800000), (0, 1 - e, e))
        self.assertEqual(oracle.gradient3(0xC03F8000), (0, e, -1 + e))  # p = e, q = -e
        self.assertEqual(oracle.gradient3(0x40408000), (2 * e, -e, 1 - 3 * e))  # p = e, q = 3 e

    def test_gradients_lie_on_the_surface(self) -> None:
        for word in self.WORDS:
            self.assertEqual(sum(map(abs, oracle.gradient2(word))), 1)
            self.assertEqual(sum(map(abs, oracle.gradient3(word))), 1)

    def test_gradients_are_exact(self) -> None:
        for word in self.WORDS:
            for component in oracle.gradient2(word) + oracle.gradient3(word):
                self.assertEqual(golden_rows.to_f32(component), component)
                self.assertTrue((component * 2**9).is_integer())
            for component in oracle.gradient3(word):
                self.assertTrue((component * 2**8).is_integer())

    def test_gradients_have_no_zero_but_a_positive_one(self) -> None:
        for word in self.WORDS:
            for component in oracle.gradient2(word) + oracle.gradient3(word):
                self.assertTrue(component != 0 or math.copysign(1, component) == 1)

    def test_as_many_gradients_as_the_contract_says(self) -> None:
        self.assertEqual(len({oracle.gradient2(field << 22) for field in range(2**10)}), 1024)
        self.assertEqual(len({oracle.gradient3(field << 15) for field in range(2**17)}), 131072)

    def test_gradients_are_uniform(self) -> None:
        # As many in each quadrant, in each octant (its border, where x or y is 0, apart), and in each half by height.
        quadrants = Counter(tuple(x > 0 for x in oracle.gradient2(field << 22)) for field in range(2**10))
        self.assertEqual(set(quadrants.values()), {256})
        gradients = [oracle.gradient3(field << 15) for field in range(2**17)]
        octants = Counter(tuple(x > 0 for x in g) for g in gradients if g[0] and g[1])
        self.assertEqual(len(octants), 8)
        self.assertEqual(len(set(octants.values())), 1)
        # Above half the height lies a quarter of the octahedron's faces.
        self.assertEqual(sum(abs(z) > 0.5 for _, _, z in gradients), 2**15)

    def test_unit_ranges(self) -> None:
        self.assertEqual((oracle.unorm(0), oracle.unorm(oracle.MASK)), (0, 1 - 2**-24))
        self.assertEqual((oracle.snorm(0), oracle.snorm(2**31), oracle.snorm(oracle.MASK)), (-1, 0, 1 - 2**-23))


INT_MIN, INT_MAX = -2**31, 2**31 - 1
EDGE_CELLS = (0, 1, -1, 47, 48, -48, -49, 2**20, -2**20 - 1, 2**30, -2**30 + 1, INT_MIN, INT_MIN + 1, INT_MAX - 1,
              INT_MAX)


def unit_vector(n: int, bits: int) -> tuple[int, int]:
    """(cos n, sin n) in fixed point as a power of (cos 1, sin 1), without any pi; n >= 0."""
    one = 1 << bits
    inverse_factorials = [one]
    while inverse_factorials[-1]:
        inverse_factorials.append(inverse_factorials[-1] // len(inverse_factorials))
    x, y = (sum(inverse_factorials[i::4]) - sum(inverse_factorials[i + 2::4]) for i in (0, 1))
    c, s = one, 0
    while n:
        if n & 1:
            c, s = (c * x - s * y) >> bits, (c * y + s * x) >> bits
        x, y = (x * x - y * y) >> bits, x * y >> bits - 1
        n >>= 1
    return c, s


class Sine(unittest.TestCase):
    def arcs(self, count: int) -> list[int]:
        """Edge cases, and as many others of each size."""
        numbers = generator("arcs")
        random = [numbers.integer(-2**bits, 2**bits) for bits in range(1, 32) for _ in range(count)]
        # The numerators of convergents of pi, up to the largest: the sine is as small as it gets.
        near_multiples = [3, 22, 355, 245850922, 411557987, 1068966896, -1068966896]
        return [0, 1, -1, INT_MAX, INT_MIN, 2**31] + near_multiples + random

    def test_pi(self) -> None:
        self.assertEqual(float(Fraction(oracle.PI, 2**oracle.SINE_BITS)), math.pi)

    def test_is_that_of_the_c_library(self) -> None:
        # Which reduces exactly, and is off by less than one unit in the last place.
        for n in self.arcs(300):
            expected = math.sin(n)
            self.assertLessEqual(abs(float(oracle.sine(n)) - expected), math.ulp(expected), n)

    def test_is_as_exact_as_it_says(self) -> None:
        for n in self.arcs(10):
            _, s = unit_vector(abs(n), 256)
            self.assertLess(abs(oracle.sine(n) - math.copysign(1, n) * Fraction(s, 2**256)), oracle.SINE_ERROR, n)

    def test_the_nearest_double_is_certain(self) -> None:
        for n in self.arcs(100):
            value = oracle.sine(n)
            if n != 0:
                self.assertEqual(float(value - oracle.SINE_ERROR), float(value + oracle.SINE_ERROR), n)
        self.assertEqual(oracle.sine(0), 0)

    def test_rounds_as_float32_does(self) -> None:
        for n in self.arcs(300):
            self.assertEqual(oracle.round24(n), golden_rows.to_f32(n), n)

    def test_ties_go_to_even(self) -> None:
        ties = {2**24 + 1: 2**24, 2**24 + 3: 2**24 + 4, 2**30 + 64: 2**30, 2**30 + 192: 2**30 + 256,
                2**31 - 64: 2**31, 2**31 - 192: 2**31 - 256}
        for n, even in ties.items():
            for sign in (1, -1):
                self.assertEqual(oracle.round24(sign * n), sign * even)
                self.assertEqual(oracle.sine_of_word(sign * n & oracle.MASK), oracle.sine(sign * even))

    def test_ties_away_from_zero_would_show(self) -> None:
        for n, away in {2**24 + 1: 2**24 + 2, 2**30 + 64: 2**30 + 128, 2**31 - 192: 2**31 - 128}.items():
            for sign in (1, -1):
                self.assertGreater(abs(oracle.sine_of_word(sign * n & oracle.MASK) - oracle.sine(sign * away)), 2**-5)

    def test_words_are_signed(self) -> None:
        # INT_MAX rounds to 2^31.
        for word, opposite in ((0xFFFFFFFF, 1), (0x80000000, INT_MAX), (0x80000001, INT_MAX), (0xFF000001, 0xFFFFFF)):
            self.assertEqual(float(oracle.sine_of_word(word)), -float(oracle.sine_of_word(opposite)))


class Configurations(unittest.TestCase):
    def test_names(self) -> None:
        self.assertEqual(oracle.configuration("fnv1"), oracle.Configuration("fnv1"))
        self.assertEqual(oracle.configuration("pcg+sine"), oracle.Configuration("pcg", sine=True))
        self.assertEqual(oracle.configuration("pcg+period48"), oracle.Configuration("pcg", period=48))
        self.assertEqual(oracle.configuration("partial_fnv1+sine+period1073741824"),
                         oracle.Configuration("partial_fnv1", True, 2**30))
        self.assertEqual(oracle.configuration("pcg+fixed"), oracle.Configuration("pcg", fixed=True))
        self.assertEqual(oracle.configuration("pcg+sine+period48+fixed"), oracle.Configuration("pcg", True, 48, True))

    def test_bad_names(self) -> None:
        for name in ("", "any", "fnv1+", "fnv1+cosine", "fnv1+period", "fnv1+period0", "fnv1+period048",
                     "fnv1+period48+sine", "fnv1+fixed+sine", "fnv1+precise", "fnv1+period-48", "fnv1+period1048577",
                     "fnv1+period2147483648"):
            with self.assertRaises(ValueError, msg=name):
                oracle.configuration(name)


class Gradients(unittest.TestCase):
    PERIODS = (1, 48, 2**20 - 1, 2**20, 2**30)
    KINDS = ("lattice", "pcg", "custom", "lattice+sine", "fnv1+sine", "partial_jenkins+sine")

    def cells(self, n: int) -> list[tuple[int, ...]]:
        """Edge cases alone and with each other, and random ones."""
        numbers = generator("cells")
        mixed = [tuple(numbers.pick(EDGE_CELLS) for _ in range(n)) for _ in range(10)]
        return [(c,) * n for c in EDGE_CELLS] + mixed + [
            tuple(numbers.integer(INT_MIN, INT_MAX) for _ in range(n)) for _ in range(10)]

    def test_octahedral_is_that_of_the_word(self) -> None:
        for name in oracle.HASHES:
            for cell in self.cells(2):
                self.assertEqual(oracle.gradient(name, cell, 7), oracle.gradient2(oracle.point_word(name, cell, 7)))
            for cell in self.cells(3):
                self.assertEqual(oracle.gradient(name, cell, 7), oracle.gradient3(oracle.point_word(name, cell, 7)))

    def test_sine_without_a_seed_is_the_papers(self) -> None:
        # The paper's listing with the C library's sine, and float(int) by the conversion to float32 of the machine.
        def component(word: int) -> float:
            word &= oracle.MASK
            return math.sin(golden_rows.to_f32(word - 2**32 if word >= 2**31 else word))

        for hash_name, function in oracle.WORD_HASHES.items():
            name = hash_name + "+sine"
            for x, y, z in self.cells(3):
                hx = function(x & oracle.MASK)
                hy = function(hx + y & oracle.MASK)
                hz = function(hy + z & oracle.MASK)
                pairs = list(zip(oracle.gradient(name, (x, y)), (component(hx + hy), component(hy + hy))))
                pairs += zip(oracle.gradient(name, (x, y, z)),
                             (component(hz + hx), component(hz + hy), component(hz + hz)))
                for value, expected in pairs:
                    self.assertAlmostEqual(float(value), expected, delta=2**-53)

    def test_sine_words_are_chained_hashes(self) -> None:
        for name in oracle.HASHES:
            for x, y in self.cells(2):
                first = oracle.hash_words(name, [x & oracle.MASK])
                second = oracle.hash_words(name, [first + y & oracle.MASK])
                self.assertEqual(oracle.gradient(name + "+sine", (x, y)),
                                 (oracle.sine_of_word(first + second), oracle.sine_of_word(2 * second)))

    def test_hash_of_one_word_under_lattice(self) -> None:
        # Values of a C program written from the contract.
        vectors = {0: 0x67F2B63B, 1: 0x0723F215, 0x80000000: 0xBA25E115, oracle.MASK: 0xAFB9C52F}
        for word, value in vectors.items():
            self.assertEqual(oracle.hash_words("lattice", [word]), value)

    def test_seed_joins_the_first_word_only(self) -> None:
        seed = 0xDEADBEEF
        first = oracle.pcg(5) ^ oracle.mix(seed)
        second = oracle.pcg(first - 6 & oracle.MASK)
        third = oracle.pcg(second + 7 & oracle.MASK)
        expected = tuple(oracle.sine_of_word(third + word) for word in (first, second, third))
        self.assertEqual(oracle.gradient("pcg+sine", (5, -6, 7), seed), expected)
        self.assertNotEqual(oracle.gradient("pcg+sine", (5, -6, 7)), expected)

    def test_a_period_leaves_the_cells_from_0_on(self) -> None:
        for kind, period, n in itertools.product(self.KINDS, self.PERIODS, (2, 3)):
            for cell in self.cells(n):
                base = [c % period for c in cell]
                self.assertEqual(oracle.gradient(f"{kind}+period{period}", cell, 3), oracle.gradient(kind, base, 3))

    def test_gradients_repeat_after_a_period_and_not_before(self) -> None:
        for kind, period, n, axis in itertools.product(self.KINDS, self.PERIODS, (2, 3), (0, 1)):
            name = f"{kind}+period{period}"
            for start in (0, -1, INT_MIN, INT_MAX - period, -period, 3 * period // 2):
                def at(c: int) -> tuple:
                    return oracle.gradient(name, [c if i == axis else 5 for i in range(n)], 3)
                self.assertEqual(at(start), at(start + period), (name, start))
                if period > 1:
                    self.assertNotEqual(at(start), at(start + period // 2), (name, start))

    def test_wrapping_by_hand(self) -> None:
        # 2^31 = 48 * 44739242 + 32.
        by_period = {1: (0, 0, 0), 48: (47, 16, 31), 2**20: (2**20 - 1, 0, 2**20 - 1), 2**30: (2**30 - 1, 0, 2**30 - 1)}
        for period, expected in by_period.items():
            self.assertEqual(tuple(oracle.wrapped(c, period) for c in (-1, INT_MIN, INT_MAX)), expected)

    def test_beyond_the_largest_cell_lies_the_smallest(self) -> None:
        for name in ("lattice", "fnv1+sine", "fnv1+sine+period1048576"):
            self.assertEqual(oracle.gradient(name, (2**31, 5)), oracle.gradient(name, (INT_MIN, 5)))

    def test_the_period_goes_on_to_the_last_cell(self) -> None:
        # INT_MAX is 31 modulo 48; its far corner is 32, where the cell after it, INT_MIN, is 16.
        self.assertEqual(oracle.wrapped(2**31 - 1, 48), 31)
        self.assertEqual(oracle.wrapped(2**31, 48), 32)
        self.assertEqual(oracle.wrapped(INT_MIN, 48), 16)


class Perlin(unittest.TestCase):
    def samples(self, n: int, count: int = 40):
        """A hash, a point and a seed, some times."""
        numbers = generator(f"perlin{n}")
        for name in oracle.HASHES:
            for _ in range(count):
                yield name, [numbers.uniform(-50, 50) for _ in range(n)], numbers.word()

    def test_zero_at_lattice_points(self) -> None:
        for name, n in itertools.product(oracle.HASHES, (2, 3)):
            for point in itertools.product((-2**22, -3, 0, 7), repeat=n):
                self.assertEqual(oracle.perlin(name, point, 5), 0)

    def test_weighted_sum_is_interpolation(self) -> None:
        for n in (2, 3):
            for sample in self.samples(n, 5):
                self.assertEqual(oracle.perlin(*sample), interpolated_perlin(*sample))
            for name in ("murmur+sine", "pcg+period48", "lattice+sine+period7"):
                for _, point, seed in itertools.islice(self.samples(n), 3):
                    self.assertEqual(oracle.perlin(name, point, seed), interpolated_perlin(name, point, seed))

    def test_tiny_negative_coordinate(self) -> None:
        # Its fraction has more bits than a double.
        self.assertEqual(oracle.perlin("pcg", (-2.0**-126, 0.5)),
                         oracle.perlin_cell("pcg", (-1, 0), (1 - Fraction(1, 2**126), 0.5)))

    def test_within_range_and_not_flat(self) -> None:
        for n in (2, 3):
            values = [oracle.perlin(*sample) for sample in self.samples(n)]
            self.assertLessEqual(max(map(abs, values)), 1)
            self.assertGreater(max(values), 0.5)
            self.assertLess(min(values), -0.5)

    def test_range_of_the_sine_gradient(self) -> None:
        for n in (2, 3):
            values = [oracle.perlin("lattice+sine", point, seed) for _, point, seed in self.samples(n)]
            self.assertLessEqual(max(map(abs, values)), Fraction(n, 2))
            self.assertGreater(max(values), 0.5)
            self.assertLess(min(values), -0.5)
        self.assertEqual((oracle.scale("lattice+sine", 2), oracle.scale("lattice+sine", 3)), (1, 1))

    def test_noise_repeats_after_a_period(self) -> None:
        for n in (2, 3):
            for name, period in (("lattice+period48", 48), ("fnv1+sine+period1048576", 2**20), ("pcg+period1", 1)):
                for _, point, seed in itertools.islice(self.samples(n), 5):
                    moved = [Fraction(x) + factor * period for x, factor in zip(point, (-3, 1, 2))]
                    self.assertEqual(oracle.perlin(name, point, seed), oracle.perlin(name, moved, seed))

    def test_scale_is_the_largest_that_stays_within_range(self) -> None:
        # On |x| + |y| (+ |z|) = 1 a ramp is at most the largest component of f - o. Its weighted mean, largest over
        # the cell, times the scale, is just below 1, and with the next larger multiple of 1/1024 it is above.
        grid = [Fraction(i, 32) for i in range(17)]  # the other half is its mirror image
        near = [Fraction(x) for x in (0.3268, 0.3491, 0.5)]  # the maxima, found by a finer search
        for n, scale in oracle.OCTAHEDRAL_SCALES.items():
            bound = max(self.weighted_bound(f) for axis in (grid, near) for f in itertools.product(axis, repeat=n))
            self.assertLess(bound * scale, 1)
            self.assertGreater(bound * (scale + Fraction(1, 1024)), 1)

    def weighted_bound(self, fraction: Sequence[Fraction]) -> Fraction:
        total = Fraction(0)
        for corner in itertools.product((0, 1), repeat=len(fraction)):
            weight = math.prod(oracle.smooth(f) if o else 1 - oracle.smooth(f) for f, o in zip(fraction, corner))
            total += weight * max(abs(f - o) for f, o in zip(fraction, corner))
        return total

    def test_cells_meet(self) -> None:
        # f = 1 in one cell is f = 0 in the next, also where the cells wrap.
        for n in (2, 3):
            numbers = generator("meet")
            names = (*oracle.HASHES, "lattice+sine", "lattice+period48", "fnv1+sine+period48")
            for name, axis, cell in itertools.product(names, range(n), (-1, 0, 47, 2**31 - 1)):
                if "period48" in name and cell == 2**31 - 1:
                    continue  # 48 does not divide 2^32: see test_the_period_goes_on_to_the_last_cell
                cells = [cell] * n
                fraction = [numbers.uniform(0, 1) for _ in range(n)]
                ones = [1.0 if i == axis else f for i, f in enumerate(fraction)]
                zeros = [0.0 if i == axis else f for i, f in enumerate(fraction)]
                following = [-2**31 if i == axis and c == 2**31 - 1 else c + (i == axis) for i, c in enumerate(cells)]
                self.assertEqual(oracle.perlin_cell(name, cells, ones, 9),
                                 oracle.perlin_cell(name, following, zeros, 9))

    def test_continuous(self) -> None:
        step = 2.0**-18
        for n in (2, 3):
            for name, point, seed in self.samples(n, 5):
                for axis in range(n):
                    border = [math.floor(x) if i == axis else x for i, x in enumerate(point)]
                    before = [x - step if i == axis else x for i, x in enumerate(border)]
                    difference = oracle.perlin(name, border, seed) - oracle.perlin(name, before, seed)
                    self.assertLess(abs(difference), 8 * step)

    def test_point_is_cell_and_fraction(self) -> None:
        self.assertEqual(oracle.perlin("pcg", (-1.25, 3.5), 7), oracle.perlin_cell("pcg", (-2, 3), (0.75, 0.5), 7))
        self.assertEqual(oracle.perlin("pcg", (-1.25, 3.5)), oracle.perlin("pcg", (-1.25, 3.5), 0))

    def test_seeds_differ(self) -> None:
        for name in oracle.HASHES:
            self.assertEqual(len({oracle.perlin(name, (0.375, 0.5), seed) for seed in range(32)}), 32, name)
            self.assertEqual(len({oracle.perlin(name, (0.375, 0.5, 0.25), seed) for seed in range(32)}), 32, name)


class OctaveSums(unittest.TestCase):
    POINTS = [(0.375, -12.25), (5.125, 7.75, -0.625)]

    def test_one_octave_is_the_noise(self) -> None:
        for point in self.POINTS:
            noise = oracle.perlin("lattice", point, 3)
            self.assertEqual(oracle.fbm("lattice", point, 1, 2.0, 0.5, 3), noise)
            self.assertEqual(oracle.turbulence("lattice", point, 1, 2.0, 0.5, 3), abs(noise))

    def test_gain_zero_leaves_the_first_octave(self) -> None:
        for point in self.POINTS:
            self.assertEqual(oracle.fbm("pcg", point, 6, 2.0, 0.0, 3), oracle.perlin("pcg", point, 3))

    def test_two_octaves_by_hand(self) -> None:
        seed, next_seed = 0xFFFFFFFF, 0x9E3779B8
        first = oracle.perlin("pcg", (0.375, -12.25), seed)
        second = oracle.perlin("pcg", (0.75 + 0.34375, -24.5 + 0.59375), next_seed)
        self.assertEqual(oracle.fbm("pcg", (0.375, -12.25), 2, 2.0, 0.25, seed), (4 * first + second) / 5)
        self.assertEqual(oracle.turbulence("pcg", (0.375, -12.25), 2, 2.0, 0.25, seed),
                         (4 * abs(first) + abs(second)) / 5)

    def test_third_axis_is_shifted_too(self) -> None:
        terms = oracle.octave_terms("pcg", (1.0, 2.0, 3.0), 2, 2.0, 0.5, 0)
        self.assertEqual(terms[1], (0.5, oracle.perlin("pcg", (2.34375, 4.59375, 6.71875), 0x9E3779B9)))

    def test_clouds_of_fbm(self) -> None:
        seen = set()
        for seed in range(64):
            t = 2 * oracle.fbm("pcg", (0.375, 0.5), 3, 2.0, 0.5, seed) + Fraction(1, 4)
            expected = 0 if t <= 0 else 1 if t >= 1 else 3 * t**2 - 2 * t**3
            self.assertEqual(oracle.clouds("pcg", (0.375, 0.5), 3, 2.0, 0.5, seed), expected)
            seen.add("clear" if t <= 0 else "full" if t >= 1 else "between")
        self.assertEqual(seen, {"clear", "full", "between"})

    def test_no_octaves(self) -> None:
        for octaves in (0, -1):
            self.assertEqual(oracle.fbm("pcg", (1.5, 2.5), octaves, 2.0, 0.5), 0)
            self.assertEqual(oracle.turbulence("pcg", (1.5, 2.5), octaves, 2.0, 0.5), 0)
            self.assertEqual(oracle.clouds("pcg", (1.5, 2.5), octaves, 2.0, 0.5), 0.15625)

    def test_ranges(self) -> None:
        numbers = generator("ranges")
        for n in (2, 3):
            for _ in range(200):
                arguments = ("lattice", [numbers.uniform(-20, 20) for _ in range(n)], 4, 2.0, 0.5, numbers.word())
                self.assertLessEqual(abs(oracle.fbm(*arguments)), 1)
                self.assertTrue(abs(oracle.fbm(*arguments)) <= oracle.turbulence(*arguments) <= 1)
                self.assertTrue(0 <= oracle.clouds(*arguments) <= 1)

    def test_ranges_of_the_sine_gradient(self) -> None:
        numbers = generator("sine ranges")
        for n in (2, 3):
            for _ in range(50):
                arguments = ("lattice+sine", [numbers.uniform(-20, 20) for _ in range(n)], 4, 2.0, 0.5, numbers.word())
                self.assertTrue(abs(oracle.fbm(*arguments)) <= oracle.turbulence(*arguments) <= Fraction(n, 2))
                self.assertTrue(0 <= oracle.clouds(*arguments) <= 1)

    def test_repeat_after_a_period_with_a_whole_lacunarity(self) -> None:
        for name, lacunarity, repeats in (("lattice+period48", 2.0, True), ("lattice+sine+period48", 3.0, True),
                                          ("lattice+period48", 1.5, False)):
            for point in self.POINTS:
                moved = [x - 48 for x in point]
                for function in (oracle.fbm, oracle.turbulence):
                    values = [function(name, p, 3, lacunarity, 0.5, 3) for p in (point, moved)]
                    self.assertEqual(values[0] == values[1], repeats, (name, lacunarity))

    def test_seeds_differ(self) -> None:
        self.assertEqual(len({oracle.fbm("pcg", (0.375, 0.5), 4, 2.0, 0.5, seed) for seed in range(32)}), 32)
