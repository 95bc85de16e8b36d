"""Section 25 of docs/reference/contract.md: Perlin noise that is lifted where cells have their points."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

from proof.oracle import noises, sums
from proof.oracle.gradients import Knobs
from proof.oracle.hashes import MASK, SEED_STEP, mix
from proof.oracle.integers import NOISE_UNIT, UNIT
from proof.oracle.jacobians import clamped_to, prod
from proof.oracle.sums import FixedPlace, Options, Place, clamped

PERLIN, CELLULAR = noises.find("perlin"), noises.find("cellular")
MOST = 3  # octaves of cells

Octave = TypeVar("Octave", sums.Octave, sums.FixedOctave)


def check(knobs: Knobs) -> None:
    if knobs.sine:
        raise ValueError("with the sine gradient there is no hn_perlin_worley")


def few(options: Options) -> Options:
    """With the octaves of cells."""
    return replace(options, octaves=min(options.octaves, MOST))


def with_seeds(octaves: Iterable[Octave], seed: int) -> Iterator[Octave]:
    """The octaves of cells, which have seeds of their own: t_i."""
    t = mix(seed + SEED_STEP & MASK)
    for place, periods, _ in octaves:
        yield place, periods, t
        t = t + SEED_STEP & MASK


# --- Exact -------------------------------------------------------------------------------------------------------


def cells(knobs: Knobs, place: Place, options: Options, seed: int, periods: Sequence[int]) -> Fraction:
    """B."""
    octaves = sums.octaves_of(place, few(options), seed, periods)
    found = [1 - 2 * CELLULAR.exact(knobs, q, t, p)[0] for q, p, t in with_seeds(octaves, seed)]
    weights = sums.weights(few(options))
    return clamped(sums.fbm(sums.Terms(found, weights, weights, Fraction(options.gain), Fraction(0))), -1, 1)


def exact(knobs: Knobs, place: Place, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    check(knobs)
    perlin = sums.exact("fbm", PERLIN, knobs, place, options, seed, periods)
    return (1 - (1 - perlin) * (1 - cells(knobs, place, options, seed, periods)) / 4,)


# --- Fixed: in units of 2^-21 ------------------------------------------------------------------------------------


def fixed_cells(knobs: Knobs, place: FixedPlace, options: Options, seed: int, periods: Sequence[int]) -> int:
    octaves = sums.fixed_octaves_of(place, few(options), seed, periods)
    distances = [sums.fixed_at(CELLULAR, knobs, octave)[0] for octave in with_seeds(octaves, seed)]
    found = [NOISE_UNIT - 2 * distance * (NOISE_UNIT // UNIT) for distance in distances]
    weights = sums.fixed_weights(few(options))
    mean = sums.fixed_fbm(sums.Terms(found, weights, weights, sums.in_weights(options.gain), 0))
    return clamped_to(mean, NOISE_UNIT)


def fixed(knobs: Knobs, place: FixedPlace, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    check(knobs)
    perlin = sums.fixed_fbm(sums.fixed_terms(PERLIN, knobs, place, options, seed, periods))
    lack = prod(NOISE_UNIT - perlin, NOISE_UNIT - fixed_cells(knobs, place, options, seed, periods))
    return (Fraction(NOISE_UNIT - (lack + 16 >> 5), NOISE_UNIT),)
