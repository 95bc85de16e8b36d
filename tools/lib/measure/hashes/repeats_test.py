"""Lags after which words of the default hash come again: docs/measured/default-hash.md states how many do, and these
are sampled. The hash is frozen, so nothing counts and searches them all any more; the page names what did."""

from __future__ import annotations

import re
import unittest

import numpy as np

from base.tree import ROOT
from proof.oracle.hashes import point_word

REPEATS = {(9393642, -15495197): 2.5, (1073741824, 536870912): 37.5, (5123698, -14328747, -377113): 8.6,
           (1018750, -449671, 185784): 1.4, (1302036, -12307130, 11291210, -16715271): 12.3}  # in percent


def percent_of_equal_words(lag: tuple[int, ...], count: int) -> float:
    cells = np.random.default_rng(1).integers(-(1 << 31), 1 << 31, (count, len(lag)))
    return 100 * sum(point_word("lattice", list(map(int, cell)), 0) == point_word("lattice", list(map(int, cell + lag)), 0)
                     for cell in cells) / count


class Repeats(unittest.TestCase):
    def test_words_come_again_as_often_as_the_page_states(self):
        page = " ".join((ROOT / "docs" / "measured" / "default-hash.md").read_text(encoding="utf-8").split())
        for lag, percent in REPEATS.items():
            with self.subTest(lag):
                self.assertAlmostEqual(percent_of_equal_words(lag, 4000), percent, delta=0.5 * percent ** 0.5)
                self.assertLess(percent_of_equal_words((lag[0] + 1, *lag[1:]), 500), 1)
                text = re.escape(f"({', '.join(map(str, lag))})")
                self.assertRegex(page, rf"{text}, (with )?{percent}%|{text} has {percent}%|{percent}% at {text}")
