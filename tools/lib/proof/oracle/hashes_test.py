"""Tests of hashes.py: the published vectors show that the hashes are the ones they are named after."""

from __future__ import annotations

import unittest

from proof.golden.generator import generator_of
from proof.oracle import hashes

DRAWS = generator_of("words")
SAMPLE = [0, 1, 2**31, hashes.MASK] + [DRAWS.word() for _ in range(50)]

# Of bytes: test_fnv.c of Landon Curt Noll; Wikipedia, "Jenkins hash function"; xxh32zero_test.go of pierrec/lz4.
OF_BYTES = {
    hashes.fnv1: {b"": 0x811C9DC5, b"a": 0x050C5D7E, b"foobar": 0x31F0B262, b"cho\0": 0xFCC81061,
                 b"chongo was here!\n": 0xDD002F35},
    hashes.one_at_a_time: {b"a": 0xCA2E9442, b"The quick brown fox jumps over the lazy dog": 0x519E91F5},
    hashes.xxh32: {b"": 0x02CC5D05, b"a": 0x550D7456, b"abc": 0x32D153FF, b"abcd": 0xA3643705, b"abcde": 0x9738F19B,
                  b"abcdefgh": 0x0BB3C6BB, b"abcdefghij": 0x8B988CFE}}


def murmurhash2(data: bytes, seed: int) -> int:
    """MurmurHash2, 32 bit, after Appleby; only to pin the oracle's murmur to it."""
    m = 0x5BD1E995
    h = seed ^ len(data)
    tail = len(data) // 4 * 4
    for i in range(0, tail, 4):
        k = int.from_bytes(data[i:i + 4], "little") * m & hashes.MASK
        h = h * m & hashes.MASK ^ (k ^ k >> 24) * m & hashes.MASK
    if tail < len(data):
        h = (h ^ int.from_bytes(data[tail:], "little")) * m & hashes.MASK
    return murmurhash2_avalanche(h)


def murmurhash2_avalanche(h: int) -> int:
    """The last three lines of MurmurHash2."""
    h = (h ^ h >> 13) * 0x5BD1E995 & hashes.MASK
    return h ^ h >> 15


class PublishedVectors(unittest.TestCase):
    """A hash that is not the one it is named after."""

    def test_of_bytes(self) -> None:
        for function, vectors in OF_BYTES.items():
            for data, value in vectors.items():
                self.assertEqual(function(data), value, data)
        # Cyan4973/xxHash, cli/xsum_sanity_check.c: with a seed.
        buffer = bytes(2654435761 * 11400714785074694797**i >> 56 & 0xFF for i in range(14))
        self.assertEqual(hashes.xxh32(buffer, 2654435761), 0x6AF1D1FE)
        with self.assertRaises(ValueError):
            hashes.xxh32(bytes(16))

    def test_murmurhash2(self) -> None:
        # aappleby/smhasher, main.cpp: the verification value, of the hashes of (), (0), (0, 1), ... with 256 seeds.
        found = b"".join(murmurhash2(bytes(range(i)), 256 - i).to_bytes(4, "little") for i in range(256))
        self.assertEqual(murmurhash2(found, 0), 0x27864C1E)
        for word in SAMPLE:  # the oracle's leaves the avalanche out
            expected = murmurhash2(word.to_bytes(4, "little"), 10 ^ 4)
            self.assertEqual(murmurhash2_avalanche(hashes.murmur(word)), expected)

    def test_pcg(self) -> None:
        # imneme/pcg-c, test-low/expected/check-oneseq-32-rxs-m-xs-32.out: the generator seeded with 42. pcg_hash(k)
        # is the output of the state that follows k; seeding ends with adding 42 to the increment, and one step.
        state, values = 2891336453 + 42, []
        for _ in range(6):
            values.append(hashes.pcg(state))
            state = (state * 747796405 + 2891336453) & hashes.MASK
        self.assertEqual(values, [0x256B5357, 0xA5EFAD32, 0x170B7830, 0x334A5B22, 0x3DE5C680, 0x9B47B7B3])

    def test_pcg_of_several_words(self) -> None:
        # Games-by-Mason/geom, src/hash.zig: words, and others as floats in [0, 1].
        self.assertEqual(hashes.pcg2d(0, 1), (2313183303, 4026777116))
        self.assertEqual(hashes.pcg3d(0, 1, 2), (3409911753, 1806500465, 2000842263))
        self.assertEqual(hashes.pcg4d(0, 1, 2, 3), (933639991, 2252496459, 1324331964, 1990701187))
        floats = {hashes.pcg2d(1, 2): (1.0669651e-2, 4.9842097e-2),
                  hashes.pcg3d(1, 2, 3): (9.789959e-1, 2.849572e-1, 3.4935537e-1),
                  hashes.pcg4d(1, 2, 3, 4): (2.1146852e-1, 9.417182e-1, 8.791596e-1, 1.0639917e-2)}
        for found, expected in floats.items():
            for word, number in zip(found, expected, strict=True):
                self.assertAlmostEqual(word / hashes.MASK, number, delta=1e-7)

    def test_lowbias32(self) -> None:
        # Wellons, "Prospecting for Hash Functions", has the inverse. The values are of several programs that use it.
        for word, value in ((0, 0), (1, 0x688990C0), (2, 0xD1132181), (0xDEADBEEF, 0xE628C683)):
            self.assertEqual(hashes.lowbias32(word), value)
        for word in SAMPLE:
            x = hashes.lowbias32(word)
            x = (x ^ x >> 16) * 0x43021123 & hashes.MASK
            x = (x ^ x >> 15 ^ x >> 30) * 0x1D69E2A5 & hashes.MASK
            self.assertEqual(x ^ x >> 16, word)


class Hashes(unittest.TestCase):
    """A join of coordinates, a seed or a chain that is not the contract's. The values are of a C program."""

    def test_partial_hashes_agree_with_whole_ones_on_bytes(self) -> None:
        for byte in range(0, 256, 17):
            self.assertEqual(hashes.hash_words("partial_jenkins", [byte]), hashes.one_at_a_time(bytes([byte])))
            self.assertEqual(hashes.hash_words("partial_fnv1", [byte]), hashes.fnv1(bytes([byte, byte])))

    def test_custom(self) -> None:
        self.assertEqual(hashes.custom(1), 0x045D9F3B)
        self.assertEqual(hashes.custom(0x10000), 0xA3989F3B)

    def test_mixer(self) -> None:
        # The published lines of prospector32.
        for word, value in ((1, 0xED345605), (0x80000000, 0x12F4F1B9), (0xDEADBEEF, 0xB19C7922)):
            self.assertEqual(hashes.mix(word), value)

    def test_joins_by_hand(self) -> None:
        # Without a seed, s is 0: J is x' >> 12, and M is 2 x' + 1 = 0x691BC2C5 times 0x1001; 24 bits of it count.
        self.assertEqual(hashes.joins((1,)), (0xB48DE, 0x4812C5))
        # A adds 0xEBCA77 * 0xE6133E, 0xB2AE3D * 0x913FDC and 0xD4EB2F * 0x85AAB8 to x', and 32 bits of each count.
        self.assertEqual(hashes.weighted_sum((1,) * 4), 0xB48DE162 + 0xA00BDDD2 + 0x42FBBF6C + 0x2CA13FC8 - 2**32)
        # This is 0xC436BE68; twice it, and 1, is 0x886D7CD1.
        self.assertEqual(hashes.joins((1,) * 4), (0xB48DE ^ 0x10BD79 ^ 0x30ACAB ^ 0x13EA75, 0x3A8CD1))
        # mix(1) is 0xED345605 (see above): with x' it adds up to 0xA1C23767.
        self.assertEqual(hashes.joins((1,), 1), (0xB48DE ^ 0xED3456, 0x715ECF))
        # The centre of a cell adds h' = 0x165667B1 to x', which makes 0xCAE44913.
        self.assertEqual(hashes.joins((1,), 0, True), (0xB48DE ^ 0x165667, 0xEB0227))

    def test_of_a_lattice_point(self) -> None:
        # Of one to four coordinates, of the centre in space and in 4D, and mixed.
        of_points = {
            ("lattice", (1, 1, 1, 1), 0): (0x523EAED6, 0x85DCE37F, 0xF17B380C, 0xD9DAB1C9, 0xF4592521, 0x8B382CFA),
            ("fnv1", (1, 1, 1, 1), 0): (0x3AB639A2, 0xE5131B2E, 0x8BB0B48A, 0x6CE5E51C, 0xD69B5788, 0x2BCEFCE2),
            ("lattice", (5, -6, 7, -8), 0xDEADBEEF): (0x4C0EB395, 0x673B4445, 0xBB2A6B7D, 0x038022CE, 0xFF8A09AE,
                                                      0xE23139BB),
            ("fnv1", (5, -6, 7, -8), 0xDEADBEEF): (0xCC5C6D1A, 0x5A50CD31, 0xF54A693C, 0x88CE5A03, 0x9BAAB443,
                                                   0xBFAA7F94)}
        for (name, point, seed), expected in of_points.items():
            found = [hashes.point_word(name, point[:n], seed) for n in (1, 2, 3, 4)]
            found += [hashes.point_word(name, point[:n], seed, True) for n in (3, 4)]
            self.assertEqual(tuple(found), expected, (name, point))
        for name, mixed in (("lattice", (0x1C9CCF03, 0x614304D2, 0x72A8220A, 0x82FA63DB)),
                            ("fnv1", (0x34C9C663, 0x12704AF9, 0x386B338F, 0xB35D2BF0))):
            found = tuple(hashes.lattice(name, (5, -6, 7, -8)[:n], 0xDEADBEEF) for n in (1, 2, 3, 4))
            self.assertEqual(found, mixed, name)

    def test_words_chain(self) -> None:
        for name, function in hashes.WORD_HASHES.items():
            last = function(function(function(function(5) + 6 & hashes.MASK) + 7 & hashes.MASK) + 8 & hashes.MASK)
            self.assertEqual(hashes.hash_words(name, (5, 6, 7, 8)), last, name)

    def test_of_a_component(self) -> None:
        # The high bits of the last are -1, but for those that are shifted out: 0x31000000 - 0xEB1831.
        for word, y, z in ((0, 0, 0), (0xFF, 0, 0), (0x100, 0xEB1831, 0x84A5E5), (0x3FF, 3 * 0xEB1831, 3 * 0x84A5E5),
                           (0x01000000, 0x18310000, 0xA5E50000), (hashes.MASK, 0x3014E7CF, 0xE47B5A1B)):
            self.assertEqual([hashes.component_word(word, i) for i in range(3)], [word, y, z], hex(word))
