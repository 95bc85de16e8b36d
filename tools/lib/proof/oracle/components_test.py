"""Tests of components.py, perlin_vector.py and value_vector.py: each component is the noise of words of its own."""

from __future__ import annotations

import itertools
import unittest
from unittest import mock

from proof.oracle import hashes, noises
from proof.oracle.components import component
from proof.oracle.lattice import Lattice
from proof.oracle.testing import FORMS, KNOBS, places

FACTORS = (1, 0xEB1831, 0x84A5E5)


class Components(unittest.TestCase):
    """A component of other words, of another noise, or with other units."""

    def test_each_is_the_noise_of_words_of_its_own(self) -> None:
        for name, n, slopes in itertools.product(("value", "perlin"), (2, 3), ("", "_d")):
            noise = noises.find(f"{name}{slopes}")
            vectors = [component(noise, i) for i in range(n)] if slopes else [noises.find(f"{name}_vector")] * n
            for (p, seed), periods, form in itertools.product(places("words", n, 2, 16), ((), (48, 5, 0)[:n]), FORMS):
                for i, of in enumerate(vectors):
                    def word(lattice: Lattice, corner: list[int]) -> int:
                        h = hashes.point_word("lattice", lattice.point(corner), lattice.seed)
                        return h // 256 * FACTORS[i] % 2**32 if i else h

                    found = getattr(of, form)(KNOBS, p, seed, periods)
                    with mock.patch.object(Lattice, "word", word):
                        right = getattr(noise, form)(KNOBS, p, seed, periods)
                    self.assertEqual(found if slopes else found[i:i + 1], right)

    def test_only_in_two_and_three_dimensions(self) -> None:
        for name, n in itertools.product(("value", "perlin"), (1, 4)):
            with self.assertRaisesRegex(ValueError, "two and three"):
                noises.find(f"{name}_vector").exact(KNOBS, (0.5,) * n)
        for n, i in ((1, 0), (2, 2), (4, 1)):
            with self.assertRaisesRegex(ValueError, f"in {n}D has no component {i}"):
                component(noises.find("value_d"), i).exact(KNOBS, (0.5,) * n)
