"""Tests of tools/measure uniform: the constants, and that wrong ones show. tools/make errors measures how near
the library is to the model, and golden files hold it to that."""

from __future__ import annotations

import unittest
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from base.testing import called
from catalog.tables.markdown import with_section
from measure.uniform import command, model

NUMBER = 9  # of hn_perlin(vec2), by which one noise stands for all
SUBJECT = next(subject for subject in model.SUBJECTS if subject.number == NUMBER)
# By chance the distribution of POINTS is off by 0.0017 on average. This is too much for constants that are right, which
# are off by less than the bound allows, but not by much: of MANY_POINTS it is off by 0.0006.
POINTS, MANY_POINTS = 1 << 18, 1 << 21
SUMS = ((1.0, 0.5), (5.0, 0.5))


class UniformTest(unittest.TestCase):
    sampler: model.Sampler
    folder: Path

    @classmethod
    def setUpClass(cls) -> None:
        temporary = TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        (cls.folder / "one.inc").write_text(f"SUBJECT({NUMBER}, {SUBJECT.name}, {SUBJECT.axes}, {SUBJECT.function})\n")
        cls.sampler = model.Sampler(cls.folder, macros=[f'HN_SUBJECTS="{cls.folder / "one.inc"}"'])
        cls.text = model.library_text()
        cls.spreads = model.spreads_of(cls.text)
        cls.bell = model.Bell.of(cls.text)

    def test_the_contract_and_hn_distribution_have_the_constants(self) -> None:
        page = command.CONTRACT.read_text(encoding="utf-8")
        table = command.contract_table(command.in_units(self.text))
        self.assertEqual(page, with_section("docs/reference/contract.md", page, "tools/measure uniform: contract", table))
        self.assertEqual(self.text, command.with_spreads(self.text, command.in_units(self.text)))
        for name, numbers in (("B", self.bell.end), ("H", self.bell.way)):
            parts = ", ".join(str(round(number * model.PARTS)) for number in numbers)
            self.assertIn(f"`{name}` is `({parts}) / {model.PARTS}`", page)

    def test_the_tail_of_every_sum_rises(self) -> None:
        # A coefficient of a sum is linear in rho_8, which lies between rho_4^3 and rho_4^2 (Hoelder, on the
        # squares of weights as probabilities). So the coefficients are in order for every gain and number of octaves if
        # they are on these two curves. There a difference of two is a cubic in rho_4, and this is where it is least.
        for name, (_, *shape) in self.spreads.items():
            ends = np.array([0.0, *shape, 1.0])
            self.assertTrue(np.all(np.diff(ends) >= 0.0), name)
            h = (shape[2] - self.bell.end[2]) * self.bell.way
            first = np.diff([0.0, *self.bell.end, 1.0])
            linear, last = np.diff([0.0, *h, 0.0]), np.diff([0.0, *(np.array(shape) - self.bell.end - h), 0.0])
            for power in (2, 3):
                for constant, slope, top in zip(first, linear, last, strict=True):
                    curve = np.polynomial.Polynomial([constant, slope, *[0.0] * (power - 2), top])
                    turns = [root.real for root in curve.deriv().roots() if abs(root.imag) < 1e-9 and 0 < root.real < 1]
                    self.assertGreaterEqual(min(curve(np.array([0.0, 1.0, *turns]))), 0.0, (name, power))

    def test_wrong_constants_are_reported(self) -> None:
        def problems(spread: tuple[float, ...], points: int = POINTS) -> list[str]:
            errors = self.sampler.errors(points, {SUBJECT.name: spread}, SUMS, [SUBJECT])
            return command.too_large([command.Row(*key, points, error) for key, error in errors.items()])

        right = self.spreads[SUBJECT.name]
        self.assertEqual(problems(right, MANY_POINTS), [])
        for place, factor in ((0, 1.06), (0, 0.94), (2, 1.15), (3, 0.95)):
            wrong = (*right[:place], right[place] * factor, *right[place + 1:])
            found = problems(wrong)
            self.assertTrue(found, (place, factor))
            self.assertIn("PERLIN2, ", found[0])

    def test_the_record_has_every_noise_within_its_bound(self) -> None:
        rows = command.read()
        self.assertEqual({row[:3] for row in rows},
                         {(subject.name, *sum_) for subject in model.SUBJECTS for sum_ in command.SUMS})
        self.assertEqual(command.too_large(rows), [])
        self.assertEqual({row.points for row in rows}, {10**7})

    def test_wrong_input_is_refused(self) -> None:
        for arguments, message in ((["--points", "10"], "1000 points at least"),
                                   (["--out", "/none/x.csv"], "there is no folder")):
            status, printed = called(command.main, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(message, printed)
        path = self.folder / "record.csv"
        for text, message in (("a,b\n", "the first line must be"),
                              ("noise,octaves,gain,points,error\nX,1\n", r"csv:2: ")):
            path.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(ValueError, message):
                command.read(path)
        with self.assertRaisesRegex(ValueError, "hn_distribution has no line of SINE2"):
            model.spreads_of(self.text.replace("HN_DISTRIBUTION_SINE2)", "HN_DISTRIBUTION_OTHER)"))
        with self.assertRaisesRegex(ValueError, "three calls of hn_i_of_sum"):
            model.Bell.of("")
