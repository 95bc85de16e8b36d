"""tools/pick's text in shading languages has the bits of the C++ header with HN_FIXED, and in WGSL its numbers with HN_FAST.

    python3 -m translate.pick.shading_test FOLDER LANGUAGE...     FOLDER has what pick.languages_test has written

Exit status: 0 it has, 1 it has not, 77 there is no wgpu or no compiler here.
"""

from __future__ import annotations

import functools
import sys
import unittest
from collections.abc import Sequence
from pathlib import Path
from unittest import mock

import numpy

from base.testing import skipped_without
from base.tree import GLSL
from translate.pick import command, own_loops, printer
from translate.pick.evaluate import Module
from translate.pick.languages_test import POINTS, difference, functions, words
from translate.pick.languages_test import module as split_module
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES
from translate.pick.shading_runners import RUNNERS, Case, Runner, WgslRunner


@functools.cache
def module(arithmetic: str, language: str = "glsl") -> Module:
    return read(GLSL, {**command.settings(*arithmetic.split()), **LANGUAGES[language].library})


def text(language: str, arithmetic: str, *names: str, calls_first: bool = False) -> str:
    of = module(arithmetic, language)
    return Program(of, chosen(of, names), calls_first).text(LANGUAGES[language])


class Header(unittest.TestCase):
    """Beside the C++ header, in one language."""
    language: str
    runner: Runner
    folder: Path

    def differences(self, texts: Sequence[tuple[str, str, str]]) -> list[str]:
        """How each text of a function, by its arithmetic and its name, differs from the header, and each loop of somebody
        else from its right results; nothing where it does not."""
        cases: list[Case] = []
        expected: list[bytes] = []
        for arithmetic, name, shown in texts:
            of = split_module(arithmetic)
            passed, back = words(self.folder, arithmetic, of)[name]
            cases.append(Case(of, functions(of, arithmetic)[name], shown, passed, len(back)))
            expected.append(back)
        for whole, (function, passed, back) in zip(own_loops.module(False).tree, own_loops.cases(True, POINTS)):
            shown = Program(own_loops.module(False), [whole]).text(LANGUAGES[self.language])
            cases.append(Case(own_loops.module(True), function, shown, passed, len(back)))
            expected.append(back)
        found = self.runner.run(cases, POINTS)
        return [difference(case.function, back, got, POINTS)
                for case, back, got in zip(cases, expected, found, strict=True)]

    def test_the_bits_are_those_of_the_library_and_a_fault_of_the_printer_is_noticed(self) -> None:
        """At once, since a language may take seconds to compile anything."""
        keys = [(arithmetic, name) for arithmetic in self.runner.arithmetics
                for name in functions(split_module(arithmetic), arithmetic)]
        self.assertGreater(len(keys), 5)
        # Each function by both ways to find what is called.
        right = [(*key, text(self.language, *key, calls_first=bool(i % 2))) for i, key in enumerate(keys)]
        key = self.runner.arithmetics[0], "hn_perlin2"
        with mock.patch.dict(printer.STRENGTH, {"-": printer.STRENGTH["*"]}):  # as strong as a product
            wrong = (*key, text(self.language, *key))
        self.assertNotIn(wrong, right)
        found = self.differences([*right, wrong])
        of_right, of_wrong, own = found[:len(right)], found[len(right)], found[len(right) + 1:]
        self.assertEqual([f"{key}: {said}" for key, said in zip(keys, of_right) if said], [])
        self.assertRegex(of_wrong, f"^[1-9][0-9]* of {POINTS} ")
        self.assertEqual(own, [""] * len(own_loops.POINTS))


class Wgsl(unittest.TestCase):
    runner: WgslRunner

    def far(self, name: str, change: tuple[str, str] = ("", "")) -> float:
        """The part of the points at which HN_FAST gives another number than the header, by more than it is rounded: 1 is all."""
        of = split_module("fast")
        function, (passed, back) = functions(of, "fast")[name], words(Header.folder, "fast", of)[name]
        shown = text("wgsl", "fast", name)
        self.assertIn(change[0], shown)
        got, = self.runner.run([Case(of, function, shown.replace(*change), passed, len(back))], POINTS)
        types = [*([function.type] if function.type != "void" else []), *(one.type for one in function.parameters if one.is_set)]
        are_floats = [scalar == "float" for type_ in types for _, scalar in of.parts(type_)]
        ours, right = (numpy.frombuffer(one, numpy.uint32).reshape(POINTS, -1) for one in (got, back))
        with numpy.errstate(invalid="ignore"):
            near = numpy.isclose(ours.view(numpy.float32), right.view(numpy.float32), 1e-5, 1e-5)
        return (~numpy.where(are_floats, near, ours == right)).any(axis=1).mean()

    def test_numbers_of_fast_are_those_of_the_library(self) -> None:
        """But for some beside a wall, where a rounding leads to another cell, and of sums those far out, whose late octaves
        have no fraction left."""
        known = functions(split_module("fast"), "fast")
        names = [name for name in known if not name.startswith("hn_next")]  # behind the last octave it has no value
        self.assertGreater(len(names), 5)
        sums = {name for name in names if {"octaves", "detail"} & {one.at.text for one in known[name].parameters}}
        self.assertEqual([name for name in names if self.far(name) > (0.4 if name in sums else 0.1)], [])
        self.assertGreater(self.far("hn_perlin2", (" * 1.7880859375", " * 1.78825")), 0.5)

    def test_a_hash_of_the_users_is_called(self) -> None:
        """One that is a hash of the library gives the words of that."""
        of = split_module("fixed")
        function, (passed, back) = functions(of, "fixed")["hn_perlin2"], words(Header.folder, "fixed", of)["hn_perlin2"]
        cases = []
        for options in ({"hash": "pcg"}, {"hash": "custom", "hash_function": "mine"}):
            library = command.read_library(GLSL, command.Choice("wgsl", "fixed", **options))
            shown = Program(library, chosen(library, ["hn_perlin2"])).text(LANGUAGES["wgsl"])
            self.assertEqual("mine(" in shown, options["hash"] == "custom")
            own = text("wgsl", "fixed", "hn_hash_pcg").replace("hn_hash_pcg", "mine")
            cases.append(Case(of, function, own + shown, passed, len(back)))
        one, other = self.runner.run(cases, POINTS)
        self.assertEqual(one, other)
        self.assertNotEqual(one, back)

    def test_the_compilation_can_fail(self) -> None:
        with self.assertRaises(Exception):
            self.runner.device.compile(text("wgsl", "fast", "hn_perlin2").replace("-> f32", "-> u32"))


if __name__ == "__main__":
    Header.folder = Path(sys.argv[1]).resolve()
    languages = sys.argv[2:]
    suite = unittest.TestSuite()
    with skipped_without():
        for language in languages:
            runner = RUNNERS[language]()
            of_language = type(f"Header_{language}", (Header,), {"language": "hlsl" if language == "dxc" else language,
                                                                    "runner": runner})
            suite.addTest(unittest.defaultTestLoader.loadTestsFromTestCase(of_language))
            if language == "wgsl":
                Wgsl.runner = runner
                suite.addTest(unittest.defaultTestLoader.loadTestsFromTestCase(Wgsl))
    sys.exit(not unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful())
