"""Lags after which words come again: where they are, that they do come again there, and that pages tell of them."""

from __future__ import annotations

import unittest
from dataclasses import replace

import numpy as np

from oracle.words import point_word
from quality.joins import Joins, nearest_repeat
from quality.near_returns import REACH
from tree import ROOT

SHARE = 0.01
POSITIONS = 1 << (REACH + 1)  # no two positions of floats are as many cells apart


def share_of_equal_words(lag: tuple[int, ...], count: int = 4000) -> float:
    cells = np.random.default_rng(1).integers(-(1 << 31), 1 << 31, (count, len(lag)))
    return sum(point_word("lattice", list(map(int, cell)), 0) == point_word("lattice", list(map(int, cell + lag)), 0)
               for cell in cells) / count


class Repeats(unittest.TestCase):
    def test_there_is_none_on_the_plane(self):
        self.assertIsNone(nearest_repeat(2, SHARE))

    def test_they_are_farther_than_positions_reach(self):
        page = (ROOT / "docs" / "default-hash.md").read_text(encoding="utf-8")
        for dimensions in (3, 4):
            repeat = nearest_repeat(dimensions, SHARE)
            self.assertGreater(repeat.reach, POSITIONS)
            self.assertTrue(f" {repeat.reach:,} " in page, f"docs/default-hash.md must tell of {repeat}")

    def test_words_come_again_there(self):
        for dimensions, share in ((3, 0.5), (4, 0.5)):
            repeat = nearest_repeat(dimensions, share)
            self.assertAlmostEqual(share_of_equal_words(repeat.lag), repeat.share, delta=0.04)
            beside = (repeat.lag[0] + 1, *repeat.lag[1:])
            self.assertLess(share_of_equal_words(beside), 0.01)

    def test_joins_that_repeat_are_told(self):
        plain = replace(Joins(), factors=(1, 1, 1, 1))  # what goes forth along x and back along y cancels
        self.assertGreater(nearest_repeat(2, SHARE, plain).share, 0.01)
        near = replace(Joins(), primes=(1, 1, 1, 1))  # coordinates that are not spread
        self.assertLess(nearest_repeat(3, SHARE, near).reach, POSITIONS)


if __name__ == "__main__":
    unittest.main()
