"""Lags after which words come again: how many do, that the search finds such lags, and that pages have them."""

from __future__ import annotations

import unittest
from dataclasses import replace

import numpy as np

from base.thorough import THOROUGH, in_thorough_runs
from base.tree import ROOT
from measure.hashes.joins import Joins, Repeat, keeps_the_sum, of_one_change, on_the_plane, shares, steps_of
from measure.hashes.lags import REACH
from proof.oracle.words import point_word

LEAST = 0.01
POSITIONS = 1 << (REACH + 1)  # no two positions of floats are as many cells apart
# The worst that is known within that reach. Of the plane all lags are searched; of the others, those of one change.
WORST = {2: Repeat((9393642, -15495197), 0.0248), 3: Repeat((5123698, -14328747, -377113), 0.0864),
         4: Repeat((1302036, -12307130, 11291210, -16715271), 0.1226)}
FAR = Repeat((1073741824, 536870912), 0.375)  # on the plane
MORE_CHANGES = Repeat((1018750, -449671, 185784), 0.0136)  # in space, which no search here finds


def share_of_equal_words(lag: tuple[int, ...], count: int = 4000) -> float:
    cells = np.random.default_rng(1).integers(-(1 << 31), 1 << 31, (count, len(lag)))
    return sum(point_word("lattice", list(map(int, cell)), 0) == point_word("lattice", list(map(int, cell + lag)), 0)
               for cell in cells) / count


def worst(found) -> Repeat | None:
    return max(found, key=lambda repeat: repeat.share, default=None)


class Repeats(unittest.TestCase):
    def test_words_come_again_as_often_as_is_told(self):
        for repeat in (*WORST.values(), FAR, MORE_CHANGES):
            steps = steps_of(np.array([repeat.lag]))
            self.assertTrue(keeps_the_sum(steps).all(), repeat)
            share, = shares(steps)
            self.assertAlmostEqual(share, repeat.share, 4)
            self.assertAlmostEqual(share_of_equal_words(repeat.lag), share, delta=0.03)
            self.assertLess(share_of_equal_words((repeat.lag[0] + 1, *repeat.lag[1:]), 500), 0.01)

    def test_a_share_is_that_of_all_points(self):
        # Of coordinates that have so few bits that all points can be tried, times 2^20 to be as long as ours.
        for axes in (2, 3):
            joins = Joins(shifts=(26, 25, 27))
            points = np.stack(np.meshgrid(*[np.arange(256, dtype=np.uint64)] * axes, indexing="ij"), -1).reshape(-1, axes)
            points = points[::49 if axes == 3 else 1] << np.uint64(24)
            rng = np.random.default_rng(axes)
            for steps in rng.integers(0, 256, (40 if THOROUGH else 5, axes)).astype(np.uint64) << np.uint64(24):
                after = (points + steps) & np.uint64(0xFFFFFFFF)
                shifts = np.array(joins.shifts[:axes], np.uint64)
                same = (np.bitwise_xor.reduce(points >> shifts, axis=1) ==
                        np.bitwise_xor.reduce(after >> shifts, axis=1)).mean()
                self.assertAlmostEqual(shares(steps[None], joins=joins)[0], same, 9 if axes == 2 else 2)

    def test_the_worst_that_a_search_finds_within_positions(self):
        self.assertIsNone(worst(of_one_change(2, POSITIONS, LEAST)))
        self.assertEqual(self.rounded(worst(of_one_change(3, POSITIONS, LEAST))), WORST[3])

    @in_thorough_runs
    def test_the_worst_in_four_dimensions(self):
        self.assertEqual(self.rounded(worst(of_one_change(4, POSITIONS, LEAST))), WORST[4])

    @in_thorough_runs
    def test_the_worst_of_all_on_the_plane(self):
        self.assertEqual(self.rounded(worst(on_the_plane(POSITIONS, LEAST))), WORST[2])

    def test_the_searches_agree_on_the_plane(self):
        # Of coordinates that are not spread: a lag along x and its opposite along y cancel.
        plain = replace(Joins(), primes=(1, 1, 1, 1), factors=(1, 1, 1, 1), sum_bits=16)
        reach = 1 << 16
        some = {self.rounded(repeat) for repeat in of_one_change(2, reach, 0.2, plain)}
        self.assertTrue(some)
        self.assertEqual(some, {self.rounded(repeat) for repeat in on_the_plane(reach, 0.2, plain)})

    def test_joins_that_repeat_near_are_found(self):
        near = replace(Joins(), primes=(1, 1, 1, 1))  # coordinates that are not spread
        self.assertGreater(worst(of_one_change(3, 1 << 9, LEAST, near)).share, 0.5)

    def test_pages_have_these_numbers(self):
        page = " ".join((ROOT / "docs" / "measured" / "default-hash.md").read_text(encoding="utf-8").split())
        for repeat in (*WORST.values(), FAR, MORE_CHANGES):
            for text in (f"({', '.join(map(str, repeat.lag))})", f"{100 * repeat.share:.1f}%"):
                self.assertTrue(text in page, f"docs/measured/default-hash.md has no {text}")

    @staticmethod
    def rounded(repeat: Repeat) -> Repeat:
        """One of the two opposite lags."""
        lag = repeat.lag if repeat.lag > (0,) else tuple(-c for c in repeat.lag)
        return Repeat(lag, round(repeat.share, 4))


if __name__ == "__main__":
    unittest.main()
