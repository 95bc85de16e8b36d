"""Chooses how the oracle evaluates a function of the library, by its row: by its noise or sum, its arguments, or its
name in the library."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from catalog.tables.configurations import Configuration
from catalog.tables.functions import Function
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
from proof.oracle.gradients import Knobs, Real
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.nearest import NEAREST, OFFSET
from proof.oracle.noises import Noise
from proof.oracle.self_check import self_check

Values = tuple[Real, ...]
Evaluate = Callable[[Knobs, Sequence[Real]], Values]


def along_axes(of: Callable[[int, int, int], Real], *row: int) -> Values:
    """A row has a position that is a whole number along each axis, and cells and units."""
    *position, cells, units = row
    return tuple(of(x, cells, units) for x in position)


def scatter_point(knobs: Knobs, *row: int) -> Values:
    *place, seed = row
    n = len(place) // 2
    return scatter.point(Lattice(knobs, seed, tuple(place[n:])), place[:n])


def scattered(knobs: Knobs, *row: Real) -> Values:
    *place, radius, seed = row
    n = len(place) // 2
    return (scatter.scattered(Lattice(knobs, seed, tuple(place[n:])), place[:n], radius),)


# The functions that are neither noises nor sums, by their names. They take a row, whatever the knobs; ...
OF_ROWS: dict[str, Callable[..., Values]] = {
    "hn_unorm": lambda h: (gradients.unorm(h),), "hn_snorm": lambda h: (gradients.snorm(h),),
    "hn_gradient1": gradients.gradient1, "hn_gradient2": gradients.gradient2,
    "hn_gradient3": gradients.gradient3, "hn_gradient4": gradients.gradient4,
    "hn_hash_lowbias32": lambda key: (hashes.lowbias32(key),),
    "hn_hash_pcg2d": hashes.pcg2d, "hn_hash_pcg3d": hashes.pcg3d, "hn_hash_pcg4d": hashes.pcg4d,
    "hn_rehash": lambda h, k: (numbers.rehash(h, k),),
    "hn_unorm_two": lambda h: numbers.unorms(h, 2), "hn_unorm_three": lambda h: numbers.unorms(h, 3),
    "hn_unorm_four": lambda h: numbers.unorms(h, 4), "hn_gaussian": lambda h: (numbers.gaussian(h),),
    "hn_circle": numbers.circle, "hn_disk": numbers.disk, "hn_sphere": numbers.sphere, "hn_ball": numbers.ball,
    "hn_shuffle": lambda i, n, seed: (numbers.shuffle(i, n, seed),), "hn_sobol": numbers.sobol,
    "hn_cell": functools.partial(along_axes, positions.cell),
    "hn_fraction": functools.partial(along_axes, positions.fraction),
    "hn_distribution": uniform.spread, "hn_distribution_fbm": uniform.spread_fbm,
    "hn_uniform": lambda *row: uniform.uniform_d(*row)[:1], "hn_uniform_d": uniform.uniform_d}
# the knobs and a row; ...
OF_KNOBS: dict[str, Callable[..., Values]] = {
    "hn_hash": lambda knobs, *words: (hashes.hash_words(knobs.hash, words),),
    "hn_lattice": lambda knobs, *point: (hashes.lattice(knobs.hash, point[:-1], point[-1]),),
    "hn_gradient": lambda knobs, *point: gradients.gradient(knobs, point[:-1], point[-1]),
    "hn_self_check": lambda knobs, zero: (self_check(knobs.hash, zero),),
    "hn_scatter_point": scatter_point, "hn_scattered": scattered}
# and in fixed arithmetic, where that changes them.
FIXED: dict[str, Callable[..., Values]] = {
    "hn_gradient": lambda knobs, *point: integers.gradient(knobs, point[:-1], point[-1]),
    "hn_distribution_fbm": lambda _, *row: uniform.fixed_spread_fbm(*row),
    "hn_uniform": lambda _, *row: uniform.fixed_uniform_d(*row)[:1],
    "hn_uniform_d": lambda _, *row: uniform.fixed_uniform_d(*row)}

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
    called = function.calls
    if fixed and called in FIXED:
        return lambda knobs, row: FIXED[called](knobs, *row)
    if called in OF_KNOBS:
        return lambda knobs, row: OF_KNOBS[called](knobs, *row)
    if called in OF_ROWS:
        return lambda _, row: OF_ROWS[called](*row)
    if function.form in ("position", "cell", "place_of_noise"):
        return _noise_evaluator(function, fixed)
    if function.form == "sum" and function.bound in (*sums.SUMS, *jacobians.SUMS, *OF_THEIR_OWN):
        return _sum_evaluator(function, fixed)
    where = ("sums.py, and name it in SUMS there; with slopes, and of vectors, in jacobians.py"
             if function.form == "sum" else "functions.py, in OF_ROWS or OF_KNOBS, or as a new form")
    raise function.error(f"the oracle has no {function.id}: write its values from docs/reference/contract.md in "
                         f"tools/lib/proof/oracle/{where}")


def _of_a_place(position: Sequence[int], cells: int, units: int) -> tuple[list[int], list[float]]:
    """The cell and the fraction of a position that is a whole number."""
    return ([positions.cell(x, cells, units) for x in position],
            [positions.fraction(x, cells, units) for x in position])


# The outputs of a function beside its value.
SETS = {"nearest": NEAREST, "offset": OFFSET}


def chosen(noise: Noise, function: Function, numbers: list[Real]) -> Noise:
    """The noise with the wave, the bandwidth, the phase, the jitter and the metric that it takes from the end of the numbers."""
    choice = Choice()
    if "metric" in function.takes:
        choice = replace(choice, metric=numbers.pop())
    if "jitter" in function.takes:
        choice = replace(choice, jitter=numbers.pop())
    of = noise.rotated(numbers.pop()) if function.has_phase else noise
    if "bandwidth" in function.takes:
        choice = replace(choice, bandwidth=numbers.pop())
    if "wave" in function.takes:
        choice = replace(choice, wave=tuple(numbers[-function.axes:]))
        del numbers[-function.axes:]
    return of.chosen(choice)


def values_of(noise: Noise, function: Function, fixed: bool) -> Evaluate:
    """All that a noise returns, of a row of the function's inputs."""
    n = function.axes

    def values(knobs: Knobs, row: Sequence[Real]) -> Values:
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


def _noise_evaluator(function: Function, fixed: bool) -> Evaluate:
    try:
        noise = SETS[function.sets] if function.sets else noises.find(function.bound)
    except LookupError as error:
        raise function.error(str(error)) from error
    if function.component is not None:
        noise = component(noise, function.component)
    values = values_of(noise, function, fixed)
    # In four dimensions the value and the derivatives have a row each.
    indices = [noise.outputs.index(name) for name in names_of(function)]

    def evaluate(knobs: Knobs, row: Sequence[Real]) -> Values:
        found = values(knobs, row)
        return tuple(found[i] for i in indices)

    return evaluate


def sum_values(name: str, fixed: bool) -> Callable[..., Values]:
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

    def evaluate(knobs: Knobs, row: Sequence[Real]) -> Values:
        *settings, seed = row[behind_periods:]
        place = in_cell(row[:n], row[n:behind_place]) if function.has_cell else at_position(row[:n])
        options = sums.Options(**dict(zip(names, settings, strict=True)))
        if function.has_cell:
            options = sums.from_cell(options)
        return values(knobs, place, options, seed, row[behind_place:behind_periods])

    return evaluate
