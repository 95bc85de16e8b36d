"""Tests of self_check.py: what a program in C makes of it, and that everything it is made of shows."""

from __future__ import annotations

import unittest
from unittest import mock

from proof.oracle import numbers, positions, self_check, words

# The program was written from the contract.
VALUES = {("lattice", 0): 464614027, ("lattice", 1): 2867596985, ("lattice", 2): 2483684267,
          ("lattice", words.MASK): 783962384, ("pcg", 0): 2027622782, ("pcg", 1): 2067113223}


class SelfCheck(unittest.TestCase):
    def test_of_a_program_in_c(self) -> None:
        self.assertEqual({key: self_check.self_check(*key) for key in VALUES}, VALUES)

    def check_fails(self) -> None:
        self.assertNotEqual(self_check.self_check("lattice", 0), VALUES["lattice", 0])

    def test_each_number_and_their_order_show(self) -> None:
        numbers_of, count = self_check.numbers_of, len(list(self_check.numbers_of(5, 7, 3)))
        self.assertEqual(count, 15)
        for at in range(count):
            def without(*arguments) -> list[float]:
                found = list(numbers_of(*arguments))
                return found[:at] + found[at + 1:]

            def one_off(*arguments) -> list[float]:
                found = list(numbers_of(*arguments))
                return [*found[:at], found[at] + 1, *found[at + 1:]]

            def exchanged(*arguments) -> list[float]:
                found = list(numbers_of(*arguments))
                return [*found[:at], *found[at:at + 2][::-1], *found[at + 2:]]

            for fault in (without, one_off, *([exchanged] if at + 1 < count else [])):
                with mock.patch.object(self_check, "numbers_of", fault):
                    self.check_fails()

    def test_each_function_and_the_rounds_show(self) -> None:
        for module, name in ((numbers, "unorms"), (numbers, "sphere"), (numbers, "disk"), (numbers, "sobol"),
                             (numbers, "shuffle"), (positions, "cell")):
            right = getattr(module, name)

            def of_another(h, *others):
                return right(h ^ 1 << 20, *others)

            with mock.patch.object(module, name, of_another):
                self.check_fails()
        for name, value in (("ROUNDS", 15), ("UNITS", 8)):
            with mock.patch.object(self_check, name, value):
                self.check_fails()

    def test_each_of_the_first_words_gives_another(self) -> None:
        self.assertEqual(len({self_check.self_check("lattice", zero) for zero in range(40)}), 40)

    def test_what_is_no_whole_number(self) -> None:
        with mock.patch.object(numbers, "gaussian", lambda h: 2.0**-14), self.assertRaisesRegex(ValueError, "no whole"):
            self_check.self_check("lattice", 0)
