"""Properties of every noise of the oracle, in each number of dimensions and with each gradient in bounds.inc.

A noise that is added needs no test here."""

from __future__ import annotations

import functools
import itertools
import math
import unittest
from collections.abc import Callable, Sequence
from fractions import Fraction

from proof.bounds import table
from proof.bounds.table import Bounds
from proof.oracle import gradients, noises
from proof.oracle.components import component
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Choice
from proof.oracle.noises import Noise
from proof.oracle.testing import FORMS, Place, moved, places, quotient

PHASE = 0.3  # of noises that rotate
WAVE = (2.25, -1.5, 0.7)  # of phasor noise
# Of noises whose gradients rotate, by that of the noise without a phase.
OTHER_SCALES = {("perlin", 3): Fraction(879, 985), ("simplex", 3): Fraction(4902, 4918),
                ("curl", 3): Fraction(4902, 4918) ** 2}  # a product of two
# For a vector with derivatives the second component stands for all.
COMPONENTS = {f"{of}_vector_d": component(noises.find(f"{of}_d"), 1) for of in ("perlin", "value")}


def settings(bounds: Bounds) -> list[Knobs]:
    sine = bounds.gradient == "sine"
    return [Knobs("lattice", sine), Knobs("fnv1", sine)]


def named(name: str, n: int) -> Noise:
    """With its gradients rotated, if they rotate."""
    noise = COMPONENTS.get(name) or noises.find(name)
    if name.startswith("phasor"):
        noise = noise.chosen(Choice(wave=WAVE[:n]))
    return noise if noise.phase is None else noise.rotated(PHASE)


def has_derivatives(bounds: Bounds) -> bool:
    return "_d" in bounds.noise


def is_cellular(noise: Noise) -> bool:
    """Whether it returns distances, with a metric."""
    return noise.outputs[0] == "first"


def values_of(noise: Noise, numbers: Sequence[Fraction]) -> Sequence[Fraction]:
    """The value, each distance, or each component, without derivatives."""
    return numbers if is_cellular(noise) or noise.outputs == noises.VECTOR else numbers[:1]


def derivatives_of(noise: Noise, numbers: Sequence[Fraction], of: str = "d") -> list[Fraction]:
    """Of the value, or with "q" of the quadrature."""
    return [number for name, number in zip(noise.outputs, numbers) if len(name) == 2 and name[0] == of]


def points(bounds: Bounds, name: str, count: int) -> list[Place]:
    return list(places(name, bounds.dimensions, count))


def of_every_noise(check: Callable[[EveryNoise, Noise, Bounds], None]) -> Callable[[EveryNoise], None]:
    """The test that each passes."""
    @functools.wraps(check)
    def test(self: EveryNoise) -> None:
        for bounds in table.read():
            with self.subTest(noise=bounds.noise, dimensions=bounds.dimensions, gradient=bounds.gradient):
                check(self, named(bounds.noise, bounds.dimensions), bounds)

    return test


class EveryNoise(unittest.TestCase):
    """A derivative that is not the limit of differences, or a rotation that is another than the phase's."""

    def test_every_noise_has_bounds(self) -> None:
        self.assertEqual(sorted({bounds.noise for bounds in table.read()}), sorted([*noises.names(), *COMPONENTS]))

    @of_every_noise
    def test_noise_is_0_at_lattice_points(self, noise: Noise, bounds: Bounds) -> None:
        """Noise of gradients is."""
        if bounds.noise.startswith(("perlin", "simplex")):
            for knobs, c in itertools.product(settings(bounds), (-3, 0, -0.0, 7, 2**23, -2**31, 3e38)):
                for of in (noise.exact, noise.fixed):
                    self.assertEqual({*values_of(noise, of(knobs, (c,) * bounds.dimensions, 5))}, {0})

    @of_every_noise
    def test_the_sine_gradient_is_that_of_perlin_noise_alone(self, noise: Noise, bounds: Bounds) -> None:
        """In the plane and in space, without derivatives. Others refuse it, or have no use for it."""
        p, n = (0.3, 0.7, 0.9, 0.2)[:bounds.dimensions], bounds.dimensions
        for of in (noise.exact, noise.fixed):
            if bounds.noise == "perlin" and n in (2, 3):
                self.assertNotEqual(of(Knobs("lattice"), p), of(Knobs("lattice", sine=True), p))
            elif bounds.noise.startswith("perlin"):
                with self.assertRaisesRegex(ValueError, "sine gradient"):
                    of(Knobs("lattice", sine=True), p)
            else:
                self.assertEqual(of(Knobs("lattice"), p), of(Knobs("lattice", sine=True), p))

    @of_every_noise
    def test_derivatives_are_the_limits_of_difference_quotients(self, noise: Noise, bounds: Bounds) -> None:
        """And with derivatives it is the same noise."""
        if has_derivatives(bounds):
            # The noise without derivatives, and which of its numbers has them.
            plain, first = named(bounds.noise.replace("_d", ""), bounds.dimensions), int("_vector" in bounds.noise)
            knobs, count = settings(bounds)[0], 2 if "phasor" in bounds.noise else 1
            for index, (p, seed) in enumerate(points(bounds, "derivatives", 2)):
                arguments = (seed, (5 * (index % 2),) * bounds.dimensions)
                found = noise.exact(knobs, p, *arguments)
                self.assertEqual(found[:count], plain.exact(knobs, p, *arguments)[first:first + count])
                self.assertEqual(noise.fixed(knobs, p, *arguments)[:count],
                                 plain.fixed(knobs, p, *arguments)[first:first + count])
                for i, name in enumerate("dq", first):
                    for axis, slope in enumerate(derivatives_of(noise, found, name)):
                        limit = quotient(lambda x: plain.exact(knobs, moved(p, axis, x), *arguments)[i])
                        self.assertLess(abs(limit - slope), 2**-64)

    @of_every_noise
    def test_a_phase_rotates(self, noise: Noise, bounds: Bounds) -> None:
        """Gradients and waves rotate by as much, so that noise is linear in the cosine and in the sine of a phase."""
        if noise.phase is None:
            return
        knobs, n = settings(bounds)[0], bounds.dimensions
        (p, seed), = points(bounds, "turns", 1)

        def at(phase: float | Fraction, form: str = "exact") -> tuple[Fraction, ...]:
            return getattr(noise.rotated(phase), form)(knobs, p, seed, (3,) * n)

        for form in FORMS:
            self.assertEqual(len({at(i / 8, form) for i in range(8)}), 8)
            for phase, turns in itertools.product((0.375, -2.0**-20), (1, 2**24)):
                self.assertEqual(at(phase + math.copysign(turns, phase), form), at(phase, form))
        if is_cellular(noise):
            return
        if (noise.name, n) == ("curl_phase", 3):  # a product, whose second factor is the same half a turn later
            for phase in map(Fraction, (0.1, -0.7)):
                half = zip(at(phase), at(phase + Fraction(1, 2)), strict=True)
                self.assertLess(max(abs(a + b) for a, b in half), 2**-180)
        else:
            for phase in map(Fraction, (0.1, -0.7, 0.5)):
                cosine, sine = map(gradients.sine_of_turns, (phase + Fraction(1, 4), phase))
                for found, still, quarter in zip(at(phase), at(0), at(0.25), strict=True):
                    self.assertLess(abs(found - cosine * still - sine * quarter), 2**-180)
        if bounds.noise.endswith("_phase"):
            plain = noises.find(bounds.noise.removesuffix("_phase"))
            scale = OTHER_SCALES.get((bounds.noise.split("_")[0], n), 1)
            self.assertEqual(at(0), tuple(scale * x for x in plain.exact(knobs, p, seed, (3,) * n)))

    def test_a_noise_that_is_not_there_and_a_period_too_few(self) -> None:
        message = "no merlin: write it in .*/noises from docs/reference/contract.md, and name it in NOISES"
        with self.assertRaisesRegex(LookupError, message):
            noises.find("merlin")
        with self.assertRaises(ValueError):
            noises.find("value").exact(Knobs("lattice"), (0.5, 0.5), 0, (48,))
