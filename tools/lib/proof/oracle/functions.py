"""Chooses how the oracle evaluates a function of the library, by its row: the family, its arguments, and its name."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from catalog.tables.configurations import Configuration
from catalog.tables.functions import NOISES, OCTAVE_SUMS, Function
from proof.oracle import (
    gradients,
    gullies,
    hashes,
    integers,
    jacobians,
    noises,
    numbers,
    perlin_worley,
    positions,
    scatter,
    sums,
    uniform,
)
from proof.oracle.components import component
from proof.oracle.curl import CURL
from proof.oracle.gradients import Knobs, Real
from proof.oracle.hexes import HEXES
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.nearest import NEAREST, OFFSET
from proof.oracle.noises import Noise
from proof.oracle.self_check import self_check

Evaluate = Callable[[Knobs, Sequence[Real]], tuple[Real, ...]]

# Whatever the knobs: of words, by the id of the row.
OF_WORDS: dict[str, Callable[..., tuple[Real, ...]]] = {
    "hash.unorm": lambda h: (gradients.unorm(h),), "hash.snorm": lambda h: (gradients.snorm(h),),
    "hash.gradient1": gradients.gradient1, "hash.gradient2": gradients.gradient2,
    "hash.gradient3": gradients.gradient3, "hash.gradient4": gradients.gradient4,
    "hash.lowbias32": lambda key: (hashes.lowbias32(key),),
    "hash.pcg2d": hashes.pcg2d, "hash.pcg3d": hashes.pcg3d, "hash.pcg4d": hashes.pcg4d,
    "numbers.rehash": lambda h, k: (numbers.rehash(h, k),),
    "numbers.unorm_two": lambda h: numbers.unorms(h, 2), "numbers.unorm_three": lambda h: numbers.unorms(h, 3),
    "numbers.unorm_four": lambda h: numbers.unorms(h, 4), "numbers.gaussian": lambda h: (numbers.gaussian(h),),
    "numbers.circle": numbers.circle, "numbers.disk": numbers.disk,
    "numbers.sphere": numbers.sphere, "numbers.ball": numbers.ball,
    "numbers.shuffle": lambda i, n, seed: (numbers.shuffle(i, n, seed),), "numbers.sobol": numbers.sobol,
    "uniform.spread": uniform.spread}
# Whatever the knobs but the arithmetic: exact, and in fixed arithmetic.
OF_SPREADS: dict[str, tuple[Callable[..., tuple[Real, ...]], Callable[..., tuple[Real, ...]]]] = {
    "uniform.uniform": (lambda *row: uniform.uniform_d(*row)[:1], lambda *row: uniform.fixed_uniform_d(*row)[:1]),
    "uniform.uniform_d": (uniform.uniform_d, uniform.fixed_uniform_d),
    "uniform.spread_fbm": (uniform.spread_fbm, uniform.fixed_spread_fbm)}
# They take a position that is a whole number, along one axis, and cells and units.
OF_A_PLACE: dict[str, Callable[[int, int, int], Real]] = {"cell": positions.cell, "fraction": positions.fraction}

# Sums of noises that nobody chooses.
OF_THEIR_OWN = {"gullies": gullies, "perlin_worley": perlin_worley}
NOISE_OF_SUMS = "perlin"  # unless the user names another


def knobs_of(configuration: Configuration) -> Knobs:
    return Knobs(configuration.hash, configuration.gradient == "sine")


LARGEST = (2 - 2.0**-23) * 2.0**127  # a float


def finite(x: Real) -> Real:
    """Where an infinity has a value it counts as the nearer end of a range, and no range is larger than that of
    floats."""
    return math.copysign(LARGEST, x) if isinstance(x, float) and math.isinf(x) else x


def evaluator(function: Function, fixed: bool) -> Evaluate:
    """The function in fixed arithmetic, or exactly: of the knobs and a row of inputs."""
    of = _evaluator_of(function, fixed)
    return lambda knobs, row: of(knobs, list(map(finite, row)))


def _evaluator_of(function: Function, fixed: bool) -> Evaluate:
    n, family = function.axes, function.family
    if function.id in OF_WORDS:
        return lambda _, row: OF_WORDS[function.id](*row)
    if function.id in OF_SPREADS:
        return lambda _, row: OF_SPREADS[function.id][fixed](*row)
    if function.form == "place":
        along_axis = OF_A_PLACE[function.name.rstrip("1234")]
        return lambda _, row: tuple(along_axis(x, *row[n:]) for x in row[:n])
    if function.form == "zero":
        return lambda knobs, row: (self_check(knobs.hash, *row),)
    if function.form == "candidate":
        return _candidate_evaluator(function)
    if function.bound == HEXES.name:
        return _evaluator(HEXES, function, fixed)
    if family == "hash" and function.form == "words":
        return lambda knobs, row: (hashes.hash_words(knobs.hash, row),)
    if family == "hash" and function.form == "point":
        return lambda knobs, row: (hashes.lattice(knobs.hash, row[:n], row[n]),)
    if family in ("gradient", "sine_gradient") and function.form == "point":
        gradient = integers.gradient if fixed else gradients.gradient
        return lambda knobs, row: gradient(knobs, row[:n], row[n])
    if family == "curl" and function.form in ("position", "cell"):
        return _evaluator(CURL, function, fixed)
    if family in NOISES and function.form in ("position", "cell", "place_of_noise"):
        return _noise_evaluator(function, fixed)
    if family in OCTAVE_SUMS and function.bound in (*sums.SUMS, *jacobians.SUMS, *OF_THEIR_OWN):
        return _sum_evaluator(function, fixed)
    raise function.error(f"the oracle has no {function.id}: write its values from docs/reference/contract.md in "
                         f"tools/lib/proof/oracle/{place_of(family)}")


def place_of(family: str) -> str:
    """Where the oracle has the functions of a family; those that are no noises and sums are named in this file, too."""
    if family in OCTAVE_SUMS:
        return "sums.py, and name it in SUMS there; with slopes, and of vectors, in jacobians.py"
    return "noises/" if family in NOISES else "functions.py, in OF_WORDS, OF_SPREADS or OF_A_PLACE, or as a new form"


def _candidate_evaluator(function: Function) -> Evaluate:
    """Where the candidate of a cell is, or whether it stands among those within a radius."""
    n = function.axes

    def evaluate(knobs: Knobs, row: Sequence[Real]) -> tuple[Real, ...]:
        *radius, seed = row[2 * n:]
        lattice, cell = Lattice(knobs, seed, tuple(row[n:2 * n])), row[:n]
        return (scatter.scattered(lattice, cell, *radius),) if radius else scatter.point(lattice, cell)

    return evaluate


def _of_a_place(position: Sequence[int], cells: int, units: int) -> tuple[list[int], list[float]]:
    """The cell and the fraction of a position that is a whole number."""
    return ([positions.cell(x, cells, units) for x in position],
            [positions.fraction(x, cells, units) for x in position])


# The outputs of a function beside its value.
SETS = {"nearest": NEAREST, "offset": OFFSET}


def _noise_evaluator(function: Function, fixed: bool) -> Evaluate:
    if function.sets:
        return _evaluator(SETS[function.sets], function, fixed)
    try:
        noise = noises.find(function.noise)
    except LookupError as error:
        raise function.error(str(error)) from error
    if function.component is not None:
        noise = component(noise, function.component)
    return _evaluator(noise, function, fixed)


def chosen(noise: Noise, function: Function, numbers: list[Real]) -> Noise:
    """The noise with the wave, the phase, the jitter and the metric that it takes from the end of the numbers."""
    choice = Choice()
    if function.has_metric:
        choice = replace(choice, metric=numbers.pop())
    if function.has_jitter:
        choice = replace(choice, jitter=numbers.pop())
    of = noise.rotated(numbers.pop()) if function.has_phase else noise
    if function.has_wave:
        choice = replace(choice, wave=tuple(numbers[-function.axes:]))
        del numbers[-function.axes:]
    return of.chosen(choice)


def values_of(noise: Noise, function: Function, fixed: bool) -> Evaluate:
    """All that a noise returns, of a row of the function's inputs."""
    n = function.axes

    def values(knobs: Knobs, row: Sequence[Real]) -> tuple[Real, ...]:
        *numbers, seed = row
        of = chosen(noise, function, numbers)
        at_position, in_cell = (of.fixed, of.fixed_cell) if fixed else (of.exact, of.exact_cell)
        if function.form == "place_of_noise":
            return in_cell(knobs, *_of_a_place(numbers[:n], *numbers[n:]), seed)
        if function.form == "cell":
            return in_cell(knobs, numbers[:n], numbers[n:2 * n], seed, numbers[2 * n:])
        return at_position(knobs, numbers[:n], seed, numbers[n:])

    return values


def names_of(function: Function) -> list[str]:
    """The names of its results, as the noise calls it: the derivatives behind a quadrature belong to it."""
    names = [column.name for column in function.outputs]
    return [name.replace("d", "q") if len(name) == 2 else name for name in names] if "quadrature" in names else names


def _evaluator(noise: Noise, function: Function, fixed: bool) -> Evaluate:
    values = values_of(noise, function, fixed)
    # In four dimensions the value and the derivatives have a row each.
    indices = [noise.outputs.index(name) for name in names_of(function)]

    def evaluate(knobs: Knobs, row: Sequence[Real]) -> tuple[Real, ...]:
        found = values(knobs, row)
        return tuple(found[i] for i in indices)

    return evaluate


def sum_values(name: str, fixed: bool) -> Callable[..., tuple[Real, ...]]:
    """The results of a sum: of the knobs, the place, the options, the seed and the periods."""
    if name in OF_THEIR_OWN:
        return OF_THEIR_OWN[name].fixed if fixed else OF_THEIR_OWN[name].exact
    if name in jacobians.SUMS:
        noise, of_several = noises.find(jacobians.SUMS[name].noise), jacobians.fixed if fixed else jacobians.exact
        return lambda *arguments: of_several(name, noise, *arguments)
    noise, of_one = noises.find(NOISE_OF_SUMS), sums.fixed if fixed else sums.exact
    return lambda *arguments: (of_one(name, noise, *arguments),)


def _sum_evaluator(function: Function, fixed: bool) -> Evaluate:
    n, values = function.axes, sum_values(function.bound, fixed)
    at_position, in_cell = ((sums.fixed_at_position, sums.fixed_in_cell) if fixed else
                            (sums.at_position, sums.in_cell))
    behind_place = 2 * n if function.has_cell else n
    behind_periods = behind_place + n * function.has_period
    names = ["octaves" if name == "detail" else name for name in function.settings]

    def evaluate(knobs: Knobs, row: Sequence[Real]) -> tuple[Real, ...]:
        *settings, seed = row[behind_periods:]
        place = in_cell(row[:n], row[n:behind_place]) if function.has_cell else at_position(row[:n])
        options = sums.Options(**dict(zip(names, settings, strict=True)))
        if function.has_cell:
            options = sums.from_cell(options)
        return values(knobs, place, options, seed, row[behind_place:behind_periods])

    return evaluate
