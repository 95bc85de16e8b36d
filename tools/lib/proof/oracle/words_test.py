"""Tests of words.py: the published vectors show that the hashes are the ones they are named after."""

from __future__ import annotations

import itertools
import math
import unittest
from collections import Counter
from collections.abc import Callable

from proof.golden.generator import Generator, fnv1a64, generator_of
from proof.oracle import words


def murmurhash2(data: bytes, seed: int) -> int:
    """MurmurHash2, 32 bit, after Appleby; only to pin the oracle's murmur to it."""
    m = 0x5BD1E995
    h = seed ^ len(data)
    tail = len(data) // 4 * 4
    for i in range(0, tail, 4):
        k = int.from_bytes(data[i:i + 4], "little") * m & words.MASK
        h = h * m & words.MASK ^ (k ^ k >> 24) * m & words.MASK
    if tail < len(data):
        h = (h ^ int.from_bytes(data[tail:], "little")) * m & words.MASK
    return murmurhash2_avalanche(h)


def murmurhash2_avalanche(h: int) -> int:
    """The last three lines of MurmurHash2."""
    h = (h ^ h >> 13) * 0x5BD1E995 & words.MASK
    return h ^ h >> 15


def smhasher_verification(function: Callable[[bytes, int], int]) -> int:
    """SMHasher's VerificationTest of a 32-bit hash: the hash of its hashes of (), (0), (0, 1), ... with 256 seeds."""
    hashes = b"".join(words.word_bytes(function(bytes(range(i)), 256 - i)) for i in range(256))
    return function(hashes, 0)


class PublishedVectors(unittest.TestCase):
    def test_fnv1(self) -> None:
        # test_fnv.c of Landon Curt Noll; also php-src, ext/hash/tests/fnv132.phpt.
        vectors = {
            b"": 0x811C9DC5, b"a": 0x050C5D7E, b"foo": 0x408F5E13, b"foob": 0xB4B1178B, b"foobar": 0x31F0B262,
            b"foo\0": 0xB4B117E9, b"chon": 0xFCC8100F, b"cho\0": 0xFCC81061, b"curd": 0xE184FF97,
            b"chongo was here!\n": 0xDD002F35,
        }
        for data, value in vectors.items():
            self.assertEqual(words.fnv1(data), value, data)

    def test_one_at_a_time(self) -> None:
        # Wikipedia, "Jenkins hash function".
        self.assertEqual(words.one_at_a_time(b"a"), 0xCA2E9442)
        self.assertEqual(words.one_at_a_time(b"The quick brown fox jumps over the lazy dog"), 0x519E91F5)

    def test_xxh32(self) -> None:
        # Cyan4973/xxHash, cli/xsum_sanity_check.c: (length, seed, value) on its test buffer.
        prime32, prime64 = 2654435761, 11400714785074694797
        buffer = bytes(prime32 * prime64**i >> 56 & 0xFF for i in range(14))
        vectors = [
            (0, 0, 0x02CC5D05), (0, prime32, 0x36B78AE7), (1, 0, 0xCF65B03E), (1, prime32, 0xB4545AA4),
            (14, 0, 0x1208E7E2), (14, prime32, 0x6AF1D1FE),
        ]
        for length, seed, value in vectors:
            self.assertEqual(words.xxh32(buffer[:length], seed), value, (length, seed))

    def test_xxh32_of_text(self) -> None:
        # pierrec/lz4, internal/xxh32/xxh32zero_test.go.
        vectors = {
            b"a": 0x550D7456, b"ab": 0x4999FC53, b"abc": 0x32D153FF, b"abcd": 0xA3643705, b"abcde": 0x9738F19B,
            b"abcdefgh": 0x0BB3C6BB, b"abcdefghij": 0x8B988CFE,
        }
        for data, value in vectors.items():
            self.assertEqual(words.xxh32(data), value, data)

    def test_murmurhash2(self) -> None:
        # aappleby/smhasher, main.cpp: the verification value of MurmurHash2.
        self.assertEqual(smhasher_verification(murmurhash2), 0x27864C1E)

    def test_pcg(self) -> None:
        # imneme/pcg-c, test-low/expected/check-oneseq-32-rxs-m-xs-32.out: the generator seeded with 42. pcg_hash(k)
        # is the output of the state that follows k; seeding ends with adding 42 to the increment, and one step.
        state, values = 2891336453 + 42, []
        for _ in range(6):
            values.append(words.pcg(state))
            state = (state * 747796405 + 2891336453) & words.MASK
        self.assertEqual(values, [0x256B5357, 0xA5EFAD32, 0x170B7830, 0x334A5B22, 0x3DE5C680, 0x9B47B7B3])

    def test_pcg_of_several_words(self) -> None:
        # Games-by-Mason/geom, src/hash.zig: words, and others as floats in [0, 1].
        self.assertEqual(words.pcg2d(0, 1), (2313183303, 4026777116))
        self.assertEqual(words.pcg3d(0, 1, 2), (3409911753, 1806500465, 2000842263))
        self.assertEqual(words.pcg4d(0, 1, 2, 3), (933639991, 2252496459, 1324331964, 1990701187))
        floats = {words.pcg2d(1, 2): (1.0669651e-2, 4.9842097e-2),
                  words.pcg3d(1, 2, 3): (9.789959e-1, 2.849572e-1, 3.4935537e-1),
                  words.pcg4d(1, 2, 3, 4): (2.1146852e-1, 9.417182e-1, 8.791596e-1, 1.0639917e-2)}
        for found, expected in floats.items():
            for word, number in zip(found, expected, strict=True):
                self.assertAlmostEqual(word / words.MASK, number, delta=1e-7)

    def test_lowbias32(self) -> None:
        # Wellons, "Prospecting for Hash Functions", has the inverse. The values are of several programs that use it.
        for word, value in ((0, 0), (1, 0x688990C0), (2, 0xD1132181), (0xDEADBEEF, 0xE628C683)):
            self.assertEqual(words.lowbias32(word), value)
        draws = generator_of("lowbias32")
        for word in [words.MASK, 2**31] + [draws.word() for _ in range(100)]:
            x = words.lowbias32(word)
            x = (x ^ x >> 16) * 0x43021123 & words.MASK
            x = (x ^ x >> 15 ^ x >> 30) * 0x1D69E2A5 & words.MASK
            self.assertEqual(x ^ x >> 16, word)

    def test_splitmix64(self) -> None:
        # Rosetta Code, "Pseudo-random numbers/Splitmix64".
        numbers = Generator(1234567)
        self.assertEqual([numbers.next() for _ in range(3)],
                         [6457827717110365317, 3203168211198807973, 9817491932198370423])

    def test_fnv1a64(self) -> None:
        # test_fnv.c of Landon Curt Noll.
        vectors = {b"": 0xCBF29CE484222325, b"a": 0xAF63DC4C8601EC8C, b"foobar": 0x85944171F73967E8}
        for data, value in vectors.items():
            self.assertEqual(fnv1a64(data), value, data)


class Hashes(unittest.TestCase):
    def test_byte_order(self) -> None:
        for name, function in (("fnv1", words.fnv1), ("jenkins", words.one_at_a_time), ("xxhash32", words.xxh32)):
            self.assertEqual(words.hash_words(name, [0x04030201]), function(b"\1\2\3\4"), name)

    def test_partial_hashes_agree_with_whole_ones_on_bytes(self) -> None:
        for byte in range(256):
            self.assertEqual(words.hash_words("partial_jenkins", [byte]), words.one_at_a_time(bytes([byte])))
            self.assertEqual(words.hash_words("partial_fnv1", [byte]), words.fnv1(bytes([byte, byte])))

    def test_murmur_is_murmurhash2_before_its_avalanche(self) -> None:
        numbers = generator_of("murmur")
        for word in [0, 1, words.MASK] + [numbers.word() for _ in range(100)]:
            expected = murmurhash2(words.word_bytes(word), 10 ^ 4)
            self.assertEqual(murmurhash2_avalanche(words.murmur(word)), expected)

    def test_xxh32_of_a_word_in_one_formula(self) -> None:
        # The contract gives this form as well.
        numbers = generator_of("xxh32")
        for word in [0, 1, words.MASK] + [numbers.word() for _ in range(100)]:
            h = words.rotl((374761397 + word * 3266489917) & words.MASK, 17) * 668265263 & words.MASK
            h = (h ^ h >> 15) * 2246822519 & words.MASK
            h = (h ^ h >> 13) * 3266489917 & words.MASK
            self.assertEqual(words.hash_words("xxhash32", [word]), h ^ h >> 16)

    def test_no_long_xxh32(self) -> None:
        with self.assertRaises(ValueError):
            words.xxh32(bytes(16))

    def test_custom(self) -> None:
        self.assertEqual(words.custom(1), 0x045D9F3B)
        self.assertEqual(words.custom(0x10000), 0xA3989F3B)

    def test_mixer(self) -> None:
        # Values of a C program around the published lines of prospector32.
        vectors = {0x00000001: 0xED345605, 0x80000000: 0x12F4F1B9, 0xDEADBEEF: 0xB19C7922}
        for word, value in vectors.items():
            self.assertEqual(words.mix(word), value)

    def test_joins_by_hand(self) -> None:
        # Without a seed, s is 0: J is x' >> 12, and M is 2 x' + 1 = 0x691BC2C5 times 0x1001; 24 bits of it count.
        self.assertEqual(words.joins((1,)), (0xB48DE, 0x4812C5))
        # A adds 0xEBCA77 * 0xE6133E, 0xB2AE3D * 0x913FDC and 0xD4EB2F * 0x85AAB8 to x', and 32 bits of each count.
        self.assertEqual(words.weighted_sum((1,) * 4), 0xB48DE162 + 0xA00BDDD2 + 0x42FBBF6C + 0x2CA13FC8 - 2**32)
        # This is 0xC436BE68; twice it, and 1, is 0x886D7CD1.
        self.assertEqual(words.joins((1,) * 4), (0xB48DE ^ 0x10BD79 ^ 0x30ACAB ^ 0x13EA75, 0x3A8CD1))
        # mix(1) is 0xED345605 (see above): with x' it adds up to 0xA1C23767.
        self.assertEqual(words.joins((1,), 1), (0xB48DE ^ 0xED3456, 0x715ECF))
        # The centre of a cell adds h' = 0x165667B1 to x', which makes 0xCAE44913.
        self.assertEqual(words.joins((1,), 0, True), (0xB48DE ^ 0x165667, 0xEB0227))

    def test_word_of_a_lattice_point(self) -> None:
        # Values of a C program written from the contract: of one to four ones, then with signs and a seed.
        vectors = {
            ("lattice", (1, 1, 1, 1), 0): (0x523EAED6, 0x85DCE37F, 0xF17B380C, 0xD9DAB1C9),
            ("fnv1", (1, 1, 1, 1), 0): (0x3AB639A2, 0xE5131B2E, 0x8BB0B48A, 0x6CE5E51C),
            ("lattice", (5, -6, 7, -8), 0xDEADBEEF): (0x4C0EB395, 0x673B4445, 0xBB2A6B7D, 0x038022CE),
            ("fnv1", (5, -6, 7, -8), 0xDEADBEEF): (0xCC5C6D1A, 0x5A50CD31, 0xF54A693C, 0x88CE5A03),
            ("lattice", (0, 0, 0, 0), 0): (0x8F16D072,) * 4,
            ("fnv1", (0, 0, 0, 0), 0): (0xF3762ABF,) * 4,
        }
        for (name, point, seed), expected in vectors.items():
            found = tuple(words.point_word(name, point[:n], seed) for n in (1, 2, 3, 4))
            self.assertEqual(found, expected, (name, point))

    def test_word_of_a_centre(self) -> None:
        # Of the same C program, in three and in four dimensions.
        vectors = {
            ("lattice", (1, 1, 1, 1), 0): (0xF4592521, 0x8B382CFA),
            ("fnv1", (1, 1, 1, 1), 0): (0xD69B5788, 0x2BCEFCE2),
            ("lattice", (5, -6, 7, -8), 0xDEADBEEF): (0xFF8A09AE, 0xE23139BB),
            ("fnv1", (5, -6, 7, -8), 0xDEADBEEF): (0x9BAAB443, 0xBFAA7F94),
        }
        for (name, point, seed), expected in vectors.items():
            found = tuple(words.point_word(name, point[:n], seed, True) for n in (3, 4))
            self.assertEqual(found, expected, (name, point))

    def test_lattice_mixes_the_word_and_the_sum(self) -> None:
        # Of the same C program.
        vectors = {"lattice": (0x1C9CCF03, 0x614304D2, 0x72A8220A, 0x82FA63DB),
                   "fnv1": (0x34C9C663, 0x12704AF9, 0x386B338F, 0xB35D2BF0)}
        for name, mixed in vectors.items():
            found = tuple(words.lattice(name, (5, -6, 7, -8)[:n], 0xDEADBEEF) for n in (1, 2, 3, 4))
            self.assertEqual(found, mixed, name)
        for name in words.HASHES:
            total = words.point_word(name, (1, 2), 3) + words.weighted_sum((1, 2), 3)
            self.assertEqual(words.lattice(name, (1, 2), 3), words.mix(total % 2**32), name)

    def test_points_whose_word_is_0_differ(self) -> None:
        # The first ones on a line, and their hashes, of the same C program.
        for x, hashed in ((255180, 0xA425AA05), (619969, 0x591DA4F3), (2859252, 0xD27663EE)):
            self.assertEqual((words.joins((x,))[0], words.point_word("lattice", (x,))), (0, 0))
            self.assertEqual(words.lattice("lattice", (x,)), hashed)

    def test_every_hash_takes_the_same_joins(self) -> None:
        for seed in range(8):
            j, m = words.joins((5, -6, 7), seed)
            for name, function in words.WORD_HASHES.items():
                h = (function(j) * m + j) % 2**32
                self.assertEqual(words.point_word(name, (5, -6, 7), seed), h ^ h // 512, name)

    def test_low_bit_is_that_of_the_join(self) -> None:
        # By the contract these are not good: bits 12 and 11 of the spread coordinates.
        for x, y in itertools.product(range(8), repeat=2):
            first, second = words.spread((x, y))
            self.assertEqual(words.point_word("lattice", (x, y)) % 2, (first // 2**12 + second // 2**11) % 2)

    def test_bijections_do_not_collide(self) -> None:
        # A random function would collide here about eight times.
        keys = range(2**18)
        for function in (words.pcg, words.murmur, words.mix, words.lowbias32):
            self.assertEqual(len(set(map(function, keys))), len(keys), function.__name__)

    def test_words_chain(self) -> None:
        for name, function in words.WORD_HASHES.items():
            last = function(function(function(function(5) + 6 & words.MASK) + 7 & words.MASK) + 8 & words.MASK)
            self.assertEqual(words.hash_words(name, (5, 6, 7, 8)), last, name)

    def test_coordinates_are_twos_complement_and_wrap(self) -> None:
        for name in words.HASHES:
            self.assertEqual(words.lattice(name, (-1, 2**31), 3), words.lattice(name, (2**32 - 1, -2**31), 3))


class NearTheOrigin(unittest.TestCase):
    """Why a lattice point is spread: people look at the origin, and there no hash may show its weakness."""

    # Of n = 4096 values of a random function, n (n - 1) / 2 / 2^32 = 0.002 pairs are equal; that three are, by chance
    # 0.002^3 / 6, a billionth, would be a weakness.
    SIDE, LIMIT = range(-32, 32), 2

    def values(self, name: str) -> dict[tuple[int, int], int]:
        """The hashes of the points of all four quadrants."""
        return {point: words.lattice(name, point) for point in itertools.product(self.SIDE, repeat=2)}

    def test_few_points_collide(self) -> None:
        for name in words.HASHES:
            counts = Counter(self.values(name).values())
            self.assertLessEqual(sum(math.comb(count, 2) for count in counts.values()), self.LIMIT, name)

    def test_opposite_points_differ(self) -> None:
        for name in words.HASHES:
            values = self.values(name)
            equal = sum(values.get((-x, -y)) == value for (x, y), value in values.items() if (x, y) > (0, 0))
            self.assertLessEqual(equal, self.LIMIT, name)

    def test_origin_is_not_zero(self) -> None:
        for name, n in itertools.product(words.HASHES, (1, 2, 3, 4)):
            self.assertNotEqual(words.lattice(name, (0,) * n, 0), 0, (name, n))


class Components(unittest.TestCase):
    def test_by_hand(self) -> None:
        # The high bits of the last are -1, but for those that are shifted out: 0x31000000 - 0xEB1831.
        for word, y, z in ((0, 0, 0), (0xFF, 0, 0), (0x100, 0xEB1831, 0x84A5E5), (0x3FF, 3 * 0xEB1831, 3 * 0x84A5E5),
                           (0x01000000, 0x18310000, 0xA5E50000), (words.MASK, 0x3014E7CF, 0xE47B5A1B)):
            self.assertEqual([words.component_word(word, i) for i in range(3)], [word, y, z], hex(word))
