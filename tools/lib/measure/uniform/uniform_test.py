"""Tests of tools/measure uniform: the constants, the library's text against the model, and that wrong constants show."""

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
# Errors of the comments in uniform.glsl: of a value, and of a slope times the reach.
ERRORS = {"FAST": (2e-6, 1e-5), "FIXED": (8e-5, 5e-4)}
ARITHMETICS = {"FAST": 1, "FIXED": 3}


class UniformTest(unittest.TestCase):
    samplers: dict[str, model.Sampler]
    folder: Path

    @classmethod
    def setUpClass(cls) -> None:
        temporary = TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        (cls.folder / "one.inc").write_text(f"SUBJECT({NUMBER}, {SUBJECT.name}, {SUBJECT.axes}, {SUBJECT.function})\n")
        cls.samplers = {}
        for name, number in ARITHMETICS.items():
            (cls.folder / name).mkdir()
            cls.samplers[name] = model.Sampler(
                cls.folder / name, macros=[f"HN_ARITHMETIC={number}", f'HN_SUBJECTS="{cls.folder / "one.inc"}"'])
        cls.text = model.library_text()
        cls.spreads = model.spreads_of(cls.text)
        cls.bell = model.Bell.of(cls.text)

    def test_the_contract_and_hn_distribution_have_the_constants(self) -> None:
        page = command.CONTRACT.read_text(encoding="utf-8")
        table = command.contract_table(command.in_units(self.text))
        self.assertEqual(page, with_section("docs/reference/contract.md", page, "tools/measure uniform: contract", table))
        self.assertEqual(self.text, command.with_spreads(self.text, command.in_units(self.text)))
        for sampler in self.samplers.values():
            self.assertEqual(sampler.spread_of(NUMBER).tolist(), [*self.spreads[SUBJECT.name]])
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

    def test_the_library_computes_the_model(self) -> None:
        random = np.random.default_rng(1)
        shapes = np.sort(random.random((3000, 3)), axis=1)
        spreads = np.concatenate([random.uniform(0.1, 2.9, (3000, 1)), shapes], axis=1)
        values = random.uniform(-1.1, 1.1, 3000) * spreads[:, 0]
        values, spreads = values.astype(np.float32), spreads.astype(np.float32)
        exact = spreads.astype(float)
        far = model.uniform(np.abs(values).astype(float), exact[:, 0], exact[:, 1:])
        expected = np.where(values < 0, 1.0 - far, far)
        step = 1e-5
        sizes = np.abs(values).astype(float)
        ends = [model.uniform(np.maximum(sizes + side * step, 0.0), exact[:, 0], exact[:, 1:]) for side in (-0.5, 0.5)]
        slopes = (ends[1] - ends[0]) / step
        inside = sizes > step
        for name, (error, slope_error) in ERRORS.items():
            found = self.samplers[name].map(values, spreads)
            self.assertEqual(found[:, 0].tolist(), found[:, 1].tolist(), name)
            self.assertLess(np.abs(found[:, 1] - expected).max(), error, name)
            off = np.abs(found[:, 2] - slopes) * exact[:, 0]
            self.assertLess(off[inside].max(), slope_error + 2e-4, name)  # a difference over a step is off by that

    def test_the_library_computes_spreads_of_sums(self) -> None:
        for octaves, gain in ((1.0, 0.5), (2.0, 1.0), (3.5, 0.5), (8.0, 0.8)):
            for spread in self.spreads.values():
                shape = np.array(spread[1:])
                rhos = [np.array([model.rho(octaves, gain, power)]) for power in (4, 8)]
                shape_of_sum = model.shape_of_sum(shape, self.bell, *rhos)
                of_octaves = model.weights(octaves, gain)
                ratio = (of_octaves**2).sum() * model.variance(shape) / model.variance(shape_of_sum)
                expected = [spread[0] * np.sqrt(ratio) / of_octaves.sum(), *shape_of_sum]
                for name, error in (("FAST", 2e-6), ("FIXED", 1e-3)):
                    found = self.samplers[name].spread_of_sum(spread, octaves, gain)
                    self.assertLess(np.abs(found - expected).max(), error, (name, octaves, gain, spread))

    def test_with_fixed_arithmetic_it_never_falls(self) -> None:
        random = np.random.default_rng(2)
        values = np.sort(np.round(random.normal(0.0, 0.3, 20000) * 2**21) / 2**21)
        for spread in (self.spreads["PERLIN1"], self.spreads["VALUE1"], (0.07, 0.9, 0.1, 0.3), (2.9, 0.0, 0.0, 0.0)):
            found = self.samplers["FIXED"].map(values, np.array(spread))
            self.assertTrue(np.all(np.diff(found[:, 1]) >= 0.0), spread)

    def test_wrong_constants_are_reported(self) -> None:
        def problems(spread: tuple[float, ...], points: int = POINTS) -> list[str]:
            errors = self.samplers["FAST"].errors(points, {SUBJECT.name: spread}, SUMS, [SUBJECT])
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
