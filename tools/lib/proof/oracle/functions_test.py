"""Tests of functions.py: the oracle evaluates each row of the table of functions."""

from __future__ import annotations

import unittest
from collections.abc import Iterator
from unittest import mock

from base.golden_values import Golden
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import Function, read_functions
from proof.golden.files import Values, golden_files, line, meaning
from proof.oracle import functions
from proof.oracle.nearest import NEAREST, OFFSET
from proof.oracle.words import signed

ROWS = 3  # of each file, at its beginning, in its middle and at its end


def of_each_kind() -> list[Function]:
    """One function for each name in shaders, and for each of its numbers."""
    return list({(function.calls, function.outputs): function for function in read_functions()}.values())


def values_of_files() -> Iterator[Values]:
    """With the first and with the last setting, which is fixed arithmetic where there is that."""
    for file in golden_files(of_each_kind(), read_configurations()):
        yield from {values.name: values for values in (file.values[0], file.values[-1])}.values()


class EveryFunction(unittest.TestCase):
    def check(self) -> None:
        """Other programs find the values of golden files, too."""
        for values in values_of_files():
            function, golden = values.function, Golden(values.function.id, values.name, finite=False)
            kinds = [column.type for column in function.inputs]
            step = max(1, (len(golden.inputs) - 1) // (ROWS - 1))
            for words, expected in list(zip(golden.inputs, golden.values))[::step]:
                row = [signed(word) if kind == "i32" else meaning(kind, word) for kind, word in zip(kinds, words)]
                found = line(function.outputs, values.evaluate(row))
                self.assertEqual([int(word, 16) for word in found.split()], expected, (function.id, values.name))

    def test_is_evaluated_as_its_golden_file_says(self) -> None:
        self.check()

    def test_another_evaluation_is_noticed(self) -> None:
        for name, fault in (("OF_WORDS", functions.OF_WORDS | {"numbers.rehash": lambda h, k: (h,)}),
                            ("SETS", {"nearest": OFFSET, "offset": NEAREST}), ("names_of", lambda _: ["value"])):
            with mock.patch.object(functions, name, fault), self.assertRaises((AssertionError, ValueError), msg=name):
                self.check()
